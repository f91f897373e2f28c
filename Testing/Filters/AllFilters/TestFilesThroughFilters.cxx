// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestFilesThroughFilters.cxx
 * Files from elsewhere, where they are there, through every filter: each cell has all of its
 * children, with its own data, and no array is lost. What a filter leaves out is counted by the
 * types of cells in the file, not by what the filter says.
 */
#include "FileCells.h"
#include "FileTools.h"
#include "SubdivisionDeformationTools.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkExtractDimensions.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSimplicialComplexTopology.h"
#include "vtkSubdivisionCageSource.h"
#include "vtkSurfaceSubdivision.h"

using namespace deformation_tools;
using namespace file_tools;

namespace
{

/// Arrays of `from` that `to` does not have, or has with other components or too few tuples.
/// Normals do not hold any more (TestInputNormals.cxx).
std::string FindLostArrays(vtkFieldData* from, vtkFieldData* to, vtkIdType tuples)
{
  std::string lost;
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    vtkAbstractArray* found = to->GetAbstractArray(array->GetName());
    auto* attributes = vtkDataSetAttributes::SafeDownCast(from);
    if (attributes && array == attributes->GetNormals())
    {
      continue;
    }
    const bool isKept = found && found->GetNumberOfComponents() == array->GetNumberOfComponents() &&
      found->GetNumberOfTuples() == (tuples < 0 ? array->GetNumberOfTuples() : tuples);
    lost += isKept ? "" : std::string(array->GetName()) + " ";
  }
  return lost;
}

void ExpectNoLostArrays(vtkPointSet* input, vtkPointSet* output, bool ofCells = true)
{
  EXPECT_EQ(
    FindLostArrays(input->GetPointData(), output->GetPointData(), output->GetNumberOfPoints()), "");
  EXPECT_EQ(FindLostArrays(input->GetFieldData(), output->GetFieldData(), -1), "");
  if (ofCells)
  {
    EXPECT_EQ(
      FindLostArrays(input->GetCellData(), output->GetCellData(), output->GetNumberOfCells()), "");
  }
}

/// How many children each cell of the input has. All of them have its data.
std::vector<vtkIdType> CountChildren(vtkPointSet* input, vtkPointSet* output)
{
  std::vector<vtkIdType> counts(static_cast<std::size_t>(input->GetNumberOfCells()), 0);
  vtkDataArray* ids = output->GetCellData()->GetArray("vtkOriginalCellIds");
  if (!ids)
  {
    ADD_FAILURE() << "no original ids";
    return counts;
  }
  vtkIdType different = 0;
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    const auto parent = static_cast<vtkIdType>(ids->GetComponent(c, 0));
    ++counts.at(static_cast<std::size_t>(parent));
  }
  for (int a = 0; a < input->GetCellData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = input->GetCellData()->GetArray(a);
    vtkDataArray* made = array ? output->GetCellData()->GetArray(array->GetName()) : nullptr;
    for (vtkIdType c = 0; made && c < output->GetNumberOfCells(); ++c)
    {
      const auto parent = static_cast<vtkIdType>(ids->GetComponent(c, 0));
      different += made->GetComponent(c, 0) == array->GetComponent(parent, 0) ? 0 : 1;
    }
  }
  EXPECT_EQ(different, 0);
  return counts;
}

/// Cells whose number of children is not one of those that expected(cell) allows, from the first to
/// the second, in steps of the third.
template <typename Expected>
void ExpectChildren(
  const FileCells& cells, const std::vector<vtkIdType>& counts, const Expected& expected)
{
  vtkIdType wrong = 0;
  for (std::size_t c = 0; c < counts.size(); ++c)
  {
    const std::array<vtkIdType, 3> allowed = expected(c);
    const bool isWrong = counts[c] < allowed[0] || counts[c] > allowed[1] ||
      (allowed[2] > 0 && counts[c] % allowed[2] != 0);
    if (isWrong && wrong++ == 0)
    {
      ADD_FAILURE() << "cell " << c << " of type " << cells.Types[c] << " has " << counts[c]
                    << " children, not " << allowed[0] << " to " << allowed[1];
    }
  }
  EXPECT_EQ(wrong, 0);
}

/// Of a solid its faces on the outside are subdivided: all faces of a polyhedron give at most so
/// many.
constexpr vtkIdType MostOutside = 400;

/// Points that cells use are finite.
void ExpectFinite(vtkPointSet* output)
{
  vtkDataArray* points = output->GetPoints() ? output->GetPoints()->GetData() : nullptr;
  vtkIdType wrong = 0;
  for (vtkIdType p = 0; points && p < points->GetNumberOfTuples(); ++p)
  {
    for (int k = 0; k < 3; ++k)
    {
      wrong += std::isfinite(points->GetComponent(p, k)) ? 0 : 1;
    }
  }
  EXPECT_EQ(wrong, 0);
}

