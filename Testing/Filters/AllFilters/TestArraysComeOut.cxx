// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestArraysComeOut.cxx
 * Arrays that go into a filter come out of it, with everything that vtkDataSetAttributes copies:
 * names, types, names of components, information keys, lookup tables, active attributes. That holds
 * for all filters, of meshes, blocks and further updates, however arrays are stored.
 */
#include "ArraysOfAllKinds.h"
#include "LabelTools.h"
#include "PartitionTools.h"
#include "SubdivisionDeformationTools.h"

#include "Private/Uniform/UniformSubdivision.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkCompositeDataIterator.h"
#include "vtkExtractDimensions.h"
#include "vtkInformation.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSimplicialComplexTopology.h"
#include "vtkSubdivisionCageSource.h"
#include "vtkSubdivisionEdit.h"
#include "vtkSubdivisionLimitProbe.h"
#include "vtkSubdivisionSmoothness.h"
#include "vtkSurfaceSubdivision.h"

using namespace all_kinds;
using namespace deformation_tools;

namespace
{

using Mesh = vtkSmartPointer<vtkPointSet>;
using Algorithm = vtkSmartPointer<vtkAlgorithm>;

void Load(vtkDataSet* mesh)
{
  AddAll(mesh->GetPointData(), mesh->GetNumberOfPoints());
  AddAll(mesh->GetCellData(), mesh->GetNumberOfCells());
  vtkNew<vtkStringArray> title;
  title->SetName("title");
  title->InsertNextValue("of a mesh");
  mesh->GetFieldData()->AddArray(title);
}

/// Tetrahedra around an edge.
Mesh MakeSolid()
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 } },
    { { VTK_TETRA, { 0, 2, 3, 1 } }, { VTK_TETRA, { 0, 3, 4, 1 } } });
  Load(grid);
  return grid;
}

/// The sides of an octahedron.
Mesh MakeSurface()
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 6; ++i)
  {
    points->InsertNextPoint(i % 3 == 0 ? 1 - i / 3 * 2 : 0, i % 3 == 1 ? 1 - i / 3 * 2 : 0,
      i % 3 == 2 ? 1 - i / 3 * 2 : 0);
  }
  vtkNew<vtkCellArray> cells;
  for (int octant = 0; octant < 8; ++octant)
  {
    const vtkIdType ids[3] = { octant & 1 ? 3 : 0, octant & 2 ? 4 : 1, octant & 4 ? 5 : 2 };
    const bool isTurned = (octant & 1) ^ (octant >> 1 & 1) ^ (octant >> 2 & 1);
    cells->InsertNextCell({ ids[0], ids[isTurned ? 2 : 1], ids[isTurned ? 1 : 2] });
  }
  surface->SetPoints(points);
  surface->SetPolys(cells);
  Load(surface);
  return surface;
}

enum Keeps
{
  Nothing,    ///< of such arrays
  AllButIds,  ///< no global ids, and no normals
  Children,   ///< no global ids, because there are several cells for one
  Everything, ///< also normals
  PointIds    ///< also global ids, but no normals, because something moves
};

/// A filter, and what it keeps of point and cell arrays.
struct Case
{
  const char* Name;
  std::function<Mesh()> MakeInput;
  std::function<Algorithm()> MakeFilter;
  Keeps OfPoints;
  Keeps OfCells;
};

template <typename Filter>
std::function<Algorithm()> Make(const std::function<void(Filter*)>& configure)
{
  return [configure]() -> Algorithm
  {
    const auto filter = vtkSmartPointer<Filter>::New();
    configure(filter);
    return filter;
  };
}

std::function<Algorithm()> MakeUniform(int levels, int scheme = 0)
{
  return Make<vtkMultiDimensionalSubdivision>(
    [=](auto* filter)
    {
      filter->SetNumberOfLevels(levels);
      filter->SetVolumeScheme(scheme);
    });
}

std::function<Algorithm()> MakeOfSurfaces(int levels, int scheme)
{
  return Make<vtkSurfaceSubdivision>(
    [=](auto* filter)
    {
      filter->SetNumberOfLevels(levels);
      filter->SetScheme(scheme);
    });
}

vtkSmartPointer<vtkUnstructuredGrid> MakeCage()
{
  vtkNew<vtkSubdivisionCageSource> source;
  source->SetInputData(MakeSurface());
  source->Update();
  return source->GetOutput();
}

