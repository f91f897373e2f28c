// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRandomForgeries.cxx
 * Outputs whose stamps, ids and leaves were changed at random, as a damaged or made-up file may
 * have them, through every filter: nothing crashes, and none takes much more memory than the mesh
 * needs.
 *
 * Seeds as in TestRandomDifferential.cxx.
 */
#include "RandomTools.h"
#include "SubdivisionDeformationTools.h"
#include "SurfaceTools.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkExtractDimensions.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSimplicialComplexTopology.h"

#include <sys/resource.h>

using namespace random_tools;

namespace
{

// ------------------------------------------------------------------------------------------------
// What filters wrote

template <typename FilterClass>
vtkSmartPointer<vtkDataObject> Update(FilterClass* filter, vtkDataObject* input)
{
  vtkNew<Messages> messages; // of any kind
  messages->Watch(filter);
  filter->SetInputDataObject(input);
  filter->Update();
  vtkDataObject* output = filter->GetOutputDataObject(0);
  if (!output)
  {
    return nullptr;
  }
  auto copy = vtkSmartPointer<vtkDataObject>::Take(output->NewInstance());
  copy->DeepCopy(output);
  return copy;
}

template <typename FilterClass>
void SetSharedOptions(FilterClass* filter, Chance& chance)
{
  filter->SetGenerateOriginalIds(Draw(chance, 2) == 0);
  filter->SetGenerateGlobalIds(Draw(chance, 2) == 0);
  filter->SetDetectFeatures(Draw(chance, 2) == 0);
  filter->SetFeatureAngle(20.);
  filter->SetMaximumNumberOfCells(100000);
  if (Draw(chance, 3) == 0)
  {
    filter->PreserveInterfacesOn();
    filter->SetInterfaceValues(Draw(chance, 2));
    filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Material");
  }
}

/// Cells of two materials, and values at points.
void AddMaterials(vtkPointSet* mesh)
{
  vtkNew<vtkIntArray> material;
  material->SetName("Material");
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    material->InsertNextValue(i < mesh->GetNumberOfCells() / 2 ? 1 : 2);
  }
  mesh->GetCellData()->AddArray(material);
  mesh->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("Values", 1, mesh->GetNumberOfPoints(), 0, 1, 7));
}

Grid MakeSmallGrid(Chance& chance)
{
  switch (Draw(chance, 5))
  {
    case 0:
      return MakeRandomComplex(chance(), Draw(chance, 2) == 0);
    case 1:
      return MakeFan(3 + Draw(chance, 5));
    case 2:
      return MakeKuhnBox(1, 0.1, chance());
    case 3:
      return MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 1, 0 } },
        { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 1, 2 } }, { VTK_VERTEX, { 2 } } });
    default:
      return MakeFlaggedOctahedron({ { VTK_TRIANGLE, { 0, 1, 3 } } });
  }
}

vtkSmartPointer<vtkDataObject> Subdivide(vtkDataObject* input, Chance& chance)
{
  vtkNew<Filter> filter;
  SetSharedOptions(filter.Get(), chance);
  filter->SetNumberOfLevels(Draw(chance, 3));
  filter->SetVolumeScheme(Draw(chance, 3));
  filter->SetKeepCellTypes(Draw(chance, 8) == 0);
  filter->SetProjectToLimit(Draw(chance, 8) == 0);
  filter->SetGenerateLimitNormals(Draw(chance, 4) == 0);
  filter->SetInterpolatePoints(Draw(chance, 8) == 0);
  SetCellArray(filter, 0, "Singular");
  return Update(filter.Get(), input);
}

vtkSmartPointer<vtkDataObject> Refine(vtkDataObject* input, Chance& chance)
{
  vtkNew<vtkRedGreenRefinement> filter;
  SetSharedOptions(filter.Get(), chance);
  filter->RefineByAttributeErrorOff();
  filter->RefineByEdgeLengthOn();
  filter->SetMaximumEdgeLength(0.2 + DrawNumber(chance));
  filter->SetMaximumLevel(Draw(chance, 3));
  filter->SetPlacement(Draw(chance, 2));
  return Update(filter.Get(), input);
}

vtkSmartPointer<vtkDataObject> SubdivideSurface(vtkDataObject* input, int scheme, Chance& chance)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  SetSharedOptions(filter.Get(), chance);
  filter->SetScheme(scheme);
  filter->SetNumberOfLevels(Draw(chance, 3));
  filter->SetProjectToLimit(Draw(chance, 8) == 0);
  filter->SetGenerateLimitNormals(Draw(chance, 4) == 0);
  return Update(filter.Get(), input);
}

vtkSmartPointer<vtkDataObject> RefineSurface(vtkDataObject* input, Chance& chance)
{
  vtkNew<vtkAdaptiveSurfaceSubdivision> filter;
  SetSharedOptions(filter.Get(), chance);
  filter->SetMaximumLevel(Draw(chance, 3));
  return Update(filter.Get(), input);
}

int DrawScheme(Chance& chance)
{
  return Draw(chance, vtkSurfaceSubdivision::LINEAR + 1);
}