/// Centres of some cells of the highest dimension that a mesh has: points inside of it.
Grid TakeCentres(vtkUnstructuredGrid* mesh)
{
  int highest = 0;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    highest = std::max(highest, mesh->GetCell(c)->GetCellDimension());
  }
  std::vector<Point> centres;
  const vtkIdType step = 1 + mesh->GetNumberOfCells() / 2000;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); c += step)
  {
    const Ids ids = GetCell(mesh, c);
    if (static_cast<int>(ids.size()) != highest + 1)
    {
      continue;
    }
    centres.push_back({ 0., 0., 0. });
    for (const vtkIdType id : ids)
    {
      const Point corner = GetPoint(mesh, id);
      for (int k = 0; k < 3; ++k)
      {
        centres.back()[k] += corner[k] / static_cast<double>(ids.size());
      }
    }
  }
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < centres.size(); ++i)
  {
    cells.push_back({ VTK_VERTEX, { static_cast<vtkIdType>(i) } });
  }
  return MakeGrid(centres, cells);
}

const char* const Files[] = { "hex_geos_box_hybrid.vtu", "hex_gmsh_quadtri_torus_4types.vtu",
  "hex_mfem_tinyzoo.vtu", "large_porepy_case3_500k.vtu", "line_navis_neuron.vtu",
  "mix_elmer_shell_on_solid.vtu", "mix_elmer_wire_pair.vtu", "mix_geos_cube.vtu",
  "mix_nastran_isat.vtu", "mix_ogs5_fracture_network.vtu", "mix_porepy_case2_4k.vtu",
  "nat_bunny_verts_dup_points.vtp", "nat_fea_quadratic_tets.vtu", "nat_geos_all_types.vtu",
  "nat_ogs_sphere_zero_volume.vtu", "nm_hourglass_bowtie.vtp", "nm_nastran_wingbox.vtu",
  "nm_ogs5_fracture_surfaces.vtu", "nm_triple_vierbein.vtp", "poly_cow_mixed.vtp",
  "poly_dodecahedron.vtp", "surf_bunny_3k.vtp", "surf_bunny_full.vtp", "surf_moebius_quads.vtp",
  "tet_geos_synthetic.vtu", "tet_gmsh_coil_crack.vtu" };

class FilesThroughFilters : public testing::TestWithParam<const char*>
{
protected:
  void SetUp() override
  {
    const std::string path = GetSharedFile(GetParam());
    if (const std::string reason = WhyNotRead(path); !reason.empty())
    {
      GTEST_SKIP() << reason;
    }
    this->Input = ReadFile(path);
    this->Cells = std::make_unique<FileCells>(this->Input);
    ASSERT_GT(this->Input->GetNumberOfCells(), 0);
  }
  /// Whether it would take too long to run everything.
  bool IsLarge() const { return this->Input->GetNumberOfCells() > 100000; }
  /// Runs a filter, which may not fail.
  vtkSmartPointer<vtkPointSet> Run(vtkAlgorithm* filter, Messages* messages)
  {
    messages->Watch(filter);
    filter->SetInputDataObject(0, this->Input);
    filter->Update();
    EXPECT_TRUE(messages->Errors.empty()) << messages->Errors[0];
    return vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0));
  }
  /// Runs a filter that loses no array, and gives each cell as many children as `expected` says.
  template <typename Filter, typename Expected>
  void ExpectChildrenOf(Filter* filter, const Expected& expected)
  {
    vtkNew<Messages> messages;
    filter->GenerateOriginalIdsOn();
    const auto output = this->Run(filter, messages);
    ExpectNoLostArrays(this->Input, output);
    ExpectChildren(*this->Cells, CountChildren(this->Input, output), expected);
  }
  /// All cells are there, those of dimension d as 2^d children of each of their simplices.
  void ExpectUniform(vtkPointSet* output)
  {
    ExpectNoLostArrays(this->Input, output);
    ExpectFinite(output);
    ExpectChildren(*this->Cells, CountChildren(this->Input, output),
      [this](std::size_t c) -> std::array<vtkIdType, 3>
      {
        const Shape& shape = this->Cells->Shapes[c];
        const vtkIdType children = vtkIdType(1) << shape.Dimension;
        return { children * shape.Least, children * shape.Most, children };
      });
  }

  vtkSmartPointer<vtkPointSet> Input;
  std::unique_ptr<FileCells> Cells;
};

}