std::vector<Case> ListCases()
{
  std::vector<Case> cases = {
    { "no level", MakeSolid, MakeUniform(0), Everything, Everything },
    { "a level", MakeSolid, MakeUniform(1), AllButIds, Children },
    { "tets and octahedra", MakeSolid, MakeUniform(2, 1), AllButIds, Children },
    { "on the limit", MakeSolid,
      Make<vtkMultiDimensionalSubdivision>(
        [](auto* filter)
        {
          filter->SetNumberOfLevels(0);
          filter->ProjectToLimitOn();
        }),
      PointIds, PointIds },
    { "Bezier cells", MakeSolid,
      Make<vtkMultiDimensionalSubdivision>(
        [](auto* filter)
        {
          filter->SetNumberOfLevels(1);
          filter->SetOutputCells(vtkMultiDimensionalSubdivision::BEZIER_CELLS);
        }),
      AllButIds, Children },
    { "red-green", MakeSolid,
      Make<vtkRedGreenRefinement>(
        [](auto* filter)
        {
          filter->RefineByAttributeErrorOff();
          filter->RefineByEdgeLengthOn();
          filter->SetMaximumEdgeLength(1.2);
        }),
      AllButIds, Children },
    { "red-green of nothing", MakeSolid,
      Make<vtkRedGreenRefinement>([](auto* filter) { filter->RefineByAttributeErrorOff(); }),
      Everything, Everything },
    { "adaptive", MakeSurface,
      Make<vtkAdaptiveSurfaceSubdivision>(
        [](auto* filter)
        {
          filter->RefineByAttributeErrorOff();
          filter->RefineByEdgeLengthOn();
          filter->SetMaximumEdgeLength(1.);
        }),
      AllButIds, AllButIds },
    { "topology", MakeSolid, Make<vtkSimplicialComplexTopology>([](auto*) {}), Everything,
      Nothing },
    { "smoothness", MakeSurface, Make<vtkSubdivisionSmoothness>([](auto*) {}), Everything,
      Nothing },
    { "dimensions", MakeSolid, Make<vtkExtractDimensions>([](auto*) {}), Everything, Everything },
    { "an edit of nothing", MakeSolid, Make<vtkSubdivisionEdit>([](auto*) {}), Everything,
      Everything },
    { "edit", MakeSolid,
      Make<vtkSubdivisionEdit>([](auto* filter) { filter->SetTranslation(0., 0., 1.); }), PointIds,
      PointIds },
    { "deformation", MakeSurface,
      Make<vtkSubdivisionDeformation>(
        [](auto* filter)
        {
          filter->SetRestMeshData(MakeCage());
          filter->SetDeformedMeshData(MakeCage());
        }),
      Everything, Everything },
    { "probe", MakeSolid,
      Make<vtkSubdivisionLimitProbe>(
        [](auto* filter)
        {
          vtkNew<vtkPolyData> places;
          vtkNew<vtkPoints> points;
          points->InsertNextPoint(.1, .2, .3);
          places->SetPoints(points);
          filter->SetInputDataObject(3, places);
        }),
      AllButIds, Nothing },
  };
  for (int scheme = vtkSurfaceSubdivision::LOOP; scheme <= vtkSurfaceSubdivision::LINEAR; ++scheme)
  {
    cases.push_back({ "surface", MakeSurface, MakeOfSurfaces(1, scheme), AllButIds, AllButIds });
    cases.push_back(
      { "surface, no level", MakeSurface, MakeOfSurfaces(0, scheme), Everything, PointIds });
  }
  return cases;
}

/// What VTK copies besides values.
std::string CompareLooks(vtkAbstractArray* a, vtkAbstractArray* b)
{
  const std::string name = a->GetName();
  if (!b)
  {
    return name + " is lost";
  }
  if (a->GetDataType() != b->GetDataType() ||
    a->GetNumberOfComponents() != b->GetNumberOfComponents())
  {
    return name + " has another type";
  }
  if (!b->GetComponentName(0) ||
    std::string(a->GetComponentName(0)) != std::string(b->GetComponentName(0)))
  {
    return name + " has another name of its component";
  }
  const char* unit =
    b->HasInformation() ? b->GetInformation()->Get(vtkDataArray::UNITS_LABEL()) : "";
  if (!unit || std::string(unit) != a->GetInformation()->Get(vtkDataArray::UNITS_LABEL()))
  {
    return name + " has other information";
  }
  auto* data = vtkDataArray::SafeDownCast(a);
  if (data && data->GetLookupTable() != vtkDataArray::SafeDownCast(b)->GetLookupTable())
  {
    return name + " has another lookup table";
  }
  return std::string();
}

