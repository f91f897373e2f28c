// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridInput.h
 * Reads cells of all types uncut, and the singular edges, faces and vertices between them.
 */
#ifndef SubdivisionObjects_HybridInput_h
#define SubdivisionObjects_HybridInput_h

#include "Core/Memory/Coordinates.h"
#include "Core/Solids/Hybrid/HybridLevel.h"
#include "Private/Uniform/HybridCells.h"
#include "Private/Uniform/UniformSubdivision.h"

#include <functional>
#include <string>
#include <vector>

namespace subdivision
{

/**
 * Reads all cells as cells of their own types. Solids with repeated points are the cells that they
 * are (CollapsedCells.h), non-linear cells their pieces, and four tetrahedra with one OctahedronId
 * an octahedron. Polyhedra and prisms become pyramids and tetrahedra around their centre, which a
 * warning counts, polygons of more than four points triangles. Then cells give way to triangles.
 * `globalIds` orders points (null: the index does).
 */
HybridCells ReadHybridCells(vtkPointSet* input, const vtkIdType* globalIds);

template <typename Id>
CellList<Id> ListCells(const HybridCells& cells);

/// A vertex, edge or face that is singular by marks, embedded cells, materials or angles.
struct DerivedPart
{
  int Dimension;
  std::vector<vtkIdType> Corners;
  double Sharpness; ///< infinite: it stays sharp
};

/// The choices on which strata depend beside the cells of the control mesh.
struct HybridChoices
{
  SingularSimplices Singular; ///< for ever
  SolidSharpness Sharpness;
  StrataOptions Options;
  std::vector<DerivedPart> Derived;

  bool operator==(const HybridChoices& other) const;
};

/// Reads the choices of the control mesh. `sources`: the cell of the input of each cell. If an
/// earlier filter made `made` > 0 steps of it, `derived` are the parts that it derived, and nothing
/// else is. Returns false if the mesh has not all of these.
template <typename Id>
bool ReadHybridChoices(const CellComplex<Id>& complex, const std::vector<vtkIdType>& sources,
  vtkPointSet* input, const FeatureOptions& options, const Coordinates& points, int made,
  const std::vector<DerivedPart>& derived, const std::function<void(const std::string&)>& warn,
  HybridChoices& choices);

/// Tells where cells of the control mesh come apart.
template <typename Id>
void TellOpenPoints(const CellComplex<Id>& complex, const std::vector<vtkIdType>& sources,
  const FeatureOptions& features, const Coordinates& points,
  const std::function<void(const std::string&)>& warn);

/// Decides the strata of the control level.
template <typename Id>
void DecideStrata(HybridLevel<Id>& level, HybridChoices& choices);

}

#endif