TEST_P(FilesThroughFilters, MultiDimensionalSubdivision)
{
  for (const int scheme : { vtkMultiDimensionalSubdivision::BOX_SPLINE,
         vtkMultiDimensionalSubdivision::TET_OCT, vtkMultiDimensionalSubdivision::LINEAR })
  {
    SCOPED_TRACE(scheme);
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    vtkNew<Messages> messages;
    filter->SetVolumeScheme(scheme);
    filter->GenerateOriginalIdsOn();
    filter->CacheOperatorOff();
    this->ExpectUniform(this->Run(filter, messages));
    if (this->IsLarge())
    {
      return;
    }
  }
}

TEST_P(FilesThroughFilters, ProjectionToTheLimit)
{
  for (const int scheme :
    { vtkMultiDimensionalSubdivision::BOX_SPLINE, vtkMultiDimensionalSubdivision::AUTOMATIC })
  {
    SCOPED_TRACE(scheme);
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    vtkNew<Messages> messages;
    filter->SetNumberOfLevels(this->IsLarge() ? 0 : 1);
    filter->SetVolumeScheme(scheme);
    filter->ProjectToLimitOn();
    filter->GenerateLimitNormalsOn();
    filter->GenerateOriginalIdsOn();
    filter->CacheOperatorOff();
    const auto output = this->Run(filter, messages);
    EXPECT_TRUE(output->GetPointData()->HasArray("LimitNormals"));
    ExpectNoLostArrays(this->Input, output);
    ExpectFinite(output);
    if (!this->IsLarge() && scheme == vtkMultiDimensionalSubdivision::BOX_SPLINE)
    {
      this->ExpectUniform(output);
    }
  }
}

TEST_P(FilesThroughFilters, KeptCellTypes)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToLinear();
  filter->KeepCellTypesOn();
  this->ExpectChildrenOf(filter.Get(),
    [this](std::size_t c) -> std::array<vtkIdType, 3>
    {
      const Shape& shape = this->Cells->Shapes[c];
      const vtkIdType children = vtkIdType(1) << shape.Dimension;
      switch (this->Cells->Types[c])
      {
        case VTK_QUAD:
          return { children, 8, 1 };
        // These may give way to triangles: pyramids, which become 12 cells, and tetrahedra.
        case VTK_HEXAHEDRON:
        case VTK_VOXEL:
          return { children, 12 * 8, 4 };
        case VTK_WEDGE:
          return { children, 8 * 8, 4 };
        case VTK_PYRAMID:
          return { 12, 16, 4 };
        case VTK_PENTAGONAL_PRISM:
        case VTK_HEXAGONAL_PRISM:
        case VTK_POLYHEDRON:
          return { children, 12 * shape.Most, 4 };
        default:
          return { children * shape.Least, children * shape.Most, children };
      }
    });
}

TEST_P(FilesThroughFilters, QuadraticCellsInPieces)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetNumberOfLevels(0);
  filter->SetVolumeSchemeToBoxSpline();
  filter->SetQuadraticCellsToPieces();
  this->ExpectChildrenOf(filter.Get(),
    [this](std::size_t c) -> std::array<vtkIdType, 3>
    {
      const Shape& shape = this->Cells->Shapes[c];
      const int pieces = this->Cells->Types[c] == VTK_QUADRATIC_TETRA ? 8 : 1;
      return { pieces * shape.Least, pieces * shape.Most, pieces };
    });
}

TEST_P(FilesThroughFilters, RedGreenRefinement)
{
  for (const int placement : { vtkRedGreenRefinement::LINEAR, vtkRedGreenRefinement::LIMIT })
  {
    SCOPED_TRACE(placement);
    if (this->IsLarge() && placement == vtkRedGreenRefinement::LIMIT)
    {
      return;
    }
    vtkNew<vtkRedGreenRefinement> filter;
    vtkNew<Messages> messages;
    filter->RefineByAttributeErrorOff();
    filter->RefineByEdgeLengthOn();
    filter->SetMaximumEdgeLength(0.);
    filter->SetMaximumLevel(1);
    filter->SetPlacement(placement);
    filter->GenerateOriginalIdsOn();
    const auto output = this->Run(filter, messages);
    if (messages->CountWarnings("are so small") == 0)
    {
      this->ExpectUniform(output);
      continue;
    }
    // Edges without length are not split: cells there have fewer children.
    ExpectNoLostArrays(this->Input, output);
    ExpectChildren(*this->Cells, CountChildren(this->Input, output),
      [this](std::size_t c) -> std::array<vtkIdType, 3>
      {
        const Shape& shape = this->Cells->Shapes[c];
        return { shape.Least, shape.Most << shape.Dimension, 1 };
      });
  }
}

