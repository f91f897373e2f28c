// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceStamp.h
 * How vtkSurfaceSubdivision recognises its own output, so that filters in a row give what one
 * filter would have given (Mathematics 2).
 *
 * Field data `SubdivisionSurface` holds numbers, `SubdivisionSurfaceSizes` the corners of each
 * control face where they differ, `SubdivisionCornerAngles` the angles that were measured at
 * corners, `SubdivisionSharpAngles` those of faces, and `SubdivisionSharpCorners` what was given of
 * vertices, where creases are sharp for some levels, `SubdivisionSurfaceCreases` the edges that
 * were detected as features, as pairs of control points. Control points keep their ids and children
 * are consecutive, so the control mesh is read off the cells; it is refined again and compared with
 * them. Of schemes that do not halve edges, `SubdivisionSurfaceCells` has the control cells, and
 * the creases are all that there are, with corners as pairs of one point. Where some faces have no
 * cells of their own, `SubdivisionCarried:LEVEL:NAME` is the cell array NAME of all faces of a
 * level (Mathematics 1).
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

/// The cell data of earlier faces: a cell that lies in two of them shows those of one only.
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

struct SurfaceStamp
{
  int Scheme = 0;
  int Levels = 0;
  vtkIdType NumberOfControlPoints = 0;
  vtkIdType NumberOfControlFaces = 0;
  int Size = 0; ///< corners of each control face; 0: see Sizes
  std::vector<vtkIdType> Sizes;
  std::vector<double> Angles;
  /// Where creases end after some levels there are other corners in each, whose angles are those of
  /// the first input too: pairs of a corner of a control face and its angle; three numbers for each
  /// control point, itself and the angle and flatness that were given or -1.
  std::vector<double> FaceAngles;
  std::vector<double> GivenCorners;
  std::vector<vtkIdType> Creases;
  /// Segments, two points each, the corners of the control faces, vertices; empty: from the
  /// children.
  std::vector<vtkIdType> Cells;
  CarriedCells Carried;

  /// `size`: corners of each face, 0 if they differ; `withCells`: sets Cells, too.
  void SetControl(const SurfaceCells& control, int size, bool withCells);
};

/// False where there is no stamp, or it is not of this mesh.
bool ReadSurfaceStamp(vtkPolyData* input, SurfaceStamp& stamp);
void WriteSurfaceStamp(const SurfaceStamp& stamp, vtkPolyData* output);
void RemoveSurfaceStamp(vtkPolyData* output);

/// The control cells of the cells of an output, with the input cell of the first child of each.
/// False where they cannot be such, or `isSame(a, b)` tells the cells of two children apart.
bool LiftSurfaceCells(const SurfaceCells& cells, const SurfaceStamp& stamp,
  const std::function<bool(vtkIdType, vtkIdType)>& isSame, SurfaceCells& control);

}

#endif
