// SPDX-License-Identifier: BSD-3-Clause
#include "Private/AdaptiveSurface/AdaptiveSurface.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Sorting.h"
#include "Core/Surfaces/Scheme/SurfaceSides.h"
#include "Core/Surfaces/SqrtThree/AdaptiveSqrtThreeOutput.h"
#include "Private/AdaptiveSurface/AdaptiveSurfaceMarks.h"
#include "Private/AdaptiveSurface/AdaptiveSurfaceNumbers.h"
#include "Private/AdaptiveSurface/SharedFaces.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/CellArrays.h"
#include "Private/Arrays/PointArrays.h"
#include "Private/Control/OpenPoints.h"
#include "Private/Partitions/FittingMarks.h"
#include "Private/Run/SizeChecks.h"
#include "Private/Surface/SurfaceChecks.h"
#include "Private/Surface/SurfaceCreases.h"
#include "Private/Surface/SurfaceFrames.h"
#include "Private/Surface/SurfaceNumbers.h"
#include "Private/Surface/SurfaceStamp.h"
#include "Private/Values/MissingValues.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace subdivision
{
namespace
{

constexpr const char* TooManyGiven = "The input has more than MaximumNumberOfCells cells: nothing "
                                     "is refined. Raise MaximumNumberOfCells.";

template <typename Id>
class AdaptiveRun
{
public:
  AdaptiveRun(vtkPolyData* input, const SurfaceOptions& options, RefinementOptions& criteria,
    const SurfaceCells& cells, OtherPartitions* others, vtkPolyData* output)
    : Input(input)
    , Options(options)
    , Wanted(criteria)
    , Cells(cells)
    , Others(others)
    , Output(output)
    , Scheme(MakeSurfaceScheme<Id>(options.Scheme, false))
  {
    this->NoCentres.Simplices.NumberOfPoints = input->GetNumberOfPoints();
  }
  /// `memoryIsLimit`: why there may not be more cells.
  bool Run(double mostCells, bool memoryIsLimit)
  {
    this->MemoryIsLimit = memoryIsLimit;
    this->StartPoints();
    this->ReadControl();
    if (this->IsStopped(0.1) || !this->RunRounds(static_cast<vtkIdType>(mostCells)) ||
      this->IsStopped(0.7))
    {
      return false;
    }
    const AdaptiveSqrtThreeOutput<Id> plan(*this->Mesh);
    this->WriteCells(plan);
    if (this->IsStopped(0.8))
    {
      return false;
    }
    this->WritePoints(plan);
    RebuildPointGhosts(this->Input, this->Output);
    RemoveSurfaceStamp(this->Output);
    if (this->Others && this->Options.GenerateGlobalIds)
    {
      NumberAdaptiveSurface(
        this->Input, this->Cells, this->Control, *this->Mesh, plan, *this->Others, this->Output)
        .Write(this->Output);
    }
    return true;
  }

private:
  bool IsStopped(double done) const
  {
    return this->Options.Progress && this->Options.Progress(done);
  }
  void StartPoints()
  {
    this->GlobalIds = ReadIdsOf(this->Input->GetPointData(), this->Input->GetNumberOfPoints());
    this->Points = StartPointArrays(
      this->Options, this->Input, this->NoCentres, this->GlobalIds, false, this->Options.Warn);
  }
  void ReadControl()
  {
    this->Control = MakeControlLevel<Id>(this->Cells);
    SurfaceCreases creases = ReadSurfaceCreases(this->Options.Features, this->Cells, this->Control);
    const Coordinates points = this->Points->GetCoordinates();
    AddSharpEdges(this->Control.Mesh,
      { FindDerivedEdges(this->Control.Mesh, this->Cells.FaceCells, points, this->Options.Features),
        {} },
      creases);
    const FeatureOptions& features = this->Options.Features;
    OpenPointOptions open{ features.MergesPoints, features.ClosesNodes, features.JoiningCure, {} };
    open.FindCell = [this](int dimension, vtkIdType index)
    { return dimension == 2 ? this->Cells.FaceCells[static_cast<std::size_t>(index)] : -1; };
    for (const std::string& warning : DescribeOpenPointsOfSurface(this->Control.Mesh, points, open))
    {
      this->Options.Warn(warning);
    }
    this->Control.Tags =
      ClassifySurface(this->Control.Mesh, *this->Scheme, creases.Features, points);
    this->Scheme->RestrictTags(this->Control);
    this->Mesh = std::make_unique<AdaptiveSqrtThree<Id>>(this->Control);
    this->Rows =
      std::make_unique<AdaptiveSqrtThreeRows<Id>>(*this->Mesh, this->Control, *this->Scheme);
    if (this->Others)
    {
      this->Shared =
        std::make_unique<SharedFaces<Id>>(this->Cells, this->Control, *this->Mesh, *this->Others);
    }
  }
  /// Returns false if Progress asks to stop.
  bool RunRounds(vtkIdType mostCells)
  {
    if (this->Others && this->IsTooLarge(true))
    {
      this->Options.Warn(TooManyGiven);
      return true;
    }
    RefinementCriteria criteria(this->Wanted, this->Input, this->NoCentres);
    const std::vector<vtkIdType> segmentCells = this->FindSegmentCells();
    AdaptiveSurfaceMarks<Id> finder(*this->Mesh, *this->Rows, this->Wanted, criteria,
      this->Cells.FaceCells, segmentCells, this->Shared ? &this->Shared->GetScope() : nullptr);
    AdaptiveNotes notes;
    vtkIdType left = 0;
    for (int round = 0; left == 0; ++round)
    {
      if (this->IsStopped(0.1 + 0.6 * round / (round + 5.)))
      {
        return false;
      }
      std::vector<AdaptiveMark<Id>> marks = finder.Find(notes);
      const auto size = static_cast<vtkIdType>(marks.size());
      if ((this->Others ? this->Others->Sum(size) : size) == 0)
      {
        if (round == 0 && this->Wanted.SplitAll())
        {
          return this->RunRounds(mostCells);
        }
        break;
      }
      StableSort(marks,
        [](const AdaptiveMark<Id>& a, const AdaptiveMark<Id>& b) { return a.Error > b.Error; });
      left = this->Others ? this->SplitTogether(marks, mostCells) : this->Split(marks, mostCells);
    }
    if (left > 0)
    {
      this->WarnOfLeft(left, mostCells);
    }
    this->TellNotes(notes);
    return true;
  }
  /// Does the splits of a round, and returns how many did not fit.
  vtkIdType Split(const std::vector<AdaptiveMark<Id>>& marks, vtkIdType mostCells)
  {
    vtkIdType left = 0;
    ForEachInTurn(static_cast<vtkIdType>(marks.size()),
      [&](vtkIdType i)
      {
        const Id face = marks[i].Face;
        const bool isDone = left == 0 &&
          (face < 0 ? this->Mesh->Cut(-1 - face, mostCells) : this->Mesh->Split(face, mostCells));
        left += !isDone && (face < 0 || !this->Mesh->IsSplit(face)) ? 1 : 0;
      });
    return left;
  }
  /// The same for all partitions. If not all fit, each splits the faces with the largest errors.
  vtkIdType SplitTogether(const std::vector<AdaptiveMark<Id>>& marks, vtkIdType mostCells)
  {
    const AdaptiveSqrtThree<Id> before = *this->Mesh;
    if (!this->IsTooLarge(this->Shared->Split(marks, marks.size(), mostCells)))
    {
      return 0;
    }
    this->MemoryIsLimit = this->NumberOfCells <= this->Options.MaximumNumberOfCells;
    const auto fitsWith = [&](std::size_t count)
    {
      *this->Mesh = before;
      this->Shared->Restart();
      return !this->IsTooLarge(this->Shared->Split(marks, count, mostCells));
    };
    const std::size_t fits = FindFittingError(marks, *this->Others, fitsWith);
    fitsWith(fits);
    const auto left = std::count_if(marks.begin() + static_cast<std::ptrdiff_t>(fits), marks.end(),
      [this](const AdaptiveMark<Id>& mark)
      { return mark.Face < 0 || !this->Mesh->IsSplit(mark.Face); });
    return std::max<vtkIdType>(1, this->Others->Sum(left));
  }
  /// Whether all partitions together have too many cells, or one does not have the memory.
  bool IsTooLarge(bool fits)
  {
    this->NumberOfCells = this->Others->Sum(this->Shared->CountOwnCells());
    return this->Others->Sum(fits ? 0 : 1) > 0 ||
      this->NumberOfCells > this->Options.MaximumNumberOfCells;
  }
  void WarnOfLeft(vtkIdType left, vtkIdType mostCells)
  {
    const vtkIdType most = this->Others
      ? this->Options.MaximumNumberOfCells
      : mostCells + static_cast<vtkIdType>(this->Cells.Vertices.size());
    this->Options.Warn(DescribeLeftOut(left, most, this->MemoryIsLimit));
  }
  void TellNotes(AdaptiveNotes& notes) const
  {
    NoteEdgesWithoutValue(
      notes.WithoutValue, this->Wanted.Attribute, "on the limit at or next to them", this->Options);
    if (notes.TooShort > 0)
    {
      this->Options.Warn(std::to_string(notes.TooShort) +
        " cells that the criteria ask for were not refined: they are so small that no number lies "
        "between the coordinates of their points. Use weaker criteria there.");
    }
  }

  /// For each segment, an input cell on it; -1: there is none.
  std::vector<vtkIdType> FindSegmentCells() const
  {
    std::vector<vtkIdType> cells(this->Mesh->GetNumberOfSegments(), -1);
    for (vtkIdType line = this->Control.Lines.size() - 1; line >= 0; --line)
    {
      const Id segment = this->Mesh->GetSegmentOfEdge(this->Control.Lines[line] / 2);
      cells[segment] = this->Cells.SegmentCells[line];
    }
    return cells;
  }
  void WriteCells(const AdaptiveSqrtThreeOutput<Id>& plan)
  {
    using Piece = typename AdaptiveSqrtThreeOutput<Id>::Piece;
    std::vector<Piece> pieces;
    std::vector<vtkIdType> lineCells;
    for (const vtkIdType line : InTurn(this->Control.Lines.size()))
    {
      plan.AppendPieces(this->Control.Lines[line], pieces);
      lineCells.resize(pieces.size(), this->Cells.SegmentCells[line]);
    }
    SurfaceLevel<Id> level;
    level.Mesh.Arity = 3;
    level.Mesh.NumberOfVertices = this->Mesh->GetNumberOfVertices();
    level.Mesh.NumberOfFaces = plan.GetNumberOfTriangles();
    level.Mesh.Vertices = Buffer<Id>(3 * level.Mesh.NumberOfFaces);
    level.Mesh.EdgeVertices = Buffer<Id>(static_cast<vtkIdType>(2 * pieces.size()));
    level.Lines = Buffer<Id>(static_cast<vtkIdType>(pieces.size()));
    const vtkIdType points = static_cast<vtkIdType>(this->Cells.Vertices.size());
    const vtkIdType before = points + level.Lines.size();
    vtkNew<vtkUnsignedCharArray> generations;
    generations->SetName(GenerationName);
    Allocate(generations, 1, before + level.Mesh.NumberOfFaces);
    vtkNew<vtkIdTypeArray> ids;
    Allocate(ids, 1, before + level.Mesh.NumberOfFaces);
    vtkIdType* sources = ids->GetPointer(0);
    unsigned char* generation = generations->GetPointer(0);
    std::copy(this->Cells.VertexCells.begin(), this->Cells.VertexCells.end(), sources);
    std::fill(generation, generation + points, static_cast<unsigned char>(0));
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      level.Lines[i] = static_cast<Id>(2 * i);
      std::copy_n(pieces[i].Ends, 2, level.Mesh.EdgeVertices.data() + 2 * i);
      generation[points + i] = static_cast<unsigned char>(pieces[i].Generation);
      sources[points + i] = lineCells[i];
    }
    plan.WriteTriangles(level.Mesh.Vertices.data(), generation + before, sources + before);
    ForEach(level.Mesh.NumberOfFaces,
      [&](vtkIdType i) { sources[before + i] = this->Cells.FaceCells[sources[before + i]]; });
    WriteSurfaceCells(level, this->Cells.Vertices, this->Options.Use32BitIds, this->Output);
    ids->SetName(OriginalCellIdsName);
    CellArrayOptions options;
    options.PointsMove = true;
    options.OriginalIds = this->Options.GenerateOriginalIds; // global ids are copied then, too
    options.Replaced = { OriginalCellIdsName };
    options.Warn = this->Options.Warn;
    CopyCellArrays(this->Input, ids, options, this->Output);
    AddInstead(this->Input->GetCellData(), ids, this->Output->GetCellData());
    AddInstead(this->Input->GetCellData(), generations, this->Output->GetCellData());
  }
  Buffer<unsigned char> FindTurned() const
  {
    const PolygonMesh<Id>& mesh = this->Control.Mesh;
    return this->Others ? FindTurnedOfPart(mesh,
                            MakeControlKeys(this->Input, this->Cells, *this->Others), *this->Others)
                        : FindTurnedFaces(mesh);
  }
  void WritePoints(const AdaptiveSqrtThreeOutput<Id>& plan)
  {
    const vtkIdType given = this->Mesh->GetNumberOfControlVertices();
    const vtkIdType size = this->Mesh->GetNumberOfVertices();
    Buffer<Id> origins(size - given);
    auto origin = [&](vtkIdType point)
    { return point < given ? point : static_cast<vtkIdType>(origins[point - given]); };
    for (vtkIdType v = given; v < size; ++v)
    {
      origins[v - given] = static_cast<Id>(origin(this->Mesh->FindFirstParent(
        static_cast<Id>(v), [this](Id a, Id b) { return this->Points->IsEarlier(a, b); })));
    }
    const AdaptiveSqrtThreeLimit<Id> limit(*this->Rows, plan.GetVertexLevels());
    const bool wantsFrames = this->Options.HasFrames();
    const Buffer<unsigned char> turned = wantsFrames ? this->FindTurned() : Buffer<unsigned char>();
    TangentPairs tangents(wantsFrames ? limit.GetNumberOfRows() : 0);
    if (wantsFrames)
    {
      Buffer<double> points(3 * given);
      std::copy_n(this->Points->GetCoordinates().Values, points.size(), points.begin());
      limit.FindTangents(points, tangents);
      TurnTangents(
        turned, [this](vtkIdType v) { return this->Rows->FindFaceOfTangents(static_cast<Id>(v)); },
        tangents);
      if (this->Options.GenerateLimitNormals)
      {
        FindNormals(*this->Scheme, this->Control, {}, turned, points.data(), tangents);
      }
    }
    this->Points->Advance(limit, origin);
    if (this->Options.GenerateLimitNormals)
    {
      this->Points->SetLimitNormals(tangents.Normals);
    }
    if (this->Options.GenerateTangents)
    {
      this->Points->SetLimitTangents(tangents.Values);
    }
    this->Points->Finish(this->Output);
  }

  vtkPolyData* Input;
  const SurfaceOptions& Options;
  RefinementOptions& Wanted;
  const SurfaceCells& Cells;
  OtherPartitions* Others; ///< null: the input is the whole surface
  vtkPolyData* Output;
  std::shared_ptr<const SurfaceScheme<Id>> Scheme;
  SimplicesOfCells NoCentres;
  std::vector<vtkIdType> GlobalIds;
  std::unique_ptr<PointArrays> Points;
  SurfaceLevel<Id> Control;
  std::unique_ptr<AdaptiveSqrtThree<Id>> Mesh;
  std::unique_ptr<AdaptiveSqrtThreeRows<Id>> Rows;
  std::unique_ptr<SharedFaces<Id>> Shared; ///< null: the input is the whole surface
  vtkIdType NumberOfCells = 0;             ///< of all partitions, when IsTooLarge was called
  bool MemoryIsLimit = false;
};

/// How many cells the output may have: by the option, by MaximumLevel, and by the memory that there
/// is.
/// Of a partition, copies included: the option holds for all partitions together.
double FindMostCells(vtkPolyData* input, const SurfaceCells& cells, const SurfaceOptions& options,
  int maximumLevel, bool isPartition, bool& memoryIsLimit)
{
  // Connectivity and offset, faces of all levels, values and limits; a point for two cells.
  // A partition keeps the faces of the round before.
  const double perCell = 32. + (isPartition ? 2. : 1.) * 75. + 165. +
    GetBytesPerTuple(input->GetCellData()) +
    (24. + 3. * GetBytesPerTuple(input->GetPointData())) / 2.;
  const double fitting = GetAvailableMemory() / perCell;
  const auto given = static_cast<double>(cells.FaceCells.size() + cells.SegmentCells.size());
  KeepEstimate(given * perCell); // how many there will be is not known before
  const double allowed =
    static_cast<double>(options.MaximumNumberOfCells) - static_cast<double>(cells.Vertices.size());
  const double possible = given * std::pow(3., maximumLevel);
  const double wanted = isPartition ? possible : std::min(allowed, possible);
  memoryIsLimit = fitting < wanted;
  return std::min(fitting, wanted);
}

}