// ------------------------------------------------------------------------------------------------
// Forgeries

bool IsOurs(const char* name)
{
  const std::string text = name ? name : "";
  for (const char* part :
    { "Subdivision", "Original", "Leaves", "Green", "OctahedronId", "Material" })
  {
    if (text.find(part) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

double DrawWrongNumber(double old, vtkPointSet* mesh, Chance& chance)
{
  const auto points = static_cast<double>(mesh->GetNumberOfPoints());
  const auto cells = static_cast<double>(mesh->GetNumberOfCells());
  const double numbers[] = { 0., 1., 2., 3., 4., 7., 9., 10., 19., 20., 21., -1., -2., old + 1.,
    old - 1., 2. * old, old / 2., -old, points, points - 1., points + 1., cells, cells - 1.,
    cells + 1., 100., 101., 103., 107., 2147483647., 2147483648., 4294967296., 1e18, 9.2e18,
    -9.2e18, 1e300, std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity() };
  return numbers[Draw(chance, static_cast<int>(std::size(numbers)))];
}

/// The array with other values, another size, or of another type.
vtkSmartPointer<vtkDataArray> Forge(vtkDataArray* given, vtkPointSet* mesh, Chance& chance)
{
  const bool isOtherType = Draw(chance, 4) == 0;
  auto array = vtkSmartPointer<vtkDataArray>::Take(isOtherType
      ? vtkDataArray::CreateDataArray(Draw(chance, 2) == 0 ? VTK_DOUBLE : VTK_CHAR)
      : given->NewInstance());
  array->DeepCopy(given);
  array->SetName(given->GetName());
  const vtkIdType values = array->GetNumberOfValues();
  const int components = array->GetNumberOfComponents();
  switch (Draw(chance, 8))
  {
    case 0:
      array->SetNumberOfTuples(Draw(chance, static_cast<int>(array->GetNumberOfTuples()) + 1));
      break;
    case 1:
    {
      const vtkIdType before = array->GetNumberOfTuples();
      array->Resize(2 * before + 1);
      array->SetNumberOfTuples(2 * before + 1);
      for (vtkIdType i = before * components; i < array->GetNumberOfValues(); ++i)
      {
        array->SetComponent(i / components, static_cast<int>(i % components), Draw(chance, 20));
      }
      break;
    }
    case 2:
    {
      auto other = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
      other->SetName(array->GetName());
      other->SetNumberOfComponents(1 + Draw(chance, 4));
      for (vtkIdType i = 0; i < values / other->GetNumberOfComponents(); ++i)
      {
        other->InsertNextTuple(other->GetNumberOfComponents() == 1
            ? given->GetTuple(i / components)
            : std::vector<double>(4, static_cast<double>(Draw(chance, 30))).data());
      }
      array = other;
      break;
    }
    default:
      for (int n = Draw(chance, 3); n >= 0 && values > 0; --n)
      {
        const vtkIdType i = Draw(chance, static_cast<int>(values));
        const int c = static_cast<int>(i % components);
        array->SetComponent(
          i / components, c, DrawWrongNumber(array->GetComponent(i / components, c), mesh, chance));
      }
  }
  return array;
}

void ForgeOne(vtkPointSet* mesh, Chance& chance)
{
  std::vector<std::pair<vtkFieldData*, vtkDataArray*>> arrays;
  for (vtkFieldData* data :
    { mesh->GetFieldData(), static_cast<vtkFieldData*>(mesh->GetPointData()),
      static_cast<vtkFieldData*>(mesh->GetCellData()) })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      if (data->GetArray(i) && IsOurs(data->GetArrayName(i)))
      {
        arrays.emplace_back(data, data->GetArray(i));
      }
    }
  }
  if (arrays.empty())
  {
    return;
  }
  const auto [data, array] = arrays[Draw(chance, static_cast<int>(arrays.size()))];
  if (Draw(chance, 8) == 0)
  {
    data->RemoveArray(array->GetName());
    return;
  }
  const auto forged = Forge(array, mesh, chance);
  const bool isForAll = data == mesh->GetFieldData() ||
    forged->GetNumberOfTuples() == array->GetNumberOfTuples(); // VTK's own readers see to that
  if (isForAll)
  {
    data->AddArray(forged);
  }
}

void ForgeSome(vtkDataObject* object, Chance& chance)
{
  std::vector<vtkPointSet*> meshes;
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(object))
  {
    for (unsigned int b = 0; b < blocks->GetNumberOfBlocks(); ++b)
    {
      meshes.push_back(vtkPointSet::SafeDownCast(blocks->GetBlock(b)));
    }
  }
  else
  {
    meshes.push_back(vtkPointSet::SafeDownCast(object));
  }
  for (int n = Draw(chance, 3); n >= 0 && !meshes.empty(); --n)
  {
    if (vtkPointSet* mesh = meshes[Draw(chance, static_cast<int>(meshes.size()))])
    {
      ForgeOne(mesh, chance);
    }
  }
}

