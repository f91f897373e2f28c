// SPDX-License-Identifier: BSD-3-Clause
// Ghost types that are fewer or more than the cells: fewer say nothing, of more the first count.
#include "PartitionTools.h"

#include "Private/Surface/SurfaceSubdivision.h"
#include "Private/Uniform/UniformSubdivision.h"

#include "vtkPartitionedDataSet.h"

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;

namespace
{

constexpr unsigned char Duplicate = vtkDataSetAttributes::DUPLICATECELL;
constexpr unsigned char Hidden = vtkDataSetAttributes::HIDDENCELL;
constexpr vtkIdType Many = 1000;

const Partition Halves = { "halves", 2, 1, false };

Grid MakeBox()
{
  const Grid box = MakeMixedBox(2);
  AddArrays(box);
  NumberCells(box);
  return box;
}

/// Gives cells the types that `typeOf` says, and `more` than there are cells; the memory of fewer
/// goes on with duplicates, so that who reads beyond the end finds them.
void SetGhosts(
  vtkPointSet* mesh, vtkIdType more, const std::function<unsigned char(vtkIdType)>& typeOf)
{
  const vtkIdType size = mesh->GetNumberOfCells();
  vtkNew<vtkUnsignedCharArray> types;
  types->SetName(vtkDataSetAttributes::GhostArrayName());
  types->SetNumberOfValues(size + Many);
  types->FillValue(Duplicate);
  for (vtkIdType c = 0; c < size; ++c)
  {
    types->SetValue(c, typeOf(c));
  }
  types->SetNumberOfValues(std::max(size + more, vtkIdType(0)));
  mesh->GetCellData()->AddArray(types);
}

/// One type for a mesh of more cells.
void SetTooFewGhosts(vtkPointSet* mesh)
{
  SetGhosts(mesh, 1 - mesh->GetNumberOfCells(), [](vtkIdType) { return Duplicate; });
  ASSERT_LT(mesh->GetCellData()
              ->GetAbstractArray(vtkDataSetAttributes::GhostArrayName())
              ->GetNumberOfTuples(),
    mesh->GetNumberOfCells());
}

template <typename Composite>
vtkSmartPointer<Composite> MakeComposite(const std::vector<Mesh>& meshes)
{
  auto composite = vtkSmartPointer<Composite>::New();
  for (size_t i = 0; i < meshes.size(); ++i)
  {
    if constexpr (std::is_same_v<Composite, vtkPartitionedDataSet>)
    {
      composite->SetPartition(static_cast<unsigned int>(i), meshes[i]);
    }
    else
    {
      composite->SetBlock(static_cast<unsigned int>(i), meshes[i]);
    }
  }
  return composite;
}

vtkSmartPointer<vtkDataObject> RunFilterOn(vtkDataObject* input)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToBoxSpline();
  UpdateInSilence(filter, input);
  return filter->GetOutputDataObject(0);
}

/// What the filter makes of the meshes as blocks of both kinds of composite data sets is `whole`.
void ExpectBlocksAre(vtkDataObject* whole, const std::vector<Mesh>& meshes)
{
  auto* expected = vtkPointSet::SafeDownCast(whole);
  ASSERT_TRUE(expected);
  ExpectWhole(expected, GetMeshes(RunFilterOn(MakeComposite<vtkMultiBlockDataSet>(meshes))));
  ExpectWhole(expected, GetMeshes(RunFilterOn(MakeComposite<vtkPartitionedDataSet>(meshes))));
}

subdivision::SurfaceOptions MakeSurfaceOptions()
{
  subdivision::SurfaceOptions options;
  options.Scheme = subdivision::SurfaceSchemeKind::SqrtThree;
  options.Warn = [](const std::string& message)
  { EXPECT_EQ(std::string::npos, message.find("any other mesh")) << message; };
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  return options;
}

bool Subdivide(vtkPointSet* input, const subdivision::SurfaceOptions& options, vtkPointSet* output)
{
  return SubdivideSurface(
    vtkPolyData::SafeDownCast(input), options, vtkPolyData::SafeDownCast(output));
}

bool Subdivide(vtkPointSet* input, const subdivision::UniformOptions& options, vtkPointSet* output)
{
  return SubdivideUniformly(input, options, vtkUnstructuredGrid::SafeDownCast(output));
}

template <typename Options>
std::vector<Mesh> SubdivideParts(
  const std::vector<Mesh>& parts, const Options& options, int ghostLayers = 0)
{
  Options own = options;
  subdivision::DistributionOptions distribution;
  distribution.IsOfSurfaces = std::is_same_v<Options, subdivision::SurfaceOptions>;
  distribution.GhostLayers = ghostLayers;
  std::vector<Mesh> outputs;
  EXPECT_TRUE(RunOnParts(
    parts, Halves, distribution, own, [&own](vtkPointSet* input, vtkPointSet* output)
    { return Subdivide(input, own, output); }, outputs));
  return outputs;
}

