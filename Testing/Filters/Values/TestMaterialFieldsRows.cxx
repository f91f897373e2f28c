// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMaterialFieldsRows.cxx
 * Values that jump at interfaces: the rows of each material, against those of the operator.
 */
#include "MaterialTools.h"

#include "vtkSubdivisionOperator.h"

using namespace material_tools;

namespace
{

/// The value of each material at each point that it has: by material and point without copies.
using ValueOf = std::map<std::pair<double, vtkIdType>, double>;

ValueOf ReadValues(vtkUnstructuredGrid* torn)
{
  vtkDataArray* ids = torn->GetPointData()->GetArray(IdsName);
  vtkDataArray* values = torn->GetPointData()->GetArray(ValueName);
  ValueOf read;
  for (vtkIdType c = 0; c < torn->GetNumberOfCells(); ++c)
  {
    for (const vtkIdType id : GetCell(torn, c))
    {
      if (torn->GetCell(c)->GetCellDimension() == 3)
      {
        read[{ GetMaterial(torn, c), static_cast<vtkIdType>(ids->GetComponent(id, 0)) }] =
          values->GetComponent(id, 0);
      }
    }
  }
  return read;
}

/// Tetrahedra of a material each: the second has a point of the first, the third a face of the
/// second, and the fourth an edge of the third.
Grid MakeChain()
{
  const Grid tets =
    MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 0.3, 0.3, 1. }, { 0., 0., 2. },
               { 0., 1., 2. }, { 1., 0., 2. }, { 0.3, 0.3, 3. }, { -1., 0., 3. }, { 0., -1., 3. } },
      { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 3, 6, 5, 4 } }, { VTK_TETRA, { 4, 6, 5, 7 } },
        { VTK_TETRA, { 4, 7, 8, 9 } } });
  return AddMaterials(tets, [](vtkIdType c) { return static_cast<int>(c); });
}

}

/// A row has its columns of points that the material has, divided by the sum of these.
TEST(MaterialFieldsRows, AreThoseOfPointsWithoutOtherColumns)
{
  const Grid mesh = MakeChain();
  for (const int scheme :
    { vtkMultiDimensionalSubdivision::BOX_SPLINE, vtkMultiDimensionalSubdivision::TET_OCT })
  {
    SCOPED_TRACE(scheme);
    const Choice choice = MakeUniform("", scheme, false);
    const Grid torn = choice.Run(mesh, 0, Jump);
    for (vtkIdType i = 0; i < torn->GetNumberOfPoints(); ++i) // copies have values of their own
    {
      torn->GetPointData()->GetArray(ValueName)->SetComponent(i, 0, std::sin(3. * i + 1.));
    }
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    KeepInterfaces(filter);
    filter->SetInputDataObject(mesh);
    filter->SetVolumeScheme(scheme);
    filter->SetNumberOfLevels(1);
    vtkNew<vtkSubdivisionOperator> operation;
    ASSERT_TRUE(filter->ComputeOperator(operation));
    vtkNew<vtkIdTypeArray> offsets;
    vtkNew<vtkIdTypeArray> ids;
    vtkNew<vtkDoubleArray> weights;
    operation->GetRows(offsets, ids, weights);
    const ValueOf before = ReadValues(torn);
    int dropped = 0;
    for (const auto& [place, value] : ReadValues(choice.Run(torn, 1,
           [](vtkSubdivisionAlgorithm* jumping)
           {
             Jump(jumping);
             jumping->RemoveAllFieldsOfCells();
           })))
    {
      double sum = 0.;
      double all = 0.;
      for (vtkIdType i = offsets->GetValue(place.second); i < offsets->GetValue(place.second + 1);
        ++i)
      {
        const auto found = before.find({ place.first, ids->GetValue(i) });
        const double weight = found == before.end() ? 0. : weights->GetValue(i);
        sum += found == before.end() ? 0. : weight * found->second;
        all += weight;
      }
      dropped += all < 0.999 ? 1 : 0;
      ASSERT_NEAR(value, sum / all, 1e-12) << place.first << " " << place.second;
    }
    EXPECT_GE(dropped, 6);
  }
}

/// A material that touches another in a point: beyond that lies a third one, which has nothing to
/// do with the first.
TEST(MaterialFieldsRows, MaterialsBeyondTheNextDoNotMix)
{
  const Grid mesh = MakeChain();
  const Choice choice = MakeUniform("", vtkMultiDimensionalSubdivision::BOX_SPLINE, false);
  const auto run = [&](double beyond)
  {
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      mesh->GetPointData()->GetArray(ValueName)->SetComponent(i, 0, i < 4 ? 1. : beyond);
    }
    return ReadValues(choice.Run(mesh, 2,
      [](vtkSubdivisionAlgorithm* filter)
      {
        Jump(filter);
        filter->RemoveAllFieldsOfCells();
      }));
  };
  for (const auto& [place, value] : run(100.))
  {
    if (place.first == 0.)
    {
      EXPECT_EQ(value, 1.) << place.second;
    }
  }
}
