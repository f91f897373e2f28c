// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestEditedOutputs.cxx
 * Who has an output may write into its arrays, as NumPy does, and no modified time tells. What
 * filters keep between executions may not depend on it: the next outputs are those of a new filter.
 */
#include "FeatureTools.h"
#include "SubdivisionDeformationTools.h"
#include "SurfaceTools.h"

#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSimplicialComplexTopology.h"
#include "vtkSubdivisionSmoothness.h"

#include <cstring>

using namespace feature_tools;

namespace
{

using Mesh = vtkSmartPointer<vtkPointSet>;
using Algorithm = vtkSmartPointer<vtkAlgorithm>;

std::vector<vtkCellArray*> GetCellArrays(vtkPointSet* mesh)
{
  if (auto* surface = vtkPolyData::SafeDownCast(mesh))
  {
    return { surface->GetVerts(), surface->GetLines(), surface->GetPolys() };
  }
  return { vtkUnstructuredGrid::SafeDownCast(mesh)->GetCells() };
}

/// All arrays of numbers of a mesh.
std::vector<vtkSmartPointer<vtkDataArray>> GetArrays(vtkPointSet* mesh)
{
  std::vector<vtkSmartPointer<vtkDataArray>> arrays{ mesh->GetPoints()->GetData() };
  for (vtkCellArray* cells : GetCellArrays(mesh))
  {
    arrays.emplace_back(cells->GetConnectivityArray());
    arrays.emplace_back(cells->GetOffsetsArray());
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh))
  {
    arrays.emplace_back(subdivision::GetCellTypes(grid));
  }
  for (vtkFieldData* data :
    { mesh->GetFieldData(), static_cast<vtkFieldData*>(mesh->GetPointData()),
      static_cast<vtkFieldData*>(mesh->GetCellData()) })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      if (data->GetArray(i))
      {
        arrays.emplace_back(data->GetArray(i));
      }
    }
  }
  return arrays;
}

/// Writes zeros into one array of the output after the other, in the way of NumPy; not into those
/// that pass from the input.
void WriteZeros(vtkPointSet* output, const std::vector<Mesh>& inputs, std::size_t which)
{
  std::set<vtkDataArray*> passed;
  for (const Mesh& input : inputs)
  {
    for (const auto& array : GetArrays(input))
    {
      passed.insert(array);
    }
  }
  const auto arrays = GetArrays(output);
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    vtkDataArray* array = arrays[i];
    if ((which == arrays.size() || which == i) && passed.count(array) == 0 &&
      array->GetNumberOfValues() > 0)
    {
      std::memset(array->GetVoidPointer(0), 0,
        static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
    }
  }
}

vtkPointSet* Run(vtkAlgorithm* filter, const std::vector<Mesh>& inputs)
{
  for (std::size_t port = 0; port < inputs.size(); ++port)
  {
    filter->SetInputDataObject(static_cast<int>(port), inputs[port]);
  }
  filter->Modified();
  filter->Update();
  return vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0));
}

/// Runs a filter again and again, writes into its outputs, and compares with new filters. Values,
/// points, and `choose(filter, turn)` are what changes.
void CheckThatEditsDoNotCount(
  const std::string& what, const std::vector<Mesh>& inputs, const std::function<Algorithm()>& make,
  const std::function<void(vtkAlgorithm*, int)>& choose = [](vtkAlgorithm*, int) {})
{
  const Algorithm first = make();
  const std::size_t arrays = GetArrays(Run(first, inputs)).size();
  for (std::size_t which = 0; which <= arrays; ++which)
  {
    const Algorithm filter = make();
    choose(filter, 0);
    Run(filter, inputs);
    for (int turn = 1; turn < 5; ++turn)
    {
      WriteZeros(vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0)), inputs, which);
      vtkPointSet* mesh = inputs.back();
      if (turn == 1)
      {
        mesh->GetPointData()->GetArray("Values")->SetComponent(1, 0, 0.1 * turn);
      }
      else if (turn < 4)
      {
        double x[3];
        mesh->GetPoints()->GetPoint(1, x);
        mesh->GetPoints()->SetPoint(1, x[0] + 0.01, x[1], x[2]);
      }
      choose(filter, turn);
      vtkPointSet* output = Run(filter, inputs);
      const Algorithm fresh = make();
      choose(fresh, turn);
      ASSERT_EQ(Compare(output, Run(fresh, inputs)), "")
        << what << ", array " << which << ", turn " << turn;
    }
  }
}

