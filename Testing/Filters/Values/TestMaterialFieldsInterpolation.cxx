// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMaterialFieldsInterpolation.cxx
 * Values that jump and are interpolated: InterfaceValues with InterpolateArrays.
 */
#include "FileTools.h"
#include "MaterialTools.h"

#include "vtkSurfaceSubdivision.h"

using namespace material_tools;

namespace
{

void JumpInterpolated(vtkSubdivisionAlgorithm* filter)
{
  Jump(filter);
  filter->InterpolateArraysOn();
}

/// Copies that exist already, each with a value of its own.
Grid MakeTorn(vtkUnstructuredGrid* mesh)
{
  const Grid torn = MakeUniform("", vtkMultiDimensionalSubdivision::BOX_SPLINE, false)
                      .Run(mesh, 0,
                        [](vtkSubdivisionAlgorithm* filter)
                        {
                          Jump(filter);
                          filter->RemoveAllFieldsOfCells();
                        });
  RemoveStamp(torn);
  torn->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>(ValueName, 2, torn->GetNumberOfPoints(), -1., 1., 9));
  return torn;
}

using Values = std::map<std::pair<vtkIdType, double>, std::array<double, 2>>;

/// The values that each material has at the first points, in cells that are no faces of others.
Values ReadValues(vtkUnstructuredGrid* torn, vtkIdType points)
{
  vtkDataArray* ids = torn->GetPointData()->GetArray(IdsName);
  vtkDataArray* values = torn->GetPointData()->GetArray(ValueName);
  const std::vector<int> dimensions = FindDimensions(torn);
  Values read;
  for (vtkIdType c = 0; c < torn->GetNumberOfCells(); ++c)
  {
    for (const vtkIdType p : GetCell(torn, c))
    {
      const auto id = static_cast<vtkIdType>(ids->GetComponent(p, 0));
      if (id < points && dimensions[static_cast<std::size_t>(p)] == 3 &&
        torn->GetCell(c)->GetCellDimension() == 3)
      {
        read[{ id, GetMaterial(torn, c) }] = { values->GetComponent(p, 0),
          values->GetComponent(p, 1) };
      }
    }
  }
  return read;
}

vtkIdType CountOriginals(vtkUnstructuredGrid* torn)
{
  vtkDataArray* ids = torn->GetPointData()->GetArray(IdsName);
  vtkIdType count = 0;
  while (count < torn->GetNumberOfPoints() && ids->GetComponent(count, 0) == count)
  {
    ++count;
  }
  return count;
}

/// How many points of materials have other values.
vtkIdType CountDifferences(const Values& given, const Values& found)
{
  EXPECT_EQ(found.size(), given.size());
  return std::count_if(given.begin(), given.end(),
    [&](const auto& value)
    {
      const auto at = found.find(value.first);
      return at == found.end() || std::abs(at->second[0] - value.second[0]) > 2e-10 ||
        std::abs(at->second[1] - value.second[1]) > 2e-10;
    });
}

}

// The limit of the values of each material passes through those that the input has, on both sides
// of an interface.
TEST(MaterialFieldsInterpolation, EachMaterialHasItsOwnValues)
{
  const std::vector<Grid> meshes = MakeMeshes();
  for (const Grid& mesh : meshes)
  {
    const Grid torn = MakeTorn(mesh);
    const vtkIdType points = CountOriginals(torn);
    ASSERT_LT(points, torn->GetNumberOfPoints());
    const Values given = ReadValues(torn, points);
    for (const Choice& choice : MakeChoices())
    {
      for (const int levels : { 0, 1, 2 })
      {
        SCOPED_TRACE(std::string(choice.Name) + ", levels " + std::to_string(levels) +
          ", mesh of " + std::to_string(mesh->GetNumberOfCells()) + " cells");
        if (choice.ToLimit)
        {
          vtkNew<Messages> messages;
          const Grid made = choice.Run(torn, levels,
            [&](vtkSubdivisionAlgorithm* filter)
            {
              JumpInterpolated(filter);
              messages->Watch(filter);
            });
          const vtkIdType different = CountDifferences(given, ReadValues(made, points));
          EXPECT_TRUE(different == 0 || (levels > 0 && mesh != meshes.front()));
          EXPECT_LE(different, GetNumberOfMisses(messages));
          EXPECT_LE(GetNumberOfMisses(messages), 2 * different);
          const Grid smoothed = choice.Run(torn, levels, Jump);
          EXPECT_GT(CountDifferences(given, ReadValues(smoothed, points)),
            static_cast<vtkIdType>(given.size()) / 4);
        }
      }
    }
  }
}