/// Two filters in a row on parts give what they give on the whole, whatever is done to the ghost
/// types between them.
template <typename Options>
void ExpectNextGoesOn(vtkPointSet* mesh, const Options& options, int more)
{
  constexpr bool isOfSurfaces = std::is_same_v<Options, subdivision::SurfaceOptions>;
  const auto none = [](vtkIdType) { return static_cast<unsigned char>(0); };
  const Mesh once = subdivision::MakeMesh(isOfSurfaces);
  ASSERT_TRUE(Subdivide(mesh, options, once));
  if (more >= 0)
  {
    SetGhosts(once, 0, none);
  }
  const Mesh whole = subdivision::MakeMesh(isOfSurfaces);
  ASSERT_TRUE(Subdivide(once, options, whole));
  const std::vector<Mesh> parts = SubdivideParts(Cut(mesh, Halves), options);
  for (const Mesh& part : parts)
  {
    if (more < 0)
    {
      SetTooFewGhosts(part);
    }
    else
    {
      SetGhosts(part, more, none);
    }
  }
  ExpectWhole(whole, SubdivideParts(parts, options));
}

}

TEST(GhostLengths, TooFewInBlocksSayNothing)
{
  const Grid box = MakeBox();
  const std::vector<Mesh> cut = Cut(box, CutInSlabs(box, 2), 2, KnownBy::GlobalIds);
  for (const Mesh& mesh : cut)
  {
    SetTooFewGhosts(mesh);
  }
  ExpectBlocksAre(RunFilterOn(box), cut);
}

TEST(GhostLengths, OfTooManyInBlocksTheFirstCount)
{
  // Each block has all cells; those of the other are duplicates, and few are hidden.
  const Grid box = MakeBox();
  const std::vector<int> slabs = CutInSlabs(box, 2);
  const auto isHidden = [](vtkIdType c) { return c % 5 == 3; };
  std::vector<Mesh> blocks;
  for (int b = 0; b < 2; ++b)
  {
    const Mesh block = Cut(box, std::vector<int>(slabs.size(), 0), 1, KnownBy::GlobalIds)[0];
    SetGhosts(
      block, 7, [&](vtkIdType c) { return slabs[c] != b ? Duplicate
                                     : isHidden(c)      ? Hidden
                                                        : 0; });
    blocks.push_back(block);
  }
  const Grid whole = DeepCopy(box);
  SetGhosts(
    whole, 0, [&](vtkIdType c) { return isHidden(c) ? Hidden : static_cast<unsigned char>(0); });
  ExpectBlocksAre(RunFilterOn(whole), blocks);
}

TEST(GhostLengths, TooFewInPartsSayNothing)
{
  const Grid box = MakeBox();
  subdivision::UniformOptions options;
  options.Levels = 1;
  options.Warn = [](const std::string&) {};
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  const Mesh whole = subdivision::MakeMesh(false);
  ASSERT_TRUE(Subdivide(box, options, whole));
  const std::vector<Mesh> cut = Cut(box, Halves);
  for (const Mesh& part : cut)
  {
    SetTooFewGhosts(part);
  }
  ExpectWhole(whole, SubdivideParts(cut, options));
}

TEST(GhostLengths, NextFilterOnPartsGoesOn)
{
  const Grid box = MakeBox();
  subdivision::UniformOptions options;
  options.Levels = 1;
  options.Warn = [](const std::string& message)
  { EXPECT_EQ(std::string::npos, message.find("any other mesh")) << message; };
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  subdivision::SurfaceOptions ofSurface = MakeSurfaceOptions();
  ofSurface.Scheme = subdivision::SurfaceSchemeKind::Loop; // SqrtThree does not go on
  for (const int more : { -1, 0, 7 })
  {
    SCOPED_TRACE(more);
    ExpectNextGoesOn(box, options, more);
    ExpectNextGoesOn(MakeSkin(MakeMeshes()[0]), ofSurface, more);
  }
}

TEST(GhostLengths, PartsHaveGhostCellsWhoeverHadThem)
{
  // Only the first part has ghost types; those of the second are too few, or there are none.
  const Mesh surface = MakeSkin(MakeMeshes()[0]);
  const auto expected = SubdivideParts(Cut(surface, Halves), MakeSurfaceOptions(), 1);
  for (const bool tooFew : { false, true })
  {
    SCOPED_TRACE(tooFew);
    const std::vector<Mesh> cut = Cut(surface, Halves);
    SetGhosts(cut[0], 0, [](vtkIdType) { return static_cast<unsigned char>(0); });
    if (tooFew)
    {
      SetTooFewGhosts(cut[1]);
    }
    const auto parts = SubdivideParts(cut, MakeSurfaceOptions(), 1);
    for (size_t p = 0; p < parts.size(); ++p)
    {
      vtkUnsignedCharArray* types = parts[p]->GetCellGhostArray();
      vtkUnsignedCharArray* wanted = expected[p]->GetCellGhostArray();
      ASSERT_TRUE(types && wanted) << p;
      ASSERT_EQ(wanted->GetNumberOfValues(), types->GetNumberOfValues());
      EXPECT_TRUE(std::equal(wanted->GetPointer(0),
        wanted->GetPointer(0) + wanted->GetNumberOfValues(), types->GetPointer(0)));
    }
  }
}

TEST(GhostLengths, TooFewHideNothingWithKeptTypes)
{
  const Grid box = MakeBox();
  const auto run = [](vtkDataObject* input)
  {
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    filter->SetVolumeSchemeToBoxSpline();
    filter->SetVolumeScheme(vtkMultiDimensionalSubdivision::LINEAR);
    filter->KeepCellTypesOn();
    filter->SetInputDataObject(input);
    filter->Update();
    return vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfCells();
  };
  const vtkIdType wanted = run(box);
  ASSERT_GT(wanted, 0);
  SetGhosts(box, 1 - box->GetNumberOfCells(), [](vtkIdType) { return Hidden; });
  EXPECT_EQ(wanted, run(box));
}
