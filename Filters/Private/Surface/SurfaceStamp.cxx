// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceStamp.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Control/Stamp.h"
#include "Private/Run/StampFields.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace subdivision
{
namespace
{

constexpr const char* SizesName = "SubdivisionSurfaceSizes";
constexpr const char* AnglesName = "SubdivisionCornerAngles";
constexpr const char* FaceAnglesName = "SubdivisionSharpAngles";
constexpr const char* GivenCornersName = "SubdivisionSharpCorners";
constexpr const char* CreasesName = "SubdivisionSurfaceCreases";
constexpr const char* SharpnessName = "SubdivisionSurfaceCreaseSharpness";
constexpr const char* CellsName = "SubdivisionSurfaceCells";
constexpr const char* PointIdsName = "SubdivisionSurfaceGlobalIds";
const std::string CarriedPrefix = "SubdivisionCarried:";

/// The numbers of a stamp.
enum SurfaceStampNumber
{
  Version,
  Scheme,
  Levels,
  ControlPoints,
  ControlFaces,
  FaceSize,
  Points,
  Cells,
  NumberOfNumbers
};

constexpr StampFormat Format{ SurfaceStampName, 2, NumberOfNumbers, Levels, ControlPoints, Points,
  Cells };

bool AreControlPoints(const std::vector<vtkIdType>& ids, const SurfaceStamp& stamp)
{
  return std::all_of(ids.begin(), ids.end(),
    [&stamp](vtkIdType id) { return id >= 0 && id < stamp.NumberOfControlPoints; });
}

bool IsCarried(vtkAbstractArray* array)
{
  return array->GetName() && std::string(array->GetName()).rfind(CarriedPrefix, 0) == 0;
}

CarriedCells ReadCarried(vtkFieldData* data, int levels)
{
  CarriedCells carried;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (IsCarried(array))
    {
      const std::string text = std::string(array->GetName()).substr(CarriedPrefix.size());
      char* end = nullptr;
      const long level = std::strtol(text.c_str(), &end, 10);
      if (*end == ':' && level >= 0 && level < levels)
      {
        carried.Entries.push_back({ end + 1, static_cast<int>(level), array });
      }
    }
  }
  return carried;
}

}

const CarriedCells::Entry* CarriedCells::Find(const char* name) const
{
  const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
    [name](const Entry& entry) { return name && entry.Name == name; });
  return found == this->Entries.end() ? nullptr : &*found;
}

void SurfaceStamp::SetControl(const SurfaceCells& control, int size, bool withCells)
{
  this->NumberOfControlPoints = control.NumberOfPoints;
  this->NumberOfControlFaces = control.GetNumberOfFaces();
  this->Size = size;
  for (vtkIdType f = 0; size == 0 && f < control.GetNumberOfFaces(); ++f)
  {
    this->Sizes.push_back(control.FaceOffsets[f + 1] - control.FaceOffsets[f]);
  }
  if (withCells)
  {
    this->Cells = control.Segments;
    this->Cells.insert(this->Cells.end(), control.Corners.begin(), control.Corners.end());
    this->Cells.insert(this->Cells.end(), control.Vertices.begin(), control.Vertices.end());
  }
}

bool ReadSurfaceStamp(vtkPolyData* input, SurfaceStamp& stamp)
{
  vtkFieldData* data = input->GetFieldData();
  const std::vector<vtkIdType> numbers = ReadStampNumbers(input, Format);
  if (numbers.empty() || numbers[ControlFaces] < 0 || numbers[ControlFaces] > numbers[Cells] ||
    numbers[FaceSize] < 0)
  {
    return false;
  }
  stamp.Scheme = static_cast<int>(numbers[Scheme]);
  stamp.Levels = static_cast<int>(numbers[Levels]);
  stamp.NumberOfControlPoints = numbers[ControlPoints];
  stamp.NumberOfControlFaces = numbers[ControlFaces];
  stamp.Size = static_cast<int>(std::min<vtkIdType>(numbers[FaceSize], 1 << 30));
  stamp.Sizes = ReadFieldIds(SizesName, data);
  stamp.Angles = ReadFieldValues(AnglesName, data);
  stamp.FaceAngles = ReadFieldValues(FaceAnglesName, data);
  stamp.GivenCorners = ReadFieldValues(GivenCornersName, data);
  stamp.Creases = { ReadFieldIds(CreasesName, data), ReadFieldValues(SharpnessName, data) };
  stamp.Cells = ReadFieldIds(CellsName, data);
  stamp.GlobalIds = ReadFieldIds(PointIdsName, data);
  stamp.Interpolated = ReadFieldIds(InterpolatedName, data);
  stamp.Carried = ReadCarried(data, stamp.Levels);
  const SharpPairs& creases = stamp.Creases;
  return (creases.Sharpness.empty() || 2 * creases.Sharpness.size() == creases.Points.size()) &&
    AreControlPoints(creases.Points, stamp) &&
    (stamp.Size > 0 || static_cast<vtkIdType>(stamp.Sizes.size()) == stamp.NumberOfControlFaces) &&
    (stamp.GlobalIds.empty() ||
      static_cast<vtkIdType>(stamp.GlobalIds.size()) == stamp.NumberOfControlPoints);
}

