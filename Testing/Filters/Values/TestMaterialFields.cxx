// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMaterialFields.cxx
 * Values that jump at interfaces: InterfaceValues of vtkMultiDimensionalSubdivision and
 * vtkRedGreenRefinement.
 */
#include "MaterialTools.h"

#include "vtkAppendFilter.h"
#include "vtkSimplicialComplexTopology.h"

using namespace material_tools;

namespace
{

/// The mesh without copies.
Grid JoinCopies(vtkUnstructuredGrid* torn)
{
  vtkDataArray* ids = torn->GetPointData()->GetArray(IdsName);
  const Grid joined = DeepCopy(torn);
  vtkNew<vtkCellArray> cells;
  for (const Ids& cell : GetCells(torn))
  {
    cells->InsertNextCell(static_cast<int>(cell.size()));
    for (const vtkIdType id : cell)
    {
      cells->InsertCellPoint(static_cast<vtkIdType>(ids->GetComponent(id, 0)));
    }
  }
  vtkNew<vtkUnsignedCharArray> types;
  for (vtkIdType c = 0; c < torn->GetNumberOfCells(); ++c)
  {
    types->InsertNextValue(static_cast<unsigned char>(torn->GetCellType(c)));
  }
  joined->SetCells(types, cells);
  return joined;
}

/// Two blocks: what is not of a block is a duplicate there.
vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks(
  vtkUnstructuredGrid* mesh, const std::function<vtkIdType(vtkIdType)>& blockOf)
{
  const auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned int b = 0; b < 2; ++b)
  {
    const Grid block = DeepCopy(mesh);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType c = 0; c < block->GetNumberOfCells(); ++c)
    {
      ghosts->InsertNextValue(blockOf(c) == b ? 0 : vtkDataSetAttributes::DUPLICATECELL);
    }
    block->GetCellData()->AddArray(ghosts);
    blocks->SetBlock(b, block);
  }
  return blocks;
}

Grid GetBlock(vtkMultiBlockDataSet* blocks, unsigned int b)
{
  return vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(b));
}

/// Runs the filter on blocks, which may not warn.
vtkSmartPointer<vtkMultiBlockDataSet> RunOnBlocks(vtkMultiBlockDataSet* blocks, int levels,
  const std::function<void(vtkMultiDimensionalSubdivision*)>& configure)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetNumberOfLevels(levels);
  filter->SetVolumeSchemeToBoxSpline();
  configure(filter);
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(blocks);
  filter->Update();
  EXPECT_EQ(messages->Warnings, std::vector<std::string>());
  EXPECT_TRUE(messages->Errors.empty());
  const auto made = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  made->DeepCopy(filter->GetOutputDataObject(0));
  return made;
}

void JumpAgain(vtkSubdivisionAlgorithm* filter)
{
  Jump(filter);
  filter->RemoveAllFieldsOfCells();
}

}

// What is constant in each material stays so, at every level and at the limit. The mesh is that of
// continuous values.
TEST(MaterialFields, ConstantsStayConstantAndGeometryIsTheSame)
{
  for (const Grid& mesh : MakeMeshes())
  {
    for (const Choice& choice : MakeChoices())
    {
      for (const int levels : { 0, 1, 2 })
      {
        SCOPED_TRACE(std::string(choice.Name) + ", levels " + std::to_string(levels) +
          ", mesh of " + std::to_string(mesh->GetNumberOfCells()) + " cells");
        const Grid torn = choice.Run(mesh, levels, Jump);
        const Grid whole = choice.Run(mesh, levels, KeepInterfaces);
        vtkDataArray* ids = torn->GetPointData()->GetArray(IdsName);
        ASSERT_TRUE(ids);
        EXPECT_GT(torn->GetNumberOfPoints(), whole->GetNumberOfPoints());
        for (vtkIdType p = 0; p < torn->GetNumberOfPoints(); ++p)
        {
          const auto id = static_cast<vtkIdType>(ids->GetComponent(p, 0));
          ASSERT_EQ(GetPoint(whole, id), GetPoint(torn, p));
          ASSERT_TRUE(p >= whole->GetNumberOfPoints() || id == p);
        }
        EXPECT_EQ(GetCells(whole), GetCells(JoinCopies(torn)));
        EXPECT_FALSE(torn->GetCellData()->HasArray("SubdivisionColour"));
        EXPECT_EQ(
          whole->GetCellData()->GetNumberOfArrays(), torn->GetCellData()->GetNumberOfArrays());
        EXPECT_EQ(whole->GetPointData()->GetNumberOfArrays() + 2,
          torn->GetPointData()->GetNumberOfArrays());
        vtkDataArray* constants = torn->GetPointData()->GetArray(ConstantName);
        const std::vector<int> dimensions = FindDimensions(torn);
        for (vtkIdType c = 0; c < torn->GetNumberOfCells(); ++c)
        {
          for (const vtkIdType id : GetCell(torn, c))
          {
            // Cells on others take the values of these.
            if (dimensions[static_cast<std::size_t>(id)] == torn->GetCell(c)->GetCellDimension())
            {
              ASSERT_NEAR(GetConstant(GetMaterial(torn, c)), constants->GetComponent(id, 0), 1e-14)
                << "cell " << c << ", point " << id;
            }
          }
        }
        if (HasFailure())
        {
          return;
        }
      }
    }
  }
}