// A material of small values is as exact as one of large values: the tolerance is a part of its own
// range.
TEST(MaterialFieldsInterpolation, EachMaterialHasItsOwnTolerance)
{
  const Grid torn = MakeTorn(MakeMeshes().front());
  const vtkIdType points = CountOriginals(torn);
  vtkDataArray* values = torn->GetPointData()->GetArray(ValueName);
  std::set<vtkIdType> seen;
  std::map<double, double> scales;
  for (vtkIdType c = 0; c < torn->GetNumberOfCells(); ++c)
  {
    const double material = GetMaterial(torn, c);
    const double scale = scales[material] = std::pow(10., 6. * (std::fmod(material, 3.) - 1.));
    for (const vtkIdType p : GetCell(torn, c))
    {
      for (int k = 0; k < 2 && seen.count(p) == 0; ++k)
      {
        // The large values are constant: they need no iteration.
        values->SetComponent(p, k, scale > 1. ? scale : scale * values->GetComponent(p, k));
      }
      seen.insert(p);
    }
  }
  const Values given = ReadValues(torn, points);
  const Values found = ReadValues(MakeUniform("", vtkMultiDimensionalSubdivision::BOX_SPLINE, true)
                                    .Run(torn, 0, JumpInterpolated),
    points);
  ASSERT_EQ(found.size(), given.size());
  ASSERT_GT(scales.size(), 1u);
  for (const auto& [where, value] : given)
  {
    for (int k = 0; k < 2; ++k)
    {
      EXPECT_NEAR(found.at(where)[k], value[k], 2e-10 * scales.at(where.second))
        << "material " << where.second;
    }
  }
}

// What is constant in each material stays so.
TEST(MaterialFieldsInterpolation, ConstantsStayConstant)
{
  for (const Grid& mesh : MakeMeshes())
  {
    for (const Choice& choice : MakeChoices())
    {
      SCOPED_TRACE(choice.Name);
      if (!choice.ToLimit)
      {
        continue;
      }
      const Grid torn = choice.Run(mesh, 2, JumpInterpolated);
      vtkDataArray* constants = torn->GetPointData()->GetArray(ConstantName);
      for (vtkIdType c = 0; c < torn->GetNumberOfCells(); ++c)
      {
        for (const vtkIdType id : GetCell(torn, c))
        {
          ASSERT_TRUE(torn->GetCell(c)->GetCellDimension() < 3 ||
            std::abs(GetConstant(GetMaterial(torn, c)) - constants->GetComponent(id, 0)) < 1e-14);
        }
      }
    }
  }
}

// One material alone has the values of a continuous field that is interpolated.
TEST(MaterialFieldsInterpolation, OneMaterialIsContinuous)
{
  const Grid mesh = AddMaterials(MakeMixedBox(2), [](vtkIdType) { return 4; });
  for (const Choice& choice : MakeChoices())
  {
    SCOPED_TRACE(choice.Name);
    if (!choice.ToLimit)
    {
      continue;
    }
    const Grid torn = choice.Run(mesh, 2, JumpInterpolated);
    const Grid whole = choice.Run(mesh, 2,
      [](vtkSubdivisionAlgorithm* filter)
      {
        KeepInterfaces(filter);
        filter->InterpolateArraysOn();
      });
    ExpectSameValues(whole, torn);
  }
}

