// SPDX-License-Identifier: BSD-3-Clause
#include "RandomSurfaces.h"

namespace surfacetools
{

RandomSurface::RandomSurface(unsigned seed)
  : Random(seed)
{
  switch (seed % 4)
  {
    case 0:
      this->MakeSphere();
      break;
    case 1:
      this->MakeSheet(true);
      break;
    case 2:
      this->MakeSheet(false);
      break;
    default:
      this->MakeSphere();
      this->CutOff(static_cast<vtkIdType>(this->Pick(this->Surface.Points.size())));
  }
}

void RandomSurface::MakeSphere()
{
  Model& m = this->Surface;
  m.Points = { { 1., 1., 1. }, { 1., -1., -1. }, { -1., 1., -1. }, { -1., -1., 1. } };
  m.Faces = { { 0, 1, 2 }, { 0, 3, 1 }, { 0, 2, 3 }, { 1, 3, 2 } };
  for (std::size_t left = 6 + this->Pick(20); left > 0; --left)
  {
    const std::size_t face = this->Pick(m.Faces.size());
    const auto corners = m.Faces[face];
    const auto added = static_cast<vtkIdType>(m.Points.size());
    Point point{};
    for (const vtkIdType corner : corners)
    {
      const double weight = this->Choose(0.2, 1.);
      for (std::size_t c = 0; c < 3; ++c)
      {
        point[c] += weight * m.Points[static_cast<std::size_t>(corner)][c];
      }
    }
    m.Points.push_back(point);
    m.Faces[face] = { corners[0], corners[1], added };
    m.Faces.push_back({ corners[1], corners[2], added });
    m.Faces.push_back({ corners[2], corners[0], added });
    this->TurnEdges(6);
  }
  const double noise = this->Choose(0., 0.4);
  for (Point& point : m.Points)
  {
    const double length = std::hypot(point[0], point[1], point[2]);
    for (double& x : point)
    {
      x = x / length + this->Choose(-noise, noise);
    }
  }
}

void RandomSurface::MakeSheet(bool isClosed)
{
  const double turn = 2. * std::acos(-1.);
  const std::size_t width = 3 + this->Pick(4);
  const std::size_t height = 3 + this->Pick(4);
  const double noise = this->Choose(0., 0.35);
  const std::size_t columns = isClosed ? width : width + 1;
  const std::size_t rows = isClosed ? height : height + 1;
  for (std::size_t i = 0; i < columns * rows; ++i)
  {
    const double x = static_cast<double>(i % columns);
    const double y = static_cast<double>(i / columns);
    const double u = turn * x / static_cast<double>(width);
    const double v = turn * y / static_cast<double>(height);
    const double radius = 2.5 + std::cos(v);
    Point point = { radius * std::cos(u), radius * std::sin(u), std::sin(v) };
    point = isClosed ? point : Point{ x, y, this->Choose(-1., 1.) };
    for (double& coordinate : point)
    {
      coordinate += this->Choose(-noise, noise);
    }
    this->Surface.Points.push_back(point);
  }
  for (std::size_t i = 0; i < width * height; ++i)
  {
    const std::size_t x = i % width;
    const std::size_t y = i / width;
    auto at = [&](std::size_t column, std::size_t row)
    { return static_cast<vtkIdType>((row % rows) * columns + column % columns); };
    this->Surface.Faces.push_back({ at(x, y), at(x + 1, y), at(x + 1, y + 1) });
    this->Surface.Faces.push_back({ at(x, y), at(x + 1, y + 1), at(x, y + 1) });
  }
  this->TurnEdges(2 * width * height);
}

void RandomSurface::TurnEdges(std::size_t trials)
{
  auto& faces = this->Surface.Faces;
  for (; trials > 0; --trials)
  {
    const std::size_t at = this->Pick(faces.size());
    const std::size_t side = this->Pick(3);
    auto& face = faces[at];
    const vtkIdType a = face[side];
    const vtkIdType b = face[(side + 1) % 3];
    const vtkIdType c = face[(side + 2) % 3];
    const auto other = std::find_if(faces.begin(), faces.end(),
      [&](const auto& f) { return &f != &face && Has(f, a) && Has(f, b); });
    if (other == faces.end() || this->CountFaces(a, a) <= 3 || this->CountFaces(b, b) <= 3)
    {
      continue;
    }
    const vtkIdType d = (*other)[0] + (*other)[1] + (*other)[2] - a - b;
    if (c != d && this->CountFaces(c, d) == 0)
    {
      face = { a, d, c };
      *other = { d, b, c };
    }
  }
}

void RandomSurface::CutOff(vtkIdType vertex)
{
  auto& faces = this->Surface.Faces;
  faces.erase(std::remove_if(faces.begin(), faces.end(),
                [vertex](const auto& face) { return Has(face, vertex); }),
    faces.end());
  std::map<vtkIdType, vtkIdType> numbers;
  std::vector<Point> points;
  for (auto& face : faces)
  {
    for (vtkIdType& corner : face)
    {
      const auto found = numbers.emplace(corner, static_cast<vtkIdType>(points.size()));
      if (found.second)
      {
        points.push_back(this->Surface.Points[static_cast<std::size_t>(corner)]);
      }
      corner = found.first->second;
    }
  }
  this->Surface.Points = points;
}

}
