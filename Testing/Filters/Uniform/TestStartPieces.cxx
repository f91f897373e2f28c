// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestStartPieces.cxx
 * Solids of the tet/oct scheme that are cut as the box spline cuts them: the corners of each piece
 * are the limit at the places that its number says.
 */
#include "LimitProbeTools.h"

#include "Private/Places/SolidPieces.h"
#include "Private/Uniform/StartPieces.h"

#include "vtkSubdivisionModelSource.h"

using namespace limit_probe_tools;

namespace
{

Grid MakeLevels(vtkUnstructuredGrid* mesh, int levels, bool projects)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToTetOct();
  filter->SetNumberOfLevels(levels);
  filter->SetProjectToLimit(projects);
  return UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), mesh);
}

}

TEST(StartPieces, CornersAreTheLimitWhereTheirNumbersSay)
{
  const Grid mesh = MakeLevels(MakeModel(vtkSubdivisionModelSource::MATERIAL_BLOCK), 1, false);
  vtkDataArray* numbers = mesh->GetCellData()->GetArray("OctahedronId");
  subdivision::SimplexList simplices;
  simplices.NumberOfPoints = mesh->GetNumberOfPoints();
  subdivision::Buffer<vtkIdType> octahedra(mesh->GetNumberOfCells());
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    const Ids cell = GetCell(mesh, c);
    ASSERT_EQ(cell.size(), 4u);
    simplices.Dimensions.push_back(3);
    simplices.Connectivity.insert(simplices.Connectivity.end(), cell.begin(), cell.end());
    octahedra[c] = static_cast<vtkIdType>(numbers->GetComponent(c, 0));
  }
  for (const int steps : { 1, 2 })
  {
    const Grid fine = MakeLevels(mesh, steps, true);
    const Grid cut = subdivision::CutSolidsAnew(fine, simplices, octahedra, steps);
    ASSERT_EQ(cut->GetNumberOfCells(), fine->GetNumberOfCells());
    const vtkIdType parts = vtkIdType(1) << (3 * steps);
    place_tools::Places places;
    Ids corners;
    for (vtkIdType i = 0; i < cut->GetNumberOfCells(); i += steps == 1 ? 37 : 301)
    {
      for (int k = 0; k < 4; ++k)
      {
        std::array<double, 4> corner{};
        corner[k] = 1.;
        const auto at = subdivision::LeavePartOfSimplex(3, steps, i % parts, corner);
        places.Add(i / parts, { at[1], at[2], at[3] });
        corners.push_back(GetCell(cut, i)[k]);
      }
    }
    vtkNew<vtkMultiDimensionalSubdivision> evaluator;
    evaluator->SetVolumeSchemeToTetOct();
    evaluator->SetInputData(mesh);
    const auto limit = place_tools::Evaluate(evaluator, places);
    for (vtkIdType i = 0; i < places.GetSize(); ++i)
    {
      const Point p = GetPoint(limit, i);
      const Point q = GetPoint(fine, corners[static_cast<std::size_t>(i)]);
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_NEAR(p[c], q[c], 1e-11) << "steps " << steps << ", place " << i;
      }
    }
  }
}
