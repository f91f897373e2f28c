// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Topology/TopologyProbe.h"

#include "Core/Memory/Sorting.h"
#include "Core/Solids/BoxSpline/BoxSplineScheme.h"
#include "Core/Solids/Complex/RunSimplices.h"
#include "Core/Solids/Strata/ComplexDescription.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/CellArrays.h"
#include "Private/Arrays/PointArrays.h"
#include "Private/Control/ControlComplex.h"
#include "Private/Partitions/SharedNumbers.h"
#include "Private/Reading/CellReader.h"
#include "Private/Run/SizeChecks.h"
#include "Private/Topology/SharedCounts.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSignedCharArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <memory>
#include <variant>

namespace subdivision
{
namespace
{

constexpr unsigned char DuplicateCell = vtkDataSetAttributes::DUPLICATECELL;

/// act(dimension, number) for a cell and its faces. `cell` is its number among vertex cells, edges,
/// faces or tetrahedra.
template <typename Id, typename Act>
void VisitFaces(const SimplicialComplex<Id>& complex, int dimension, vtkIdType cell, const Act& act)
{
  auto visit = [&act](int faceDimension, const Id* begin, int count)
  {
    for (int i = 0; i < count; ++i)
    {
      act(faceDimension, static_cast<vtkIdType>(begin[i]));
    }
  };
  switch (dimension)
  {
    case 0:
      act(0, cell);
      break;
    case 1:
      visit(0, complex.EdgeVertices.data() + 2 * cell, 2);
      act(1, cell);
      break;
    case 2:
      visit(0, complex.FaceVertices.data() + 3 * cell, 3);
      visit(1, complex.FaceEdges.data() + 3 * cell, 3);
      act(2, cell);
      break;
    default:
      visit(0, complex.TetVertices.data() + 4 * cell, 4);
      visit(1, complex.TetEdges.data() + 6 * cell, 6);
      visit(2, complex.TetFaces.data() + 4 * cell, 4);
      act(3, cell);
      break;
  }
}

/// The points of some cells as keys.
SharedKeys MakeKeys(const CellReader& reader, const std::vector<vtkIdType>& cells, int width,
  const std::vector<vtkIdType>& points)
{
  SharedKeys keys;
  keys.Width = width;
  keys.Own.assign(cells.size(), 1);
  std::vector<vtkIdType> scratch;
  for (const vtkIdType c : InTurn(cells))
  {
    const CellIds cell = reader.GetCell(c, scratch);
    for (int k = 0; k < width; ++k)
    {
      keys.Keys.push_back(points[cell.Ids[k]]);
    }
    std::sort(keys.Keys.end() - width, keys.Keys.end());
  }
  return keys;
}

class Probe
{
public:
  Probe(vtkPointSet* input, const ProbeOptions& options, vtkUnstructuredGrid* output)
    : Input(input)
    , Options(options)
    , Output(output)
    , Others(options.Others)
  {
  }
  bool Run()
  {
    this->Read(true);
    if (this->IsStopped(0.1))
    {
      return false;
    }
    if (!this->Build()) // the stamp is wrong
    {
      this->Read(false);
      this->Build();
    }
    Tell(this->Mesh.Warnings, this->Options);
    return std::visit(
      [this](const auto& control) { return this->Describe(control); }, this->Control);
  }

private:
  void Read(bool trustStamp)
  {
    this->Mesh = ReadControlMesh(this->Input, trustStamp, this->Options.Features);
    this->Points = StartPointArrays(this->Options, this->Input, this->Mesh.Cells,
      this->Mesh.GlobalIds, this->Mesh.IsStamped, nullptr);
  }
  /// Builds the complex. Returns false if the stamp is wrong.
  bool Build()
  {
    // One level more: here all faces of the last one are made.
    return NeedsLargeIds(
             this->Mesh.GetControl(), this->Mesh.MadeLevels + 1, BoxSplineScheme<int>::Traits)
      ? this->BuildAs<long long>()
      : this->BuildAs<int>();
  }
  template <typename Id>
  bool BuildAs()
  {
    auto& control = this->Control.emplace<ControlComplex<Id>>();
    return BuildControlComplex<BoxSplineScheme<Id>>(
      this->Mesh, this->Options.Features, this->Points->GetCoordinates(),
      [this](const std::string& warning) { this->Mesh.Warnings.push_back(warning); },
      Depth::ForRefinement, control, control.Current);
  }
  /// Writes the output. Returns false after an error or if Progress asks to stop.
  template <typename Id>
  bool Describe(const ControlComplex<Id>& control)
  {
    if (this->IsStopped(0.5))
    {
      return false;
    }
    const SimplicialComplex<Id>& complex = control.Current.Complex;
    const SingularSimplices singular = CollectSingular(complex, control,
      RefineFlags(this->Mesh.GetControl(), this->Mesh.MadeLevels, this->Mesh.Values.Singular));
    const ComplexDescription<Id> description =
      DescribeComplex(complex, control.Current.Strata, singular);
    this->Select(description);
    if (this->GetNumberOfCells() > this->Options.MaximumNumberOfCells)
    {
      this->Options.Fail("The complex has " + std::to_string(this->GetNumberOfCells()) +
        " vertices, edges and triangles to output, which is above MaximumNumberOfCells = " +
        std::to_string(this->Options.MaximumNumberOfCells) +
        ". Turn SpecialOnly on, take a part of the input, or raise MaximumNumberOfCells.");
      return false;
    }
    if (this->IsStopped(0.8))
    {
      return false;
    }
    this->Points->Finish(this->Output);
    this->MakeCells(complex);
    this->AddFacts(description);
    this->AddOriginalIds(control);
    this->AddGhosts(control);
    this->FindFirstCells(control);
    this->AddBlocks();
    this->AddNumbers(this->Count(control, description));
    this->AddIds();
    return true;
  }
  template <typename Id>
  void Select(const ComplexDescription<Id>& description)
  {
    for (int dimension = 0; dimension < 3; ++dimension)
    {
      const Buffer<Id>& order = description.Order[dimension];
      Buffer<vtkIdType> places(order.size() + 1);
      ForEach(order.size(),
        [&](vtkIdType i)
        {
          const SimplexFacts& facts = description.Facts[dimension][order[i]];
          places[i] = !this->Options.SpecialOnly || facts.IsSpecial() ? 1 : 0;
        });
      CountsToOffsets(places);
      this->Chosen[dimension] = Buffer<vtkIdType>(places[order.size()]);
      ForEach(order.size(),
        [&](vtkIdType i)
        {
          if (places[i] < places[i + 1])
          {
            this->Chosen[dimension][places[i]] = order[i];
          }
        });
    }
  }
  /// Writes the cells. The vertices of each are in ascending order.
  template <typename Id>
  void MakeCells(const SimplicialComplex<Id>& complex)
  {
    const Buffer<Id>* vertices[3] = { nullptr, &complex.EdgeVertices, &complex.FaceVertices };
    const unsigned char typeOf[3] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE };
    const vtkIdType size = this->GetNumberOfCells();
    const vtkIdType firstEdge = this->Chosen[0].size();
    const vtkIdType firstFace = firstEdge + this->Chosen[1].size();
    vtkNew<vtkIdTypeArray> connectivity;
    vtkNew<vtkIdTypeArray> offsets;
    vtkNew<vtkUnsignedCharArray> types;
    connectivity->SetNumberOfValues(
      firstEdge + 2 * this->Chosen[1].size() + 3 * this->Chosen[2].size());
    offsets->SetNumberOfValues(size + 1);
    types->SetNumberOfValues(size);
    vtkIdType* ids = connectivity->GetPointer(0);
    vtkIdType* starts = offsets->GetPointer(0);
    unsigned char* kinds = types->GetPointer(0);
    this->ForOutputCells(
      [&](vtkIdType cell, int dimension, vtkIdType simplex)
      {
        const vtkIdType start = cell + std::max<vtkIdType>(cell - firstEdge, 0) +
          std::max<vtkIdType>(cell - firstFace, 0);
        starts[cell] = start;
        kinds[cell] = typeOf[dimension];
        if (dimension == 0)
        {
          ids[start] = simplex;
          return;
        }
        const Id* from = vertices[dimension]->data() + (dimension + 1) * simplex;
        std::copy(from, from + dimension + 1, ids + start);
        std::sort(ids + start, ids + start + dimension + 1);
      });
    starts[size] = connectivity->GetNumberOfValues();
    vtkNew<vtkCellArray> cells;
    cells->SetData(offsets, connectivity);
    this->Output->SetCells(types, cells);
  }
  template <typename Id>
  void AddFacts(const ComplexDescription<Id>& description)
  {
    auto facts = [&](int dimension, vtkIdType simplex) -> const SimplexFacts&
    { return description.Facts[dimension][simplex]; };
    this->AddCellArray<vtkUnsignedCharArray>(
      "SimplexDimension", [](int dimension, vtkIdType) { return dimension; });
    this->AddCellArray<vtkUnsignedCharArray>(
      "ManifoldDimensions", [&](int d, vtkIdType i) { return facts(d, i).ManifoldDimensions; });
    this->AddCellArray<vtkUnsignedCharArray>(
      "Boundary", [&](int d, vtkIdType i) { return facts(d, i).Boundary; });
    this->AddCellArray<vtkUnsignedCharArray>(
      "NonManifoldType", [&](int d, vtkIdType i) { return facts(d, i).NonManifoldType; });
    this->AddCellArray<vtkUnsignedCharArray>(
      SingularName, [&](int d, vtkIdType i) { return facts(d, i).Singular; });
    this->AddCellArray<vtkIntArray>(
      "Valence", [&](int d, vtkIdType i) { return facts(d, i).Valence; });
    this->AddCellArray<vtkSignedCharArray>(
      "RuleDimension", [&](int d, vtkIdType i) { return facts(d, i).RuleDimension; });
    this->Output->GetCellData()->SetActiveScalars("RuleDimension"); // what views show
  }
  /// The first input cell that each simplex is, or is a piece of.
  template <typename Id>
  void AddOriginalIds(const ControlComplex<Id>& control)
  {
    if (!this->Options.GenerateOriginalIds)
    {
      return;
    }
    const SimplicialComplex<Id>& complex = control.Current.Complex;
    Buffer<vtkIdType> simplices[3] = { Buffer<vtkIdType>(complex.NumberOfVertices, -1),
      FindSimplicesOf(complex, control.Runs, 1), FindSimplicesOf(complex, control.Runs, 2) };
    for (auto run = control.Runs.rbegin(); run != control.Runs.rend(); ++run)
    {
      for (vtkIdType i = run->Count - 1; run->Dimension == 0 && i >= 0; --i)
      {
        simplices[0][complex.VertexCells[run->First + i]] = run->FirstCell + i;
      }
    }
    const char* name = OriginalCellIdsName;
    vtkDataArray* carried =
      this->Mesh.IsStamped ? this->Input->GetCellData()->GetArray(name) : nullptr;
    this->AddCellArray<vtkIdTypeArray>(name,
      [&](int dimension, vtkIdType i)
      {
        const vtkIdType simplex = simplices[dimension][i];
        const vtkIdType cell = simplex < 0 ? -1 : this->GetInputCell(simplex);
        return cell >= 0 && carried ? static_cast<vtkIdType>(carried->GetComponent(cell, 0)) : cell;
      });
  }
  /// act(input cell, dimension, number) for each simplex that lies on an input cell.
  template <typename Id, typename Act>
  void VisitCells(const ControlComplex<Id>& control, const Act& act) const
  {
    const SimplicialComplex<Id>& complex = control.Current.Complex;
    ForSimplices(complex, control.Runs,
      [&](vtkIdType place, int ofCell, vtkIdType number, bool)
      {
        VisitFaces(complex, ofCell, number,
          [&, cell = this->GetInputCell(place)](int dimension, vtkIdType simplex)
          { act(cell, dimension, simplex); });
      });
  }
  /// A simplex is a duplicate if all cells that it lies on are.
  template <typename Id>
  void AddGhosts(const ControlComplex<Id>& control)
  {
    const char* name = vtkDataSetAttributes::GhostArrayName();
    auto* ghosts =
      vtkUnsignedCharArray::SafeDownCast(this->Input->GetCellData()->GetAbstractArray(name));
    if (ghosts)
    {
      const SimplicialComplex<Id>& complex = control.Current.Complex;
      Buffer<unsigned char> types[4] = { Buffer<unsigned char>(
                                           complex.NumberOfVertices, DuplicateCell),
        Buffer<unsigned char>(complex.NumberOfEdges, DuplicateCell),
        Buffer<unsigned char>(complex.NumberOfFaces, DuplicateCell),
        Buffer<unsigned char>(complex.NumberOfTets, DuplicateCell) };
      this->VisitCells(control,
        [&](vtkIdType cell, int dimension, vtkIdType simplex)
        {
          if (!(ghosts->GetValue(cell) & DuplicateCell))
          {
            types[dimension][simplex] = 0;
          }
        });
      this->AddCellArray<vtkUnsignedCharArray>(
        name, [&](int dimension, vtkIdType i) { return types[dimension][i]; });
    }
    RebuildPointGhosts(this->Input, this->Output);
  }
  template <typename Id>
  void FindFirstCells(const ControlComplex<Id>& control)
  {
    if (!this->Input->GetCellData()->GetArray(BlockName))
    {
      return;
    }
    const SimplicialComplex<Id>& complex = control.Current.Complex;
    const vtkIdType sizes[4] = { complex.NumberOfVertices, complex.NumberOfEdges,
      complex.NumberOfFaces, complex.NumberOfTets };
    for (int dimension = 0; dimension < 4; ++dimension)
    {
      this->FirstCells[dimension] =
        Buffer<vtkIdType>(sizes[dimension], this->Input->GetNumberOfCells());
    }
    this->VisitCells(control,
      [&](vtkIdType cell, int dimension, vtkIdType simplex)
      {
        vtkIdType& first = this->FirstCells[dimension][simplex];
        first = std::min(first, cell);
      });
  }
  /// A simplex belongs to the block of the first cell that it lies on.
  void AddBlocks()
  {
    vtkDataArray* blocks = this->Input->GetCellData()->GetArray(BlockName);
    if (!blocks)
    {
      return;
    }
    this->AddCellArray<vtkIntArray>(BlockName,
      [&](int dimension, vtkIdType i)
      {
        const vtkIdType cell = this->FirstCells[dimension][i];
        return cell < this->Input->GetNumberOfCells() ? static_cast<int>(blocks->GetTuple1(cell))
                                                      : NoBlock;
      });
  }
  /// The numbers of the whole complex.
  template <typename Id>
  ComplexNumbers Count(
    const ControlComplex<Id>& control, const ComplexDescription<Id>& description) const
  {
    ComplexNumbers numbers;
    if (!this->Others)
    {
      std::copy_n(description.Counts, 4, numbers.Counts);
      std::copy_n(description.Components, 4, numbers.Components);
      return numbers;
    }
    OwnSimplices own;
    for (int dimension = 0; dimension < 4; ++dimension)
    {
      const Buffer<vtkIdType>& first = this->FirstCells[dimension];
      own.Flags[dimension] = Buffer<unsigned char>(first.size());
      ForEach(first.size(),
        [&](vtkIdType i)
        {
          own.Flags[dimension][i] =
            first[i] < this->Input->GetNumberOfCells() && this->Others->IsOwn(first[i]) ? 1 : 0;
        });
    }
    this->VisitCells(control,
      [&](vtkIdType cell, int dimension, vtkIdType vertex)
      {
        if (dimension == 0 && vertex < this->Input->GetNumberOfPoints() &&
          this->Others->IsOwn(cell) && !this->Others->GetNeighbours(cell).empty())
        {
          own.Shared.push_back(vertex);
        }
      });
    SortDistinct(own.Shared);
    return CountTogether(control.Current.Complex, description, own, *this->Others);
  }
  /// Adds field arrays with numbers of the whole complex, and removes the stamp of an earlier
  /// filter, which belongs to other cells.
  void AddNumbers(const ComplexNumbers& numbers)
  {
    vtkFieldData* fields = this->Output->GetFieldData();
    WriteStampedIds(StampedIds(), this->Output);
    fields->RemoveArray(StampName);
    auto add = [fields](const char* name, const vtkIdType* values, int size)
    {
      vtkNew<vtkIdTypeArray> array;
      array->SetName(name);
      array->SetNumberOfTuples(size);
      std::copy(values, values + size, array->GetPointer(0));
      fields->AddArray(array);
    };
    const vtkIdType* counts = numbers.Counts;
    const vtkIdType euler = counts[0] - counts[1] + counts[2] - counts[3];
    add("SimplexCounts", counts, 4);
    add("EulerCharacteristic", &euler, 1);
    add("ManifoldComponents", numbers.Components, 4);
  }
  /// Adds the numbers that points and own cells have in the output of the whole mesh, if this is a
  /// part: that has the cells of each kind in the order of the numbers of their points. Ten
  /// exchanges.
  void AddIds()
  {
    if (!this->Others || !this->Options.GenerateGlobalIds)
    {
      return;
    }
    const CellReader reader(this->Output);
    vtkDataArray* blocks = this->Output->GetCellData()->GetArray(BlockName);
    std::vector<vtkIdType> own[3];
    std::vector<vtkIdType> scratch;
    for (const vtkIdType c : InTurn(reader.GetNumberOfCells()))
    {
      if (blocks->GetTuple1(c) != NoBlock)
      {
        own[reader.GetCell(c, scratch).Size - 1].push_back(c);
      }
    }
    const SimplicesOfCells& cells = this->Mesh.Cells;
    WholeNumbers numbers;
    numbers.Points = NumberVertices(this->Input->GetNumberOfPoints(), cells.GetView(),
      MakeKeysOfPieces(cells, PlaceCells(this->Input, *this->Others), *this->Others),
      *this->Others);
    numbers.Cells.Ids.assign(static_cast<std::size_t>(reader.GetNumberOfCells()), -1);
    for (int i = 0; i < 3; ++i)
    {
      numbers.Cells.Add(MakeKeys(reader, own[i], i + 1, numbers.Points.Ids), *this->Others, own[i]);
    }
    numbers.Write(this->Output);
  }

