// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Stamp.h
 * How a filter recognises a mesh that this project made (Mathematics 2), so that filters in a row
 * give what one filter would have given.
 *
 * Field data `Subdivision` holds the numbers below, `SubdivisionGlobalIds` the global ids of the
 * first input's points where it had some, `SubdivisionInvertedCells` its simplices of negative
 * and of no volume (SolidOrientation.h), `SubdivisionSingularVertices`, `...Lines`, `...Triangles`
 * the singular simplices that were derived from the first input. The control mesh itself needs no
 * copy: its vertices keep their ids and its simplices' children are consecutive, so it is read off
 * the cells, refined by arithmetic and compared with them. Whatever was changed in between is found
 * out.
 */
#ifndef SubdivisionObjects_Stamp_h
#define SubdivisionObjects_Stamp_h

#include "Core/Memory/SimplexList.h"
#include "Core/Solids/Strata/Singularities.h"

#include <vector>

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

enum class StampScheme
{
  BoxSpline = 0,
  RedGreen = 1,
  TetOct = 2
};

/// Field array of global ids that travel with a stamped mesh.
constexpr const char* GlobalIdsName = "SubdivisionGlobalIds";
/// The same of control simplices that are inverted.
constexpr const char* InvertedCellsName = "SubdivisionInvertedCells";

struct Stamp
{
  StampScheme Scheme = StampScheme::BoxSpline;
  int Levels = 0;                      ///< since the control mesh
  vtkIdType NumberOfControlPoints = 0; ///< centres of split cells included
  /// Points are on the limit: no filter may go on from them as if they were control points.
  bool IsProjected = false;
  bool TetOrderIsFinal = true; ///< else only that of tetrahedra that were made
};

/// False where there is no stamp of that scheme, where it is not of this mesh (numbers or a sample
/// of cells differ), or where a uniform scheme's points are on the limit or its tetrahedra have no
/// final order: such a mesh is like any other.
bool ReadStamp(vtkPointSet* input, StampScheme scheme, Stamp& stamp);

/// Writes or replaces the stamp of a finished output.
void WriteStamp(const Stamp& stamp, vtkUnstructuredGrid* output);

/// The derived singular simplices that travel with a stamped mesh, as tuples of point ids.
void ReadSingularTuples(vtkPointSet* input, SimplexTuples& tuples);
void WriteSingularTuples(const SimplexTuples& tuples, vtkUnstructuredGrid* output);

/// Writes or replaces ids that travel with it; none: there are none.
void WriteIds(const char* name, const std::vector<vtkIdType>& ids, vtkUnstructuredGrid* output);

/// Reads the control mesh off its descendants. False where the cells are not such descendants.
bool FindControlMesh(const SimplexView& descendants, const Stamp& stamp, SimplexList& control);

}

#endif