bool ReadStampOfPart(vtkPolyData* input, const SurfaceCells& cells, SurfaceStamp& stamp)
{
  subdivision::Stamp whole;
  constexpr int first = static_cast<int>(StampScheme::FirstOfSurfaces);
  if (!ReadPartStamp(input, whole) || static_cast<int>(whole.Scheme) < first || whole.Levels == 0 ||
    whole.NumberOfPoints != input->GetNumberOfPoints() ||
    whole.NumberOfCells != input->GetNumberOfCells())
  {
    return false;
  }
  stamp.Scheme = static_cast<int>(whole.Scheme) - first;
  stamp.Levels = whole.Levels;
  stamp.NumberOfControlPoints = whole.NumberOfControlPoints;
  stamp.Interpolated = ReadFieldIds(InterpolatedName, input->GetFieldData());
  stamp.ControlPoints =
    ReadFieldValues(ControlPointsName, input->GetFieldData(), ControlPointComponents);
  const std::vector<double> creases =
    ReadFieldValues(ControlCreasesName, input->GetFieldData(), CreaseComponents);
  bool isFinite = false;
  for (std::size_t i = 0; i < creases.size(); i += CreaseComponents)
  {
    stamp.Creases.Points.insert(
      stamp.Creases.Points.end(), { ToId(creases[i]), ToId(creases[i + 1]) });
    stamp.Creases.Sharpness.push_back(creases[i + 2]);
    isFinite = isFinite || !std::isinf(creases[i + 2]);
  }
  if (!isFinite)
  {
    stamp.Creases.Sharpness.clear();
  }
  const auto faces = cells.GetNumberOfFaces();
  if (static_cast<vtkIdType>(cells.Corners.size()) == 3 * faces)
  {
    stamp.Size = 3;
    stamp.NumberOfControlFaces = faces >> (2 * stamp.Levels);
  }
  const vtkIdType ofCorner = vtkIdType(1) << (2 * (stamp.Levels - 1));
  for (vtkIdType face = 0; stamp.Size == 0 && face < faces; face += stamp.Sizes.back() * ofCorner)
  {
    if (static_cast<vtkIdType>(cells.Corners.size()) != 4 * faces)
    {
      return false;
    }
    stamp.Sizes.push_back(CountCornersOfPolygon(face, faces, stamp.Levels,
      [&cells](vtkIdType quad, int corner) { return cells.Corners[4 * quad + corner]; }));
    if (stamp.Sizes.back() < 3)
    {
      return false;
    }
    ++stamp.NumberOfControlFaces;
  }
  return AreControlPoints(stamp.Creases.Points, stamp) &&
    static_cast<vtkIdType>(stamp.ControlPoints.size()) ==
    ControlPointComponents * stamp.NumberOfControlPoints;
}

void WriteSurfaceStamp(const SurfaceStamp& stamp, vtkPolyData* output)
{
  const std::vector<vtkIdType> numbers{ Format.Version, stamp.Scheme, stamp.Levels,
    stamp.NumberOfControlPoints, stamp.NumberOfControlFaces, stamp.Size,
    output->GetNumberOfPoints(), output->GetNumberOfCells() };
  vtkFieldData* data = output->GetFieldData();
  WriteField<vtkIdTypeArray>(SurfaceStampName, numbers, data);
  WriteField<vtkIdTypeArray>(
    SizesName, stamp.Size > 0 ? std::vector<vtkIdType>() : stamp.Sizes, data);
  WriteField<vtkDoubleArray>(AnglesName, stamp.Angles, data);
  WriteField<vtkDoubleArray>(FaceAnglesName, stamp.FaceAngles, data);
  WriteField<vtkDoubleArray>(GivenCornersName, stamp.GivenCorners, data);
  WriteField<vtkIdTypeArray>(CreasesName, stamp.Creases.Points, data);
  WriteField<vtkDoubleArray>(SharpnessName, stamp.Creases.Sharpness, data);
  WriteField<vtkIdTypeArray>(CellsName, stamp.Cells, data);
  WriteField<vtkIdTypeArray>(PointIdsName, stamp.GlobalIds, data);
  WriteField<vtkIdTypeArray>(InterpolatedName, stamp.Interpolated, data);
  for (const CarriedCells::Entry& entry : stamp.Carried.Entries)
  {
    // The array may belong to an earlier output, so that only a copy can be renamed.
    const auto copy = vtkSmartPointer<vtkAbstractArray>::Take(entry.Array->NewInstance());
    copy->DeepCopy(entry.Array);
    copy->SetName((CarriedPrefix + std::to_string(entry.Level) + ":" + entry.Name).c_str());
    data->AddArray(copy);
  }
}