  vtkIdType GetNumberOfCells() const
  {
    return this->Chosen[0].size() + this->Chosen[1].size() + this->Chosen[2].size();
  }
  vtkIdType GetInputCell(vtkIdType simplex) const
  {
    const auto& parents = this->Mesh.Cells.ParentCells;
    return parents.empty() ? simplex : parents[simplex];
  }
  /// act(output cell, dimension, number of the simplex in the complex)
  template <typename Act>
  void ForOutputCells(const Act& act) const
  {
    vtkIdType first = 0;
    for (int dimension = 0; dimension < 3; ++dimension)
    {
      const Buffer<vtkIdType>& chosen = this->Chosen[dimension];
      ForEach(chosen.size(), [&](vtkIdType i) { act(first + i, dimension, chosen[i]); });
      first += chosen.size();
    }
  }
  /// Adds a cell array with get(dimension, simplex) for each output cell.
  template <typename Array, typename Get>
  void AddCellArray(const char* name, const Get& get)
  {
    vtkNew<Array> array;
    array->SetName(name);
    array->SetNumberOfTuples(this->GetNumberOfCells());
    auto* values = array->GetPointer(0);
    this->ForOutputCells([&](vtkIdType cell, int dimension, vtkIdType simplex)
      { values[cell] = static_cast<typename Array::ValueType>(get(dimension, simplex)); });
    this->Output->GetCellData()->AddArray(array);
  }
  bool IsStopped(double done) const
  {
    return this->Options.Progress && this->Options.Progress(done);
  }

  vtkPointSet* Input;
  const ProbeOptions& Options;
  vtkUnstructuredGrid* Output;
  ControlMesh Mesh;
  std::unique_ptr<PointArrays> Points;
  std::variant<ControlComplex<int>, ControlComplex<long long>> Control;
  Buffer<vtkIdType> Chosen[3]; ///< the vertices, edges, faces that are output cells, in order
  OtherPartitions* Others;     ///< null: the input is the whole mesh
  /// The first input cell that each vertex, edge, face and tetrahedron lies on, where that is asked
  /// for; the number of cells: there is none.
  Buffer<vtkIdType> FirstCells[4];
};

}

bool ProbeTopology(vtkPointSet* input, const ProbeOptions& options, vtkUnstructuredGrid* output)
{
  return Probe(input, options, output).Run();
}

}
