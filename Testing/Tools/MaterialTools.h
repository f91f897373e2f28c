// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MaterialTools.h
 * Meshes of several materials, and runs of filters whose values jump at interfaces.
 */
#ifndef SubdivisionObjects_MaterialTools_h
#define SubdivisionObjects_MaterialTools_h

#include "FeatureTools.h"

namespace material_tools
{

using namespace feature_tools;

constexpr const char* IdsName = "MaterialPointIds";
constexpr const char* ConstantName = "Constant"; ///< of cells: GetConstant(material)
constexpr const char* ValueName = "Value";       ///< of points

inline double GetConstant(double material)
{
  return 1.7 * material + 1.;
}

/// Gives a mesh materials, a value that is constant in each, and values at points.
Grid AddMaterials(vtkUnstructuredGrid* mesh, const std::function<int(vtkIdType)>& materialOf);

/// Materials by the place of cells, 0 to 2, so that three meet along a line; and by chance, so that
/// some meet in a line or a point only, and some cells are of another material than those that they
/// are faces of.
std::vector<Grid> MakeMeshes();

inline void KeepInterfaces(vtkSubdivisionAlgorithm* filter)
{
  filter->PreserveInterfacesOn();
}

/// ConstantName becomes a field too.
void Jump(vtkSubdivisionAlgorithm* filter);

struct Choice
{
  const char* Name;
  bool ToLimit;
  std::function<Grid(vtkDataObject*, int, const std::function<void(vtkSubdivisionAlgorithm*)>&)>
    Run;
};

Choice MakeUniform(const char* name, int scheme, bool toLimit);

/// All filters of solids, with different options.
std::vector<Choice> MakeChoices();

/// Whether two outputs have the same values at the same points, but for rounding.
void ExpectSameValues(vtkUnstructuredGrid* expected, vtkUnstructuredGrid* found);

double GetMaterial(vtkUnstructuredGrid* grid, vtkIdType cell);

/// At how many points a filter says that values are not those of the input.
vtkIdType GetNumberOfMisses(const Messages* messages);

/// The dimension of the cells that each point has, at most.
std::vector<int> FindDimensions(vtkUnstructuredGrid* grid);

}

#endif