TEST_P(FilesThroughFilters, SurfaceSubdivision)
{
  using Surface = vtkSurfaceSubdivision;
  for (int scheme = Surface::LOOP; scheme <= Surface::LINEAR; ++scheme)
  {
    SCOPED_TRACE(scheme);
    vtkNew<Surface> filter;
    vtkNew<Messages> messages;
    filter->SetScheme(scheme);
    filter->GenerateOriginalIdsOn();
    const auto output = this->Run(filter, messages);
    const vtkIdType solids = this->Cells->Count(3);
    EXPECT_EQ(messages->CountWarnings(std::to_string(solids) + " cell(s) are solids"), solids > 0);
    ExpectNoLostArrays(this->Input, output);
    ExpectFinite(output);
    ExpectChildren(*this->Cells, CountChildren(this->Input, output),
      [&](std::size_t c) -> std::array<vtkIdType, 3>
      {
        const Shape& shape = this->Cells->Shapes[c];
        const vtkIdType size = this->Cells->Sizes[c];
        if (shape.Dimension == 3)
        {
          return { 0, MostOutside, 1 };
        }
        if (shape.Dimension != 2)
        {
          const vtkIdType lines =
            scheme == Surface::SQRT_THREE || scheme == Surface::FOUR_EIGHT ? 1 : 2;
          const vtkIdType children = shape.Dimension == 1 ? lines : 1;
          return { children, children, 1 };
        }
        switch (scheme)
        {
          case Surface::CATMULL_CLARK:
            return { size, size, 1 };
          case Surface::DOO_SABIN: // the faces of its edges and vertices may be with neighbours
          case Surface::MIDEDGE:
            return { 1, 1 + 2 * size, 1 };
          case Surface::FOUR_EIGHT: // a face of two triangles on an edge is in one of two cells
          case Surface::SQRT_THREE:
            return { 0, 6 * size, 1 };
          default:
            return { 4 * (size - 2), 4 * (size - 2), 1 };
        }
      });
    if (scheme == Surface::SQRT_THREE)
    {
      vtkIdType triangles = 0;
      for (const Shape& shape : this->Cells->Shapes)
      {
        triangles += shape.Dimension == 2 ? shape.Least : 0;
      }
      const vtkIdType polys = vtkPolyData::SafeDownCast(output)->GetNumberOfPolys();
      EXPECT_TRUE(solids > 0 ? polys >= 3 * triangles : polys == 3 * triangles) << polys;
    }
  }
}

TEST_P(FilesThroughFilters, AdaptiveSurfaceSubdivision)
{
  vtkNew<vtkAdaptiveSurfaceSubdivision> filter;
  vtkNew<Messages> messages;
  filter->RefineByAttributeErrorOff();
  filter->RefineByGeometricErrorOff();
  filter->RefineByEdgeLengthOn();
  filter->SetMaximumEdgeLength(0.);
  filter->SetMaximumLevel(2); // lines are cut in the second step
  const auto output = this->Run(filter, messages);
  ExpectNoLostArrays(this->Input, output);
  ExpectFinite(output);
  ExpectChildren(*this->Cells, CountChildren(this->Input, output),
    [this](std::size_t c) -> std::array<vtkIdType, 3>
    {
      const Shape& shape = this->Cells->Shapes[c];
      const vtkIdType most[4] = { 1, 3, 20 * shape.Most, 3 * MostOutside };
      const vtkIdType least[4] = { 1, 3, 1, 0 };
      return { least[shape.Dimension], most[shape.Dimension], 1 };
    });
}

TEST_P(FilesThroughFilters, SimplicialComplexTopology)
{
  vtkNew<vtkSimplicialComplexTopology> filter;
  vtkNew<Messages> messages;
  const auto output = this->Run(filter, messages);
  ExpectNoLostArrays(this->Input, output, false);
  std::vector<char> isUsed(static_cast<std::size_t>(this->Input->GetNumberOfPoints()), 0);
  vtkNew<vtkIdList> ids;
  vtkIdType least = 0; // tetrahedra
  vtkIdType most = 0;
  for (vtkIdType c = 0; c < this->Input->GetNumberOfCells(); ++c)
  {
    const auto index = static_cast<std::size_t>(c);
    const Shape& shape = this->Cells->Shapes[index];
    this->Input->GetCellPoints(c, ids);
    const vtkIdType corners =
      this->Cells->Types[index] == VTK_QUADRATIC_TETRA ? 4 : ids->GetNumberOfIds();
    for (vtkIdType i = 0; i < corners; ++i)
    {
      isUsed[static_cast<std::size_t>(ids->GetId(i))] = 1;
    }
    least += shape.Dimension == 3 ? shape.Least : 0;
    most += shape.Dimension == 3 ? shape.Most : 0;
  }
  auto* counts = vtkIdTypeArray::SafeDownCast(output->GetFieldData()->GetArray("SimplexCounts"));
  ASSERT_TRUE(counts);
  EXPECT_GE(counts->GetValue(3), least);
  EXPECT_LE(counts->GetValue(3), most);
  EXPECT_EQ(
    output->GetNumberOfCells(), counts->GetValue(0) + counts->GetValue(1) + counts->GetValue(2));
  const vtkIdType centres = output->GetNumberOfPoints() - this->Input->GetNumberOfPoints();
  EXPECT_EQ(counts->GetValue(0), centres + std::count(isUsed.begin(), isUsed.end(), 1));
}

