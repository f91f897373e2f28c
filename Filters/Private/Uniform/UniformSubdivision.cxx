// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/UniformRun.h"

#include "Core/Memory/CellSplits.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Complex/TetOrder.h"
#include "Core/Solids/Strata/SharpSkin.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/CellArrays.h"
#include "Private/Reading/SolidOrientation.h"
#include "Private/Run/SizeChecks.h"
#include "Private/Run/StampFields.h"
#include "Private/Values/SharedInterpolation.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace subdivision
{

bool UniformRun::Run()
{
  this->Others = this->Options.Others;
  if (!this->Plan())
  {
    return false;
  }
  this->NumberControl();
  this->FindTurned();
  if (!this->Execute())
  {
    return false;
  }
  this->Write();
  this->FindFactors();
  this->Keep();
  return true;
}

// ------------------------------------------------------------------------------------------------
// Planning

/// Reads the input, decides whether its stamp is true, and checks sizes. Tells the warnings of all
/// that. Returns false after an error.
bool UniformRun::Plan()
{
  this->Read(true);
  const std::string tooMany = CheckNumberOfCells(
    this->Mesh.Cells.Simplices, this->Options.Levels, this->Options.MaximumNumberOfCells);
  if (!tooMany.empty())
  {
    Tell(this->Mesh.Warnings, this->Options);
    this->Options.Fail(tooMany);
    return false;
  }
  this->StartPoints();
  if (!this->FindKeptOrBuild()) // the stamp is wrong
  {
    this->Read(false);
    this->StartPoints();
    this->FindKeptOrBuild();
  }
  Tell(this->Mesh.Warnings, this->Options);
  for (const std::string& warning : this->Found ? this->Found->Warnings : this->BuildWarnings)
  {
    this->Options.Warn(warning);
  }
  this->DecideNormals();
  std::string tooLarge = this->Found ? std::string() : this->CheckLevels();
  if (!tooLarge.empty() && this->Options.NormalsWhereSmooth)
  {
    this->Options.GenerateLimitNormals = false;
    tooLarge = this->CheckLevels();
  }
  if (!tooLarge.empty())
  {
    this->Options.Fail(tooLarge);
  }
  return tooLarge.empty();
}

/// Decides whether there are normals, where they are wanted for a picture alone.
void UniformRun::DecideNormals()
{
  if (this->Options.NormalsWhereSmooth)
  {
    this->Options.GenerateLimitNormals =
      this->Found ? this->Found->HasNormals : !this->IsNarrow && this->LooksSmooth();
  }
}

/// Whether normals make no picture worse.
bool UniformRun::LooksSmooth()
{
  const std::vector<unsigned char>& dimensions = this->Mesh.Cells.Simplices.Dimensions;
  const auto isOther = [&dimensions](unsigned char dimension)
  { return dimension != dimensions[0]; };
  if (dimensions.empty() || dimensions[0] < 2 ||
    std::any_of(dimensions.begin(), dimensions.end(), isOther) ||
    IsSharpAfter(this->Control.Sharpness, this->Options.Levels))
  {
    return false;
  }
  return std::visit(
    [this, &dimensions](const auto& level)
    {
      const auto& complex = level.Complex;
      const auto& strata = level.Strata;
      std::vector<unsigned char> faces; // at each edge of a surface
      if (dimensions[0] == 2)
      {
        faces.resize(static_cast<std::size_t>(complex.NumberOfEdges), 0);
        for (const auto edge : InTurn(complex.FaceEdges))
        {
          faces[edge] = static_cast<unsigned char>(std::min(faces[edge] + 1, 2));
        }
      }
      if (HasSharpSkin(
            complex.EdgeVertices, complex.NumberOfVertices,
            [&strata](auto vertex) { return strata.Vertices[vertex]; },
            [&strata](auto edge) { return strata.Edges[edge]; },
            [&faces](auto edge) { return !faces.empty() && faces[edge] == 1; }))
      {
        return false;
      }
      if (dimensions[0] == 2)
      {
        this->Sides = FindTriangleSides(level, {});
      }
      const std::vector<unsigned char>& twisted = this->Sides.Twisted;
      return std::find(twisted.begin(), twisted.end(), 1) == twisted.end();
    },
    this->Current);
}

/// Checks whether there is memory for the levels. Returns a text if there is not.
std::string UniformRun::CheckLevels() const
{
  return std::visit(
    [this](const auto& level)
    {
      using Scheme = SchemeOf<std::decay_t<decltype(level)>>;
      return this->CheckLevels(this->IsNarrow
          ? CountSimplices(this->Split.Simplices, Scheme::Traits)
          : CountSimplices<Scheme>(level),
        sizeof(typename Scheme::Id));
    },
    this->Current);
}

/// Reads the control mesh.
void UniformRun::Read(bool trustStamp)
{
  this->Mesh =
    ReadControlMesh(this->Input, trustStamp, this->Options.Features, this->Options.Scheme);
  if (this->Mesh.IsOfOtherScheme)
  {
    this->Mesh.Warnings.emplace_back(
      "An earlier filter made the input with another VolumeScheme. This filter takes it as any "
      "other mesh: it looks for features again, and octahedra are four tetrahedra each.");
  }
}

/// Starts points and arrays, and does all that needs coordinates of the control mesh.
void UniformRun::StartPoints()
{
  std::vector<std::string> replaced;
  if (this->Options.GenerateClassification)
  {
    replaced = { RuleName, TypeName };
  }
  this->Points = StartPointArrays(
    this->Options, this->Input, this->Mesh.Cells, this->Mesh.GlobalIds, this->Mesh.IsStamped,
    [this](const std::string& warning) { this->Mesh.Warnings.push_back(warning); }, replaced);
  this->Points->KeepColours(this->FindControlColours());
  this->FindWanted();
  if (this->Mesh.MadeLevels == 0)
  {
    this->Mesh.Inverted =
      FindInvertedTets(this->Mesh.Cells.Simplices, this->Points->GetCoordinates());
  }
  if (!this->Mesh.IsStamped && this->GetScheme().OrdersTets)
  {
    OrderTets(this->Mesh.Cells.Simplices, this->Points->GetCoordinates(), this->Mesh.GetGlobalIds(),
      static_cast<vtkIdType>(this->Mesh.GlobalIds.size()));
  }
  this->IsNarrow = this->FindSplit();
}

/// Finds the kept operator of this mesh, or builds the current level. Returns false if the stamp is
/// wrong.
bool UniformRun::FindKeptOrBuild()
{
  if (this->Options.Cache)
  {
    this->Key = this->MakeKey();
    this->Found = this->FindKept(this->Key);
  }
  return this->Found || this->Build();
}

bool UniformRun::Build()
{
  const bool further = this->Options.ReadsLimit() || this->Interpolates();
  // The rings of the level that is read are made without a step, too.
  const int levels = std::max(1, this->Options.Levels + (further ? 1 : 0));
  const bool hasSmallLevels =
    this->IsNarrow && !this->Options.Features.Sharpness && !this->Mesh.IsStamped;
  const bool large = hasSmallLevels // one level more: with the surroundings
    ? NeedsLargeIds(this->Mesh.GetControl(), 2, this->GetScheme()) ||
      NeedsLargeIds(this->Split.Simplices, this->GetLastSteps() + 2, this->GetScheme())
    : NeedsLargeIds(this->Mesh.GetControl(), this->Mesh.MadeLevels + levels, this->GetScheme());
  const bool isTrue = large ? this->BuildLevel<long long>() : this->BuildLevel<int>();
  if (isTrue && this->IsNarrow && !this->IsLocal())
  {
    this->IsNarrow = false;
    this->BuildWarnings.clear();
    return this->Build();
  }
  return isTrue;
}

int UniformRun::GetLastSteps() const
{
  return this->Options.Levels -
    (this->IsNarrow ? static_cast<int>(this->Options.Splits->Flags.size()) : 0);
}

const SchemeTraits& UniformRun::GetScheme() const
{
  return *FindSchemeTraits(static_cast<int>(this->Options.Scheme));
}

/// Finds the scheme by its number.
template <typename Id>
bool UniformRun::BuildLevel()
{
  ControlComplex<Id> control;
  const bool further =
    this->Options.Levels > 1 || this->Options.ReadsLimit() || this->Interpolates();
  bool isTrue = false;
  ForVolumeSchemes<Id>(
    [&](auto scheme)
    {
      using Scheme = decltype(scheme);
      if (Scheme::Traits.Number == this->GetScheme().Number)
      {
        isTrue = BuildControlComplex<Scheme>(
          this->Mesh, this->Options.Features, this->Points->GetCoordinates(),
          [this](const std::string& warning) { this->BuildWarnings.push_back(warning); },
          further ? Depth::ForRefinement : Depth::ForOutput, control,
          this->Current.template emplace<typename Scheme::Level>());
      }
    });
  this->Control = std::move(static_cast<ControlTraits&>(control));
  return isTrue;
}

/// Whether the rings of the level before the last one tell limits (RegularLimits.h), unless normals
/// need the last level. Points of the linear scheme are on the limit.
bool UniformRun::ReadsRings(bool hasSolids) const
{
  return this->Options.ProjectToLimit && this->Options.Scheme != StampScheme::Linear &&
    this->Options.Levels > (hasSolids ? 1 : 0) && !this->IsNarrow && !this->Points->HasWeights() &&
    !IsSharpAfter(this->Control.Sharpness, this->Options.Levels);
}

std::string UniformRun::CheckLevels(const LevelCounts& counts, double bytesPerId) const
{
  SizeEstimate estimate;
  estimate.Control = counts;
  estimate.Levels = this->GetLastSteps();
  estimate.Runs = this->CountWanted();
  estimate.BytesPerPoint = this->Points->GetBytesPerPoint();
  estimate.BytesPerCell = GetBytesPerTuple(this->Input->GetCellData());
  estimate.BytesPerId = bytesPerId;
  // Normals and limits mostly need no last level (PlanLimit).
  estimate.ProjectsByRings =
    !this->MakesLast && this->ReadsRings(counts.Tets + counts.Octahedra > 0.);
  estimate.KeepsRows = this->Options.Cache || this->Options.Factors;
  const bool takesSkin =
    !this->MakesLast && (!this->Options.ProjectToLimit || estimate.ProjectsByRings);
  estimate.Projects = this->Options.ReadsLimit() && !takesSkin;
  estimate.Frames =
    (this->Options.GenerateLimitNormals ? 1 : 0) + (this->Options.GenerateTangents ? 2 : 0);
  return CheckMemory(estimate);
}

// ------------------------------------------------------------------------------------------------
// Output

/// Writes cell data, ghost types and the stamp.
void UniformRun::Write()
{
  this->LeaveWanted();
  if (this->IsNarrow)
  {
    this->Options.Splits->Made.assign(this->Split.ParentCells.size(), 1);
    this->Mesh.Cells = std::move(this->Split);
  }
  CellArrayOptions cells;
  cells.Levels = this->GetLastSteps();
  cells.PointsMove = this->Options.MovesPoints();
  cells.OriginalIds = this->Options.GenerateOriginalIds;
  cells.CarryOriginalIds = this->Mesh.IsStamped &&
    HasIds(this->Input->GetCellData(), OriginalCellIdsName, this->Input->GetNumberOfCells());
  if (this->Cells.Octahedra)
  {
    cells.Replaced.emplace_back(this->Cells.Octahedra->GetName());
  }
  cells.Warn = this->Options.Warn;
  if (this->Options.GenerateClassification)
  {
    cells.Replaced.emplace_back(DimensionName);
    cells.Replaced.emplace_back(InvertedName);
  }
  CopyCellArrays(this->Input, this->Mesh.Cells, this->Parents, cells, this->Output);
  if (this->Cells.Octahedra)
  {
    AddInstead(this->Input->GetCellData(), this->Cells.Octahedra, this->Output->GetCellData());
  }
  if (this->Options.GenerateClassification)
  {
    AddValuesOfSimplices(this->Control.ManifoldDimensions.data(), this->Mesh.GetControl(),
      this->Mesh.MadeLevels + this->Options.Levels, DimensionName, this->Input, this->Output);
  }
  if (!this->IsNarrow) // the whole, which was made before, told of all cells
  {
    this->CheckOrientation();
    TellOvershoot(*this->Points, this->Options, this->Output, this->Options.ProjectToLimit);
  }
  FinishArrays(this->Input, this->Options, this->Output);
  if (!this->IsNarrow)
  {
    this->WriteStamps();
  }
}

void FinishArrays(vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output)
{
  if (options.Features.Sharpness)
  {
    ReduceSharpness(options.Features.Sharpness->GetName(), options.Levels, output);
  }
  ClearMarks(options.Features.Marks, output);
  RebuildPointGhosts(input, output);
}

namespace
{

/// Whether cells keep their types: all partitions do the same.
bool KeepsTypes(vtkPointSet* input, const UniformOptions& options)
{
  if (!options.KeepsTypesIfPossible)
  {
    return options.KeepCellTypes;
  }
  const bool isWorthIt = HasUncutCells(input);
  return options.Others ? options.Others->Max(isWorthIt ? 1 : 0) > 0 : isWorthIt;
}

}

bool SubdivideUniformly(
  vtkPointSet* input, const UniformOptions& given, vtkUnstructuredGrid* output)
{
  UniformOptions options = given;
  options.Features.ModifiedBoundary =
    given.Features.ModifiedBoundary && given.Scheme != StampScheme::Linear; // whose points stay
  const bool keepsTypes = KeepsTypes(input, options);
  if (keepsTypes && !options.NeedsCuts)
  {
    return RefineKeepingTypes(input, options, output);
  }
  if (keepsTypes)
  {
    options.Warn(std::string(options.NeedsCuts) +
      " is not available with VolumeScheme = Hybrid. VolumeScheme = Automatic takes BoxSpline, "
      "which cuts all cells.");
  }
  if (options.Places)
  {
    return UniformRun(input, options, output).FindPlaces(*options.Places);
  }
  return UniformRun(input, options, output).Run();
}

bool FindUniformOperators(
  vtkPointSet* input, const UniformOptions& options, UniformOperators& operators)
{
  vtkNew<vtkUnstructuredGrid> scratch;
  return UniformRun(input, options, scratch).FindOperators(operators);
}

}
