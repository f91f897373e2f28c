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

/// The same of other types: the pyramid has a point of the hexahedron.
Grid MakeMixedChain()
{
  const Grid mixed =
    MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 1., 1., 0. }, { 0., 1., 0. }, { 0., 0., 1. },
               { 1., 0., 1. }, { 1., 1., 1. }, { 0., 1., 1. }, { 0.5, 0.5, 2. }, { 1.5, 0.5, 2. },
               { 1.5, 1.5, 2. }, { 0.5, 1.5, 2. }, { 0.5, 0.5, 3. }, { 1.5, 0.5, 3. },
               { 0.5, -1., 3. }, { 0.5, 0., 4. } },
      { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } }, { VTK_PYRAMID, { 8, 9, 10, 11, 6 } },
        { VTK_WEDGE, { 12, 8, 11, 13, 9, 10 } }, { VTK_TETRA, { 12, 13, 14, 15 } } });
  return AddMaterials(mixed, [](vtkIdType c) { return static_cast<int>(c); });
}

struct Chain
{
  const char* Name;
  Grid Mesh;
  int Scheme;
};
std::vector<Chain> MakeChains()
{
  return { { "box spline", MakeChain(), vtkMultiDimensionalSubdivision::BOX_SPLINE },
    { "tet/oct", MakeChain(), vtkMultiDimensionalSubdivision::TET_OCT },
    { "hybrid, tetrahedra", MakeChain(), vtkMultiDimensionalSubdivision::HYBRID },
    { "hybrid", MakeMixedChain(), vtkMultiDimensionalSubdivision::HYBRID } };
}

}

/// A row has its columns of points that the material has, divided by the sum of these.
TEST(MaterialFieldsRows, AreThoseOfPointsWithoutOtherColumns)
{
  for (const auto& [name, mesh, scheme] : MakeChains())
  {
    SCOPED_TRACE(name);
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
  for (const auto& chain : MakeChains())
  {
    SCOPED_TRACE(chain.Name);
    const Grid mesh = chain.Mesh;
    const Choice choice = MakeUniform("", chain.Scheme, false);
    const std::set<vtkIdType> first = [&]
    {
      const auto points = GetCell(mesh, 0);
      return std::set<vtkIdType>(points.begin(), points.end());
    }();
    vtkDataArray* values = mesh->GetPointData()->GetArray(ValueName);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      values->SetComponent(i, 0, first.count(i) ? 1. : 100.);
    }
    int found = 0;
    for (const int levels : { 2, 3 })
    {
      for (const bool isLimit : { false, true })
      {
        for (const auto& [place, value] : ReadValues(choice.Run(mesh, levels,
               [isLimit](vtkSubdivisionAlgorithm* filter)
               {
                 Jump(filter);
                 filter->RemoveAllFieldsOfCells();
                 vtkUniformSubdivisionAlgorithm::SafeDownCast(filter)->SetProjectToLimit(isLimit);
               })))
        {
          if (place.first == 0.)
          {
            EXPECT_NEAR(value, 1., 1e-12) << place.second << " after " << levels;
            ++found;
          }
        }
      }
    }
    EXPECT_GT(found, 100);
  }
}

/// Where materials touch in a point, rows go across it. Then a new point in another material has
/// weights of a material after a level, which must not count in the next one: two levels are two
/// filters, the second of which begins with the materials of cells.
TEST(MaterialFieldsRows, TwoLevelsAreTwoFilters)
{
  for (const auto& chain : MakeChains())
  {
    SCOPED_TRACE(chain.Name);
    vtkDataArray* values = chain.Mesh->GetPointData()->GetArray(ValueName);
    for (vtkIdType i = 0; i < chain.Mesh->GetNumberOfPoints(); ++i)
    {
      values->SetComponent(i, 0, std::sin(7. * static_cast<double>(i)));
    }
    const auto run = [&chain](vtkUnstructuredGrid* mesh, int levels)
    {
      vtkNew<vtkMultiDimensionalSubdivision> filter;
      Jump(filter);
      filter->RemoveAllFieldsOfCells();
      KeepInterfaces(filter);
      filter->SetVolumeScheme(chain.Scheme);
      filter->SetNumberOfLevels(levels);
      filter->SetInputDataObject(mesh);
      filter->Update();
      return DeepCopy(filter->GetOutput());
    };
    const ValueOf twice = ReadValues(run(run(chain.Mesh, 1), 1));
    const ValueOf once = ReadValues(run(chain.Mesh, 2));
    ASSERT_EQ(once.size(), twice.size());
    for (const auto& [place, value] : once)
    {
      const auto found = twice.find(place);
      ASSERT_NE(found, twice.end());
      EXPECT_NEAR(value, found->second, 1e-12) << place.first << " " << place.second;
    }
  }
}
