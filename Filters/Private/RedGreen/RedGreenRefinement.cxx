// SPDX-License-Identifier: BSD-3-Clause
#include "Private/RedGreen/RedGreenRun.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/Complex/TetOrder.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/CellArrays.h"
#include "Private/Curved/CurvedCells.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Partitions/SharedNumbers.h"
#include "Private/RedGreen/OpenSplits.h"
#include "Private/RedGreen/RedGreenNormals.h"
#include "Private/RedGreen/RedGreenSeams.h"
#include "Private/RedGreen/RedGreenWriter.h"
#include "Private/RedGreen/VertexOrigins.h"
#include "Private/Run/SizeChecks.h"
#include "Private/Run/StampFields.h"
#include "Private/Values/SharedInterpolation.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace subdivision
{

bool RedGreenRun::Run()
{
  this->Read(true);
  if (this->IsStopped(0.1))
  {
    return false;
  }
  // There are as many simplices as input cells, or more, if the stamp turns out to be wrong.
  const vtkIdType simplices = std::max(
    this->Mesh.Control.Cells.Simplices.GetNumberOfSimplices(), this->Input->GetNumberOfCells());
  const double largest = 12. * (static_cast<double>(simplices) + this->MostCells);
  return largest < static_cast<double>(LargestSmallId) ? this->Refine<int>()
                                                       : this->Refine<long long>();
}

// ------------------------------------------------------------------------------------------------
// Planning

/// Reads the mesh, starts its points, and finds how many cells the output may have.
void RedGreenRun::Read(bool trustStamp)
{
  // Leaves in the place of their green parts do not conform, and then there is no limit. Where
  // limits are needed, green cells are not undone.
  const bool undo = !this->ReadsLimit();
  const auto read = [&](bool undoes)
  {
    const StampScheme scheme = undo ? StampScheme::BoxSpline : this->Options.Scheme;
    return ReadRedGreenMesh(this->Input, this->Options.Features, scheme, trustStamp, undoes);
  };
  this->Mesh = read(undo);
  if (undo && !this->AllAgree(this->Mesh.IsContinued) && this->Mesh.IsContinued)
  {
    this->Mesh = read(false);
  }
  if (this->Others)
  {
    this->Mesh.Scopes = FindScopes(this->Mesh, *this->Others);
  }
  this->StartPoints();
  this->FindLimit();
}

void RedGreenRun::StartPoints()
{
  const ControlMesh& control = this->Mesh.Control;
  this->GivenCoordinates.clear();
  this->Points = StartPointArrays(this->Options, this->Input, control.Cells, control.GlobalIds,
    this->Mesh.CarriesOriginals(), [this](const std::string& warning) { this->Warn(warning); });
}

/// How many cells the output may have, by the option and by the memory that there is.
void RedGreenRun::FindLimit()
{
  // Connectivity, offset, type, our own arrays, the state of refinement; a point for five cells.
  const double perCell = 41. + 18. + 130. + GetBytesPerTuple(this->Input->GetCellData()) +
    (this->Points->GetBytesPerPoint() + 40.) / 5.;
  // In the first round, which has most candidates, errors of all of them are found.
  const RefinementOptions& criteria = this->Options.Criteria;
  const auto simplices =
    static_cast<double>(this->Mesh.Control.Cells.Simplices.GetNumberOfSimplices());
  const double ofErrors =
    criteria.Attribute && criteria.AttributeErrorOfLimit ? BytesOfErrors * simplices : 0.;
  KeepEstimate(ofErrors + perCell * simplices); // how many there will be is not known before
  const double fitting = std::max(0., GetAvailableMemory() - ofErrors) / perCell;
  const auto wanted = static_cast<double>(this->Options.MaximumNumberOfCells);
  this->MemoryIsLimit = fitting < wanted;
  this->MostCells = std::min(fitting, wanted);
}

/// Decides whether the stamp is true, and which cells the output has. Tells the warnings of all
/// that. Returns false after an error or if Progress asks to stop.
template <typename Id>
bool RedGreenRun::Plan(SharedState<Id>& shared, RedGreenLimit<Id>& limit)
{
  bool isTrue = false;
  bool isFound = false;
  try
  {
    isTrue = this->AllAgree(this->BuildLimit(limit));
    if (isTrue)
    {
      this->Interpolate(limit);
      isFound = this->FindCells(shared, limit);
    }
  }
  catch (const std::invalid_argument&) // the midpoints of the stamp do not fit together
  {
    if (this->Others) // which would not begin again
    {
      throw;
    }
    isTrue = false;
  }
  if (!isTrue)
  {
    this->Read(false);
    limit = RedGreenLimit<Id>();
    this->BuildLimit(limit);
    this->Interpolate(limit);
    isFound = this->FindCells(shared, limit);
  }
  this->Criteria.reset();
  const bool mayBeOpen = isFound && !this->ReadsLimit() && !this->Mesh.CarriesOriginals();
  if (mayBeOpen && HasOpenSplits(*shared.State, this->GetGivenCoordinates()))
  {
    WarnOfOpenPoints<Id>(this->Mesh.Control, this->Options.Features, this->GetGivenCoordinates(),
      [this](const std::string& warning) { this->Warn(warning); });
  }
  Tell(this->Mesh.Control.Warnings, this->Options);
  return isFound;
}

/// Builds the complex that puts vertices on the limit, if that is needed. Returns false if the
/// stamp is wrong.
template <typename Id>
bool RedGreenRun::BuildLimit(RedGreenLimit<Id>& limit)
{
  if (!this->ReadsLimit())
  {
    return true;
  }
  // Tetrahedra are ordered in a copy, so that cells of the output keep the order of their points,
  // and new points have the same ids with either placement.
  ControlMesh ordered = this->Mesh.Control;
  ordered.Cells.TakeIds();
  const Coordinates points = this->Points->GetCoordinates();
  if (!this->Mesh.TetOrderIsFinal)
  {
    OrderTets(ordered.Cells.Simplices, points, ordered.GetGlobalIds(),
      static_cast<vtkIdType>(ordered.GlobalIds.size()));
  }
  return limit.Build(ordered, this->Options.Features, this->Options.Scheme, points,
    [this](const std::string& warning) { this->Warn(warning); });
}

/// Replaces points and arrays by control values whose limits they are, and lets `limit` know.
template <typename Id>
void RedGreenRun::Interpolate(RedGreenLimit<Id>& limit)
{
  const ControlMesh& control = this->Mesh.Control;
  if (control.IsStamped)
  {
    WarnOfLateInterpolation(this->Options.Interpolation,
      ReadFieldIds(InterpolatedName, this->Input->GetFieldData()),
      [this](const std::string& warning) { this->Warn(warning); });
  }
  const bool isOwn = this->Options.Interpolation.IsOn() && !control.IsStamped;
  if (!AgreeWithOthers(isOwn, this->Options))
  {
    return;
  }
  const vtkIdType size = control.Cells.Simplices.NumberOfPoints;
  const double* given = this->Points->GetCoordinates();
  this->GivenCoordinates.assign(given, given + 3 * size);
  InterpolationLimits limits;
  limits.LeastEigenvalue = GetLeastEigenvalue(this->Options.Features.Weights);
  ConnectToOthers(this->Input, control.Cells, this->Options, limits);
  this->Points->Interpolate(limit.GetControlRows(), this->Options.Interpolation, limits,
    [this](const std::string& warning) { this->Warn(warning); });
  const double* points = this->Points->GetCoordinates();
  std::vector<double> attribute;
  if (vtkDataArray* current = this->Points->FindCurrent(this->Options.Criteria.Attribute))
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      for (int c = 0; c < current->GetNumberOfComponents(); ++c)
      {
        attribute.push_back(current->GetComponent(i, c));
      }
    }
  }
  limit.SetControlValues({ points, points + 3 * size }, std::move(attribute));
}

