// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceSemiSharp.cxx
 * A crease of sharpness s is a crease like any other for floor(s) steps; an infinite one for ever.
 */
#include "SurfaceTools.h"

using namespace surfacetools;

namespace
{

/// A bumpy grid with a hole, creases that cross, end, and make concave corners with its border.
Model MakeCreased(bool triangles, unsigned seed)
{
  Model grid = MakeSheet(5, 5, triangles, { 1., 0., 0. }, { 0.2, 1., 0. });
  const std::vector<Point> noise = MakeRandomPoints(grid.Points.size(), seed);
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      grid.Points[i][c] += 0.4 * noise[i][c];
    }
  }
  grid.Corners.clear();
  const std::size_t first = triangles ? 16 : 8;
  grid.Faces.erase(grid.Faces.begin() + first, grid.Faces.begin() + first + (triangles ? 2 : 1));
  std::mt19937 random(seed);
  std::set<std::set<vtkIdType>> taken;
  for (int i = 0; i < 7; ++i)
  {
    const auto& face = grid.Faces[random() % grid.Faces.size()];
    const std::size_t k = random() % face.size();
    const std::vector<vtkIdType> line = { face[k], face[(k + 1) % face.size()] };
    if (taken.insert({ line[0], line[1] }).second)
    {
      grid.Lines.push_back(line);
    }
  }
  return grid;
}

/// Creases by flags, or by a sharpness.
vtkSmartPointer<vtkPolyData> Crease(
  const Model& model, int scheme, int levels, double sharpness, bool limit = false)
{
  const auto input = MakeInput(model);
  const bool flagged = sharpness < 0.;
  const vtkIdType lines = static_cast<vtkIdType>(model.Lines.size());
  vtkNew<vtkDoubleArray> values;
  values->SetName("Sharpness");
  vtkNew<vtkIntArray> flags;
  flags->SetName("Singular");
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    values->InsertNextValue(cell < lines && !flagged ? sharpness : 0.);
    flags->InsertNextValue(cell < lines && flagged);
  }
  input->GetCellData()->AddArray(values);
  input->GetCellData()->AddArray(flags);
  return RunFilter(input, scheme, levels, limit,
    [](vtkSurfaceSubdivision* filter)
    {
      filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
    });
}

double GetDifference(vtkPolyData* a, vtkPolyData* b, vtkIdType points)
{
  double largest = 0.;
  for (vtkIdType i = 0; i < points; ++i)
  {
    Point x;
    Point y;
    a->GetPoint(i, x.data());
    b->GetPoint(i, y.data());
    largest = std::max(largest, GetDistance(x, y));
  }
  return largest;
}

constexpr int Schemes[] = { vtkSurfaceSubdivision::LOOP, vtkSurfaceSubdivision::CATMULL_CLARK,
  vtkSurfaceSubdivision::MODIFIED_BUTTERFLY };

}

TEST(SurfaceSemiSharp, AreCreasesForAsManySteps)
{
  for (const int scheme : Schemes)
  {
    for (unsigned seed = 0; seed < 20; ++seed)
    {
      const Model model = MakeCreased(scheme != vtkSurfaceSubdivision::CATMULL_CLARK, seed);
      const auto crease = [&](double sharpness, bool limit)
      {
        const auto output = Crease(model, scheme, 2, sharpness, limit);
        output->GetCellData()->Initialize(); // the arrays that ask for creases are others
        return output;
      };
      const auto flagged = crease(-1., false);
      for (const double sharpness : { 2., 2.5, 10., std::numeric_limits<double>::infinity() })
      {
        ExpectSameBits(crease(sharpness, false), flagged);
      }
      ExpectSameBits(crease(std::numeric_limits<double>::infinity(), true), crease(-1., true));
      EXPECT_GT(
        GetDifference(Crease(model, scheme, 2, 1.5), flagged, flagged->GetNumberOfPoints()), 1e-6);
    }
  }
}

TEST(SurfaceSemiSharp, LimitsDoNotDependOnTheLevel)
{
  for (const int scheme : Schemes)
  {
    for (unsigned seed = 0; seed < 6; ++seed)
    {
      const Model model = MakeCreased(scheme != vtkSurfaceSubdivision::CATMULL_CLARK, seed);
      const vtkIdType points = static_cast<vtkIdType>(model.Points.size());
      for (const double sharpness : { 0.4, 1., 2.7 })
      {
        const auto first = Crease(model, scheme, 0, sharpness, true);
        for (int levels = 1; levels < 4; ++levels)
        {
          const auto later = Crease(model, scheme, levels, sharpness, true);
          EXPECT_LT(GetDifference(first, later, points), 1e-12)
            << "scheme " << scheme << " seed " << seed << " sharpness " << sharpness;
          for (vtkIdType i = 0; i < points; ++i)
          {
            Point a;
            Point b;
            first->GetPointData()->GetArray("LimitNormals")->GetTuple(i, a.data());
            later->GetPointData()->GetArray("LimitNormals")->GetTuple(i, b.data());
            EXPECT_LT(GetDistance(a, b), 1e-7) << "scheme " << scheme << " seed " << seed
                                               << " sharpness " << sharpness << " at " << i;
          }
        }
      }
    }
  }
}