void RemoveSurfaceStamp(vtkPolyData* output)
{
  vtkFieldData* data = output->GetFieldData();
  for (const char* name : { SurfaceStampName, SizesName, AnglesName, FaceAnglesName,
         GivenCornersName, CreasesName, SharpnessName, CellsName, PointIdsName, InterpolatedName })
  {
    data->RemoveArray(name);
  }
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (IsCarried(data->GetAbstractArray(i)))
    {
      data->RemoveArray(i);
    }
  }
}

namespace
{

/// Copies the control cells from the stamp. Their FaceCells mean nothing: the output has no
/// children of single faces.
bool CopyControlCells(const SurfaceCells& cells, const SurfaceStamp& stamp, SurfaceCells& control)
{
  control = SurfaceCells();
  control.NumberOfPoints = stamp.NumberOfControlPoints;
  control.VertexCells = cells.VertexCells;
  control.FaceCells.assign(stamp.NumberOfControlFaces, 0);
  vtkIdType corners = 0;
  const vtkIdType all = static_cast<vtkIdType>(stamp.Cells.size());
  for (const vtkIdType f : InTurn(stamp.NumberOfControlFaces))
  {
    const vtkIdType size = stamp.Size > 0 ? stamp.Size : stamp.Sizes[f];
    if (size < 3 || size > all - corners)
    {
      return false;
    }
    corners += size;
    control.FaceOffsets.push_back(corners);
  }
  const vtkIdType ends = all - corners - static_cast<vtkIdType>(cells.VertexCells.size());
  const vtkIdType segments = ends / 2;
  const vtkIdType children = static_cast<vtkIdType>(cells.SegmentCells.size());
  if (ends < 0 || ends % 2 != 0 || (segments > 0 ? children % segments != 0 : children > 0))
  {
    return false;
  }
  const auto first = stamp.Cells.begin();
  control.Segments.assign(first, first + ends);
  control.Corners.assign(first + ends, first + ends + corners);
  control.Vertices.assign(first + ends + corners, stamp.Cells.end());
  for (const vtkIdType s : InTurn(segments))
  {
    if (children == 0 || control.Segments[2 * s] == control.Segments[2 * s + 1])
    {
      return false;
    }
    control.SegmentCells.push_back(cells.SegmentCells[s * (children / segments)]);
  }
  for (const vtkIdType f : InTurn(stamp.NumberOfControlFaces))
  {
    std::vector<vtkIdType> face(control.Corners.begin() + control.FaceOffsets[f],
      control.Corners.begin() + control.FaceOffsets[f + 1]);
    std::sort(face.begin(), face.end());
    if (std::adjacent_find(face.begin(), face.end()) != face.end())
    {
      return false;
    }
  }
  return AreControlPoints(stamp.Cells, stamp);
}

}