Mesh WithValues(vtkPointSet* mesh)
{
  mesh->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("Values", 1, mesh->GetNumberOfPoints(), 0, 1, 7));
  return mesh;
}

}

TEST(EditedOutputs, OfVolumeSchemes)
{
  for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT, Filter::LINEAR })
  {
    for (const int levels : { 0, 1, 2 })
    {
      for (const bool limit : { false, true })
      {
        CheckThatEditsDoNotCount(
          "scheme " + std::to_string(scheme) + ", levels " + std::to_string(levels),
          { WithValues(MakeKuhnBox(1, 0.1)) },
          [&]
          {
            auto filter = vtkSmartPointer<Filter>::New();
            filter->SetVolumeScheme(scheme);
            filter->SetNumberOfLevels(levels);
            filter->SetProjectToLimit(limit);
            filter->SetGenerateClassification(limit);
            filter->SetGenerateLimitNormals(limit);
            filter->SetUse32BitIds(limit);
            return filter;
          },
          [](vtkAlgorithm* filter, int turn)
          {
            if (turn == 4) // the same cells with other rules
            {
              Filter::SafeDownCast(filter)->SetType1RuleToSharp();
            }
          });
      }
    }
  }
}

TEST(EditedOutputs, OfSurfaceSchemes)
{
  for (int scheme = vtkSurfaceSubdivision::LOOP; scheme <= vtkSurfaceSubdivision::LINEAR; ++scheme)
  {
    const auto mesh =
      surfacetools::MakeInput(surfacetools::MakeSheet(3, 3, true, { 1., 0., 0. }, { 0., 1., 0. }));
    CheckThatEditsDoNotCount("scheme " + std::to_string(scheme), { WithValues(mesh) },
      [scheme]
      {
        auto filter = vtkSmartPointer<vtkSurfaceSubdivision>::New();
        filter->SetScheme(scheme);
        filter->SetNumberOfLevels(2);
        return filter;
      });
  }
}

TEST(EditedOutputs, OfOtherFilters)
{
  CheckThatEditsDoNotCount("types", { WithValues(MakeKuhnBox(1, 0.1)) },
    []
    {
      auto filter = vtkSmartPointer<Filter>::New();
      filter->SetVolumeSchemeToLinear();
      filter->KeepCellTypesOn();
      return filter;
    });
  CheckThatEditsDoNotCount("red-green", { WithValues(MakeKuhnBox(1, 0.1)) },
    []
    {
      auto filter = vtkSmartPointer<vtkRedGreenRefinement>::New();
      filter->RefineByAttributeErrorOff();
      filter->RefineByEdgeLengthOn();
      filter->SetMaximumEdgeLength(0.7);
      return filter;
    });
  CheckThatEditsDoNotCount("topology", { WithValues(MakeKuhnBox(1, 0.1)) },
    [] { return vtkSmartPointer<vtkSimplicialComplexTopology>::New(); });
  CheckThatEditsDoNotCount("smoothness", { WithValues(MakeKuhnBox(1, 0.1)) },
    [] { return vtkSmartPointer<vtkSubdivisionSmoothness>::New(); });
  CheckThatEditsDoNotCount("adaptive",
    { WithValues(surfacetools::MakeInput(
      surfacetools::MakeSheet(3, 3, true, { 1., 0., 0. }, { 0., 1., 0.5 }))) },
    [] { return vtkSmartPointer<vtkAdaptiveSurfaceSubdivision>::New(); });
  const Grid cage = MakeKuhnBox(2);
  for (const int levels : { 0, 2 })
  {
    CheckThatEditsDoNotCount("deformation",
      { deformation_tools::MakeCloud(9, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1), cage,
        WithValues(DeepCopy(cage)) },
      [levels]
      {
        auto filter = vtkSmartPointer<vtkSubdivisionDeformation>::New();
        filter->SetNumberOfLevels(levels);
        return filter;
      });
  }
}