// Values of one material have no effect on another.
TEST(MaterialFields, MaterialsDoNotMix)
{
  const Grid mesh = MakeMeshes().front();
  for (const Choice& choice : MakeChoices())
  {
    SCOPED_TRACE(choice.Name);
    const Grid torn = choice.Run(mesh, 0, Jump); // copies of points, to be changed
    const Grid other = DeepCopy(torn);
    vtkDataArray* values = other->GetPointData()->GetArray(ValueName);
    for (vtkIdType c = 0; c < other->GetNumberOfCells(); ++c)
    {
      for (const vtkIdType id : GetCell(other, c))
      {
        if (GetMaterial(other, c) == 1. && other->GetCell(c)->GetCellDimension() == 3)
        {
          values->SetComponent(id, 0, 0.9 * values->GetComponent(id, 0));
        }
      }
    }
    // Red-green refinement splits by values: not those that change here.
    auto configure = [](vtkSubdivisionAlgorithm* filter)
    {
      Jump(filter);
      filter->RemoveAllFieldsOfCells();
      filter->SetInputArrayToProcess(
        5, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, ConstantName);
    };
    const Grid a = choice.Run(torn, 2, configure);
    const Grid b = choice.Run(other, 2, configure);
    ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
    vtkDataArray* ours = a->GetPointData()->GetArray(ValueName);
    vtkDataArray* theirs = b->GetPointData()->GetArray(ValueName);
    vtkIdType changed = 0;
    for (vtkIdType c = 0; c < a->GetNumberOfCells(); ++c)
    {
      for (const vtkIdType id : GetCell(a, c))
      {
        if (a->GetCell(c)->GetCellDimension() == 3)
        {
          const bool isSame = ours->GetComponent(id, 0) == theirs->GetComponent(id, 0);
          changed += isSame ? 0 : 1;
          ASSERT_TRUE(isSame || GetMaterial(a, c) == 1.) << "cell " << c;
          ASSERT_EQ(ours->GetComponent(id, 1), theirs->GetComponent(id, 1));
        }
      }
    }
    EXPECT_GT(changed, 100);
  }
}

// One material alone has the values of a continuous field.
TEST(MaterialFields, OneMaterialIsContinuous)
{
  const Grid mesh = AddMaterials(MakeMixedBox(2), [](vtkIdType) { return 4; });
  for (const Choice& choice : MakeChoices())
  {
    SCOPED_TRACE(choice.Name);
    const Grid torn = choice.Run(mesh, 2, Jump);
    const Grid whole = choice.Run(mesh, 2, KeepInterfaces);
    ExpectSameValues(whole, torn);
  }
}

// Filters in a row give what one gives with as many levels, also if the last one goes to the limit.
TEST(MaterialFields, FiltersInARow)
{
  for (const Grid& mesh : MakeMeshes())
  {
    for (const int scheme :
      { vtkMultiDimensionalSubdivision::BOX_SPLINE, vtkMultiDimensionalSubdivision::TET_OCT })
    {
      for (const bool toLimit : { false, true })
      {
        SCOPED_TRACE(std::to_string(scheme) + (toLimit ? ", limit" : ""));
        const Choice choice = MakeUniform("", scheme, false);
        const Choice last = MakeUniform("", scheme, toLimit);
        auto later = [](vtkSubdivisionAlgorithm* filter)
        {
          Jump(filter);
          filter->RemoveAllFieldsOfCells();
        };
        const Grid once = last.Run(mesh, 3, Jump);
        EXPECT_EQ("", Compare(once, last.Run(choice.Run(mesh, 1, Jump), 2, later)));
        const Grid first = choice.Run(choice.Run(mesh, 0, Jump), 2, later);
        EXPECT_EQ("", Compare(once, last.Run(first, 1, later)));
      }
    }
  }
}

