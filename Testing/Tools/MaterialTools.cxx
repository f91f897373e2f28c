// SPDX-License-Identifier: BSD-3-Clause
#include "MaterialTools.h"

#include "vtkRedGreenRefinement.h"

namespace material_tools
{
namespace
{

Choice MakeRedGreen(const char* name, bool toLimit)
{
  return { name, toLimit, [=](vtkDataObject* input, int levels, const auto& configure)
    {
      vtkNew<vtkRedGreenRefinement> filter;
      filter->SetMaximumLevel(levels);
      filter->SetRefineByAttributeError(true);
      filter->SetAttributeTolerance(0.4);
      filter->SetInputArrayToProcess(5, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, ValueName);
      filter->SetPlacement(toLimit ? vtkRedGreenRefinement::LIMIT : vtkRedGreenRefinement::LINEAR);
      configure(filter);
      return UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
    } };
}

}

Grid AddMaterials(vtkUnstructuredGrid* mesh, const std::function<int(vtkIdType)>& materialOf)
{
  const Grid grid = DeepCopy(mesh);
  vtkNew<vtkIntArray> materials;
  materials->SetName("MaterialId");
  vtkNew<vtkDoubleArray> constants;
  constants->SetName(ConstantName);
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    const int material = materialOf(c);
    materials->InsertNextValue(material);
    constants->InsertNextValue(GetConstant(material));
  }
  grid->GetCellData()->AddArray(materials);
  grid->GetCellData()->AddArray(constants);
  grid->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>(ValueName, 2, grid->GetNumberOfPoints(), -1., 1., 5));
  return grid;
}

std::vector<Grid> MakeMeshes()
{
  const Grid box = MakeMixedBox(3);
  std::vector<Grid> meshes;
  meshes.push_back(AddMaterials(box,
    [&](vtkIdType c)
    {
      double bounds[6];
      box->GetCellBounds(c, bounds);
      return bounds[0] + bounds[1] < 2.5 ? 0 : (bounds[2] + bounds[3] < 2.5 ? 1 : 2);
    }));
  for (int seed = 0; seed < 5; ++seed)
  {
    std::mt19937 chance(static_cast<unsigned>(seed));
    const Grid mesh = seed == 0 ? box
      : seed == 4               ? MakeKuhnBox(2, 0.1)
                                : MakeRandomComplex(static_cast<unsigned>(seed));
    meshes.push_back(AddMaterials(mesh, [&](vtkIdType) { return static_cast<int>(chance() % 3); }));
  }
  return meshes;
}

void Jump(vtkSubdivisionAlgorithm* filter)
{
  KeepInterfaces(filter);
  filter->SetInterfaceValuesToDiscontinuous();
  filter->AddFieldOfCells(ConstantName);
}

Choice MakeUniform(const char* name, int scheme, bool toLimit)
{
  return { name, toLimit, [=](vtkDataObject* input, int levels, const auto& configure)
    {
      vtkNew<vtkMultiDimensionalSubdivision> filter;
      filter->SetNumberOfLevels(levels);
      filter->SetVolumeScheme(scheme);
      filter->SetProjectToLimit(toLimit);
      configure(filter);
      return UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
    } };
}

std::vector<Choice> MakeChoices()
{
  return { MakeUniform("box spline", vtkMultiDimensionalSubdivision::BOX_SPLINE, false),
    MakeUniform("box spline, limit", vtkMultiDimensionalSubdivision::BOX_SPLINE, true),
    MakeUniform("tet/oct", vtkMultiDimensionalSubdivision::TET_OCT, false),
    MakeUniform("tet/oct, limit", vtkMultiDimensionalSubdivision::TET_OCT, true),
    MakeUniform("linear", vtkMultiDimensionalSubdivision::LINEAR, false),
    MakeRedGreen("red-green", false), MakeRedGreen("red-green, limit", true) };
}

double GetMaterial(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  return grid->GetCellData()->GetArray("MaterialId")->GetComponent(cell, 0);
}

vtkIdType GetNumberOfMisses(const Messages* messages)
{
  for (const std::string& warning : messages->Warnings)
  {
    const std::size_t at = warning.find(" points the values of a material");
    if (at != std::string::npos)
    {
      return std::stoll(warning.substr(warning.rfind("At ", at) + 3));
    }
  }
  return 0;
}

std::vector<int> FindDimensions(vtkUnstructuredGrid* grid)
{
  std::vector<int> dimensions(static_cast<std::size_t>(grid->GetNumberOfPoints()), -1);
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    for (const vtkIdType id : GetCell(grid, c))
    {
      dimensions[static_cast<std::size_t>(id)] =
        std::max(dimensions[static_cast<std::size_t>(id)], grid->GetCell(c)->GetCellDimension());
    }
  }
  return dimensions;
}

void ExpectSameValues(vtkUnstructuredGrid* expected, vtkUnstructuredGrid* found)
{
  ASSERT_EQ(expected->GetNumberOfPoints(), found->GetNumberOfPoints());
  vtkDataArray* theirs = expected->GetPointData()->GetArray(ValueName);
  vtkDataArray* ours = found->GetPointData()->GetArray(ValueName);
  for (vtkIdType p = 0; p < expected->GetNumberOfPoints(); ++p)
  {
    ASSERT_NEAR(theirs->GetComponent(p, 1), ours->GetComponent(p, 1), 1e-13);
  }
}

}