// InterpolationWeight blends, arrays are chosen by their name, points are interpolated beside them.
TEST(MaterialFieldsInterpolation, OptionsOfInterpolation)
{
  const Grid mesh = MakeMeshes().front();
  const Choice choice = MakeUniform("", vtkMultiDimensionalSubdivision::BOX_SPLINE, true);
  const auto run = [&](double weight, const char* name, bool points)
  {
    return choice.Run(mesh, 1,
      [&](vtkSubdivisionAlgorithm* filter)
      {
        JumpInterpolated(filter);
        filter->SetInterpolationWeight(weight);
        filter->AddInterpolatedArray(name);
        filter->SetInterpolatePoints(points);
      });
  };
  const Grid smoothed = run(0., ValueName, false);
  const Grid half = run(0.5, ValueName, false);
  const Grid whole = run(1., ValueName, true);
  const auto get = [](vtkUnstructuredGrid* grid, vtkIdType p)
  { return grid->GetPointData()->GetArray(ValueName)->GetComponent(p, 0); };
  ASSERT_EQ(whole->GetNumberOfPoints(), half->GetNumberOfPoints());
  double largest = 0.;
  for (vtkIdType p = 0; p < whole->GetNumberOfPoints(); ++p)
  {
    EXPECT_NEAR(get(half, p), (get(smoothed, p) + get(whole, p)) / 2., 1e-13);
    largest = std::max(largest, std::abs(get(half, p) - get(whole, p)));
  }
  EXPECT_GT(largest, 0.1);
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(GetPoint(mesh, p)[k], GetPoint(whole, p)[k], 1e-9);
    }
  }
  const Grid other = run(1., ConstantName, false);
  EXPECT_EQ(CompareArrays(other->GetPointData(), smoothed->GetPointData(), "points"), "");
}

// Float values that are much larger than their range are rounded: that is no miss.
TEST(MaterialFieldsInterpolation, RoundingOfLargeValuesIsNoMiss)
{
  const Grid torn = MakeTorn(MakeMeshes().front());
  torn->GetPointData()->AddArray(
    MakeArray<vtkFloatArray>(ValueName, 2, torn->GetNumberOfPoints(), 9999., 1e4, 9));
  for (const Choice& choice : MakeChoices())
  {
    for (const int levels : { 0, 3 })
    {
      SCOPED_TRACE(std::string(choice.Name) + ", levels " + std::to_string(levels));
      vtkNew<Messages> messages;
      choice.Run(torn, choice.ToLimit ? levels : 1,
        [&](vtkSubdivisionAlgorithm* filter)
        {
          JumpInterpolated(filter);
          messages->Watch(filter);
        });
      EXPECT_EQ(GetNumberOfMisses(messages), 0);
    }
  }
}

// With kept operators, and other values, there is the same.
TEST(MaterialFieldsInterpolation, KeptOperators)
{
  const Grid mesh = MakeMeshes()[1];
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToBoxSpline();
  JumpInterpolated(filter);
  filter->ProjectToLimitOn();
  UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), mesh);
  const vtkIdType builds = filter->GetNumberOfTopologyBuilds();
  const Grid other = DeepCopy(mesh);
  other->GetPointData()->GetArray(ValueName)->SetComponent(7, 0, 12.);
  const Grid again = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), other);
  EXPECT_EQ(builds, filter->GetNumberOfTopologyBuilds());
  const Choice fresh = MakeUniform("", vtkMultiDimensionalSubdivision::BOX_SPLINE, true);
  EXPECT_EQ("", Compare(fresh.Run(other, 1, JumpInterpolated), again));
}

