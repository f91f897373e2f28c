// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Stamp.h
 * How a filter recognises a mesh that this project made (Mathematics 2), so that filters in a row
 * give the same result as one filter.
 *
 * The field array `Subdivision` holds the numbers of Stamp, and others that tell whether the mesh
 * was changed. `SubdivisionGlobalIds` has the global ids of the first input's points, if there were
 * some; `SubdivisionInvertedCells` its simplices of negative and of no volume (SolidOrientation.h);
 * `SubdivisionSingularVertices`, `...Lines` and `...Triangles` the singular simplices that were
 * derived from it, `SubdivisionLineSharpness` and
 * `SubdivisionTriangleSharpness` for how many levels lines and triangles among them stay sharp. The
 * control mesh itself is not stored: its vertices keep their ids, and the children of a simplex are
 * consecutive. So the next filter reads the control mesh off the cells, refines it again and
 * compares the result with the cells. This finds every change of cells; points may move.
 */
#ifndef SubdivisionObjects_Stamp_h
#define SubdivisionObjects_Stamp_h

#include "Core/Memory/SimplexList.h"
#include "Private/Run/Marks.h"

#include <functional>
#include <vector>

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

enum class StampScheme
{
  BoxSpline = 0,
  RedGreen = 1,
  TetOct = 2,
  Linear = 3,
  Hybrid = 4,
  /// A surface of which several partitions have parts: this plus the number of its scheme.
  FirstOfSurfaces = 100
};

/// The scheme of cut cells that a value of VolumeScheme means, which is the same in all filters
/// that have one: Hybrid and Automatic cut them for the box spline, where they cut any.
inline StampScheme GetVolumeScheme(int value)
{
  constexpr StampScheme schemes[] = { StampScheme::BoxSpline, StampScheme::TetOct,
    StampScheme::Linear, StampScheme::BoxSpline, StampScheme::BoxSpline };
  return schemes[value];
}

/// The field array with the global ids of control points.
constexpr const char* GlobalIdsName = "SubdivisionGlobalIds";
/// The field array with the inverted and flat control simplices, and its form in parts.
constexpr const char* InvertedCellsName = "SubdivisionInvertedCells";
constexpr const char* FirstInvertedName = "SubdivisionFirstInverted";
/// The values that an earlier filter solved for, so that the limit passes through them: 1 points, 2
/// arrays, 3 both; there is no array where there were none.
constexpr const char* InterpolatedName = "SubdivisionInterpolated";
/// The field arrays with the derived singular simplices, by their dimension.
constexpr const char* SingularNames[3] = { "SubdivisionSingularVertices",
  "SubdivisionSingularLines", "SubdivisionSingularTriangles" };
/// The field arrays with the remaining sharpness of these lines and triangles, if any is finite.
constexpr const char* SharpnessNames[3] = { "", "SubdivisionLineSharpness",
  "SubdivisionTriangleSharpness" };

/// The field arrays of a part of a surface with its control points as they were at first: the
/// number of each in the whole, its coordinates, and the numbers of SurfaceStamp.h. A second one
/// has pairs of points, and for how many levels the edge between them stays sharp.
constexpr const char* ControlPointsName = "SubdivisionControlPoints";
constexpr int ControlPointComponents = 6;
constexpr const char* ControlCreasesName = "SubdivisionControlCreases";
constexpr int CreaseComponents = 3;

/// A number of points or cells that no mesh has.
constexpr vtkIdType UnknownNumber = -1;

struct Stamp
{
  StampScheme Scheme = StampScheme::BoxSpline;
  int Levels = 0;                      ///< steps since the control mesh
  vtkIdType NumberOfControlPoints = 0; ///< centres of split cells included
  /// Whether points are on the limit. Then no filter may take them for points of a level.
  bool IsProjected = false;
  bool TetOrderIsFinal = true; ///< if false, only of tetrahedra which a filter made
  /// How many points and cells the whole output has, of which this is a part; 0: it is the whole,
  /// UnknownNumber: no filter can go on with the parts.
  /// Other numbers and field arrays of the stamp then count in the whole, too.
  vtkIdType NumberOfPoints = 0;
  vtkIdType NumberOfCells = 0;
};

/// Returns false if there is no stamp of that scheme, or if numbers or a sample of cells differ
/// from it. For uniform schemes also if points are on the limit, or if tetrahedra do not have their
/// final order. Such a mesh is read like any other.
bool ReadStamp(vtkPointSet* input, StampScheme scheme, Stamp& stamp);

/// Reads the numbers of a stamp of a volume scheme, which may count in a whole output of which the
/// mesh is a part. Returns false if there are none, or if points of a uniform scheme are on the
/// limit.
bool ReadPartStamp(vtkPointSet* part, Stamp& stamp);

/// Writes or replaces the stamp of a finished output.
void WriteStamp(const Stamp& stamp, vtkPointSet* output);

/// The lists of ids that stand beside the numbers of a stamp.
struct StampedIds
{
  SharpTuples Singular;            ///< derived singular simplices
  std::vector<vtkIdType> Global;   ///< of the first control points
  std::vector<vtkIdType> Inverted; ///< as FindInvertedTets gives them
  /// The same in a part of an output: 2 * the first cell of the control simplex + 1 if it is flat.
  std::vector<vtkIdType> FirstInverted;
  std::vector<vtkIdType> Interpolated; ///< one number (InterpolatedName) or none
};

/// Writes or replaces the field arrays of a finished output; removes arrays without ids.
void WriteStampedIds(const StampedIds& ids, vtkPointSet* output);

/// Reads the derived singular simplices, as tuples of point ids.
void ReadSingularTuples(vtkPointSet* input, SharpTuples& tuples);

/// How many corners the polygon has whose descendants begin with quad `first` of `quads`, `levels`
/// steps after it, each of which split polygons into quads around their centre: all around the same
/// centre. `vertexOf(quad, corner)`.
vtkIdType CountCornersOfPolygon(vtkIdType first, vtkIdType quads, int levels,
  const std::function<vtkIdType(vtkIdType, int)>& vertexOf);

/// Finds the control mesh from its descendants. Returns false if the cells are no descendants of
/// simplices after stamp.Levels steps.
bool FindControlMesh(const SimplexView& descendants, const Stamp& stamp, SimplexList& control);

}

#endif
