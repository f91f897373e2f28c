// SPDX-License-Identifier: BSD-3-Clause
// The output of a subdivision of a surface, and the way there.
#include "Private/Surface/SurfaceRun.h"

#include "Core/Memory/Ids.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/CellArrays.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Surface/SurfaceChecks.h"
#include "Private/Values/SharedInterpolation.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"

#include <algorithm>

namespace subdivision
{

/// Whether points and cells alone need the levels, each only until the next one but one is there:
/// the last step, in which the output is made, then finds more memory.
template <typename Id>
bool SurfaceRun<Id>::ForgetsLevels() const
{
  return !this->Kept && this->Input->GetCellData()->GetNumberOfArrays() == 0 &&
    !this->Options.GenerateOriginalIds && !this->Options.Others;
}

/// Leaves the cells out that do not go on: vertices, and lines of which no part does.
template <typename Id>
void SurfaceRun<Id>::LeaveSplit()
{
  std::vector<vtkIdType> segments;
  for (const vtkIdType line : this->Steps->GetSplitLines())
  {
    segments.push_back(this->Cells.SegmentCells[static_cast<std::size_t>(line)]);
  }
  this->Cells.SegmentCells = std::move(segments);
  this->Cells.VertexCells.clear();
  this->Cells.Vertices.clear();
}

/// Makes the cells and points of the output. Returns false if Progress asks to stop.
template <typename Id>
bool SurfaceRun<Id>::Execute()
{
  const int levels = this->Options.Levels;
  if (this->IsNarrow())
  {
    this->LeaveSplit();
  }
  this->Interpolate();
  const SurfaceSteps<Id>& smoothed = this->Joined ? *this->Joined : *this->Steps;
  const Buffer<unsigned char> turned =
    this->MakesFrames() ? this->FindTurned(smoothed) : Buffer<unsigned char>();
  if (this->Joined)
  {
    this->Points->ReusePoints(this->FollowPoints(turned));
  }
  if (this->Options.Factors)
  {
    this->Options.Factors->SetNumberOfSharpSteps(
      std::max(0, this->Steps->GetNumberOfSharpSteps() - this->MadeLevels));
  }
  for (int step = 0; step < levels; ++step)
  {
    if (this->IsStopped(0.5 + 0.5 * (step + 1.) / (levels + 1.)))
    {
      return false;
    }
    if (this->ForgetsLevels())
    {
      this->Steps->ForgetBefore(this->MadeLevels + step - 1); // the last step may begin two before
    }
    const BlockOperator<Id> rows = this->Steps->GetStep(this->MadeLevels + step);
    if (!this->Joined)
    {
      this->AppendFactors(rows);
    }
    this->Points->Advance(
      rows,
      [&](vtkIdType row)
      {
        thread_local std::vector<vtkIdType> parents;
        this->Steps->GetParents(this->MadeLevels + step, row, parents);
        return *std::min_element(parents.begin(), parents.end(),
          [this](vtkIdType a, vtkIdType b) { return this->Points->IsEarlier(a, b); });
      },
      step + 1 < levels);
    if (this->Scheme->IsDual())
    {
      this->Points->ForgetInputPoints();
    }
    const std::vector<Id>& left = this->Steps->GetLeft(this->MadeLevels + step + 1);
    if (!left.empty())
    {
      this->Points->Renumber([&left](vtkIdType row) { return vtkIdType(left[row]); },
        static_cast<vtkIdType>(left.size()));
    }
  }
  const bool addFrames = !this->Joined && this->MakesFrames();
  const LimitFrames frames =
    addFrames ? this->FindFrames(*this->Steps, turned, this->Points->GetPoints()) : LimitFrames();
  if (this->Options.ProjectToLimit)
  {
    const BlockOperator<Id> limit = this->Steps->GetLimit(LimitKind::Position);
    if (!this->Joined)
    {
      this->AppendFactors(limit);
    }
    this->Points->Advance(limit, [](vtkIdType row) { return row; });
  }
  if (addFrames)
  {
    this->SetFrames(frames);
  }
  this->WriteCells(); // after the points: the last level but one takes no memory any more
  this->Points->Finish(this->Output);
  return true;
}

/// Writes cell data, ghost types and the stamp.
template <typename Id>
void SurfaceRun<Id>::Write()
{
  this->CopyCellData();
  ClearMarks(this->Options.Features.Marks, this->Output);
  RebuildPointGhosts(this->Input, this->Output);
  if (!this->IsNarrow()) // the whole, which was made before, told of all points
  {
    TellOvershoot(*this->Points, this->Options, this->Output, this->Options.ProjectToLimit);
  }
  this->WriteStamp();
  if (!this->Sides.Normals.empty())
  {
    SplitSides(this->Sides, GetLast(*this->Steps).Mesh, this->Output);
  }
}

template <typename Id>
void SurfaceRun<Id>::WriteCells()
{
  if (this->Kept && this->Kept->HasCells())
  {
    this->Output->SetVerts(this->Kept->Verts);
    this->Output->SetLines(this->Kept->Lines);
    this->Output->SetPolys(this->Kept->Polys);
    return;
  }
  WriteSurfaceCells(*this->Steps, this->Cells.Vertices, this->Options.Use32BitIds, this->Output);
  if (this->Kept)
  {
    this->Kept->Verts = this->Output->GetVerts();
    this->Kept->Lines = this->Output->GetLines();
    this->Kept->Polys = this->Output->GetPolys();
    this->Kept->Handed.Set(this->Kept->ListArrays());
  }
}

template <typename Id>
void SurfaceRun<Id>::WriteStamp()
{
  RemoveSurfaceStamp(this->Output);
  if (this->MadeLevels > 0)
  {
    WarnOfLateInterpolation(
      this->Options.Interpolation, this->Stamp.Interpolated, this->Options.Warn);
  }
  SurfaceStamp stamp;
  stamp.Scheme = static_cast<int>(this->Options.Scheme);
  const bool isLimit = this->Options.ProjectToLimit;
  if (OtherPartitions* others = this->Options.Others)
  {
    this->WriteStampOfPart(*others, !isLimit && this->GetAllLevels() > 0);
    return;
  }
  if (isLimit || this->GetAllLevels() == 0 || this->Joined || !this->Sides.Normals.empty())
  {
    return;
  }
  stamp.Levels = this->GetAllLevels();
  stamp.SetControl(
    this->GetControl(), this->Steps->GetLevel(0).Mesh.Arity, !this->Scheme->HalvesEdges());
  for (const Sector<Id>& sector : this->ControlSectors)
  {
    stamp.Angles.push_back(sector.Angle);
  }
  for (const Sector<Id>& sector : this->ControlSectors)
  {
    stamp.Angles.push_back(sector.Flatness);
  }
  stamp.FaceAngles = this->Stamp.FaceAngles;
  stamp.GivenCorners = this->Stamp.GivenCorners;
  stamp.Creases = this->Creases;
  if (!this->Scheme->IsDual())
  {
    stamp.GlobalIds = this->MadeLevels > 0 ? this->Stamp.GlobalIds : this->GlobalIds;
  }
  stamp.Carried = this->Stamp.Carried;
  stamp.Interpolated = this->GetInterpolated();
  WriteSurfaceStamp(stamp, this->Output);
}

bool SubdivideSurface(vtkPolyData* input, const SurfaceOptions& options, vtkPolyData* output)
{
  const auto scheme = MakeSurfaceScheme<int>(
    options.Scheme, options.Features.ModifiedBoundary, options.Features.Weights);
  SurfaceCells cells;
  bool isLarge = false;
  if (!ReadAndCheck(input, *scheme, options, cells, isLarge))
  {
    return false;
  }
  const auto run = [&](auto&& made)
  {
    return options.Places ? made.FindPlaces(std::move(cells), *options.Places)
                          : made.Run(std::move(cells));
  };
  if (isLarge)
  {
    const auto largeScheme = MakeSurfaceScheme<long long>(
      options.Scheme, options.Features.ModifiedBoundary, options.Features.Weights);
    return run(SurfaceRun<long long>(input, options, largeScheme, output));
  }
  return run(SurfaceRun<int>(input, options, scheme, output));
}

SUBDIVISION_COMPILE(class SurfaceRun);

}
