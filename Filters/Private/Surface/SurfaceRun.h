// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceRun.h
 * One execution of vtkSurfaceSubdivision: from the cells that were read to the output.
 */
#ifndef SubdivisionObjects_SurfaceRun_h
#define SubdivisionObjects_SurfaceRun_h

#include "Core/Memory/CellSplits.h"
#include "Core/Operators/MatrixFactors.h"
#include "Core/Surfaces/Places/SurfacePlaces.h"
#include "Core/Surfaces/Scheme/SurfaceSides.h"
#include "Core/Surfaces/Steps/SurfaceSteps.h"
#include "Private/Arrays/PointArrays.h"
#include "Private/Control/Stamp.h"
#include "Private/Places/NearestPlaces.h"
#include "Private/Places/PlaceOutput.h"
#include "Private/Surface/PartsOfCells.h"
#include "Private/Surface/SurfaceCreases.h"
#include "Private/Surface/SurfaceFrames.h"
#include "Private/Surface/SurfaceNumbers.h"
#include "Private/Surface/SurfaceSeams.h"
#include "Private/Surface/SurfaceSearch.h"
#include "Private/Surface/SurfaceStamp.h"
#include "Private/Surface/SurfaceSubdivision.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace subdivision
{

/// Of the cell of a place.
struct PlaceOrigin
{
  vtkIdType Point = -1; ///< the nearest corner
  int Dimension = 0;
};

template <typename Id>
class SurfaceRun
{
public:
  SurfaceRun(vtkPolyData* input, const SurfaceOptions& options,
    std::shared_ptr<const SurfaceScheme<Id>> scheme, vtkPolyData* output)
    : Input(input)
    , Options(options)
    , Output(output)
    , Scheme(std::move(scheme))
  {
  }

  bool Run(SurfaceCells&& cells)
  {
    this->Cells = std::move(cells);
    if (!this->Plan() || !this->Execute())
    {
      return false;
    }
    this->Write();
    return true;
  }
  /// Finds the limit at places instead of making an output (SurfacePlaces.cxx).
  bool FindPlaces(SurfaceCells&& cells, const PlaceRequest& request);
  /// Makes the levels, without an output; `first` is the one of the cells. Null after an error
  /// (passed to Fail) or if Progress asks to stop.
  const SurfaceSteps<Id>* MakeLevels(SurfaceCells&& cells, int& first)
  {
    this->Cells = std::move(cells);
    const bool isMade = this->Plan();
    first = this->MadeLevels;
    return isMade ? this->Steps : nullptr;
  }

private:
  const SurfaceCells& GetControl() const
  {
    return this->MadeLevels > 0 ? this->Lifted : this->Cells;
  }
  /// Whether every cell of the input is used, and used as it is.
  bool IsWhole() const
  {
    return this->Cells.Warnings.empty() &&
      static_cast<vtkIdType>(this->Cells.VertexCells.size() + this->Cells.SegmentCells.size() +
        this->Cells.FaceCells.size()) == this->Input->GetNumberOfCells();
  }
  /// Whether the stamp can belong to an input of this size. The stamp of a file may claim anything.
  bool FitsStamp() const
  {
    const double corners = std::accumulate(this->Stamp.Sizes.begin(), this->Stamp.Sizes.end(),
      static_cast<double>(this->Stamp.Size) * this->Stamp.NumberOfControlFaces);
    const double faces = this->Scheme->CountFaces(
      static_cast<double>(this->Stamp.NumberOfControlFaces), corners, this->Stamp.Levels);
    return faces <= 8. * static_cast<double>(this->Cells.GetNumberOfFaces()) + 1000.;
  }
  /// The size of the level of the input, if the stamp is true: larger levels are not made.
  ClaimedLevel GetClaimedLevel() const
  {
    ClaimedLevel claimed;
    if (this->MadeLevels > 0)
    {
      claimed = { this->MadeLevels, this->Cells.GetNumberOfFaces(),
        static_cast<vtkIdType>(this->Cells.SegmentCells.size()) };
    }
    return claimed;
  }
  /// Whether two cells were given the same flags and sharpness.
  bool HasSameFlags(vtkIdType a, vtkIdType b) const
  {
    auto same = [a, b](vtkDataArray* array)
    { return !array || array->GetComponent(a, 0) == array->GetComponent(b, 0); };
    return same(this->Options.Features.Singular) && same(this->Options.Features.Sharpness);
  }
  bool IsStopped(double done) const
  {
    return this->Options.Progress && this->Options.Progress(done);
  }
  /// Whether rules follow from coordinates, arrays and options, and not from a stamp.
  bool FindsRules() const { return this->MadeLevels == 0 || this->Stamp.IsOfPart(); }
  Coordinates GetControlCoordinates()
  {
    return this->ControlCoordinates.empty()
      ? this->Points->GetCoordinates()
      : Coordinates(this->ControlCoordinates.data(), this->Points->GetTie());
  }
  // Parts of a surface (SurfaceParts.cxx).
  void KeepControlCoordinates();
  SurfaceLevel<Id> MakeFirstLevel(const SurfaceCells& control) const;
  void WriteStampOfPart(OtherPartitions& others, bool isLevel);
  void WriteControlPoints(const SurfaceNumbers& numbers, const OtherPartitions& others);
  void WarnOfPartsAfresh() const;
  int GetAllLevels() const { return this->MadeLevels + this->Options.Levels; }

  int FindFirstLeft(const SurfaceCells& cells, const EdgeSharpness& sharpness) const;
  bool Plan();
  bool ReadStamp();
  void ForgetStamp();
  void StartPoints();
  bool Build();
  SurfaceSteps<Id>* MakeSteps(
    const SurfaceCells& cells, const SurfaceCells& control, KeptSurface<Id>*& kept);
  void SetSharpness(SurfaceSteps<Id>& steps, const SurfaceCreases& creases);
  // Interpolation (SurfaceInterpolation.cxx).
  bool Interpolates() const;
  void MakeControl(const SurfaceCells& cells, const SurfaceCreases& creases, KeptSurface<Id>* kept);
  void Interpolate();
  /// The numbers of interpolation for the stamp.
  std::vector<vtkIdType> GetInterpolated() const
  {
    return this->Solves ? this->Options.Interpolation.GetNumbers() : this->Stamp.Interpolated;
  }
  void FindCreases(const PolygonMesh<Id>& mesh, const SurfaceCells& cells);
  SurfaceCreases ReadCreases(const SurfaceCells& cells, const SurfaceLevel<Id>& level);
  bool FindSeams()
  {
    const bool areWanted = this->Options.KeepsMerged ||
      (this->Options.JoinSeams && this->Input->GetPointData()->GetTCoords());
    return areWanted && this->Scheme->HalvesEdges() &&
      JoinEqualPoints(this->Cells, this->Points->GetCoordinates(), this->JoinedMesh);
  }
  /// Hands out an operator of the points as matrices, if somebody wants them.
  void AppendFactors(const BlockOperator<Id>& rows) const
  {
    if (this->Options.Factors)
    {
      this->Options.Factors->Append(rows);
    }
  }
  vtkSmartPointer<vtkDataArray> FollowPoints(const Buffer<unsigned char>& turned);
  bool IsDescendant() const;
  SurfaceTags<Id> Classify(const SurfaceLevel<Id>& control, const SurfaceFeatures& features);
  std::vector<std::string> DescribeOpen(const SurfaceCells& cells, const SurfaceLevel<Id>& level);
  /// Whether only cells go on that are split (CellSplits.h).
  bool IsNarrow() const { return this->Options.Splits && !this->Options.Splits->Made.empty(); }
  void LeaveSplit();
  bool Execute();
  bool LooksSmooth(
    const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, const EdgeSharpness& sharpness) const;
  LastLevel GetLastLevel() const;
  bool MakesFrames() const { return this->MakesNormals || this->Options.GenerateTangents; }
  bool ForgetsLevels() const;
  void Write();
  // Places (SurfacePlaces.cxx, SurfaceNearest.cxx).
  static const SurfaceLevel<Id>& GetLast(const SurfaceSteps<Id>& steps)
  {
    return steps.GetLevel(steps.GetNumberOfSteps());
  }
  /// The steps that points follow, and the cells that steps began with.
  const SurfaceSteps<Id>& GetStepsOfPoints() const
  {
    return this->Joined ? *this->Joined : *this->Steps;
  }
  const SurfaceCells& GetCellsOf(const SurfaceSteps<Id>& steps) const
  {
    return &steps == this->Joined ? this->JoinedMesh.Cells : this->Cells;
  }
  bool ReadPlace(vtkIdType i, const PlaceInCell& given, const PartsOfCells& parts,
    const SurfaceSteps<Id>& steps, SurfacePlace<Id>& place, PlaceOrigin& origin,
    std::vector<vtkIdType>& missing) const;
  SurfacePlace<Id> TakePlaceOfLine(
    const SurfaceLevel<Id>& level, const SurfacePlace<Id>& place) const;
  void SumPlaces(const SurfaceSteps<Id>& steps, const std::vector<SurfacePlace<Id>>& places,
    PlaceDerivatives derivatives,
    const std::function<void(vtkIdType, const PlaceRows<Id>&)>& use) const;
  bool FindNearest(vtkDataSet* targets, const PartsOfCells& parts,
    std::vector<NearestPlace>& nearest, std::vector<PlaceInCell>& inCells,
    std::vector<vtkIdType>& missing);
  Buffer<unsigned char> FindTurned(const SurfaceSteps<Id>& steps) const;
  // Parts (SurfaceParts.cxx).
  Buffer<unsigned char> FindTurnedOfPart(
    const PolygonMesh<Id>& mesh, OtherPartitions& others) const;
  /// Whether the output has a point and a normal for each side of sharp edges.
  bool SplitsSides() const
  {
    return this->Options.SplitSharpEdges && this->MakesNormals && !this->Options.Others &&
      !this->Options.Factors &&
      (this->Options.Scheme == SurfaceSchemeKind::Loop ||
        this->Options.Scheme == SurfaceSchemeKind::CatmullClark);
  }
  LimitFrames FindFrames(
    const SurfaceSteps<Id>& steps, const Buffer<unsigned char>& turned, vtkDataArray* points)
  {
    if (this->SplitsSides())
    {
      const SurfaceLevel<Id>& last = GetLast(steps);
      LimitFinder<Id> finder(last, last.Tags, *this->Scheme,
        this->Options.Features.ModifiedBoundary, this->Options.Features.Weights);
      this->Sides = FindSharpSides(last, finder, turned, points);
    }
    return FindLimitFrames(
      steps, turned, points, this->MakesNormals, this->Options.GenerateTangents);
  }
  void SetFrames(const LimitFrames& frames)
  {
    this->Points->ReuseLimitNormals(frames.Normals);
    if (this->Options.GenerateTangents)
    {
      this->Points->SetLimitTangents(frames.Tangents);
    }
  }
  void WriteCells();
  void CopyCellData(); // SurfaceCellArrays.cxx
  void WriteStamp();

  vtkPolyData* Input;
  const SurfaceOptions& Options;
  vtkPolyData* Output;
  std::shared_ptr<const SurfaceScheme<Id>> Scheme;
  SurfaceCells Cells;
  SurfaceCells Lifted; ///< the control cells, where earlier filters made levels
  SurfaceStamp Stamp;
  /// Values that the user gave at control points.
  struct
  {
    std::vector<double> Angles;
    std::vector<double> Flatness;
  } Given;
  std::vector<double> ControlCoordinates; ///< only of a part
  int MadeLevels = 0;
  bool ExceedsStamp = false;         ///< a level before the input's level is larger
  std::vector<std::string> Warnings; ///< not told until it is known whether the stamp is true
  SimplicesOfCells NoCentres;
  std::vector<vtkIdType> GlobalIds;
  std::unique_ptr<PointArrays> Points;
  bool Solves = false;                                ///< all partitions interpolate
  bool MakesNormals = false;                          ///< the output has normals
  SharpSides Sides;                                   ///< none unless SplitsSides()
  SharpPairs Marked;                                  ///< FindMarkedEdges
  SharpPairs Creases;                                 ///< SubdivisionSurfaceCreases of the stamp
  std::vector<std::unique_ptr<SurfaceSteps<Id>>> Own; ///< steps that are not kept
  SurfaceSteps<Id>* Steps = nullptr;
  JoinedSurface JoinedMesh;
  SurfaceSteps<Id>* Joined = nullptr; ///< the points follow it where there are seams
  /// The control level, also of the joined mesh; null where their limits are not needed.
  SurfaceSteps<Id>* Control = nullptr;
  SurfaceSteps<Id>* JoinedControl = nullptr;
  KeptSurface<Id>* Kept = nullptr;
  std::vector<Sector<Id>> ControlSectors;
};

}

#endif
