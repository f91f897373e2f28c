// SPDX-License-Identifier: BSD-3-Clause
#include "UniformSubdivision.h"

#include "CellArrays.h"
#include "Core/TetOrder.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include "vtksys/SystemInformation.hxx"

#include <cmath>
#include <limits>
#include <sstream>

namespace subdivision
{
namespace
{

constexpr const char* RuleName = "RuleDimension";
constexpr const char* TypeName = "NonManifoldType";
constexpr const char* DimensionName = "ManifoldDimension";
constexpr const char* GlobalIdsName = "SubdivisionGlobalIds";

/// What is to be subdivided, whatever it was read from.
struct ControlMesh
{
  SimplicesOfCells Cells; ///< the input's simplices
  SimplexList Simplices;  ///< those of the control mesh; only where MadeLevels > 0
  int MadeLevels = 0;     ///< steps that earlier filters made
  vtkSmartPointer<vtkDataArray> GlobalIdArray; ///< of the control points
  std::vector<vtkIdType> GlobalIds;

  const SimplexList& GetControl() const
  {
    return this->MadeLevels > 0 ? this->Simplices : this->Cells.Simplices;
  }
  const vtkIdType* GetGlobalIds() const
  {
    return this->GlobalIds.empty() ? nullptr : this->GlobalIds.data();
  }
};

class UniformRun
{
public:
  UniformRun(vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output)
    : Input(input)
    , Options(options)
    , Output(output)
  {
  }
  bool Run();

private:
  bool ReadInput(bool mayBeOurs);
  void ReadGlobalIds(vtkDataArray* ids);
  bool CheckNumberOfCells();
  bool CheckMemory(const LevelCounts& counts, double bytesPerPoint);
  bool NeedsLargeIds() const;
  bool ReportProgress(double done) const
  {
    return this->Options.Progress && this->Options.Progress(done);
  }

  enum class Outcome
  {
    Done,
    Stopped,
    NotOurs ///< the stamp fits, the cells do not
  };
  template <typename Id>
  Outcome RunWith();
  template <typename Id>
  bool BuildCurrent(Level<Id>& level);
  template <typename Id>
  bool IsWhatWasRead(const SimplicialComplex<Id>& complex) const;
  template <typename Id>
  Outcome Step(Level<Id>& level);
  template <typename Id, typename Write>
  void MakeCells(const std::vector<CellRun>& runs, const Write& write);
  void Finish();
  void AddClassification(const Buffer<Stratum>& vertices, const Buffer<Stratum>& edges);

