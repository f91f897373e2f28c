// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePlaceTools.h"

#include "vtkCell.h"

namespace surfacetools
{
namespace
{

using Parameters = std::array<double, 3>;

Parameters GetMiddle(const std::vector<Parameters>& corners)
{
  Parameters middle{};
  for (const Parameters& corner : corners)
  {
    for (int c = 0; c < 3; ++c)
    {
      middle[c] += corner[c] / static_cast<double>(corners.size());
    }
  }
  return middle;
}

/// The corners of the children of a part, one after the other, in the order of the schemes.
std::vector<std::vector<Parameters>> SplitPart(const std::vector<Parameters>& x)
{
  const std::size_t n = x.size();
  const auto middle = [&](std::size_t i) { return GetMiddle({ x[i], x[(i + 1) % n] }); };
  if (n == 2)
  {
    return { { x[0], middle(0) }, { middle(0), x[1] } };
  }
  if (n == 3)
  {
    return { { x[0], middle(0), middle(2) }, { middle(0), x[1], middle(1) },
      { middle(2), middle(1), x[2] }, { middle(0), middle(1), middle(2) } };
  }
  std::vector<std::vector<Parameters>> children;
  for (std::size_t k = 0; k < 4; ++k)
  {
    children.push_back({ x[k], middle(k), GetMiddle(x), middle((k + 3) % 4) });
  }
  return children;
}

/// Calls use(cell, parameters, point) for each corner of each cell that `levels` steps make.
void ForFineCorners(vtkPolyData* input, vtkPolyData* fine, int levels, bool triangles,
  const std::function<void(vtkIdType, const Parameters&, vtkIdType)>& use)
{
  vtkIdType made = 0;
  vtkNew<vtkIdList> points;
  const std::function<void(vtkIdType, const std::vector<Parameters>&, int)> descend =
    [&](vtkIdType cell, const std::vector<Parameters>& corners, int left)
  {
    if (left == 0)
    {
      fine->GetCellPoints(made++, points);
      ASSERT_EQ(points->GetNumberOfIds(), static_cast<vtkIdType>(corners.size()));
      for (std::size_t k = 0; k < corners.size(); ++k)
      {
        use(cell, corners[k], points->GetId(static_cast<vtkIdType>(k)));
      }
      return;
    }
    for (const auto& child : SplitPart(corners))
    {
      descend(cell, child, left - 1);
    }
  };
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    const auto size = static_cast<int>(input->GetCell(cell)->GetNumberOfPoints());
    if (size == 1)
    {
      descend(cell, { { 0., 0., 0. } }, 0);
    }
    else if (size == 2)
    {
      descend(cell, { { 0., 0., 0. }, { 1., 0., 0. } }, levels);
    }
    else if (triangles)
    {
      descend(cell, { { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. } }, levels);
    }
    else
    {
      const bool isQuad = size == 4;
      for (int k = 0; k < (isQuad ? 1 : size); ++k)
      {
        const double w = k;
        descend(cell, { { 0., 0., w }, { 1., 0., w }, { 1., 1., w }, { 0., 1., w } },
          isQuad ? levels : levels - 1);
      }
    }
  }
  EXPECT_EQ(made, fine->GetNumberOfCells());
}

vtkSmartPointer<vtkDoubleArray> MakeValues(vtkIdType size)
{
  auto values = vtkSmartPointer<vtkDoubleArray>::New();
  values->SetName("Values");
  values->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < 2 * size; ++i)
  {
    values->InsertNextValue(std::sin(1.7 * static_cast<double>(i) + 0.3));
  }
  return values;
}

}

vtkSmartPointer<vtkPolyData> Evaluate(
  vtkPolyData* input, int scheme, const Places& places, const Configure& configure)
{
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  filter->SetScheme(scheme);
  if (configure)
  {
    configure(filter);
  }
  return Evaluate(filter.Get(), places);
}

Point GetPoint(vtkDataSet* mesh, vtkIdType i)
{
  Point p{};
  mesh->GetPoint(i, p.data());
  return p;
}

Point GetTuple(vtkPolyData* result, const char* name, vtkIdType i)
{
  Point p{};
  result->GetPointData()->GetArray(name)->GetTuple(i, p.data());
  return p;
}

void CheckAgainstLevels(vtkPolyData* input, int scheme, int levels, const Configure& configure)
{
  if (!input->GetPointData()->HasArray("Values"))
  {
    input->GetPointData()->AddArray(MakeValues(input->GetNumberOfPoints()));
  }
  const auto fine = RunFilter(input, scheme, levels, true, configure);
  Places places;
  std::vector<vtkIdType> expected;
  ForFineCorners(input, fine, levels, scheme == Filter::LOOP,
    [&](vtkIdType cell, const Parameters& p, vtkIdType point)
    {
      places.Add(cell, p);
      expected.push_back(point);
    });
  const auto result = Evaluate(input, scheme, places, configure);
  vtkDataArray* values = result->GetPointData()->GetArray("Values");
  vtkDataArray* fineValues = fine->GetPointData()->GetArray("Values");
  for (vtkIdType i = 0; i < places.GetSize(); ++i)
  {
    const vtkIdType point = expected[static_cast<std::size_t>(i)];
    const auto where = [&]
    {
      return testing::Message() << "cell " << places.Cells->GetValue(i) << " at "
                                << places.Parameters->GetComponent(i, 0) << " "
                                << places.Parameters->GetComponent(i, 1) << " "
                                << places.Parameters->GetComponent(i, 2);
    };
    ASSERT_LT(GetDistance(GetPoint(result, i), GetPoint(fine, point)), 1e-12 * input->GetLength())
      << where();
    for (int c = 0; c < 2; ++c)
    {
      ASSERT_NEAR(values->GetComponent(i, c), fineValues->GetComponent(point, c), 1e-12) << where();
    }
  }
}