TEST_P(FilesThroughFilters, ExtractDimensions)
{
  vtkIdType sum = 0;
  for (int dimension = 0; dimension < 4; ++dimension)
  {
    vtkNew<vtkExtractDimensions> filter;
    vtkNew<Messages> messages;
    filter->ClearOutputDimensions();
    filter->AddOutputDimension(dimension);
    const auto output = this->Run(filter, messages);
    EXPECT_EQ(output->GetNumberOfCells(), this->Cells->Count(dimension));
    sum += output->GetNumberOfCells();
    ExpectNoLostArrays(this->Input, output);
  }
  EXPECT_EQ(sum, this->Input->GetNumberOfCells());
}

// Each file is bent by a cage around it.
TEST_P(FilesThroughFilters, SubdivisionDeformation)
{
  const Map move = [](const Point& p) { return Point{ 2. * p[0] + p[1], p[1] - p[2], p[2] }; };
  vtkNew<vtkSubdivisionCageSource> cage;
  cage->SetInputDataObject(0, this->Input);
  cage->SetMargin(100.); // the limit of the cage is smaller than the cage
  cage->Update();
  vtkNew<vtkSubdivisionDeformation> filter;
  vtkNew<Messages> messages;
  filter->SetNumberOfLevels(1);
  filter->SetOutsidePointsToError();
  filter->TransformVectorsOff();
  filter->SetRestMeshData(cage->GetOutput());
  filter->SetDeformedMeshData(Moved(cage->GetOutput(), move));
  const auto output = this->Run(filter, messages);
  EXPECT_TRUE(messages->Warnings.empty()) << messages->Warnings[0];
  ASSERT_EQ(output->GetNumberOfPoints(), this->Input->GetNumberOfPoints());
  EXPECT_EQ(output->GetNumberOfCells(), this->Input->GetNumberOfCells());
  ExpectNoLostArrays(this->Input, output);
  EXPECT_LT(GetLargestError(output, this->Input, move), 1e-5 * this->Input->GetLength());
}

// Each file is the control mesh of what lies in it, in its surfaces, or on its curves.
TEST_P(FilesThroughFilters, RestMeshOfSubdivisionDeformation)
{
  const Map move = [](const Point& p) { return Point{ 2. * p[0] + p[1], p[1] - p[2], p[2] }; };
  const int levels = this->IsLarge() ? 0 : 1;
  vtkNew<vtkMultiDimensionalSubdivision> smoothed;
  vtkNew<Messages> messages;
  smoothed->SetNumberOfLevels(levels);
  smoothed->SetVolumeSchemeToBoxSpline();
  smoothed->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  smoothed->CacheOperatorOff();
  const Grid centres =
    TakeCentres(vtkUnstructuredGrid::SafeDownCast(this->Run(smoothed, messages)));
  ASSERT_GT(centres->GetNumberOfPoints(), 0);
  Deformer filter;
  filter->SetNumberOfLevels(levels);
  const auto moved = vtkSmartPointer<vtkPointSet>::Take(this->Input->NewInstance());
  moved->ShallowCopy(this->Input);
  moved->SetPoints(MovePoints(this->Input, move));
  const auto output = filter.Run(centres, this->Input, moved);
  EXPECT_TRUE(filter.GetErrors().empty()) << filter.GetErrors()[0];
  EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 0);
  ASSERT_EQ(output->GetNumberOfPoints(), centres->GetNumberOfPoints());
  EXPECT_LT(GetLargestError(output, centres, move), 1e-5 * this->Input->GetLength());
}

INSTANTIATE_TEST_SUITE_P(Shared, FilesThroughFilters, testing::ValuesIn(Files),
  [](const auto& param)
  {
    const std::string name = param.param;
    return name.substr(0, name.find('.'));
  });