// ------------------------------------------------------------------------------------------------
// Output

namespace
{

/// Numbers the vertices that the same number of halvings made, by the numbers of the ends of their
/// edges, ends[vertex - first]. `own`: of each vertex, whether it belongs to an own cell.
template <typename Id>
void NumberMidpoints(const std::vector<Id>& vertices, Id first,
  const std::vector<std::array<Id, 2>>& allEnds, const std::vector<char>& own,
  OtherPartitions& others, WholeIds& points)
{
  SharedKeys midpoints;
  midpoints.Width = 2;
  for (const Id vertex : InTurn(vertices))
  {
    const auto& ends = allEnds[vertex - first];
    const auto [least, most] = std::minmax(points.Ids[ends[0]], points.Ids[ends[1]]);
    midpoints.Keys.push_back(std::max<vtkIdType>(least, 0));
    midpoints.Keys.push_back(std::max<vtkIdType>(most, 0));
    midpoints.Own.push_back(own[vertex] && least >= 0);
  }
  points.Add(midpoints, others, { vertices.begin(), vertices.end() });
}

/// The same for means of vertices.
void NumberMeans(const std::vector<WeightedVertices>& means, vtkIdType first,
  const std::vector<char>& own, OtherPartitions& others, WholeIds& points)
{
  SharedKeys keys;
  keys.Width = 8;
  std::vector<vtkIdType> places;
  for (const WeightedVertices& mean : InTurn(means))
  {
    places.push_back(first);
    keys.Own.push_back(own[first++]);
    WeightedVertices whole{};
    std::size_t size = 0;
    for (const auto& [vertex, weight] : mean)
    {
      const vtkIdType id = vertex < 0 ? -1 : points.Ids[vertex];
      id >= 0 ? Insert({ id, weight }, size++, whole) : void();
      keys.Own.back() = vertex >= 0 && id < 0 ? char(0) : keys.Own.back();
    }
    for (const auto& [id, weight] : whole)
    {
      keys.Keys.insert(keys.Keys.end(), { id, weight });
    }
  }
  points.Add(keys, others, places);
}

/// Numbers the output of a state whose vertices are sorted; `simplices`: of which each cell is a
/// part; `midpoints`: the ends of new vertices, of nodes of curved cells too; `means`: further
/// nodes. Vertices of each number of halvings are numbered after vertices of less: two exchanges
/// for each, of 32 bytes for each vertex.
template <typename Id>
WholeNumbers NumberOutput(vtkPointSet* input, const RedGreenMesh& mesh, const RedGreen<Id>& state,
  const std::vector<vtkIdType>& simplices, const std::vector<std::array<Id, 2>>& midpoints,
  const std::vector<WeightedVertices>& means, OtherPartitions& others, vtkUnstructuredGrid* output)
{
  std::vector<vtkIdType> sources;
  for (const vtkIdType simplex : InTurn(simplices))
  {
    sources.push_back(mesh.GetInputCell(simplex));
  }
  const std::vector<vtkIdType> places = PlaceCells(input, others);
  WholeNumbers numbers;
  numbers.Cells = NumberCells(places, sources, others);
  const std::vector<char> own = FindOwnPoints(output, sources, others);
  numbers.Points = NumberVertices(input->GetNumberOfPoints(), mesh.Control.Cells.GetView(),
    MakeKeysOfPieces(mesh.Control.Cells, places, others), others);
  numbers.Points.Ids.resize(own.size(), -1);
  std::vector<std::vector<Id>> added = ListByHalvings(state);
  const auto halvings = others.Gather(static_cast<vtkIdType>(added.size()));
  added.resize(static_cast<std::size_t>(*std::max_element(halvings.begin(), halvings.end())));
  const Id first = state.GetNumberOfInputVertices();
  const Id size = state.GetNumberOfVertices();
  std::vector<Id> nodes[2]; // between vertices, and between these
  for (Id node = size; node < first + static_cast<Id>(midpoints.size()); ++node)
  {
    const auto& ends = midpoints[node - first];
    nodes[ends[0] < size && ends[1] < size ? 0 : 1].push_back(node);
  }
  added.insert(added.end(), std::begin(nodes), std::end(nodes));
  for (const std::vector<Id>& vertices : added)
  {
    NumberMidpoints(vertices, first, midpoints, own, others, numbers.Points);
  }
  NumberMeans(means, first + static_cast<vtkIdType>(midpoints.size()), own, others, numbers.Points);
  return numbers;
}

}