// The same with kept operators and other values, and without a cache.
TEST(MaterialFields, KeptOperators)
{
  for (const Grid& mesh : MakeMeshes())
  {
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    filter->SetNumberOfLevels(3);
    Jump(filter);
    UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), mesh);
    const vtkIdType builds = filter->GetNumberOfTopologyBuilds();
    const Grid other = DeepCopy(mesh);
    other->GetPointData()->GetArray(ValueName)->SetComponent(7, 0, 12.);
    const Grid again = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), other);
    EXPECT_EQ(builds, filter->GetNumberOfTopologyBuilds());
    vtkNew<vtkMultiDimensionalSubdivision> fresh;
    fresh->SetNumberOfLevels(3);
    fresh->SetCacheOperator(false);
    Jump(fresh);
    EXPECT_EQ("", Compare(UpdateWithoutErrors<vtkUnstructuredGrid>(fresh.Get(), other), again));
  }
}

TEST(MaterialFields, SaysWhatItIgnores)
{
  const Grid mesh = MakeMeshes().front();
  auto warn = [&](vtkSubdivisionAlgorithm* filter, const char* part)
  {
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetInputDataObject(mesh);
    filter->SetInterfaceValuesToDiscontinuous();
    filter->Update();
    EXPECT_TRUE(messages->Errors.empty());
    EXPECT_EQ(1, messages->CountWarnings(part));
    EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_FALSE(filter->GetOutput()->GetPointData()->HasArray(IdsName));
  };
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  warn(filter, "PreserveInterfaces");
  vtkNew<vtkSimplicialComplexTopology> topology;
  topology->PreserveInterfacesOn();
  warn(topology, "ignores InterfaceValues");

  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->PreserveInterfacesOn();
  filter->AddFieldOfCells("nothing");
  filter->AddFieldOfCells(ValueName);
  filter->Update();
  EXPECT_EQ(1, messages->CountWarnings("nothing"));
  EXPECT_EQ(1, messages->CountWarnings("\"Value\""));
  EXPECT_TRUE(messages->Errors.empty());
}

// Ids of copies that cannot be true join nothing, and names of arrays that the filter uses itself
// are told of.
TEST(MaterialFields, ForgedArrays)
{
  const Grid mesh = MakeMeshes().front();
  const Choice choice = MakeUniform("", vtkMultiDimensionalSubdivision::BOX_SPLINE, false);
  const Grid expected = choice.Run(mesh, 1, Jump);
  for (const vtkIdType id : { vtkIdType(-1), vtkIdType(1) << 62, vtkIdType(3) }) // of other places
  {
    const Grid forged = DeepCopy(mesh);
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName(IdsName);
    ids->SetNumberOfValues(mesh->GetNumberOfPoints());
    ids->FillValue(id);
    forged->GetPointData()->AddArray(ids);
    EXPECT_EQ(expected->GetNumberOfPoints(), choice.Run(forged, 1, Jump)->GetNumberOfPoints());
  }
  for (const char* name : { "SubdivisionField0:x", "SubdivisionField", "SubdivisionField99:y" })
  {
    const Grid forged = DeepCopy(mesh);
    forged->GetPointData()->AddArray(
      MakeArray<vtkDoubleArray>(name, 2, mesh->GetNumberOfPoints(), 1., 2., 3));
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    filter->SetVolumeSchemeToBoxSpline();
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetInputDataObject(forged);
    filter->Update(); // a name like others
    EXPECT_TRUE(messages->Warnings.empty());
    EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray(name));
    Jump(filter);
    filter->Update();
    EXPECT_EQ(1, messages->CountWarnings(name));
    EXPECT_TRUE(messages->Errors.empty());
  }
}

// What a filter makes itself is no field: normals in a second filter are those of continuous
// values.
TEST(MaterialFields, NormalsAreNoFields)
{
  const Grid mesh = MakeMeshes().front();
  auto run = [](vtkDataObject* input, bool jumps)
  {
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    filter->ProjectToLimitOn();
    filter->GenerateLimitNormalsOn();
    KeepInterfaces(filter);
    filter->SetInterfaceValues(jumps);
    return UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
  };
  auto twice = [&](bool jumps) { return run(run(mesh, jumps), jumps); };
  const Grid torn = twice(true);
  const Grid whole = twice(false);
  vtkDataArray* ids = torn->GetPointData()->GetArray(IdsName);
  vtkDataArray* ours = torn->GetPointData()->GetArray("LimitNormals");
  vtkDataArray* theirs = whole->GetPointData()->GetArray("LimitNormals");
  ASSERT_TRUE(ids && ours && theirs);
  for (vtkIdType p = 0; p < torn->GetNumberOfPoints(); ++p)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto id = static_cast<vtkIdType>(ids->GetComponent(p, 0));
      ASSERT_EQ(theirs->GetComponent(id, k), ours->GetComponent(p, k));
    }
  }
}