// ------------------------------------------------------------------------------------------------
// Filters that believe or do not

long GetPeakMegabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

/// Runs any filter. It may complain, but not take much.
void RunAny(vtkDataObject* forged, Chance& chance)
{
  const long before = GetPeakMegabytes();
  const auto start = std::chrono::steady_clock::now();
  const int which = Draw(chance, 8);
  switch (which)
  {
    case 0:
    case 1:
      Subdivide(forged, chance);
      break;
    case 2:
      Refine(forged, chance);
      break;
    case 3:
      RefineSurface(forged, chance);
      break;
    case 4:
    {
      vtkNew<vtkSimplicialComplexTopology> filter;
      filter->SetGenerateOriginalIds(true);
      Update(filter.Get(), forged);
      break;
    }
    case 5:
    {
      deformation_tools::Deformer filter;
      filter->SetMaximumNumberOfCells(100000);
      filter->SetSurfaceScheme(vtkSurfaceSubdivision::LOOP + Draw(chance, 2));
      filter->SetVolumeScheme(Draw(chance, 2));
      filter->SetNumberOfLevels(Draw(chance, 3));
      filter.Run(deformation_tools::MakeCloud(5, { 0, 0, 0 }, { 1, 1, 1 }, 1), forged, forged);
      break;
    }
    case 6:
    {
      vtkNew<vtkExtractDimensions> filter;
      Update(filter.Get(), forged);
      break;
    }
    default:
      SubdivideSurface(forged, DrawScheme(chance), chance);
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  EXPECT_LT(GetPeakMegabytes() - before, 100) << which;
  EXPECT_LT(passed.count(), 5.) << which;
}

}

TEST(RandomForgeries, Grids)
{
  ForSeeds(0.02,
    [](unsigned seed)
    {
      Chance chance(seed);
      const Grid grid = MakeSmallGrid(chance);
      AddMaterials(grid);
      auto made = Draw(chance, 3) > 0 ? Subdivide(grid, chance) : Refine(grid, chance);
      if (Draw(chance, 3) == 0)
      {
        made = Draw(chance, 2) > 0 ? Subdivide(made, chance) : Refine(made, chance);
      }
      ForgeSome(made, chance);
      RunAny(made, chance);
    });
}

TEST(RandomForgeries, Surfaces)
{
  ForSeeds(0.02,
    [](unsigned seed)
    {
      Chance chance(seed);
      const auto zoo = surfacetools::MakeZoo(Draw(chance, 2) == 0);
      auto model = zoo.begin();
      std::advance(model, Draw(chance, static_cast<int>(zoo.size())));
      const auto surface = surfacetools::MakeInput(model->second);
      AddMaterials(surface);
      const int scheme = DrawScheme(chance);
      auto made = SubdivideSurface(surface, scheme, chance);
      ForgeSome(made, chance);
      if (Draw(chance, 2) == 0)
      {
        SubdivideSurface(made, scheme, chance);
      }
      else
      {
        RunAny(made, chance);
      }
    });
}

TEST(RandomForgeries, Blocks)
{
  ForSeeds(0.02,
    [](unsigned seed)
    {
      Chance chance(seed);
      vtkNew<vtkMultiBlockDataSet> blocks;
      const bool areGrids = Draw(chance, 2) == 0;
      const auto zoo = surfacetools::MakeZoo(Draw(chance, 2) == 0);
      auto model = zoo.begin();
      std::advance(model, Draw(chance, static_cast<int>(zoo.size())));
      const Grid whole = MakeSmallGrid(chance);
      for (unsigned int b = 0; b < 2; ++b)
      {
        if (areGrids)
        {
          std::vector<Point> points;
          for (vtkIdType p = 0; p < whole->GetNumberOfPoints(); ++p)
          {
            points.push_back(GetPoint(whole, p));
          }
          std::vector<Cell> cells;
          for (vtkIdType c = b; c < whole->GetNumberOfCells(); c += 2)
          {
            cells.push_back({ whole->GetCellType(c), GetCell(whole, c) });
          }
          blocks->SetBlock(b, MakeGrid(points, cells));
          AddMaterials(vtkPointSet::SafeDownCast(blocks->GetBlock(b)));
        }
        else
        {
          surfacetools::Model part = model->second;
          part.Faces.clear();
          for (std::size_t f = b; f < model->second.Faces.size(); f += 2)
          {
            part.Faces.push_back(model->second.Faces[f]);
          }
          blocks->SetBlock(b, surfacetools::MakeInput(part));
          AddMaterials(vtkPointSet::SafeDownCast(blocks->GetBlock(b)));
        }
      }
      const int scheme = DrawScheme(chance);
      auto made = areGrids
        ? (Draw(chance, 2) == 0 ? Subdivide(blocks, chance) : Refine(blocks, chance))
        : SubdivideSurface(blocks, scheme, chance);
      ForgeSome(made, chance);
      if (!areGrids && Draw(chance, 2) == 0)
      {
        SubdivideSurface(made, scheme, chance);
      }
      else
      {
        RunAny(made, chance);
      }
    });
}
