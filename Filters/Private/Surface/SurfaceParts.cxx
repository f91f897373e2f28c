// SPDX-License-Identifier: BSD-3-Clause
// How a surface subdivision goes on with a part of a surface of which several partitions have
// parts.
#include "Private/Surface/SurfaceRun.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Surfaces/Scheme/SurfaceSides.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Run/StampFields.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"

#include <limits>

namespace subdivision
{
namespace
{

StampScheme GetStampScheme(SurfaceSchemeKind scheme)
{
  return static_cast<StampScheme>(
    static_cast<int>(StampScheme::FirstOfSurfaces) + static_cast<int>(scheme));
}

/// Of a scheme that does not halve edges.
std::string GetName(SurfaceSchemeKind scheme)
{
  return scheme == SurfaceSchemeKind::DooSabin ? "DooSabin"
    : scheme == SurfaceSchemeKind::Midedge     ? "Midedge"
    : scheme == SurfaceSchemeKind::FourEight   ? "FourEight"
                                               : "SqrtThree";
}

}

/// Keeps the coordinates that a later filter needs, or an earlier one has left.
template <typename Id>
void SurfaceRun<Id>::KeepControlCoordinates()
{
  this->ControlCoordinates.clear();
  const std::vector<double>& left = this->Stamp.ControlPoints;
  for (auto point = left.begin(); point != left.end(); point += ControlPointComponents)
  {
    this->ControlCoordinates.insert(this->ControlCoordinates.end(), point + 1, point + 4);
  }
  if (left.empty() && this->Scheme->HalvesEdges() && this->Options.Others)
  {
    const double* points = this->Points->GetCoordinates();
    this->ControlCoordinates.assign(points, points + 3 * this->Cells.NumberOfPoints);
  }
}

template <typename Id>
SurfaceLevel<Id> SurfaceRun<Id>::MakeFirstLevel(const SurfaceCells& control) const
{
  SurfaceLevel<Id> level = MakeControlLevel<Id>(control);
  if (this->Stamp.IsOfPart())
  {
    TurnEdgesOfPart(this->Cells, this->Stamp, level);
  }
  return level;
}

/// The turned faces of the control mesh, with or without seams.
template <typename Id>
Buffer<unsigned char> SurfaceRun<Id>::FindTurnedOfPart(
  const PolygonMesh<Id>& mesh, OtherPartitions& others) const
{
  ControlKeys keys = MakeControlKeys(this->Input, this->GetControl(), others);
  std::vector<char>& isSure = keys[SurfaceSegments::Vertex].Own;
  const std::vector<char> isOwn = isSure;
  for (std::size_t p = 0; p < this->JoinedMesh.FirstPoints.size(); ++p)
  {
    char& isFirstSure = isSure[this->JoinedMesh.FirstPoints[p]];
    isFirstSure = isFirstSure && isOwn[p];
  }
  return subdivision::FindTurnedOfPart(mesh, keys, others);
}

/// Writes the numbers that points and cells have in the whole output, of which this is a part, and
/// data for the next filter. `isLevel`: all points are the points of a level. Where the next one
/// cannot go on, it is told so, and warns. With a scheme that does not halve edges cells of a part
/// do not show the control mesh: the stamp then has no levels, and the numbers alone are left.
template <typename Id>
void SurfaceRun<Id>::WriteStampOfPart(OtherPartitions& others, bool isLevel)
{
  subdivision::Stamp stamp;
  stamp.Scheme = GetStampScheme(this->Options.Scheme);
  stamp.Levels = this->Scheme->HalvesEdges() ? this->GetAllLevels() : 0;
  stamp.IsProjected = !isLevel || others.Sum(this->Joined ? 1 : 0) > 0;
  if (isLevel || this->Options.GenerateGlobalIds)
  {
    const SurfaceNumbers numbers =
      NumberSurface(MakeControlKeys(this->Input, this->GetControl(), others),
        this->Steps->GetLevel(0), this->Steps->ListSegments(), others);
    numbers.Write(this->Output);
    stamp.NumberOfControlPoints = numbers.NumberOfControlPoints;
    stamp.NumberOfPoints = numbers.Points.Total;
    stamp.NumberOfCells = numbers.Cells.Total;
    if (isLevel && this->Scheme->HalvesEdges())
    {
      this->WriteControlPoints(numbers, others);
    }
  }
  if (isLevel)
  {
    subdivision::WriteStamp(stamp, this->Output);
  }
}

/// Writes the control points of own cells and the creases between them.
template <typename Id>
void SurfaceRun<Id>::WriteControlPoints(
  const SurfaceNumbers& numbers, const OtherPartitions& others)
{
  const std::vector<char> own = FindOwnPoints(this->Input, {}, others);
  const std::vector<vtkIdType>& ids = numbers.Points.Ids;
  const auto valueAt = [](const std::vector<double>& values, vtkIdType i)
  { return values.empty() ? -1. : values[i]; };
  std::vector<double> points;
  for (const vtkIdType v : InTurn(this->GetControl().NumberOfPoints))
  {
    const double* x = this->ControlCoordinates.data() + 3 * v;
    if (own[v])
    {
      points.insert(points.end(),
        { static_cast<double>(ids[v]), x[0], x[1], x[2], valueAt(this->Given.Angles, v),
          valueAt(this->Given.Flatness, v) });
    }
  }
  std::vector<double> creases;
  for (std::size_t i = 0; i < this->Creases.Points.size(); i += 2)
  {
    const vtkIdType ends[2] = { this->Creases.Points[i], this->Creases.Points[i + 1] };
    if (own[ends[0]] && own[ends[1]])
    {
      creases.insert(creases.end(),
        { static_cast<double>(ids[ends[0]]), static_cast<double>(ids[ends[1]]),
          this->Creases.Sharpness.empty() ? std::numeric_limits<double>::infinity()
                                          : this->Creases.Sharpness[i / 2] });
    }
  }
  vtkFieldData* data = this->Output->GetFieldData();
  WriteField<vtkIdTypeArray>(InterpolatedName, this->GetInterpolated(), data);
  WriteField<vtkDoubleArray>(ControlPointsName, points, data, ControlPointComponents);
  WriteField<vtkDoubleArray>(ControlCreasesName, creases, data, CreaseComponents);
}

/// Says so where an earlier filter made the parts of the input by this scheme, which does not go on
/// with parts.
template <typename Id>
void SurfaceRun<Id>::WarnOfPartsAfresh() const
{
  subdivision::Stamp stamp;
  const bool isOfScheme = ReadPartStamp(this->Input, stamp) &&
    stamp.Scheme == GetStampScheme(this->Options.Scheme) && stamp.Levels == 0 &&
    stamp.NumberOfPoints == this->Input->GetNumberOfPoints() &&
    stamp.NumberOfCells == this->Input->GetNumberOfCells();
  if (!this->Scheme->HalvesEdges() && isOfScheme)
  {
    this->Options.Warn("An earlier filter made the input on several ranks by " +
      GetName(this->Options.Scheme) +
      ", a scheme that does not go on over ranks. This filter takes the cells as any other mesh: "
      "results may differ from those of one filter with all levels. Use one filter with more "
      "levels.");
  }
}

SUBDIVISION_COMPILE(class SurfaceRun);

}
