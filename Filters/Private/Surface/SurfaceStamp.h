// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceStamp.h
 * How vtkSurfaceSubdivision recognises its own output, so that filters in a row give the same
 * result as one filter (Mathematics 2).
 *
 * Field arrays:
 *  - `SubdivisionSurface`: scheme, levels and counts.
 *  - `SubdivisionSurfaceSizes`: number of corners of each control face, where they differ.
 *  - `SubdivisionCornerAngles`: angles and flatness of the sectors at corners.
 *  - `SubdivisionSharpAngles`, `SubdivisionSharpCorners`: FaceAngles and GivenCorners below.
 *  - `SubdivisionSurfaceCreases`: edges that are marked or detected as features, as pairs of
 * control points. For schemes that do not halve edges all sharp edges, and corners as pairs of
 * equal points.
 *  - `SubdivisionSurfaceCreaseSharpness`: for how many levels from the control mesh on each of
 * these stays sharp, if that is finite for any.
 *  - `SubdivisionSurfaceGlobalIds`: global ids of the control points. The output has no global ids,
 *    but a new point takes integers and strings from the parent with the smallest one.
 *  - `SubdivisionSurfaceCells`: the control cells, for schemes that do not halve edges.
 *  - `SubdivisionCarried:LEVEL:NAME`: cell array NAME of all faces of a level, where the cells of
 *    the output do not show the data of each of them (Mathematics 1).
 *
 * A part of a surface of which several partitions have parts has the stamp of Stamp.h instead, if
 * edges are halved, with its scheme as FirstOfSurfaces + number, and the field arrays
 * `SubdivisionControlPoints` and `SubdivisionControlCreases`, which count in the whole. With other
 * schemes the levels of that stamp are 0: the next filter takes the cells for a control mesh.
 *
 * Where edges are halved, control points keep their ids and children are consecutive, so that the
 * control mesh is read off the cells. It is refined again and compared with them.
 */
#ifndef SubdivisionObjects_SurfaceStamp_h
#define SubdivisionObjects_SurfaceStamp_h

#include "Private/Surface/SurfaceCells.h"

#include "vtkAbstractArray.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>

namespace subdivision
{

/// The cell data of the faces of an earlier level. They are stored because a cell that lies in two
/// of these faces shows the data of one only.
struct CarriedCells
{
  struct Entry
  {
    std::string Name;
    int Level; ///< of the faces
    vtkSmartPointer<vtkAbstractArray> Array;
  };
  std::vector<Entry> Entries;

  /// Null where nothing is carried by that name.
  const Entry* Find(const char* name) const;
};

/// Edges as pairs of points, a corner as a point twice, and for how many levels each stays sharp.
struct SharpPairs
{
  std::vector<vtkIdType> Points;
  std::vector<double> Sharpness; ///< empty: all are infinite
};

struct SurfaceStamp
{
  int Scheme = 0;
  int Levels = 0;
  vtkIdType NumberOfControlPoints = 0;
  vtkIdType NumberOfControlFaces = 0;
  int Size = 0; ///< corners of each control face; 0: see Sizes
  std::vector<vtkIdType> Sizes;
  std::vector<double> Angles;
  /// See WriteSharpCorners: pairs of a corner of a control face and its angle on the first input;
  /// and for control points three numbers, the point and the angle and flatness that the user gave,
  /// or -1.
  std::vector<double> FaceAngles;
  std::vector<double> GivenCorners;
  SharpPairs Creases;
  /// Of the control points, on the first input; empty: it had none, or the scheme keeps no
  /// vertices.
  std::vector<vtkIdType> GlobalIds;
  std::vector<vtkIdType> Interpolated; ///< as in Stamp.h
  /// The control cells: segments (two points each), corners of faces, vertices. Empty if they can
  /// be found from their children.
  std::vector<vtkIdType> Cells;
  CarriedCells Carried;
  /// In a part of a surface of which several partitions have parts, instead of Angles, FaceAngles
  /// and GivenCorners: of each control point six numbers, its number in the whole, its coordinates,
  /// and the angle and flatness that the user gave, or -1.
  std::vector<double> ControlPoints;

  bool IsOfPart() const { return !this->ControlPoints.empty(); }
  /// `size`: corners of each face, 0 if they differ; `withCells`: sets Cells, too.
  void SetControl(const SurfaceCells& control, int size, bool withCells);
};

/// False where there is no stamp, or it is not of this mesh.
bool ReadSurfaceStamp(vtkPolyData* input, SurfaceStamp& stamp);
/// The same for the stamp of a part; `cells` are the cells of the input.
bool ReadStampOfPart(vtkPolyData* input, const SurfaceCells& cells, SurfaceStamp& stamp);
/// Gives the edges of the control level of a part the direction that they have in the whole, where
/// faces that the part lacks may decide it. The points on them, in `cells`, tell.
template <typename Id>
void TurnEdgesOfPart(
  const SurfaceCells& cells, const SurfaceStamp& stamp, SurfaceLevel<Id>& control);
void WriteSurfaceStamp(const SurfaceStamp& stamp, vtkPolyData* output);
void RemoveSurfaceStamp(vtkPolyData* output);

/// Finds the control cells of the cells of an output, with the input cell of the first child of
/// each. Returns false if the cells are no children of such cells, or if `isSame(a, b)` is false
/// for two children of one cell.
bool LiftSurfaceCells(const SurfaceCells& cells, const SurfaceStamp& stamp,
  const std::function<bool(vtkIdType, vtkIdType)>& isSame, SurfaceCells& control);

}

#endif