template <typename Id>
bool RedGreenRun::Refine()
{
  RedGreenLimit<Id> limit;
  SharedState<Id> shared;
  if (!this->Plan(shared, limit) || this->IsStopped(0.75))
  {
    return false;
  }
  shared.State->SortVertices();
  const RedGreen<Id>& state = *shared.State;
  const RedGreenOutput<Id> plan(state);
  std::vector<vtkIdType> simplices;
  WriteRedGreenCells(plan, this->Input, this->Mesh, this->Options, this->Options.LimitPlacement,
    this->Others || this->Options.Torn ? &simplices : nullptr, this->Output);
  if (this->IsStopped(0.9))
  {
    return false;
  }
  std::vector<std::array<Id, 2>> midpoints = ListEnds(state);
  std::vector<WeightedVertices> means;
  CurvedNodes nodes;
  if (this->Options.IsCurved)
  {
    std::vector<std::array<vtkIdType, 2>> middles;
    const auto list = [&](const auto& listNodes, auto& found)
    {
      return listNodes(this->Output, this->Options.Kind, this->Options.CellOrder,
        state.GetNumberOfVertices(), this->Options.Fail, nodes, found);
    };
    if (!(AreNodesOnLevels(this->Options.CellOrder) ? list(ListMiddles, middles)
                                                    : list(ListMeans, means)))
    {
      return false;
    }
    for (const auto& ends : InTurn(middles))
    {
      midpoints.push_back({ { static_cast<Id>(ends[0]), static_cast<Id>(ends[1]) } });
    }
  }
  this->MakePoints(state.GetNumberOfInputVertices(), midpoints, means, limit);
  TellOvershoot(*this->Points, this->Options, this->Output, this->Options.LimitPlacement);
  if (this->Options.IsCurved)
  {
    SetCells(nodes, this->Output);
  }
  RebuildPointGhosts(this->Input, this->Output);
  WholeNumbers whole;
  if (this->Others)
  {
    whole = NumberOutput(
      this->Input, this->Mesh, state, simplices, midpoints, means, *this->Others, this->Output);
    whole.Write(this->Output);
  }
  WriteRedGreenFields(this->Mesh, plan, this->Options.LimitPlacement, whole, this->Output);
  if (this->Options.Torn) // a filter that follows joins the sides first, as the fields have them
  {
    TearSeams(this->Options.Torn, this->Input, this->Mesh, midpoints, simplices, this->Output);
  }
  return true;
}