/// Whether all values are some of the input.
std::string FindStrange(vtkAbstractArray* in, vtkAbstractArray* out)
{
  std::set<std::string> known;
  for (vtkIdType i = 0; i < in->GetNumberOfValues(); ++i)
  {
    known.insert(in->GetVariantValue(i).ToString());
  }
  for (vtkIdType i = 0; i < out->GetNumberOfValues(); ++i)
  {
    if (!known.count(out->GetVariantValue(i).ToString()))
    {
      return std::string(in->GetName()) + " has " + out->GetVariantValue(i).ToString();
    }
  }
  return std::string();
}

void ExpectKept(
  vtkDataSetAttributes* in, vtkDataSetAttributes* out, Keeps keeps, const std::string& where)
{
  for (int a = 0; a < in->GetNumberOfArrays() && keeps != Nothing; ++a)
  {
    vtkAbstractArray* array = in->GetAbstractArray(a);
    const bool isOfPoints = vtkPointData::SafeDownCast(in) != nullptr;
    const bool mayLack =
      (array == in->GetGlobalIds() && (keeps == AllButIds || keeps == Children)) ||
      (array == in->GetPedigreeIds() && keeps == AllButIds && isOfPoints) ||
      (array == in->GetNormals() && (keeps == AllButIds || keeps == PointIds || keeps == Children));
    vtkAbstractArray* made = out->GetAbstractArray(array->GetName());
    if (mayLack && !made)
    {
      continue;
    }
    EXPECT_EQ(CompareLooks(array, made), "") << where;
    const bool isSmoothed = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
    if (made && !isSmoothed)
    {
      EXPECT_EQ(FindStrange(array, made), "") << where;
    }
  }
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES && keeps != Nothing; ++type)
  {
    vtkAbstractArray* active = in->GetAbstractAttribute(type);
    const bool isShared = type == vtkDataSetAttributes::GLOBALIDS && keeps == Children;
    if (active && out->HasArray(active->GetName()) && !isShared)
    {
      EXPECT_EQ(out->GetAbstractAttribute(type), out->GetAbstractArray(active->GetName()))
        << where << ", " << vtkDataSetAttributes::GetAttributeTypeAsString(type);
    }
  }
}

void ExpectAllKept(vtkDataSet* in, vtkDataSet* out, const Case& of, const std::string& where)
{
  ASSERT_GT(out->GetNumberOfPoints(), 0) << where;
  ExpectKept(in->GetPointData(), out->GetPointData(), of.OfPoints, where + ", points");
  ExpectKept(in->GetCellData(), out->GetCellData(), of.OfCells, where + ", cells");
  auto* title = vtkStringArray::SafeDownCast(out->GetFieldData()->GetAbstractArray("title"));
  EXPECT_TRUE(title && title->GetValue(0) == "of a mesh") << where;
}

vtkDataObject* Update(vtkAlgorithm* filter, vtkDataObject* input)
{
  filter->SetInputDataObject(0, input);
  filter->Update();
  return filter->GetOutputDataObject(0);
}

}

TEST(ArraysComeOut, OfAllFiltersAndWithTheLooksOfTheDay)
{
  for (const Case& of : ListCases())
  {
    const Mesh input = of.MakeInput();
    const Algorithm filter = of.MakeFilter();
    auto* made = vtkDataSet::SafeDownCast(Update(filter, input));
    ASSERT_TRUE(made) << of.Name;
    ExpectAllKept(input, made, of, of.Name);
    // What is kept for the next update are numbers, not looks.
    for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(input->GetPointData()),
           static_cast<vtkDataSetAttributes*>(input->GetCellData()) })
    {
      for (int a = 0; a < data->GetNumberOfArrays(); ++a)
      {
        Decorate(data->GetAbstractArray(a), data->GetAbstractArray(a)->GetName());
        data->GetAbstractArray(a)->Modified();
      }
    }
    input->Modified();
    made = vtkDataSet::SafeDownCast(Update(filter, input));
    ExpectAllKept(input, made, of, of.Name + std::string(", second update"));
  }
}

