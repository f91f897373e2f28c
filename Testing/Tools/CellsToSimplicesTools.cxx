// SPDX-License-Identifier: BSD-3-Clause
#include "CellsToSimplicesTools.h"

namespace cells_to_simplices_tools
{

vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(const Mesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p : mesh.Points)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkCellArray> cells;
  for (const Cell& cell : mesh.Cells)
  {
    types->InsertNextValue(static_cast<unsigned char>(cell.Type));
    cells->InsertNextCell(static_cast<vtkIdType>(cell.Points.size()), cell.Points.data());
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(types, cells);
  return grid;
}

std::vector<Ids> GetSimplices(const SimplicesOfCells& result)
{
  std::vector<Ids> simplices;
  auto at = result.Simplices.Connectivity.begin();
  for (const unsigned char dimension : result.Simplices.Dimensions)
  {
    simplices.emplace_back(at, at + dimension + 1);
    at += dimension + 1;
  }
  EXPECT_TRUE(at == result.Simplices.Connectivity.end());
  return simplices;
}

std::vector<Point> AddCentres(std::vector<Point> points, const SimplicesOfCells& result)
{
  for (vtkIdType c = 0; c < result.GetNumberOfCentres(); ++c)
  {
    Point centre{};
    const double n = static_cast<double>(result.CentreOffsets[c + 1] - result.CentreOffsets[c]);
    for (vtkIdType m = result.CentreOffsets[c]; m < result.CentreOffsets[c + 1]; ++m)
    {
      for (int i = 0; i < 3; ++i)
      {
        centre[i] += points[result.CentreMembers[m]][i] / n;
      }
    }
    points.push_back(centre);
  }
  return points;
}

double Volume(const std::vector<Point>& points, const Ids& tet)
{
  const Point& p = points[tet[0]];
  return Dot(Cross(Subtract(points[tet[1]], p), Subtract(points[tet[2]], p)),
           Subtract(points[tet[3]], p)) /
    6;
}

std::map<Face, int> CountFaces(const std::vector<Ids>& simplices)
{
  std::map<Face, int> count;
  for (const Ids& s : simplices)
  {
    for (size_t left = 0; s.size() == 4 && left < 4; ++left)
    {
      ++count[MakeFace(s[(left + 1) % 4], s[(left + 2) % 4], s[(left + 3) % 4])];
    }
  }
  return count;
}

std::set<Face> FacesUsed(const std::map<Face, int>& count, int times)
{
  std::set<Face> faces;
  for (const auto& [face, n] : count)
  {
    if (n == times)
    {
      faces.insert(face);
    }
  }
  return faces;
}

void ExpectSound(const SimplicesOfCells& result, vtkIdType numberOfCells)
{
  vtkIdType last = 0;
  for (const vtkIdType parent : result.ParentCells)
  {
    EXPECT_LE(last, parent);
    EXPECT_LT(parent, numberOfCells);
    last = parent;
  }
  if (!result.ParentCells.empty())
  {
    EXPECT_EQ(result.ParentCells.size(), result.Simplices.Dimensions.size());
  }
  const auto simplices = GetSimplices(result);
  for (const Ids& s : simplices)
  {
    EXPECT_EQ(std::set<vtkIdType>(s.begin(), s.end()).size(), s.size());
    EXPECT_GE(*std::min_element(s.begin(), s.end()), 0);
    EXPECT_LT(*std::max_element(s.begin(), s.end()), result.Simplices.NumberOfPoints);
  }
  EXPECT_EQ(result.CentreOffsets.back(), static_cast<vtkIdType>(result.CentreMembers.size()));
}

void ExpectFills(const SimplicesOfCells& result, const std::vector<Point>& points, double volume)
{
  const std::vector<Point> all = AddCentres(points, result);
  const auto simplices = GetSimplices(result);
  double sum = 0;
  for (const Ids& s : simplices)
  {
    if (s.size() == 4)
    {
      const double v = Volume(all, s);
      EXPECT_GT(v, 0);
      sum += v;
    }
  }
  EXPECT_NEAR(sum, volume, 1e-9 * volume);
  for (const auto& [face, n] : CountFaces(simplices))
  {
    EXPECT_LE(n, 2) << face[0] << " " << face[1] << " " << face[2];
  }
}

Ids Range(size_t size)
{
  Ids ids(size);
  for (size_t i = 0; i < size; ++i)
  {
    ids[i] = static_cast<vtkIdType>(i);
  }
  return ids;
}

Mesh Shuffled(int type, const std::vector<Point>& points, std::mt19937& random)
{
  Ids ids(points.size());
  for (size_t i = 0; i < ids.size(); ++i)
  {
    ids[i] = static_cast<vtkIdType>(i);
  }
  std::shuffle(ids.begin(), ids.end(), random);
  Mesh mesh;
  mesh.Points.resize(points.size());
  for (size_t i = 0; i < ids.size(); ++i)
  {
    mesh.Points[ids[i]] = points[i];
  }
  mesh.Cells.push_back({ type, ids });
  return mesh;
}

void ExpectOneWarning(
  const Mesh& mesh, const std::vector<std::string>& parts, const std::vector<Ids>& simplices)
{
  const auto result = Convert(mesh);
  ASSERT_EQ(result.Warnings.size(), 1u);
  for (const std::string& part : parts)
  {
    EXPECT_TRUE(Has(result.Warnings[0], part)) << result.Warnings[0] << "\nlacks: " << part;
  }
  EXPECT_EQ(GetSimplices(result), simplices);
  ExpectSound(result, static_cast<vtkIdType>(mesh.Cells.size()));
}

}