TEST(MaterialFields, ShortCellArraysAreNoFields)
{
  const Grid mesh = MakeMeshes().front();
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  Jump(filter);
  mesh->GetCellData()->GetArray(ConstantName)->SetNumberOfTuples(1);
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(mesh);
  filter->Update();
  EXPECT_EQ(1, messages->CountWarnings("to be made a field"));
  EXPECT_FALSE(filter->GetOutput()->GetPointData()->HasArray(ConstantName));
}

// Meshes that were appended have the same ids of points twice: each has its own copies.
TEST(MaterialFields, AppendedMeshes)
{
  const Grid mesh = MakeMeshes().front();
  const Choice choice = MakeUniform("", vtkMultiDimensionalSubdivision::BOX_SPLINE, false);
  const Grid torn = choice.Run(mesh, 1, Jump);
  const Grid moved = DeepCopy(torn);
  for (vtkIdType p = 0; p < moved->GetNumberOfPoints(); ++p)
  {
    double x[3];
    moved->GetPoint(p, x);
    moved->GetPoints()->SetPoint(p, x[0] + 100., x[1], x[2]);
  }
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(torn);
  append->AddInputData(moved);
  append->Update();
  RemoveStamp(torn);
  const Grid one = choice.Run(torn, 1, Jump);
  const Grid two = choice.Run(append->GetOutput(), 1, Jump);
  EXPECT_EQ(2 * one->GetNumberOfPoints(), two->GetNumberOfPoints());
}

// Without fields of its own a filter does not join copies, and says so; their ids end there.
TEST(MaterialFields, CopiesInAFilterWithoutFields)
{
  const Choice choice = MakeUniform("", vtkMultiDimensionalSubdivision::BOX_SPLINE, false);
  const Grid torn = choice.Run(MakeMeshes().front(), 1, Jump);
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(torn);
  filter->Update();
  EXPECT_EQ(1, messages->CountWarnings("cracks"));
  EXPECT_FALSE(filter->GetOutput()->GetPointData()->HasArray(IdsName));
  EXPECT_TRUE(torn->GetPointData()->HasArray(IdsName));
}

// A poly line of another material of which one segment is an edge of a solid has its own values.
TEST(MaterialFields, CellsThatArePartlyFaces)
{
  const Grid mesh = MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 0., 0., 1. },
                               { 2., 0., 0. }, { 3., 1., 0. } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_POLY_LINE, { 0, 1, 4, 5 } } });
  AddCellArray(mesh, "MaterialId", { 0, 4 });
  AddCellArray<vtkDoubleArray>(mesh, ConstantName, { 1, 41 });
  for (const int levels : { 0, 1, 2 })
  {
    const Grid torn =
      MakeUniform("", vtkMultiDimensionalSubdivision::BOX_SPLINE, false).Run(mesh, levels, Jump);
    vtkDataArray* constants = torn->GetPointData()->GetArray(ConstantName);
    for (vtkIdType c = 0; c < torn->GetNumberOfCells(); ++c)
    {
      for (const vtkIdType id : GetCell(torn, c))
      {
        EXPECT_NEAR(GetMaterial(torn, c) == 0. ? 1. : 41., constants->GetComponent(id, 0), 1e-13);
      }
    }
  }
}

// Blocks are one object, as without jumps.
TEST(MaterialFields, Blocks)
{
  const Grid mesh = MakeMeshes().front();
  const auto blocks = MakeBlocks(mesh, [](vtkIdType c) { return c % 2; });
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetNumberOfLevels(1);
  filter->SetVolumeSchemeToBoxSpline();
  Jump(filter);
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(blocks);
  filter->Update();
  EXPECT_TRUE(messages->Warnings.empty());
  auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(made);
  for (unsigned int b = 0; b < 2; ++b)
  {
    auto* block = vtkUnstructuredGrid::SafeDownCast(made->GetBlock(b));
    ASSERT_TRUE(block);
    EXPECT_GT(block->GetNumberOfCells(), 100);
    vtkDataArray* constants = block->GetPointData()->GetArray(ConstantName);
    ASSERT_TRUE(constants);
    for (vtkIdType c = 0; c < block->GetNumberOfCells(); ++c)
    {
      for (const vtkIdType id : GetCell(block, c))
      {
        ASSERT_TRUE(block->GetCell(c)->GetCellDimension() < 3 ||
          std::abs(constants->GetComponent(id, 0) - GetConstant(GetMaterial(block, c))) < 1e-14);
      }
    }
  }
}

