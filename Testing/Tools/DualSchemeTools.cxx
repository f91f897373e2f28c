// SPDX-License-Identifier: BSD-3-Clause
#include "DualSchemeTools.h"

namespace dualtools
{

Faces MakeQuads(int columns, int rows)
{
  return surfacetools::MakeSheet(columns, rows, false, {}, {}).Faces;
}

static Faces MakeTorus(int n)
{
  Faces faces;
  auto id = [n](int x, int y) -> vtkIdType { return (y % n) * n + x % n; };
  for (int y = 0; y < n; ++y)
  {
    for (int x = 0; x < n; ++x)
    {
      faces.push_back({ id(x, y), id(x + 1, y), id(x + 1, y + 1), id(x, y + 1) });
    }
  }
  return faces;
}

Faces MakeMoebius(int n)
{
  Faces faces;
  for (int i = 0; i + 1 < n; ++i)
  {
    faces.push_back({ 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1 });
  }
  faces.push_back({ 2 * n - 2, 1, 0, 2 * n - 1 });
  return faces;
}

std::vector<Shape> MakeShapes()
{
  const Faces cube = { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 },
    { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };
  const Faces tetrahedron = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  Faces flipped = MakeQuads(3, 3);
  for (std::size_t f = 0; f < flipped.size(); f += 2)
  {
    std::reverse(flipped[f].begin(), flipped[f].end());
  }
  return { { "triangle", 3, { { 0, 1, 2 } }, 1, true }, { "cube", 8, cube, 2, true },
    { "tetrahedron", 4, tetrahedron, 2, true },
    { "mixed", 7, { { 0, 1, 2, 3, 4 }, { 1, 0, 5 }, { 2, 1, 5, 6 } }, 1, true },
    { "grid", 20, MakeQuads(4, 3), 1, true }, { "torus", 16, MakeTorus(4), 0, true },
    { "Moebius strip", 10, MakeMoebius(5), 0, false }, { "flipped", 16, flipped, 1, false },
    { "pillow", 3, { { 0, 1, 2 }, { 0, 2, 1 } }, 2, true },
    { "three sheets", 5, { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }, 3, true },
    { "pinched", 5, { { 0, 1, 2 }, { 0, 3, 4 } }, 2, true },
    { "hub", 9, surfacetools::MakeFan(8, false).Faces, 1, true },
    { "valence 2", 4, { { 0, 1, 2 }, { 0, 2, 3 } }, 1, true },
    { "closed valence 2", 5, { { 0, 1, 3, 2 }, { 0, 2, 4, 1 } }, 1, true } };
}

Steps::Steps(Level&& control, subdivision::SurfaceSchemeKind kind, int steps, int firstStep)
{
  control.Step = firstStep;
  this->Values = std::make_unique<subdivision::SurfaceSteps<int>>(std::move(control),
    subdivision::MakeSurfaceScheme<int>(kind, true), steps, subdivision::LastLevel::Whole, nullptr);
}

subdivision::SparseRows<int> Steps::GetRows(int step) const
{
  return this->Values->GetStep(step).Store();
}

Points Steps::Apply(int step, const Points& in) const
{
  const auto operation = this->Values->GetStep(step);
  Points out(operation.GetNumberOfRows());
  operation.Apply(in.data()->data(), out.data()->data(), 3);
  return out;
}

Points Steps::ApplyLimit(subdivision::LimitKind kind, const Points& in) const
{
  Points out(in.size());
  this->Values->GetLimit(kind).Apply(in.data()->data(), out.data()->data(), 3);
  return out;
}

std::vector<subdivision::Carrier<int>> Steps::GetCarriers(int step) const
{
  const Level& level = (*this)[step];
  subdivision::Buffer<subdivision::Carrier<int>> carriers;
  this->Values->GetScheme().CarryFaces(
    level, subdivision::MakeCarriers<int>(level.Mesh.NumberOfFaces), true, carriers);
  return { carriers.begin(), carriers.end() };
}

int CountOpenSides(const Level& level)
{
  int open = 0;
  for (const int twin : level.Mesh.Twins)
  {
    open += twin < 0;
  }
  return open;
}

Point GetCentre(const Mesh& mesh, int face, const Points& points)
{
  Point centre{};
  for (int c = mesh.GetFirst(face); c < mesh.GetFirst(face) + mesh.GetSize(face); ++c)
  {
    for (int i = 0; i < 3; ++i)
    {
      centre[i] += points[mesh.Vertices[c]][i] / mesh.GetSize(face);
    }
  }
  return centre;
}

Data MakeData(const Points& points, const Faces& faces, const Faces& lines,
  const std::vector<vtkIdType>& vertices)
{
  const Data data = surfacetools::MakeInput(points, faces, lines);
  vtkNew<vtkCellArray> single;
  for (const vtkIdType vertex : vertices)
  {
    single->InsertNextCell({ vertex });
  }
  data->SetVerts(single);
  return data;
}

void AddIds(
  vtkDataSetAttributes* data, const char* name, const std::vector<vtkIdType>& values, bool global)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  for (const vtkIdType value : values)
  {
    array->InsertNextValue(value);
  }
  if (global)
  {
    data->SetGlobalIds(array);
  }
  else
  {
    data->AddArray(array);
  }
}

}
