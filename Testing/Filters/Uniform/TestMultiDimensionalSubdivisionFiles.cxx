// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMultiDimensionalSubdivisionFiles.cxx
 * Files from elsewhere, where they are there: sizes, warnings, and nothing that is not finite.
 */
#include "FileTools.h"
#include "MultiDimensionalSubdivisionTools.h"

#include "Private/Reading/CellsToSimplices.h"
#include "Private/Reading/ReadableMesh.h"

using namespace file_tools;
using namespace multi_dimensional_subdivision_tools;

namespace
{

struct File
{
  const char* Name;
  std::size_t Warnings;
  int Levels;
};

void PrintTo(const File& file, std::ostream* out)
{
  *out << file.Name;
}

class SubdivisionOfFile : public testing::TestWithParam<File>
{
};

}

TEST_P(SubdivisionOfFile, IsComplete)
{
  const File& file = GetParam();
  const std::string path = GetSharedFile(file.Name);
  if (const std::string reason = WhyNotRead(path); !reason.empty())
  {
    GTEST_SKIP() << reason;
  }
  const auto input = ReadFile(path);
  std::vector<std::string> warnings; // of cells that are not linear
  const auto readable =
    subdivision::MakeReadable(input, subdivision::NonLinearRule::Corners, warnings);
  const auto simplices =
    subdivision::CellsToSimplices(vtkPointSet::SafeDownCast(readable), nullptr);
  for (int levels = 1; levels <= file.Levels; ++levels)
  {
    Options options;
    options.Levels = levels;
    options.OriginalIds = options.Classification = true;
    vtkNew<Messages> messages;
    const Grid result = Subdivide(input, options, messages);
    EXPECT_EQ(messages->Errors.size(), 0u);
    EXPECT_EQ(messages->Warnings.size(), file.Warnings);
    const auto ofPoints =
      static_cast<std::size_t>(messages->CountWarnings("at the place of another") +
        messages->CountWarnings("of another cell") +
        messages->CountWarnings("of the mesh from another"));
    EXPECT_EQ(messages->Warnings.size(), simplices.Warnings.size() + warnings.size() + ofPoints);
    vtkIdType cells = 0;
    for (unsigned char dimension : simplices.Simplices.Dimensions)
    {
      cells += vtkIdType(1) << (dimension * levels);
    }
    EXPECT_EQ(result->GetNumberOfCells(), cells);
    ASSERT_GE(result->GetNumberOfPoints(), input->GetNumberOfPoints());
    vtkIdType outside = 0;
    vtkIdType notFinite = 0;
    const vtkIdType size = result->GetNumberOfPoints();
    vtkCellArray* list = result->GetCells();
    vtkDataArray* ids = list ? list->GetConnectivityArray() : nullptr;
    vtkDataArray* points = result->GetPoints() ? result->GetPoints()->GetData() : nullptr;
    for (vtkIdType i = 0; ids && i < ids->GetNumberOfValues(); ++i)
    {
      const auto p = static_cast<vtkIdType>(ids->GetComponent(i, 0));
      if (p < 0 || p >= size)
      {
        ++outside;
        continue;
      }
      const double* x = points->GetTuple3(p);
      notFinite += std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]) ? 0 : 1;
    }
    EXPECT_EQ(outside, 0);
    EXPECT_EQ(notFinite, 0);
    vtkDataSetAttributes* from[2] = { input->GetPointData(), input->GetCellData() };
    vtkFieldData* to[2] = { result->GetPointData(), result->GetCellData() };
    for (int i = 0; i < 2; ++i)
    {
      for (int a = 0; a < from[i]->GetNumberOfArrays(); ++a)
      {
        const bool areNormals = from[i]->GetAbstractArray(a) == from[i]->GetNormals();
        EXPECT_TRUE(areNormals || to[i]->HasArray(from[i]->GetArrayName(a)))
          << from[i]->GetArrayName(a);
      }
    }
    for (int a = 0; a < input->GetFieldData()->GetNumberOfArrays(); ++a)
    {
      EXPECT_TRUE(result->GetFieldData()->HasArray(input->GetFieldData()->GetArrayName(a)));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shared, SubdivisionOfFile,
  testing::Values( //
    File{ "hostile_degenerate_cells.vtu", 3, 3 }, File{ "hostile_duplicate_points.vtu", 1, 2 },
    File{ "hostile_empty.vtu", 0, 2 }, File{ "hostile_inverted_cells.vtu", 1, 2 },
    File{ "hostile_nan_inf_coords.vtu", 1, 2 }, File{ "hostile_out_of_range_ids.vtu", 1, 2 },
    File{ "hostile_quadratic_among_linear.vtu", 1, 3 },
    File{ "hostile_unsupported_types.vtu", 1, 3 }, File{ "hostile_unused_points.vtu", 0, 2 },
    File{ "hex_geos_box_hybrid.vtu", 0, 1 }, File{ "hex_gmsh_quadtri_torus_4types.vtu", 0, 1 },
    File{ "hex_mfem_tinyzoo.vtu", 0, 2 }, File{ "line_navis_neuron.vtu", 0, 2 },
    File{ "mix_elmer_shell_on_solid.vtu", 0, 1 }, File{ "mix_elmer_wire_pair.vtu", 0, 1 },
    File{ "mix_geos_cube.vtu", 0, 2 }, File{ "mix_nastran_isat.vtu", 2, 1 },
    File{ "mix_ogs5_fracture_network.vtu", 0, 1 }, File{ "mix_porepy_case2_4k.vtu", 0, 1 },
    File{ "nat_bunny_verts_dup_points.vtp", 1, 1 }, File{ "nat_fea_quadratic_tets.vtu", 1, 1 },
    File{ "nat_geos_all_types.vtu", 0, 1 }, File{ "nat_ogs_sphere_zero_volume.vtu", 0, 1 },
    File{ "nm_hourglass_bowtie.vtp", 0, 2 }, File{ "nm_nastran_wingbox.vtu", 0, 1 },
    File{ "nm_ogs5_fracture_surfaces.vtu", 0, 1 }, File{ "nm_triple_vierbein.vtp", 0, 2 },
    File{ "poly_cow_mixed.vtp", 0, 1 }, File{ "poly_dodecahedron.vtp", 0, 2 },
    File{ "surf_bunny_3k.vtp", 0, 1 }, File{ "surf_bunny_full.vtp", 0, 1 },
    File{ "surf_moebius_quads.vtp", 0, 1 }, File{ "tet_geos_synthetic.vtu", 0, 1 },
    File{ "tet_gmsh_coil_crack.vtu", 0, 1 }, File{ "large_porepy_case3_500k.vtu", 0, 1 }),
  [](const auto& param)
  {
    const std::string name = param.param.Name;
    return name.substr(0, name.find('.'));
  });