bool RefineSurface(vtkPolyData* input, const SurfaceOptions& options,
  const RefinementOptions& criteria, vtkPolyData* output)
{
  OtherPartitions* others = options.Others;
  RefinementOptions own = criteria;
  if (others)
  {
    own.FindLargest = [others](std::vector<double>& values) { others->FindLargest(values); };
  }
  vtkIdTypeArray* ids = vtkIdTypeArray::SafeDownCast(input->GetPointData()->GetGlobalIds());
  const bool hasIds = ids && ids->GetNumberOfTuples() == input->GetNumberOfPoints();
  const SurfaceCells cells = ReadSurfaceCells(input, true, hasIds ? ids->GetPointer(0) : nullptr);
  for (const std::string& warning : cells.Warnings)
  {
    options.Warn(warning);
  }
  WarnOfUnused(*MakeSurfaceScheme<int>(options.Scheme, true), options);
  const auto given = static_cast<double>(cells.FaceCells.size() + cells.SegmentCells.size());
  bool memoryIsLimit = false;
  const double most =
    FindMostCells(input, cells, options, criteria.MaximumLevel, others != nullptr, memoryIsLimit);
  if (given > most && memoryIsLimit)
  {
    options.Fail("There is not enough memory for the " +
      std::to_string(static_cast<vtkIdType>(given)) +
      " cells of the input. Use a part of the input.");
    return false;
  }
  if (given > most)
  {
    options.Warn(TooManyGiven);
  }
  const double points = static_cast<double>(cells.NumberOfPoints);
  const bool isLarge = 6. * (std::max(most, given) + points) > static_cast<double>(LargestSmallId);
  return isLarge
    ? AdaptiveRun<long long>(input, options, own, cells, others, output).Run(most, memoryIsLimit)
    : AdaptiveRun<int>(input, options, own, cells, others, output).Run(most, memoryIsLimit);
}

}