// The values beyond the range of the input are counted in the output: those of each copy, and none
// of what the filter needs inside.
TEST(MaterialFieldsInterpolation, CountsWhatExceedsTheRange)
{
  const Grid mesh = MakeMeshes().front();
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetNumberOfLevels(1);
  filter->ProjectToLimitOn();
  JumpInterpolated(filter);
  filter->SetInputData(mesh);
  filter->Update();
  vtkDataArray* values = filter->GetOutput()->GetPointData()->GetArray(ValueName);
  vtkDataArray* given = mesh->GetPointData()->GetArray(ValueName);
  vtkIdType count = 0;
  for (int k = 0; k < 2; ++k)
  {
    double range[2];
    given->GetRange(range, k);
    const double tie = 1e-9 * (range[1] - range[0]);
    for (vtkIdType p = 0; p < values->GetNumberOfTuples(); ++p)
    {
      const double value = values->GetComponent(p, k);
      count += value < range[0] - tie || value > range[1] + tie ? 1 : 0;
    }
  }
  EXPECT_GT(count, 0);
  EXPECT_EQ(1, messages->CountWarnings("exceed the range"));
  const std::vector<int> dimensions = FindDimensions(filter->GetOutput());
  const auto unused = std::count(dimensions.begin(), dimensions.end(), -1);
  EXPECT_EQ(1,
    messages->CountWarnings(": " + std::to_string(count) + " of " +
      std::to_string(values->GetNumberOfValues() - 2 * unused) + " values of " + ValueName));
  EXPECT_EQ(0, messages->CountWarnings("SubdivisionField"));
  EXPECT_EQ(0, messages->CountWarnings(ConstantName));
}

// A real mesh of several materials, with a value for each cell that is made a field.
TEST(MaterialFieldsInterpolation, AFile)
{
  const std::string path = file_tools::GetSharedFile("tet_gmsh_coil_crack.vtu");
  if (const std::string reason = file_tools::WhyNotRead(path); !reason.empty())
  {
    GTEST_SKIP() << reason;
  }
  const Grid file = DeepCopy(file_tools::ReadGrid(path));
  vtkNew<vtkDoubleArray> values;
  values->SetName(ValueName);
  values->SetNumberOfComponents(2);
  for (vtkIdType p = 0; p < file->GetNumberOfPoints(); ++p)
  {
    const Point x = GetPoint(file, p);
    values->InsertNextTuple2(std::sin(900. * x[0]), std::cos(700. * x[1] + 300. * x[2]));
  }
  file->GetPointData()->AddArray(values);
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetNumberOfLevels(0);
  filter->ProjectToLimitOn();
  filter->PreserveInterfacesOn();
  filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "PhysicalIds");
  filter->SetInterfaceValuesToDiscontinuous();
  filter->InterpolateArraysOn();
  filter->SetInputData(file);
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty());
  EXPECT_EQ(0, messages->CountWarnings("does not pass"));
  vtkPointData* data = filter->GetOutput()->GetPointData();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), file->GetNumberOfPoints());
  for (vtkIdType p = 0; p < filter->GetOutput()->GetNumberOfPoints(); ++p)
  {
    const auto id = static_cast<vtkIdType>(data->GetArray(IdsName)->GetComponent(p, 0));
    for (int k = 0; k < 2; ++k)
    {
      ASSERT_NEAR(
        values->GetComponent(id, k), data->GetArray(ValueName)->GetComponent(p, k), 2e-10);
    }
  }
}

TEST(MaterialFieldsInterpolation, NothingToInterpolate)
{
  // Points without cells, and a cell that is left out.
  for (const std::vector<Cell>& cells :
    { std::vector<Cell>{}, std::vector<Cell>{ { VTK_TRIANGLE, { 0, 1, 1 } } } })
  {
    const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, cells);
    vtkNew<vtkDoubleArray> values;
    values->SetName("T");
    values->SetNumberOfValues(3);
    values->FillValue(1.);
    grid->GetPointData()->AddArray(values);
    vtkNew<vtkIntArray> materials;
    materials->SetName("M");
    materials->SetNumberOfValues(grid->GetNumberOfCells());
    materials->FillValue(1);
    grid->GetCellData()->AddArray(materials);
    for (const bool isOfSurfaces : { false, true })
    {
      const auto run = [&](auto filter)
      {
        vtkNew<Messages> messages;
        messages->Watch(filter);
        filter->SetInputDataObject(grid);
        filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "M");
        filter->PreserveInterfacesOn();
        filter->SetInterfaceValuesToDiscontinuous();
        filter->InterpolateArraysOn();
        filter->Update();
        EXPECT_TRUE(messages->Errors.empty());
      };
      isOfSurfaces ? run(vtkNew<vtkSurfaceSubdivision>().Get())
                   : run(vtkNew<vtkMultiDimensionalSubdivision>().Get());
    }
  }
}
