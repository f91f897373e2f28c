// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenRefinementFiles.cxx
 * vtkRedGreenRefinement on files from elsewhere, where they are there: six filters in a row, marked
 * by chance, stay conforming and well shaped; hostile ones are survived by every criterion.
 */
#include "FileTools.h"
#include "RedGreenChecks.h"
#include "RedGreenRefinementTools.h"

#include "vtkSphere.h"

using namespace file_tools;
using namespace red_green_refinement_tools;

namespace
{

class RedGreenFilterOfFile : public testing::TestWithParam<const char*>
{
protected:
  void SetUp() override
  {
    const std::string path = GetSharedFile(GetParam());
    if (const std::string reason = WhyNotRead(path); !reason.empty())
    {
      GTEST_SKIP() << reason;
    }
    this->Mesh = ReadFile(path);
  }

  vtkSmartPointer<vtkPointSet> Mesh;
};

using RedGreenFilterOfHostileFile = RedGreenFilterOfFile;

/// The simplices of a mesh, tetrahedra in their final order, and nothing else.
Grid GetSimplices(vtkPointSet* mesh)
{
  vtkNew<Messages> messages;
  Options options;
  options.Levels = 0;
  options.Precision = vtkAlgorithm::DOUBLE_PRECISION; // volumes are compared to 1e-12
  const Grid simplices = Subdivide(mesh, options, messages);
  const Grid bare = Grid::New();
  bare->CopyStructure(simplices);
  return bare;
}

/// The first cell that is worse than its input cell and all that red-green refinement may make of
/// it.
std::string CheckShapes(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  auto getCorners = [](vtkUnstructuredGrid* grid, vtkIdType cell)
  {
    redgreen_reference::Corners corners;
    for (vtkIdType id : GetCell(grid, cell))
    {
      corners.push_back(GetPoint(grid, id));
    }
    return corners;
  };
  std::map<vtkIdType, std::pair<double, vtkIdType>> worst;
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    const std::pair<double, vtkIdType> own = { redgreen_reference::Quality(getCorners(output, i)),
      i };
    const auto known = worst.emplace(GetOrigin(output, i), own);
    known.first->second = std::min(known.first->second, own);
  }
  for (const auto& [origin, cell] : worst)
  {
    const auto corners = getCorners(input, origin);
    const double own = redgreen_reference::Quality(corners);
    // Red descendants of a tetrahedron have three shapes at most, all of them there after two
    // steps.
    if (own > 1e-5 && cell.first < own &&
      cell.first < (1. - 1e-9) * redgreen_reference::WorstGreenOfDescendants(corners, 2))
    {
      return "cell " + std::to_string(cell.second) + " of input cell " + std::to_string(origin);
    }
  }
  return "";
}

}

TEST_P(RedGreenFilterOfFile, SixRoundsStayConformingAndWellShaped)
{
  const Grid input = GetSimplices(this->Mesh);
  AddRandomNumbers(input);
  Grid current = input;
  for (unsigned round = 0; round < 6; ++round)
  {
    current =
      RefineByChance(current, round, std::max<vtkIdType>(8, current->GetNumberOfCells() / 40));
    if (round % 3 == 2)
    {
      ASSERT_EQ(CheckConformity(input, current), "") << "round " << round;
    }
  }
  EXPECT_GE(GetFinestLevel(current), 2);
  EXPECT_GT(current->GetNumberOfCells(), input->GetNumberOfCells());
  EXPECT_EQ(CheckShapes(input, current), "");
}

INSTANTIATE_TEST_SUITE_P(Shared, RedGreenFilterOfFile,
  testing::Values("hex_geos_box_hybrid.vtu", "hex_mfem_tinyzoo.vtu", "line_navis_neuron.vtu",
    "mix_elmer_shell_on_solid.vtu", "mix_elmer_wire_pair.vtu", "mix_geos_cube.vtu",
    "mix_nastran_isat.vtu", "mix_ogs5_fracture_network.vtu", "mix_porepy_case2_4k.vtu",
    "nat_bunny_verts_dup_points.vtp", "nat_geos_all_types.vtu", "nat_ogs_sphere_zero_volume.vtu",
    "nm_hourglass_bowtie.vtp", "nm_nastran_wingbox.vtu", "nm_ogs5_fracture_surfaces.vtu",
    "nm_triple_vierbein.vtp", "poly_cow_mixed.vtp", "poly_dodecahedron.vtp", "surf_bunny_3k.vtp",
    "surf_moebius_quads.vtp", "tet_gmsh_coil_crack.vtu", "hostile_degenerate_cells.vtu",
    "hostile_duplicate_points.vtu", "hostile_inverted_cells.vtu", "hostile_nan_inf_coords.vtu",
    "hostile_out_of_range_ids.vtu", "hostile_unsupported_types.vtu", "hostile_unused_points.vtu"),
  [](const auto& param)
  {
    const std::string name = param.param;
    return name.substr(0, name.find('.'));
  });

TEST_P(RedGreenFilterOfHostileFile, EveryCriterionSurvives)
{
  vtkPointSet* input = this->Mesh;
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(1.);
  input->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("V", 1, input->GetNumberOfPoints(), -1., 1., 3));
  for (int criterion = 0; criterion < 8; ++criterion)
  {
    for (int placement : { Filter::LINEAR, Filter::LIMIT })
    {
      vtkNew<Messages> messages;
      const Grid output = Refine(
        input,
        [&](Filter* filter)
        {
          filter->SetRefineByAttributeError(criterion < 2);
          filter->SetAttributeErrorKind(criterion);
          filter->SetAttributeTolerance(0.3);
          filter->SetInputArrayToProcess(5, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "V");
          filter->SetRefineByArrayRange(criterion == 2);
          filter->SetArrayRange(0., 0.2);
          filter->SetInputArrayToProcess(6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "V");
          filter->SetRefineByFunction(criterion == 3);
          filter->SetImplicitFunction(sphere);
          filter->SetRefineByEdgeLength(criterion == 4);
          filter->SetMaximumEdgeLength(0.3);
          filter->SetRefineByGeometricError(criterion > 4);
          filter->SetRelativeTolerance(criterion == 5);
          filter->SetGeometricTolerance(criterion == 7 ? 0. : 0.01);
          filter->SetPlacement(placement);
          filter->SetMaximumLevel(2);
          filter->SetMaximumNumberOfCells(60000);
        },
        messages);
      EXPECT_TRUE(messages->Errors.empty());
      EXPECT_GE(output->GetNumberOfPoints(), input->GetNumberOfPoints());
      vtkIdType bad = 0;
      for (const Ids& cell : GetCells(output))
      {
        for (vtkIdType id : cell)
        {
          const bool isThere = id >= 0 && id < output->GetNumberOfPoints();
          const Point p = isThere ? GetPoint(output, id) : Point();
          bad +=
            isThere && std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) ? 0 : 1;
        }
      }
      EXPECT_EQ(bad, 0) << criterion;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shared, RedGreenFilterOfHostileFile,
  testing::Values("hostile_degenerate_cells.vtu", "hostile_duplicate_points.vtu",
    "hostile_empty.vtu", "hostile_inverted_cells.vtu", "hostile_nan_inf_coords.vtu",
    "hostile_out_of_range_ids.vtu", "hostile_quadratic_among_linear.vtu",
    "hostile_unsupported_types.vtu", "hostile_unused_points.vtu", "nat_geos_all_types.vtu",
    "hex_mfem_tinyzoo.vtu"),
  [](const auto& param)
  {
    const std::string name = param.param;
    return name.substr(0, name.find('.'));
  });
