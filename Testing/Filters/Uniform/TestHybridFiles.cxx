// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestHybridFiles.cxx
 * Meshes from elsewhere, and each type of cell that VTK makes, as cells that keep their types:
 * nothing hangs, nothing is lost, and nothing is cut that no warning names.
 */
#include "FeatureTools.h"
#include "FileTools.h"
#include "TypedCellTools.h"

#include "vtkCellTypeSource.h"

using namespace feature_tools;
using namespace file_tools;
using namespace typed_cell_tools;

namespace
{

using Types = std::map<int, int>;

const Configure Linear = [](Filter* filter)
{
  filter->SetVolumeSchemeToLinear();
  filter->KeepCellTypesOn();
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
};
const Configure Pieces = [](Filter* filter)
{
  Linear(filter);
  filter->SetQuadraticCellsToPieces();
};

/// Of the types after a step, with octahedra as four tetrahedra.
Types CountChildren(const Types& types)
{
  Types children;
  for (const auto& [type, count] : types)
  {
    const std::map<int, int> factors = { { VTK_VERTEX, 1 }, { VTK_LINE, 2 }, { VTK_TRIANGLE, 4 },
      { VTK_QUAD, 4 }, { VTK_TETRA, 8 }, { VTK_PYRAMID, 4 }, { VTK_WEDGE, 8 },
      { VTK_HEXAHEDRON, 8 } };
    children[type] += count * factors.at(type);
    if (type == VTK_PYRAMID)
    {
      children[VTK_TETRA] += 8 * count;
    }
  }
  return children;
}

/// The sum of the volumes of cells without their signs.
double MeasureAll(vtkUnstructuredGrid* grid)
{
  double sum = 0.;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    double flux = 0.;
    for (const Ids& face : GetFaces(grid, c))
    {
      flux += GetFlux(grid, face);
    }
    sum += std::abs(flux) / 6.;
  }
  return sum;
}

/// `fits`: cells of the input do not overlap.
void ExpectGood(vtkDataObject* input, const Configure& configure, bool fits = true)
{
  vtkNew<Messages> messages;
  const Grid start = Execute(input, 0, configure, messages);
  const Grid output = Execute(input, 1, configure, vtkNew<Messages>());
  EXPECT_TRUE(messages->Errors.empty());
  for (const std::string& warning : messages->Warnings)
  {
    EXPECT_TRUE(warning.find("no children of the same type") != std::string::npos ||
      warning.find("lie against two triangles") != std::string::npos ||
      warning.find("Passed over") != std::string::npos ||
      warning.find("not linear") != std::string::npos)
      << warning;
  }
  EXPECT_EQ(CountTypes(output), CountChildren(CountTypes(start)));
  for (const Grid& grid : { start, output })
  {
    if (grid->GetNumberOfCells() > 100000)
    {
      continue; // looking at all faces takes long
    }
    EXPECT_EQ(SolidFaces(grid).CountCutQuads(), 0);
    if (fits)
    {
      ExpectFitting(grid);
    }
  }
  EXPECT_NEAR(MeasureSolids(output), MeasureSolids(start), 1e-12 * MeasureAll(start));
  // The smooth scheme has the same cells.
  const Grid smooth = Execute(
    input, 1,
    [&](Filter* filter)
    {
      configure(filter);
      filter->KeepCellTypesOff();
      filter->SetVolumeSchemeToHybrid();
    },
    vtkNew<Messages>());
  EXPECT_EQ(CountTypes(smooth), CountTypes(output));
  EXPECT_EQ(smooth->GetNumberOfPoints(), output->GetNumberOfPoints());
}

const char* const Files[] = { "hex_geos_box_hybrid.vtu", "hex_gmsh_quadtri_torus_4types.vtu",
  "hex_mfem_tinyzoo.vtu", "hostile_degenerate_cells.vtu", "hostile_duplicate_points.vtu",
  "hostile_inverted_cells.vtu", "hostile_nan_inf_coords.vtu", "hostile_out_of_range_ids.vtu",
  "hostile_quadratic_among_linear.vtu", "hostile_unsupported_types.vtu",
  "hostile_unused_points.vtu", "mix_elmer_shell_on_solid.vtu", "mix_elmer_wire_pair.vtu",
  "mix_geos_cube.vtu", "mix_nastran_isat.vtu", "nat_geos_all_types.vtu",
  "nat_ogs_sphere_zero_volume.vtu", "nm_nastran_wingbox.vtu", "poly_cow_mixed.vtp",
  "poly_dodecahedron.vtp", "surf_moebius_quads.vtp" };