TEST(ArraysComeOut, OfBlocksEachWithItsOwnLooks)
{
  for (const Case& of : ListCases())
  {
    if (of.Name == std::string("probe") || of.Name == std::string("smoothness")) // read no blocks
    {
      continue;
    }
    vtkNew<vtkMultiBlockDataSet> root;
    vtkNew<vtkMultiBlockDataSet> inner;
    std::vector<Mesh> inputs = { of.MakeInput(), of.MakeInput() };
    for (vtkIdType i = 0; i < inputs[1]->GetNumberOfPoints(); ++i)
    {
      Point p = GetPoint(inputs[1], i);
      p[0] += .001;
      inputs[1]->GetPoints()->SetPoint(i, p.data());
      inputs[1]->GetPointData()->GetGlobalIds()->SetComponent(i, 0, 2000. + double(i));
    }
    vtkDataArray* cellIds = inputs[1]->GetCellData()->GetGlobalIds();
    for (vtkIdType i = 0; i < inputs[1]->GetNumberOfCells(); ++i)
    {
      cellIds->SetComponent(i, 0, 2000. + double(i));
    }
    inputs[1]->GetPointData()->SetActiveScalars("large");
    inner->SetBlock(0, inputs[1]);
    inner->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "second");
    vtkNew<vtkIntArray> year;
    year->SetName("year");
    year->InsertNextValue(1999);
    inner->GetFieldData()->AddArray(year);
    root->GetFieldData()->AddArray(year);
    root->SetBlock(0, inputs[0]);
    root->SetBlock(1, inner);
    root->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "inner");
    const Algorithm filter = of.MakeFilter();
    auto* made = vtkMultiBlockDataSet::SafeDownCast(Update(filter, root));
    ASSERT_TRUE(made) << of.Name;
    auto* madeInner = vtkMultiBlockDataSet::SafeDownCast(made->GetBlock(1));
    ASSERT_TRUE(madeInner) << of.Name;
    EXPECT_TRUE(made->GetFieldData()->HasArray("year")) << of.Name;
    EXPECT_TRUE(madeInner->GetFieldData()->HasArray("year")) << of.Name;
    EXPECT_STREQ(made->GetMetaData(1u)->Get(vtkCompositeDataSet::NAME()), "inner") << of.Name;
    EXPECT_STREQ(madeInner->GetMetaData(0u)->Get(vtkCompositeDataSet::NAME()), "second") << of.Name;
    ExpectAllKept(inputs[0], vtkDataSet::SafeDownCast(made->GetBlock(0)), of,
      of.Name + std::string(", first block"));
    ExpectAllKept(inputs[1], vtkDataSet::SafeDownCast(madeInner->GetBlock(0)), of,
      of.Name + std::string(", second block"));
  }
}

TEST(ArraysComeOut, OfRanksEachWithItsOwnLooks)
{
  using namespace partition_tools;
  const Mesh whole = MakeSolid();
  whole->GetPointData()->Initialize();
  whole->GetCellData()->Initialize();
  const Partition halves{ "halves", 2, 1, false, KnownBy::Coordinates };
  const auto parts = Cut(whole, { 0, 1 }, halves.Parts, halves.Known);
  for (const Mesh& part : parts)
  {
    Load(part);
    part->GetPointData()->RemoveArray("GlobalIds"); // of this part alone
    part->GetCellData()->RemoveArray("GlobalIds");
  }
  subdivision::UniformOptions options;
  options.Levels = 1;
  subdivision::DistributionOptions distribution;
  std::vector<Mesh> outputs;
  ASSERT_TRUE(RunOnParts(
    parts, halves, distribution, options, [&](vtkPointSet* input, vtkPointSet* output)
    { return SubdivideUniformly(input, options, vtkUnstructuredGrid::SafeDownCast(output)); },
    outputs));
  ASSERT_EQ(outputs.size(), parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    ExpectAllKept(parts[p], outputs[p], { "rank", nullptr, nullptr, AllButIds, Children },
      "rank " + std::to_string(p));
  }
}

TEST(ArraysComeOut, ElementNumbersOnRequest)
{
  const Mesh solid = MakeSolid();
  const Mesh surface = MakeSurface();
  const auto expectNumbers = [](vtkAlgorithm* filter, vtkDataSet* input)
  {
    auto* made = vtkDataSet::SafeDownCast(Update(filter, input));
    vtkDataArray* origins = made->GetCellData()->GetArray("vtkOriginalCellIds");
    vtkDataArray* numbers = made->GetCellData()->GetArray("GlobalIds");
    ASSERT_TRUE(origins && numbers) << filter->GetClassName();
    EXPECT_FALSE(made->GetCellData()->GetGlobalIds()) << "children share them";
    for (vtkIdType i = 0; i < made->GetNumberOfCells(); ++i)
    {
      ASSERT_EQ(numbers->GetComponent(i, 0), 1000. + origins->GetComponent(i, 0));
    }
  };
  vtkNew<vtkMultiDimensionalSubdivision> uniform;
  uniform->GenerateOriginalIdsOn();
  expectNumbers(uniform, solid);
  vtkNew<vtkRedGreenRefinement> redGreen;
  redGreen->RefineByAttributeErrorOff();
  redGreen->RefineByEdgeLengthOn();
  redGreen->SetMaximumEdgeLength(1.2);
  redGreen->GenerateOriginalIdsOn();
  expectNumbers(redGreen, solid);
  vtkNew<vtkAdaptiveSurfaceSubdivision> adaptive;
  adaptive->RefineByAttributeErrorOff();
  adaptive->RefineByEdgeLengthOn();
  adaptive->SetMaximumEdgeLength(1.);
  adaptive->GenerateOriginalIdsOn();
  expectNumbers(adaptive, surface);
  for (int scheme = vtkSurfaceSubdivision::LOOP; scheme <= vtkSurfaceSubdivision::LINEAR; ++scheme)
  {
    vtkNew<vtkSurfaceSubdivision> filter;
    filter->SetScheme(scheme);
    filter->GenerateOriginalIdsOn();
    expectNumbers(filter, surface);
  }
}

