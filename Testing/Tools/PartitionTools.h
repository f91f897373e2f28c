// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PartitionTools.h
 * Parts of a mesh, and whether what a filter makes of them is what it makes of the whole.
 */
#ifndef SubdivisionObjects_PartitionTools_h
#define SubdivisionObjects_PartitionTools_h

#include "MultiDimensionalSubdivisionTools.h"

#include "vtkPointSet.h"

namespace partition_tools
{

using Mesh = vtkSmartPointer<vtkPointSet>;

/// The cell array by which cells of parts and of the whole are compared.
constexpr const char* CellName = "NumberOfCell";

/// Numbers the cells, so that parts of the mesh know which they have.
void NumberCells(vtkPointSet* mesh);

/// The built-in models and a box with cells of all kinds, with arrays and numbers.
std::vector<Mesh> MakeMeshes();

/// The surfaces, curves and points of a mesh, with numbers.
Mesh MakeSkin(vtkPointSet* mesh);

enum class KnownBy
{
  Coordinates,
  GlobalIds ///< of points and cells: their indices in the whole
};

/// Parts of a mesh: `partOf[c]` is that of cell c. Points that no cell uses go to the first part.
std::vector<Mesh> Cut(vtkPointSet* whole, const std::vector<int>& partOf, int parts, KnownBy known);

/// Each cell goes to a part by chance.
std::vector<int> CutByChance(vtkPointSet* whole, int parts, unsigned seed);

/// Slabs along x.
std::vector<int> CutInSlabs(vtkPointSet* whole, int parts);

/// Whether the parts of an output have the cells of the whole output, each once, with the same
/// points, coordinates and arrays, bit for bit. Both come from meshes with NumberCells.
void ExpectWhole(vtkPointSet* whole, const std::vector<Mesh>& parts);

}

#endif
