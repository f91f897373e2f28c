// SPDX-License-Identifier: BSD-3-Clause
#include "HybridZoo.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <utility>

namespace hybridtest
{

namespace
{

int AddPoint(Mesh& mesh, double x, double y, double z)
{
  mesh.Points.push_back({ x, y, z });
  return static_cast<int>(mesh.Points.size()) - 1;
}

/// A box of unit cubes, each of which stays, or becomes two wedges or six pyramids.
class Box
{
public:
  explicit Box(unsigned int seed)
    : Random(seed)
  {
  }

  Mesh Make(bool withOctahedra);
  Mesh MakeFanOf();
  void Decorate();

private:
  int Below(int count)
  {
    return static_cast<int>(this->Random() % static_cast<unsigned int>(count));
  }
  bool Chance(int percent) { return this->Below(100) < percent; }
  void AddCube(const Ids& corners);
  void JoinPyramids(bool withOctahedra);
  void DropCells();
  void Attach(const Cell& face);
  void Mark();
  void Move();

  std::mt19937 Random;
  Mesh Made;
  std::vector<Cell> Pyramids;
};

void Box::AddCube(const Ids& c)
{
  Point middle = {};
  for (int corner : c)
  {
    for (int k = 0; k < 3; ++k)
    {
      middle[k] += this->Made.Points[corner][k] / 8.;
    }
  }
  const int centre = AddPoint(this->Made, middle[0], middle[1], middle[2]);
  const Cell hex = { Type::Hex, c };
  for (const Cell& quad : Sides(hex, 2))
  {
    Ids ids = quad.Corners;
    ids.push_back(centre);
    this->Pyramids.push_back({ Type::Pyramid, ids });
  }
}

/// Two pyramids with the same base stay, become four tetrahedra, or one octahedron.
void Box::JoinPyramids(bool withOctahedra)
{
  std::map<Ids, std::vector<Cell>> byBase;
  for (const Cell& pyramid : this->Pyramids)
  {
    byBase[Sorted(Ids(pyramid.Corners.begin(), pyramid.Corners.begin() + 4))].push_back(pyramid);
  }
  std::set<Ids> taken;
  for (const Cell& cell : this->Made.Cells)
  {
    for (const Cell& quad : Sides(cell, 2))
    {
      taken.insert(Sorted(quad.Corners));
    }
  }
  for (const auto& [base, pyramids] : byBase)
  {
    const int kind = taken.count(base) > 0 ? 2 : this->Below(3);
    const Ids& c = pyramids[0].Corners;
    if (kind == 0 && pyramids.size() == 2 && withOctahedra)
    {
      const int apex = pyramids[1].Corners[4];
      this->Made.Cells.push_back({ Type::Octahedron, { c[4], apex, c[0], c[2], c[1], c[3] } });
      continue;
    }
    for (const Cell& pyramid : pyramids)
    {
      const int apex = pyramid.Corners[4];
      if (kind == 2)
      {
        this->Made.Cells.push_back(pyramid);
        continue;
      }
      this->Made.Cells.push_back({ Type::Tet, { c[0], c[1], c[2], apex } });
      this->Made.Cells.push_back({ Type::Tet, { c[0], c[2], c[3], apex } });
    }
  }
}

Mesh Box::Make(bool withOctahedra)
{
  const int size[3] = { 1 + this->Below(3), 1 + this->Below(2), 1 + this->Below(3) };
  const auto name = [&size](int i, int j, int k)
  { return i + (size[0] + 1) * (j + (size[1] + 1) * k); };
  for (int k = 0; k <= size[2]; ++k)
  {
    for (int j = 0; j <= size[1]; ++j)
    {
      for (int i = 0; i <= size[0]; ++i)
      {
        AddPoint(this->Made, i, j, k);
      }
    }
  }
  for (int j = 0; j < size[1]; ++j)
  {
    for (int i = 0; i < size[0]; ++i)
    {
      const bool isColumnOfWedges = this->Chance(25);
      for (int k = 0; k < size[2]; ++k)
      {
        const Ids c = { name(i, j, k), name(i + 1, j, k), name(i + 1, j + 1, k), name(i, j + 1, k),
          name(i, j, k + 1), name(i + 1, j, k + 1), name(i + 1, j + 1, k + 1),
          name(i, j + 1, k + 1) };
        if (isColumnOfWedges)
        {
          this->Made.Cells.push_back({ Type::Wedge, { c[0], c[1], c[2], c[4], c[5], c[6] } });
          this->Made.Cells.push_back({ Type::Wedge, { c[0], c[2], c[3], c[4], c[6], c[7] } });
        }
        else if (this->Chance(50))
        {
          this->Made.Cells.push_back({ Type::Hex, c });
        }
        else
        {
          this->AddCube(c);
        }
      }
    }
  }
  this->JoinPyramids(withOctahedra);
  this->Decorate();
  return this->Made;
}

Mesh Box::MakeFanOf()
{
  std::vector<Type> sectors(3 + this->Below(4));
  const int kind = this->Below(3);
  for (Type& sector : sectors)
  {
    sector = kind == 0 || (kind == 1 && this->Chance(50)) ? Type::Hex : Type::Wedge;
  }
  this->Made = MakeFan(sectors, 1 + this->Below(3), this->Chance(80));
  this->Decorate();
  return this->Made;
}

/// Holes give edges and vertices at which the solids are no manifold.
void Box::DropCells()
{
  std::vector<Cell> kept;
  for (const Cell& cell : this->Made.Cells)
  {
    if (!this->Chance(20))
    {
      kept.push_back(cell);
    }
  }
  this->Made.Cells = kept.empty() ? this->Made.Cells : kept;
}

/// A sheet with its line at one edge of a face, a third cell at a face, or the face itself.
void Box::Attach(const Cell& face)
{
  Point place = this->Made.Points[face.Corners[0]];
  const auto add = [this, &place](double x, double y, double z)
  { return AddPoint(this->Made, place[0] + x, place[1] + y, place[2] + z); };
  const int kind = this->Below(5);
  if (kind == 0)
  {
    this->Made.Cells.push_back(face);
    this->Made.Cells.push_back({ Type::Line, { face.Corners[0], face.Corners[1] } });
  }
  else if (kind == 1)
  {
    const int first = add(.3, .2, 1.);
    const int second = add(1.2, .1, .9);
    this->Made.Cells.push_back({ Type::Quad, { face.Corners[0], face.Corners[1], second, first } });
    this->Made.Cells.push_back({ Type::Triangle, { first, second, add(.7, .2, 2.) }, 1 });
    this->Made.Cells.push_back({ Type::Line, { second, add(2., .3, 1.) } });
  }
  else if (kind == 2)
  {
    this->Made.Cells.push_back({ Type::Line, { face.Corners[1], add(.5, 1., 1.) } });
    this->Made.Cells.push_back({ Type::Vertex, { add(2., 2., 2.) } });
  }
  else
  {
    Ids ids = face.Corners;
    ids.push_back(add(.5, .5, .7));
    this->Made.Cells.push_back({ face.Shape == Type::Quad ? Type::Pyramid : Type::Tet, ids });
  }
}

void Box::Mark()
{
  const Complex complex(this->Made);
  const int percent[3] = { 2, 3, 3 };
  for (int d = 0; d < 3; ++d)
  {
    for (const auto& item : complex.GetSides(d))
    {
      if (this->Chance(percent[d]))
      {
        this->Made.Singular.insert(item.first);
      }
    }
  }
}

void Box::Move()
{
  for (Point& point : this->Made.Points)
  {
    for (double& x : point)
    {
      x += .15 * (this->Below(2001) / 1000. - 1.);
    }
  }
}

void Box::Decorate()
{
  if (this->Chance(30))
  {
    this->DropCells();
  }
  for (int count = this->Chance(50) ? this->Below(4) : 0; count > 0; --count)
  {
    const Complex complex(this->Made);
    const auto& faces = complex.GetSides(2);
    this->Attach(std::next(faces.begin(), this->Below(static_cast<int>(faces.size())))->second);
  }
  if (this->Chance(30))
  {
    for (Cell& cell : this->Made.Cells)
    {
      cell.Material = this->Made.Points[cell.Corners[0]][0] > .5 ? 1 : cell.Material;
    }
  }
  if (this->Chance(50))
  {
    this->Mark();
  }
  this->Made.Joint = this->Chance(30) ? Joints::Sharp : Joints::Blend;
  this->Made.HasDarts = this->Chance(50);
  this->Made.HasLoopWeights = this->Chance(30);
  this->Move();
}

}

Mesh MakeCube()
{
  Mesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 1, 1, 1 }, { 0, 1, 1 } };
  mesh.Cells.push_back({ Type::Hex, { 0, 1, 2, 3, 4, 5, 6, 7 } });
  return mesh;
}