// Values that a block has at points that it shares are those of its material, as blocks say
// material where there is no array for it.
TEST(MaterialFields, BlocksHaveTheirOwnValues)
{
  const Grid mesh = MakeKuhnBox(3);
  const auto blockOf = [&](vtkIdType c)
  {
    double bounds[6];
    mesh->GetCellBounds(c, bounds);
    return static_cast<vtkIdType>(bounds[0] + bounds[1] < mesh->GetBounds()[1] ? 0 : 1);
  };
  const auto blocks = MakeBlocks(mesh, blockOf);
  for (unsigned int b = 0; b < 2; ++b)
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName(ValueName);
    values->SetNumberOfValues(mesh->GetNumberOfPoints());
    values->FillValue(b == 0 ? 1. : 5.);
    GetBlock(blocks, b)->GetPointData()->AddArray(values);
  }
  for (const bool interpolates : { false, true })
  {
    const auto made = RunOnBlocks(blocks, 2,
      [&](vtkMultiDimensionalSubdivision* filter)
      {
        JumpAgain(filter);
        filter->ProjectToLimitOn();
        filter->SetInterpolateArrays(interpolates);
      });
    for (unsigned int b = 0; b < 2; ++b)
    {
      const Grid block = GetBlock(made, b);
      vtkDataArray* values = block->GetPointData()->GetArray(ValueName);
      EXPECT_GT(block->GetNumberOfCells(), 500);
      for (vtkIdType p = 0; p < block->GetNumberOfPoints(); ++p)
      {
        ASSERT_NEAR(b == 0 ? 1. : 5., values->GetComponent(p, 0), 1e-14) << "point " << p;
      }
    }
  }
}

// Copies in blocks are joined by the next filter, which goes on, or takes what it gets for a new
// mesh.
TEST(MaterialFields, FiltersInARowOverBlocks)
{
  const Grid mesh = MakeMeshes().front();
  const auto blocks = MakeBlocks(mesh, [](vtkIdType c) { return c % 2; });
  const auto once = RunOnBlocks(blocks, 2, Jump);
  const auto first = RunOnBlocks(blocks, 1, Jump);
  const auto row = RunOnBlocks(first, 1, JumpAgain);
  for (unsigned int b = 0; b < 2; ++b)
  {
    EXPECT_EQ("", Compare(GetBlock(once, b), GetBlock(row, b)));
    RemoveStamp(GetBlock(first, b));
  }
  const auto another = RunOnBlocks(first, 1, JumpAgain);
  for (unsigned int b = 0; b < 2; ++b)
  {
    const Grid block = GetBlock(another, b);
    EXPECT_EQ(GetBlock(row, b)->GetNumberOfCells(), block->GetNumberOfCells());
    EXPECT_EQ(GetBlock(row, b)->GetNumberOfPoints(), block->GetNumberOfPoints());
    vtkDataArray* constants = block->GetPointData()->GetArray(ConstantName);
    for (vtkIdType c = 0; c < block->GetNumberOfCells(); ++c)
    {
      for (const vtkIdType id : GetCell(block, c))
      {
        ASSERT_TRUE(block->GetCell(c)->GetCellDimension() < 3 ||
          std::abs(constants->GetComponent(id, 0) - GetConstant(GetMaterial(block, c))) < 1e-14);
      }
    }
  }
}

// Each of 40 materials meets all others in one point.
TEST(MaterialFields, TooManyThatMeet)
{
  std::vector<Point> points{ { 0., 0., 0. } };
  std::vector<Cell> cells;
  std::vector<int> materials;
  for (int i = 0; i < 40; ++i)
  {
    points.push_back({ std::cos(1. * i), std::sin(1. * i), 0.1 * i });
    cells.push_back({ VTK_LINE, { 0, i + 1 } });
    materials.push_back(i);
  }
  const Grid star = MakeGrid(points, cells);
  AddCellArray(star, "MaterialId", materials);
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->PreserveInterfacesOn();
  filter->SetInterfaceValuesToDiscontinuous();
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(star);
  filter->Update();
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(std::string::npos, messages->Errors[0].find("40 fields"));
  EXPECT_EQ(0, filter->GetOutput()->GetNumberOfPoints());
}
