// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Models/ModelBuilder.h"

#include "Private/ArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace subdivision
{

namespace
{

double Rounded(double value)
{
  return std::round(value * 1e4) / 1e4 + 0.0; // + 0.0: no negative zero
}

/// The face without repeated ids, its smallest id first: a polygon that is cut as a fan.
ModelBuilder::Ids FanOf(const ModelBuilder::Ids& face)
{
  ModelBuilder::Ids fan;
  for (vtkIdType id : face)
  {
    if (std::find(fan.begin(), fan.end(), id) == fan.end())
    {
      fan.push_back(id);
    }
  }
  std::rotate(fan.begin(), std::min_element(fan.begin(), fan.end()), fan.end());
  return fan;
}

}

vtkIdType ModelBuilder::Point(const Vector& x)
{
  this->Points.push_back({ Rounded(x[0]), Rounded(x[1]), Rounded(x[2]) });
  this->Tensions.push_back(Rounded(this->Tension(x)));
  return static_cast<vtkIdType>(this->Points.size()) - 1;
}

ModelBuilder::Ids ModelBuilder::Ring(int n, double radius, double z, double phaseInDegrees)
{
  Ids ring(n);
  for (int parity = 0; parity < 2; ++parity)
  {
    for (int i = parity; i < n; i += 2)
    {
      const double angle = vtkMath::RadiansFromDegrees(360.0 * i / n + phaseInDegrees);
      ring[i] = this->Point(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  return ring;
}

void ModelBuilder::Add(const Ids& ids, Flag flag)
{
  Cell cell{ static_cast<int>(ids.size()), {}, this->Material, flag };
  std::copy(ids.begin(), ids.end(), cell.PointIds.begin());
  this->Cells.push_back(cell);
}

void ModelBuilder::Vertex(vtkIdType a, Flag flag)
{
  this->Add({ a }, flag);
}

void ModelBuilder::Line(vtkIdType a, vtkIdType b, Flag flag)
{
  this->Add({ a, b }, flag);
}

void ModelBuilder::Triangle(vtkIdType a, vtkIdType b, vtkIdType c, Flag flag)
{
  this->Add({ a, b, c }, flag);
}

void ModelBuilder::Tetrahedron(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
{
  Vector u, v, w;
  vtkMath::Subtract(this->Points[b].data(), this->Points[a].data(), u.data());
  vtkMath::Subtract(this->Points[c].data(), this->Points[a].data(), v.data());
  vtkMath::Subtract(this->Points[d].data(), this->Points[a].data(), w.data());
  const bool positive = vtkMath::Determinant3x3(u.data(), v.data(), w.data()) > 0.0;
  this->Add(positive ? Ids{ a, b, c, d } : Ids{ a, c, b, d }, SMOOTH);
}

void ModelBuilder::Polyline(const Ids& ids, Flag flag, bool closed)
{
  for (std::size_t i = 0; i + 1 < ids.size() + closed; ++i)
  {
    this->Line(ids[i], ids[(i + 1) % ids.size()], flag);
  }
}

double ModelBuilder::SquaredLength(vtkIdType a, vtkIdType b) const
{
  return vtkMath::Distance2BetweenPoints(this->Points[a].data(), this->Points[b].data());
}

void ModelBuilder::Quad(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
{
  const double ac = this->SquaredLength(a, c);
  const double bd = this->SquaredLength(b, d);
  const bool tie = std::abs(ac - bd) < 1e-3 * (ac + bd);
  if (tie ? std::min(a, c) < std::min(b, d) : ac < bd)
  {
    this->Triangle(a, b, c);
    this->Triangle(a, c, d);
  }
  else
  {
    this->Triangle(a, b, d);
    this->Triangle(b, c, d);
  }
}

void ModelBuilder::SolidFace(const Ids& face, Flag flag)
{
  const Ids fan = FanOf(face);
  for (std::size_t i = 1; i + 1 < fan.size(); ++i)
  {
    this->Triangle(fan[0], fan[i], fan[i + 1], flag);
  }
}

void ModelBuilder::Strip(const Ids& row, const Ids& next, bool closed)
{
  const std::size_t n = row.size();
  for (std::size_t i = 0; i + 1 < n + closed; ++i)
  {
    const std::size_t j = (i + 1) % n;
    this->Quad(row[i], row[j], next[j], next[i]);
  }
}

void ModelBuilder::Fan(vtkIdType centre, const Ids& row, bool closed)
{
  const std::size_t n = row.size();
  for (std::size_t i = 0; i + 1 < n + closed; ++i)
  {
    this->Triangle(centre, row[i], row[(i + 1) % n]);
  }
}

void ModelBuilder::Hexahedron(const Ids& bottom, const Ids& top)
{
  std::vector<Ids> faces{ bottom, top };
  for (int i = 0, j = 1; i < 4; ++i, j = (j + 1) % 4)
  {
    faces.push_back({ bottom[i], bottom[j], top[j], top[i] });
  }
  const vtkIdType apex = std::min(
    *std::min_element(bottom.begin(), bottom.end()), *std::min_element(top.begin(), top.end()));
  for (const Ids& face : faces)
  {
    const Ids fan = FanOf(face);
    for (std::size_t i = 1; fan[0] != apex && i + 1 < fan.size(); ++i)
    {
      this->Tetrahedron(apex, fan[0], fan[i], fan[i + 1]);
    }
  }
}

void ModelBuilder::Mirror(int axis)
{
  Ids image(this->Points.size());
  for (std::size_t id = 0; id < image.size(); ++id)
  {
    image[id] = static_cast<vtkIdType>(id);
    if (this->Points[id][axis] != 0.0)
    {
      Vector x = this->Points[id];
      x[axis] = -x[axis];
      image[id] = static_cast<vtkIdType>(this->Points.size());
      this->Points.push_back(x);
      this->Tensions.push_back(this->Tensions[id]);
    }
  }
  const std::size_t numberOfCells = this->Cells.size();
  for (std::size_t i = 0; i < numberOfCells; ++i)
  {
    Cell cell = this->Cells[i];
    std::transform(cell.PointIds.begin(), cell.PointIds.begin() + cell.Size, cell.PointIds.begin(),
      [&image](vtkIdType id) { return image[id]; });
    if (cell.PointIds != this->Cells[i].PointIds)
    {
      if (cell.Size > 2) // a mirror image turns inside out: turn it back
      {
        std::swap(cell.PointIds[1], cell.PointIds[2]);
      }
      this->Cells.push_back(cell);
    }
  }
}

std::map<ModelBuilder::Edge, std::vector<std::size_t>> ModelBuilder::FindInnerEdges() const
{
  std::map<Edge, std::vector<std::size_t>> triangles;
  std::set<Edge> ofTetrahedra;
  for (std::size_t c = 0; c < this->Cells.size(); ++c)
  {
    const Cell& cell = this->Cells[c];
    for (int i = 0; cell.Size > 2 && i < cell.Size; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        const Edge edge = std::minmax(cell.PointIds[i], cell.PointIds[j]);
        if (cell.Size == 3)
        {
          triangles[edge].push_back(c);
        }
        else
        {
          ofTetrahedra.insert(edge);
        }
      }
    }
  }
  for (auto entry = triangles.begin(); entry != triangles.end();)
  {
    const bool isInner = entry->second.size() == 2 && ofTetrahedra.count(entry->first) == 0;
    entry = isInner ? std::next(entry) : triangles.erase(entry);
  }
  return triangles;
}

bool ModelBuilder::RunsAlong(const Cell& triangle, const Edge& edge)
{
  const auto& ids = triangle.PointIds;
  const auto first = std::find(ids.begin(), ids.begin() + 3, edge.first) - ids.begin();
  return ids[(first + 1) % 3] == edge.second;
}

void ModelBuilder::OrientTriangles()
{
  const auto inner = this->FindInnerEdges();
  std::vector<bool> isDone(this->Cells.size(), false);
  std::vector<std::size_t> reached;
  for (std::size_t first = 0; first < this->Cells.size(); ++first)
  {
    if (this->Cells[first].Size == 3 && !isDone[first])
    {
      reached.push_back(first);
      isDone[first] = true;
    }
    while (!reached.empty())
    {
      const std::size_t triangle = reached.back();
      reached.pop_back();
      const auto ids = this->Cells[triangle].PointIds;
      for (int i = 0; i < 3; ++i)
      {
        const auto edge = inner.find(std::minmax(ids[i], ids[(i + 1) % 3]));
        const std::size_t other =
          edge == inner.end() ? triangle : edge->second[edge->second[0] == triangle ? 1 : 0];
        if (isDone[other])
        {
          continue;
        }
        isDone[other] = true;
        reached.push_back(other);
        Cell& turned = this->Cells[other];
        if (RunsAlong(turned, edge->first) == RunsAlong(this->Cells[triangle], edge->first))
        {
          std::swap(turned.PointIds[1], turned.PointIds[2]);
        }
      }
    }
  }
}

void ModelBuilder::Write(vtkUnstructuredGrid* output, int dataTypeOfPoints) const
{
  vtkNew<vtkPoints> points;
  points->SetDataType(dataTypeOfPoints);
  points->SetNumberOfPoints(static_cast<vtkIdType>(this->Points.size()));
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), this->Points[i].data());
  }
  constexpr unsigned char typeOfSize[] = { VTK_EMPTY_CELL, VTK_VERTEX, VTK_LINE, VTK_TRIANGLE,
    VTK_TETRA };
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkCellArray> cells;
  for (const Cell& cell : this->Cells)
  {
    types->InsertNextValue(typeOfSize[cell.Size]);
    cells->InsertNextCell(cell.Size, cell.PointIds.data());
  }
  output->SetPoints(points);
  output->SetCells(types, cells);
  this->WriteAttributes(output);
}

void ModelBuilder::WriteAttributes(vtkUnstructuredGrid* output) const
{
  vtkNew<vtkDoubleArray> tension;
  tension->SetName("Tension");
  for (double value : this->Tensions)
  {
    tension->InsertNextValue(value);
  }
  output->GetPointData()->SetScalars(tension);

  vtkNew<vtkIntArray> material;
  vtkNew<vtkIntArray> singular;
  material->SetName("MaterialId");
  singular->SetName(SingularName);
  for (const Cell& cell : this->Cells)
  {
    material->InsertNextValue(cell.Material);
    singular->InsertNextValue(cell.Singular);
  }
  output->GetCellData()->AddArray(material);
  output->GetCellData()->AddArray(singular);
}

}