Mesh MakeSixPyramids()
{
  Mesh mesh = MakeCube();
  const std::vector<Cell> quads = Sides(mesh.Cells[0], 2);
  mesh.Cells.clear();
  for (Point& point : mesh.Points)
  {
    for (double& x : point)
    {
      x = 2. * x - 1.;
    }
  }
  const int middle = AddPoint(mesh, 0., 0., 0.);
  for (const Cell& quad : quads)
  {
    Ids corners = quad.Corners;
    corners.push_back(middle);
    mesh.Cells.push_back({ Type::Pyramid, corners });
  }
  return mesh;
}

Mesh MakeFan(const std::vector<Type>& sectors, int layers, bool isClosed)
{
  Mesh mesh;
  for (int k = 0; k <= layers; ++k)
  {
    AddPoint(mesh, 0., 0., k);
  }
  const int count = static_cast<int>(sectors.size());
  const int spokes = count + !isClosed;
  const double turn = 2. * std::acos(-1.) / spokes;
  const auto addColumn = [&mesh, layers](double radius, double angle)
  {
    Ids column;
    for (int k = 0; k <= layers; ++k)
    {
      column.push_back(AddPoint(mesh, radius * std::cos(angle), radius * std::sin(angle), k));
    }
    return column;
  };
  std::vector<Ids> spoke;
  for (int i = 0; i < spokes; ++i)
  {
    spoke.push_back(addColumn(1., turn * i));
  }
  for (int i = 0; i < count; ++i)
  {
    const Ids& first = spoke[i];
    const Ids& second = spoke[(i + 1) % spokes];
    const Ids far = sectors[i] == Type::Hex ? addColumn(1.4, turn * (i + .5)) : Ids();
    for (int k = 0; k < layers; ++k)
    {
      if (sectors[i] == Type::Hex)
      {
        mesh.Cells.push_back({ Type::Hex,
          { k, first[k], far[k], second[k], k + 1, first[k + 1], far[k + 1], second[k + 1] } });
      }
      else
      {
        mesh.Cells.push_back(
          { Type::Wedge, { k, first[k], second[k], k + 1, first[k + 1], second[k + 1] } });
      }
    }
  }
  return mesh;
}

Mesh MakeRandomHybrid(unsigned int seed, bool withOctahedra)
{
  Box box(seed);
  return seed % 4 == 3 ? box.MakeFanOf() : box.Make(withOctahedra);
}

}