namespace
{

/// Limits of vertices, and after them those of means.
template <typename Id>
struct LimitsAndMeans : PointOperator
{
  LimitsAndMeans(
    const LocalLimit<Id>& vertices, const RedGreenLimit<Id>& limit, const SparseRows<Id>& rows)
    : Vertices(vertices)
    , Limit(limit)
    , Rows(rows)
  {
  }
  vtkIdType GetNumberOfColumns() const override { return this->Rows.NumberOfColumns; }
  vtkIdType GetNumberOfRows() const override
  {
    return this->Rows.NumberOfColumns + this->Rows.GetNumberOfRows();
  }
  vtkIdType GetNumberBetween() const override { return this->Vertices.GetNumberBetween(); }
  void ForEachBlock(const User& use) const override
  {
    this->Vertices.ForEachBlock(use);
    this->Limit.ForMeans(
      this->Rows, this->Vertices.GetNumberOfRows() - this->Rows.NumberOfColumns, use);
  }

  const LocalLimit<Id>& Vertices;
  const RedGreenLimit<Id>& Limit;
  const SparseRows<Id>& Rows; ///< of midpoints and means
};

}

template <typename Id>
void RedGreenRun::MakePoints(Id given, const std::vector<std::array<Id, 2>>& midpoints,
  const std::vector<WeightedVertices>& means, const RedGreenLimit<Id>& limit)
{
  VertexOrigins origin(*this->Points);
  if (this->Points->GathersSome())
  {
    const vtkIdType nodes = given + static_cast<vtkIdType>(midpoints.size());
    const auto getEnds = [&](vtkIdType v) -> std::array<vtkIdType, 2>
    {
      if (v < nodes)
      {
        return { { midpoints[v - given][0], midpoints[v - given][1] } };
      }
      const WeightedVertices& mean = means[v - nodes]; // the vertex to which it is next
      const auto* found = std::max_element(mean.begin(), mean.end(),
        [&](const auto& a, const auto& b)
        {
          return a.second != b.second ? a.second < b.second
                                      : a.first >= 0 && origin.IsFirst(b.first, a.first);
        });
      return { { found->first, found->first } };
    };
    origin.Continue(given, nodes + static_cast<vtkIdType>(means.size()), getEnds);
  }
  if (this->Options.LimitPlacement)
  {
    const bool hasNormals = this->Options.GenerateLimitNormals;
    const LocalLimit<Id> operation = limit.GetOperator(midpoints, hasNormals);
    Buffer<double> normals;
    if (hasNormals)
    {
      const RedGreenNormals<Id> sides(
        this->Input, this->Mesh.Control, this->GetGivenCoordinates(), limit, this->Others);
      normals = sides.Compute(operation, this->Points->GetCoordinates());
    }
    if (means.empty())
    {
      this->Points->Advance(operation, std::cref(origin));
    }
    else
    {
      const MidpointRows<Id> rows = MakeRowsOfMidpoints(given, midpoints, means);
      this->Points->Advance(LimitsAndMeans<Id>(operation, limit, rows.Added), std::cref(origin));
    }
    if (hasNormals)
    {
      this->Points->SetLimitNormals(normals);
    }
  }
  else
  {
    const bool adds = !midpoints.empty() || !means.empty();
    if (adds)
    {
      this->Points->Advance(MakeRowsOfMidpoints(given, midpoints, means), std::cref(origin));
    }
    if (!this->AllAgree(!adds))
    {
      this->Points->LeaveOutNormals();
    }
  }
  this->Points->Finish(this->Output);
}

bool RefineRedGreen(vtkPointSet* input, const RedGreenOptions& options, vtkUnstructuredGrid* output)
{
  RedGreenOptions own = options;
  if (OtherPartitions* others = options.Others)
  {
    own.Criteria.FindLargest = [others](std::vector<double>& values)
    { others->FindLargest(values); };
  }
  return RedGreenRun(input, own, output).Run();
}

}