TEST(ArraysComeOut, OfPlacesOfTheProbe)
{
  const Mesh solid = MakeSolid();
  for (const bool ofSurfaces : { false, true })
  {
    vtkNew<vtkSubdivisionLimitProbe> filter;
    filter->SetScheme(
      ofSurfaces ? vtkSubdivisionLimitProbe::CATMULL_CLARK : vtkSubdivisionLimitProbe::BOX_SPLINE);
    const Mesh mesh = ofSurfaces ? MakeSurface() : solid;
    vtkNew<vtkPolyData> places;
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(.1, .2, .3);
    points->InsertNextPoint(.2, .1, .3);
    places->SetPoints(points);
    AddAll(places->GetPointData(), 2);
    const auto measured = MakeArray<vtkDoubleArray>("measured", 1, 2, 0., 1., 5);
    Decorate(measured, "measured");
    places->GetPointData()->AddArray(measured);
    filter->SetInputDataObject(3, places);
    auto* made = vtkPolyData::SafeDownCast(Update(filter, mesh));
    ASSERT_EQ(made->GetNumberOfPoints(), 2);
    vtkPointData* data = made->GetPointData();
    EXPECT_EQ(CompareValues(measured, data->GetArray("measured")), "");
    EXPECT_EQ(CompareLooks(measured, data->GetArray("measured")), "");
    // Of names that the mesh has, too, both are there.
    for (const char* name : { "apart", "large", "Scalars", "type 13" })
    {
      vtkAbstractArray* ofPlace = data->GetAbstractArray((name + std::string("OfPlace")).c_str());
      ASSERT_TRUE(ofPlace && data->HasArray(name)) << name;
      const auto given = places->GetPointData()->GetAbstractArray(name);
      for (vtkIdType i = 0; i < given->GetNumberOfValues(); ++i)
      {
        EXPECT_EQ(ofPlace->GetVariantValue(i).ToString(), given->GetVariantValue(i).ToString());
      }
    }
    EXPECT_EQ(data->GetScalars(), data->GetArray("Scalars")) << "those of the mesh";
    EXPECT_STREQ(places->GetPointData()->GetArray("apart")->GetName(), "apart");
    ASSERT_TRUE(data->GetPedigreeIds()) << "points are the places";
    EXPECT_EQ(data->GetPedigreeIds()->GetVariantValue(1).ToInt(), 1001);
  }
}

TEST(ArraysComeOut, OfVoxels)
{
  const label_tools::Image image =
    label_tools::MakeImage({ 4, 4, 4 }, [](int i, int, int) { return i < 2 ? 3 : 8; });
  const vtkSmartPointer<vtkDataArray> labels = image->GetPointData()->GetScalars();
  AddAll(image->GetPointData(), 64);
  Decorate(labels, "Tissue");
  image->GetPointData()->SetActiveScalars("Tissue");
  for (const vtkIdType cells : { 0, 8 })
  {
    vtkNew<vtkSubdivisionLabelSolid> filter;
    filter->SetNumberOfControlCells(cells);
    auto* made = vtkDataSet::SafeDownCast(Update(filter, image));
    vtkCellData* data = made->GetCellData();
    for (int a = 0; a < image->GetPointData()->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = image->GetPointData()->GetAbstractArray(a);
      if (array != image->GetPointData()->GetGlobalIds() &&
        array != image->GetPointData()->GetPedigreeIds())
      {
        EXPECT_EQ(CompareLooks(array, data->GetAbstractArray(array->GetName())), "");
      }
    }
    EXPECT_EQ(FindStrange(image->GetPointData()->GetArray("large"), data->GetArray("large")), "");
  }
}