  vtkPointSet* Input;
  const UniformOptions& Options;
  vtkUnstructuredGrid* Output;
  Stamp InputStamp;
  ControlMesh Mesh;
  std::unique_ptr<PointArrays> Points;
  std::vector<CellRun> Runs; ///< of the current level
  Buffer<unsigned char> ManifoldDimensions;
};

/// The smallest of Levels steps' outputs is known before anything is built: the number of cells.
bool UniformRun::CheckNumberOfCells()
{
  double cells = 0.;
  for (unsigned char dimension : this->Mesh.Cells.Simplices.Dimensions)
  {
    cells += std::ldexp(1., dimension * this->Options.Levels);
  }
  if (cells <= static_cast<double>(this->Options.MaximumNumberOfCells))
  {
    return true;
  }
  std::ostringstream message;
  message << "NumberOfLevels = " << this->Options.Levels << " would make "
          << static_cast<vtkIdType>(std::min(cells, 9e18)) << " cells (about "
          << static_cast<vtkIdType>(std::min(cells * 41. / 1e6, 9e18))
          << " MB for the cells alone), which is above MaximumNumberOfCells = "
          << this->Options.MaximumNumberOfCells
          << ". Use fewer levels, or raise MaximumNumberOfCells.";
  this->Options.Fail(message.str());
  return false;
}

/// Estimates the peak: the output, and what the last step needs beside it.
bool UniformRun::CheckMemory(const LevelCounts& counts, double bytesPerPoint)
{
  LevelCounts last = counts;
  for (int i = 1; i < this->Options.Levels; ++i)
  {
    last = last.Refine();
  }
  const double points = last.Vertices + (this->Options.Levels > 0 ? last.Edges : 0.);
  const CellCounts cells = CountCells(RefineRuns(this->Runs, this->Options.Levels));
  double bytes = 8. * (static_cast<double>(cells.Entries) + static_cast<double>(cells.Cells)) +
    static_cast<double>(cells.Cells) + bytesPerPoint * (points + last.Vertices);
  for (int i = 0; i < this->Input->GetCellData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = this->Input->GetCellData()->GetAbstractArray(i);
    bytes +=
      static_cast<double>(cells.Cells) * array->GetDataTypeSize() * array->GetNumberOfComponents();
  }
  const double idBytes = this->NeedsLargeIds() ? 8. : 4.;
  bytes += idBytes * (10. * last.Tets + 13. * last.Edges);
  vtksys::SystemInformation system;
  const double available = 1024. *
    (static_cast<double>(system.GetHostMemoryAvailable()) -
      static_cast<double>(system.GetHostMemoryUsed()));
  if (available <= 0. || bytes <= available)
  {
    return true;
  }
  std::ostringstream message;
  message << "NumberOfLevels = " << this->Options.Levels << " would make " << cells.Cells
          << " cells and " << static_cast<vtkIdType>(points) << " points, which takes about "
          << static_cast<vtkIdType>(bytes / 1e6) << " MB; "
          << static_cast<vtkIdType>(available / 1e6)
          << " MB are available. Use fewer levels, or a part of the input.";
  this->Options.Fail(message.str());
  return false;
}

bool UniformRun::NeedsLargeIds() const
{
  double perDimension[4] = { 0., 0., 0., 0. };
  for (unsigned char dimension : this->Mesh.GetControl().Dimensions)
  {
    ++perDimension[dimension];
  }
  LevelCounts counts;
  counts.Vertices = static_cast<double>(this->Mesh.GetControl().NumberOfPoints);
  counts.Tets = perDimension[3];
  counts.Faces = perDimension[2] + 4. * counts.Tets;
  counts.Edges = perDimension[1] + 3. * counts.Faces;
  double largest = std::max(4. * counts.Faces, 2. * counts.Edges);
  for (int i = 0; i < this->Mesh.MadeLevels + this->Options.Levels; ++i)
  {
    largest = std::max({ largest, 3. * counts.Faces, 2. * counts.Edges, 8. * counts.Tets });
    counts = counts.Refine();
    largest = std::max(largest, counts.Vertices);
  }
  return largest > static_cast<double>(std::numeric_limits<int>::max());
}

void UniformRun::ReadGlobalIds(vtkDataArray* ids)
{
  this->Mesh.GlobalIdArray = ids;
  this->Mesh.GlobalIds.clear();
  if (ids)
  {
    this->Mesh.GlobalIds.resize(ids->GetNumberOfTuples());
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      vtkIdTypeArray* exact = vtkIdTypeArray::SafeDownCast(ids);
      this->Mesh.GlobalIds[i] =
        exact ? exact->GetValue(i) : static_cast<vtkIdType>(ids->GetComponent(i, 0));
    }
  }
}

/// Reads the cells; `mayBeOurs`: looks for a stamp, and for the control mesh behind it.
bool UniformRun::ReadInput(bool mayBeOurs)
{
  this->Mesh = ControlMesh();
  this->InputStamp = Stamp();
  const bool stamped = mayBeOurs && ReadStamp(this->Input, this->InputStamp);
  vtkDataArray* carried = this->Input->GetFieldData()->GetArray(GlobalIdsName);
  vtkDataArray* own = this->Input->GetPointData()->GetGlobalIds();
  this->ReadGlobalIds(stamped && carried ? carried : own);
  this->Mesh.Cells =
    CellsToSimplices(this->Input, stamped || !own ? nullptr : this->Mesh.GetGlobalIds());
  if (!stamped)
  {
    return true;
  }
  const bool whole = this->Mesh.Cells.ParentCells.empty() && this->Mesh.Cells.Warnings.empty() &&
    this->Mesh.Cells.Simplices.GetNumberOfSimplices() == this->Input->GetNumberOfCells();
  if (!whole)
  {
    return false;
  }
  if (this->InputStamp.Levels > 0)
  {
    this->Mesh.MadeLevels = this->InputStamp.Levels;
    return FindControlMesh(this->Mesh.Cells.Simplices, this->InputStamp, this->Mesh.Simplices);
  }
  return true;
}

bool UniformRun::Run()
{
  const bool ours = this->ReadInput(true);
  if (!ours)
  {
    this->ReadInput(false);
  }
  for (const std::string& warning : this->Mesh.Cells.Warnings)
  {
    this->Options.Warn(warning);
  }
  if (!this->CheckNumberOfCells())
  {
    return false;
  }
  Outcome outcome = this->NeedsLargeIds() ? this->RunWith<long long>() : this->RunWith<int>();
  if (outcome == Outcome::NotOurs)
  {
    this->ReadInput(false);
    outcome = this->NeedsLargeIds() ? this->RunWith<long long>() : this->RunWith<int>();
  }
  return outcome == Outcome::Done;
}

/// The current level: the control mesh, and the steps that earlier filters made. False if these do
/// not lead to the cells that were read.
template <typename Id>
bool UniformRun::BuildCurrent(Level<Id>& level)
{
  const int made = this->Mesh.MadeLevels;
  level.Complex = BuildComplex<Id>(this->Mesh.GetControl(), this->Runs);
  if (this->Options.GenerateClassification)
  {
    this->ManifoldDimensions = FindManifoldDimensions(level.Complex, this->Runs);
  }
  level.Strata = BuildStrata(level.Complex, SingularSimplices(), StrataOptions());
  for (int i = 0; i < made; ++i)
  {
    const bool last = i + 1 == made && this->Options.Levels < 2;
    level = Refine(level, last ? Depth::ForOutput : Depth::ForRefinement);
  }
  this->Runs = RefineRuns(this->Runs, made);
  return made == 0 || this->IsWhatWasRead(level.Complex);
}

template <typename Id>
bool UniformRun::IsWhatWasRead(const SimplicialComplex<Id>& complex) const
{
  const CellCounts counts = CountCells(this->Runs);
  const SimplexList& read = this->Mesh.Cells.Simplices;
  if (counts.Cells != read.GetNumberOfSimplices() ||
    complex.NumberOfVertices != read.NumberOfPoints)
  {
    return false;
  }
  Buffer<long long> connectivity(counts.Entries);
  Buffer<long long> offsets(counts.Cells + 1);
  Buffer<unsigned char> types(counts.Cells);
  WriteCells(complex, this->Runs,
    CellStorage<long long>{ connectivity.data(), offsets.data(), types.data() });
  return std::equal(connectivity.begin(), connectivity.end(), read.Connectivity.begin());
}

template <typename Id>
UniformRun::Outcome UniformRun::RunWith()
{
  PointArrayOptions arrays;
  arrays.InterpolateIntegers = this->Options.InterpolateIntegers;
  arrays.OriginalIds = this->Options.GenerateOriginalIds;
  arrays.CarryOriginalIds = this->InputStamp.NumberOfControlPoints > 0 &&
    this->Input->GetPointData()->GetArray("vtkOriginalPointIds");
  arrays.Precision = this->Options.OutputPointsPrecision;
  if (arrays.OriginalIds)
  {
    arrays.Replaced.emplace_back("vtkOriginalPointIds");
  }
  if (this->Options.GenerateClassification)
  {
    arrays.Replaced.insert(arrays.Replaced.end(), { RuleName, TypeName });
  }
  this->Points = std::make_unique<PointArrays>(this->Input, this->Mesh.Cells,
    this->Mesh.GetGlobalIds(), static_cast<vtkIdType>(this->Mesh.GlobalIds.size()), arrays);
  if (this->InputStamp.NumberOfControlPoints == 0)
  {
    OrderTets(
      this->Mesh.Cells.Simplices, this->Points->GetCoordinates(), this->Mesh.GetGlobalIds());
  }
  Level<Id> level;
  if (!this->BuildCurrent(level))
  {
    return Outcome::NotOurs;
  }
  const auto& complex = level.Complex;
  const LevelCounts counts{ static_cast<double>(complex.NumberOfVertices),
    static_cast<double>(complex.NumberOfEdges), static_cast<double>(complex.NumberOfFaces),
    static_cast<double>(complex.NumberOfTets) };
  if (!this->CheckMemory(counts, this->Points->GetBytesPerPoint()))
  {
    return Outcome::Stopped;
  }
  const Outcome outcome = this->Step(level);
  if (outcome == Outcome::Done)
  {
    this->Finish();
  }
  return outcome;
}

/// The steps themselves. At most two levels are alive at a time, and of the last one only its cells
/// are ever made.
template <typename Id>
UniformRun::Outcome UniformRun::Step(Level<Id>& level)
{
  const int steps = this->Options.Levels;
  if (steps == 0)
  {
    this->MakeCells<Id>(
      this->Runs, [&](const auto& out) { WriteCells(level.Complex, this->Runs, out); });
    this->Points->Finish(this->Output);
    this->AddClassification(level.Strata.Vertices, Buffer<Stratum>());
    return Outcome::Done;
  }
  for (int step = 0; step < steps; ++step)
  {
    if (this->ReportProgress((step + 1.) / (steps + 1.)))
    {
      return Outcome::Stopped;
    }
    const bool last = step + 1 == steps;
    Level<Id> next;
    if (last)
    {
      this->MakeCells<Id>(RefineRuns(this->Runs, 1),
        [&](const auto& out) { WriteChildren(level.Complex, this->Runs, out); });
    }
    else
    {
      next = Refine(level, step + 2 == steps ? Depth::ForOutput : Depth::ForRefinement);
      this->Runs = RefineRuns(this->Runs, 1);
    }
    const Stencils<Id> stencils = TakeStencils(level);
    level = std::move(next);
    this->Points->Advance(stencils);
    if (last)
    {
      this->Points->Finish(this->Output);
      this->AddClassification(stencils.Vertices, stencils.Edges);
    }
  }
  return Outcome::Done;
}

/// Allocates the output's cells and has them written.
template <typename Id, typename Write>
void UniformRun::MakeCells(const std::vector<CellRun>& runs, const Write& write)
{
  const CellCounts counts = CountCells(runs);
  const auto connectivity = MakeArray(VTK_ID_TYPE, 1, counts.Entries);
  const auto offsets = MakeArray(VTK_ID_TYPE, 1, counts.Cells + 1);
  const auto types = MakeArray(VTK_UNSIGNED_CHAR, 1, counts.Cells);
  auto pointer = [](vtkDataArray* array)
  { return array->GetNumberOfValues() > 0 ? array->GetVoidPointer(0) : nullptr; };
  write(CellStorage<long long>{ static_cast<long long*>(pointer(connectivity)),
    static_cast<long long*>(pointer(offsets)), static_cast<unsigned char*>(pointer(types)) });
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  this->Output->SetCells(vtkUnsignedCharArray::SafeDownCast(types), cells);
}

/// Cell data, ghosts and the stamp.
void UniformRun::Finish()
{
  CellArrayOptions cells;
  cells.Levels = this->Options.Levels;
  cells.OriginalIds = this->Options.GenerateOriginalIds;
  cells.CarryOriginalIds = this->InputStamp.NumberOfControlPoints > 0 &&
    this->Input->GetCellData()->GetArray("vtkOriginalCellIds");
  if (cells.OriginalIds && !cells.CarryOriginalIds)
  {
    cells.Replaced.emplace_back("vtkOriginalCellIds");
  }
  if (this->Options.GenerateClassification)
  {
    cells.Replaced.emplace_back(DimensionName);
  }
  CopyCellArrays(this->Input, this->Mesh.Cells, cells, this->Output);
  if (this->Options.GenerateClassification)
  {
    AddValuesOfSimplices(this->ManifoldDimensions.data(), this->Mesh.GetControl(),
      this->Mesh.MadeLevels + this->Options.Levels, DimensionName, this->Output);
  }
  RebuildPointGhosts(this->Input, this->Output);

  Stamp stamp;
  stamp.Levels = this->Mesh.MadeLevels + this->Options.Levels;
  stamp.NumberOfControlPoints = this->Mesh.GetControl().NumberOfPoints;
  WriteStamp(stamp, this->Output);
  this->Output->GetFieldData()->RemoveArray(GlobalIdsName);
  if (!this->Mesh.GlobalIds.empty())
  {
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName(GlobalIdsName);
    ids->SetNumberOfTuples(static_cast<vtkIdType>(this->Mesh.GlobalIds.size()));
    std::copy(this->Mesh.GlobalIds.begin(), this->Mesh.GlobalIds.end(), ids->GetPointer(0));
    this->Output->GetFieldData()->AddArray(ids);
  }
}

void UniformRun::AddClassification(const Buffer<Stratum>& vertices, const Buffer<Stratum>& edges)
{
  if (!this->Options.GenerateClassification)
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> rules;
  vtkNew<vtkUnsignedCharArray> types;
  rules->SetName(RuleName);
  types->SetName(TypeName);
  const vtkIdType size = vertices.size() + edges.size();
  rules->SetNumberOfTuples(size);
  types->SetNumberOfTuples(size);
  ForEach(size,
    [&](vtkIdType i)
    {
      const Stratum stratum = i < vertices.size() ? vertices[i] : edges[i - vertices.size()];
      const bool regular = stratum.GetRule() == Rule::RegularEdge;
      rules->SetValue(i, static_cast<unsigned char>(regular ? Rule::Solid : stratum.GetRule()));
      types->SetValue(i, static_cast<unsigned char>(stratum.GetType()));
    });
  this->Output->GetPointData()->AddArray(rules);
  this->Output->GetPointData()->AddArray(types);
}

}

bool SubdivideUniformly(
  vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output)
{
  return UniformRun(input, options, output).Run();
}

}