bool LiftSurfaceCells(const SurfaceCells& cells, const SurfaceStamp& stamp,
  const std::function<bool(vtkIdType, vtkIdType)>& isSame, SurfaceCells& control)
{
  if (!stamp.Cells.empty())
  {
    return CopyControlCells(cells, stamp, control);
  }
  const vtkIdType segments = static_cast<vtkIdType>(cells.SegmentCells.size());
  const vtkIdType pieces = vtkIdType(1) << stamp.Levels;
  const bool triangles = stamp.Size == 3 && cells.Corners.size() == cells.FaceCells.size() * 3;
  const vtkIdType quads = vtkIdType(1) << (2 * std::max(0, stamp.Levels - 1)); // of one corner
  control = SurfaceCells();
  control.NumberOfPoints = stamp.NumberOfControlPoints;
  control.Vertices = cells.Vertices;
  control.VertexCells = cells.VertexCells;
  if (segments % pieces != 0)
  {
    return false;
  }
  auto areSame = [&isSame](const std::vector<vtkIdType>& parents, vtkIdType first, vtkIdType size)
  {
    return std::all_of(parents.begin() + first, parents.begin() + first + size,
      [&](vtkIdType cell) { return isSame(parents[first], cell); });
  };
  for (vtkIdType s = 0; s < segments; s += pieces)
  {
    if (!areSame(cells.SegmentCells, s, pieces))
    {
      return false;
    }
    control.Segments.insert(
      control.Segments.end(), { cells.Segments[2 * s], cells.Segments[2 * (s + pieces) - 1] });
    control.SegmentCells.push_back(cells.SegmentCells[s]);
  }
  vtkIdType face = 0;
  const vtkIdType children = vtkIdType(1) << (2 * stamp.Levels);
  for (const vtkIdType f : InTurn(stamp.NumberOfControlFaces))
  {
    const vtkIdType size = stamp.Size > 0 ? stamp.Size : stamp.Sizes[f];
    const vtkIdType left = cells.GetNumberOfFaces() - face;
    if (size < 3 || (triangles ? children > left : size > left / quads))
    {
      return false; // also keeps the product below from overflowing: a file may claim any size
    }
    const vtkIdType total = triangles ? children : size * quads;
    if (!areSame(cells.FaceCells, face, total))
    {
      return false;
    }
    for (vtkIdType c = 0; c < size; ++c)
    {
      // Corner c of a triangle is corner c of its child c, and so on; of a polygon it is the first
      // corner of the first quad at c.
      const vtkIdType child = face + c * (triangles ? (children - 1) / 3 : quads);
      control.Corners.push_back(cells.Corners[cells.FaceOffsets[child] + (triangles ? c : 0)]);
    }
    control.FaceOffsets.push_back(static_cast<vtkIdType>(control.Corners.size()));
    control.FaceCells.push_back(cells.FaceCells[face]);
    face += total;
  }
  return face == cells.GetNumberOfFaces() && AreControlPoints(control.Corners, stamp) &&
    AreControlPoints(control.Segments, stamp) && AreControlPoints(control.Vertices, stamp);
}

template <typename Id>
void TurnEdgesOfPart(
  const SurfaceCells& cells, const SurfaceStamp& stamp, SurfaceLevel<Id>& control)
{
  if (stamp.Levels < 2) // an edge has one point of its own
  {
    return;
  }
  PolygonMesh<Id>& mesh = control.Mesh;
  std::vector<char> turned(static_cast<size_t>(mesh.GetNumberOfEdges()), 0);
  // Points on an edge are numbered along it: `first` and `last` of them,
  // seen from vertex `start`.
  const auto compare = [&](Id edge, Id start, vtkIdType first, vtkIdType last)
  { turned[edge] = (mesh.EdgeVertices[2 * edge] == start) != (first < last); };
  const vtkIdType ofFace = vtkIdType(1) << (2 * stamp.Levels);
  const auto cornerOfTriangle = [&](vtkIdType corner, vtkIdType at)
  { return cells.Corners[3 * (corner / 3 * ofFace + corner % 3 * ((ofFace - 1) / 3)) + at % 3]; };
  for (const Id c : InTurn(mesh.GetNumberOfCorners()))
  {
    const Id next = mesh.Next(c);
    if (stamp.Size == 3)
    {
      compare(mesh.Edges[c], mesh.Vertices[c], cornerOfTriangle(c, c % 3 + 1),
        cornerOfTriangle(next, c % 3));
    }
    else
    {
      compare(mesh.Edges[c], mesh.Vertices[c], cells.Corners[vtkIdType(c) * ofFace + 1],
        cells.Corners[vtkIdType(next) * ofFace + 3]);
    }
  }
  const vtkIdType pieces = vtkIdType(1) << stamp.Levels;
  for (const vtkIdType line : InTurn(control.Lines.size()))
  {
    const vtkIdType* points = cells.Segments.data() + 2 * line * pieces;
    compare(control.Lines[line] / 2, static_cast<Id>(points[0]), points[1], points[2 * pieces - 2]);
  }
  for (Id& line : InTurn(control.Lines))
  {
    line = turned[line / 2] ? line ^ 1 : line;
  }
  for (const size_t e : InTurn(turned.size()))
  {
    if (turned[e])
    {
      std::swap(mesh.EdgeVertices[2 * e], mesh.EdgeVertices[2 * e + 1]);
    }
  }
}

SUBDIVISION_COMPILE_FUNCTION(TurnEdgesOfPart);

}