Model MakeBumpySheet(int size, bool triangles, bool hasCreases)
{
  Model sheet = MakeSheet(size, size, triangles, { 1., 0., 0. }, { 0.1, 1., 0. });
  const std::vector<Point> noise = MakeRandomPoints(sheet.Points.size(), 4);
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      sheet.Points[i][c] += 0.3 * noise[i][c];
    }
  }
  sheet.Corners.clear();
  if (hasCreases)
  {
    const vtkIdType row = size + 1;
    sheet.Lines = { { row + 1, row + 2 }, { row + 2, row + 3 }, { row + 2, 2 * row + 2 },
      { row + 3, 2 * row + 3 } };
  }
  return sheet;
}

vtkSmartPointer<vtkPolyData> MakeSeamedSheet(bool triangles)
{
  Model model = MakeBumpySheet(4, triangles, false);
  std::map<vtkIdType, vtkIdType> copies;
  for (vtkIdType p = 10; p < 15; ++p)
  {
    copies[p] = static_cast<vtkIdType>(model.Points.size());
    model.Points.push_back(model.Points[static_cast<std::size_t>(p)]);
  }
  for (std::size_t f = model.Faces.size() / 2; f < model.Faces.size(); ++f)
  {
    for (vtkIdType& p : model.Faces[f])
    {
      p = copies.count(p) ? copies[p] : p;
    }
  }
  const auto size = static_cast<vtkIdType>(model.Points.size());
  for (int i = 0; i < 3; ++i)
  {
    model.Points.push_back({ 0.5 * i, 0.3 * i * i, 9. });
  }
  model.Lines = { { size, size + 1 }, { size + 1, size + 2 } };
  const auto seamed = MakeInput(model);
  vtkNew<vtkDoubleArray> texture;
  texture->SetName("Texture");
  texture->SetNumberOfComponents(2);
  for (vtkIdType p = 0; p < seamed->GetNumberOfPoints(); ++p)
  {
    texture->InsertNextTuple2(static_cast<double>(p % 5), static_cast<double>(p) / 5.);
  }
  seamed->GetPointData()->SetTCoords(texture);
  return seamed;
}

vtkSmartPointer<vtkPolyData> MakeCreasedInput(
  const Model& model, const char* name, const std::function<double(vtkIdType)>& getValue)
{
  const auto input = MakeInput(model);
  vtkNew<vtkDoubleArray> values;
  values->SetName(name);
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    values->InsertNextValue(
      cell < static_cast<vtkIdType>(model.Lines.size()) ? getValue(cell) : 0.);
  }
  input->GetCellData()->AddArray(values);
  return input;
}

Model MakeStar(int n, bool triangles)
{
  Model star;
  star.Points = { { 0., 0., 0.3 } };
  const auto add = [&](double radius, double turn, double height)
  {
    star.Points.push_back({ radius * std::cos(turn), radius * std::sin(turn), height });
    return static_cast<vtkIdType>(star.Points.size()) - 1;
  };
  const double step = 2. * std::acos(-1.) / n;
  std::vector<std::vector<vtkIdType>> rings(4);
  for (std::size_t ring = 1; ring < 4; ++ring)
  {
    const int size = triangles ? n : 2 * n; // of quads every other point has an edge to the middle
    for (int i = 0; i < size; ++i)
    {
      const double wave = 0.2 * std::sin(2.3 * i + static_cast<double>(ring));
      rings[ring].push_back(
        add(static_cast<double>(ring) + wave, (triangles ? 1. : 0.5) * i * step, wave));
    }
  }
  const auto size = rings[1].size();
  for (std::size_t i = 0; i < size; i += triangles ? 1 : 2)
  {
    triangles ? star.Faces.push_back({ 0, rings[1][i], rings[1][(i + 1) % size] })
              : star.Faces.push_back(
                  { 0, rings[1][i], rings[1][(i + 1) % size], rings[1][(i + 2) % size] });
  }
  for (std::size_t ring = 1; ring < 3; ++ring)
  {
    for (std::size_t i = 0; i < size; ++i)
    {
      const vtkIdType a = rings[ring][i];
      const vtkIdType b = rings[ring][(i + 1) % size];
      const vtkIdType c = rings[ring + 1][(i + 1) % size];
      const vtkIdType d = rings[ring + 1][i];
      if (triangles)
      {
        star.Faces.push_back({ a, d, c });
        star.Faces.push_back({ a, c, b });
      }
      else
      {
        star.Faces.push_back({ a, d, c, b });
      }
    }
  }
  return star;
}

}