class HybridFiles : public testing::TestWithParam<const char*>
{
};

class HybridSources : public testing::TestWithParam<int>
{
};

vtkSmartPointer<vtkPointSet> ReadShared(const std::string& name)
{
  const std::string path = GetSharedFile(name);
  return WhyNotRead(path).empty() ? ReadFile(path) : nullptr;
}

}

TEST_P(HybridFiles, FitAndKeepTheirVolumes)
{
  const auto input = ReadShared(GetParam());
  if (!input)
  {
    GTEST_SKIP() << WhyNotRead(GetSharedFile(GetParam()));
  }
  ExpectGood(input, Linear, GetParam() != std::string("hostile_degenerate_cells.vtu"));
}

INSTANTIATE_TEST_SUITE_P(Shared, HybridFiles, testing::ValuesIn(Files),
  [](const auto& file)
  {
    const std::string name = file.param;
    return name.substr(0, name.find('.'));
  });

/// Figures of the mesh's own description.
TEST(HybridFiles, OnlyCellsWithCutQuadsGiveWay)
{
  const auto input = ReadShared("hex_geos_box_hybrid.vtu");
  if (!input)
  {
    GTEST_SKIP() << "the file is not there";
  }
  vtkNew<Messages> messages;
  const Types types = CountTypes(Execute(input, 0, Linear, messages));
  EXPECT_EQ(messages->CountWarnings("1232 quad(s) lie against two triangles"), 1);
  EXPECT_EQ(messages->CountWarnings("641 hexahedra and 0 wedges"), 1);
  EXPECT_EQ(messages->CountWarnings("151 pyramids two tetrahedra and 0 quads"), 1);
  EXPECT_EQ(types.at(VTK_HEXAHEDRON), 943 - 641);
  const int ofHexahedra = 1232 - 151;
  EXPECT_EQ(types.at(VTK_PYRAMID), 515 - 151 + 6 * 641 - ofHexahedra);
  EXPECT_EQ(types.at(VTK_TETRA), 7949 + 2 * 1232);
}

TEST_P(HybridSources, FitAndKeepTheirVolumes)
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(GetParam());
  source->SetBlocksDimensions(2, 3, 2);
  source->SetOutputPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  ASSERT_GT(source->GetOutput()->GetNumberOfCells(), 0);
  for (const Configure& configure : { Linear, Pieces })
  {
    ExpectGood(source->GetOutput(), configure);
    // The cells have the volume that they have as tetrahedra.
    const auto asSimplices = [&](Filter* filter)
    {
      configure(filter);
      filter->KeepCellTypesOff();
    };
    const double volume =
      MeasureSolids(Execute(source->GetOutput(), 0, asSimplices, vtkNew<Messages>()));
    EXPECT_NEAR(
      MeasureSolids(Execute(source->GetOutput(), 0, configure, vtkNew<Messages>())), volume, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(VTK, HybridSources,
  testing::Values(VTK_LINE, VTK_TRIANGLE, VTK_QUAD, VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE,
    VTK_PYRAMID, VTK_PENTAGONAL_PRISM, VTK_HEXAGONAL_PRISM, VTK_QUADRATIC_EDGE,
    VTK_QUADRATIC_TRIANGLE, VTK_QUADRATIC_QUAD, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON,
    VTK_QUADRATIC_WEDGE, VTK_QUADRATIC_PYRAMID, VTK_CUBIC_LINE, VTK_LAGRANGE_CURVE,
    VTK_LAGRANGE_TRIANGLE, VTK_LAGRANGE_QUADRILATERAL, VTK_LAGRANGE_TETRAHEDRON,
    VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_WEDGE));
