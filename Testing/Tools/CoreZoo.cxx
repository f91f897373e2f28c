// SPDX-License-Identifier: BSD-3-Clause
#include "CoreZoo.h"

#include <iterator>

namespace coretest
{

Mesh MakeSpread(const std::string& name, int points)
{
  Mesh mesh(name);
  std::mt19937 random(12345);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  for (int i = 0; i < points; ++i)
  {
    const double t = 0.7 * i;
    mesh.AddPoint(2. * std::cos(t) + jitter(random), 2. * std::sin(t) + jitter(random),
      0.3 * i * ((i % 3) - 1) + jitter(random));
  }
  return mesh;
}

Mesh MakeTet(const std::string& name)
{
  Mesh mesh(name);
  mesh.AddPoints({ { 0, 0, 0 }, { 1, 0.1, 0 }, { 0, 1, 0.2 }, { 0.1, 0, 1 } });
  mesh.AddCell({ 0, 1, 2, 3 });
  return mesh;
}

Mesh MakeFan(const std::string& name, int triangles, bool closed)
{
  Mesh mesh(name);
  mesh.AddPoint(0, 0, 0.5);
  const int rim = closed ? triangles : triangles + 1;
  for (int i = 0; i < rim; ++i)
  {
    const double t = 2. * 3.14159265358979 * i / (triangles + (closed ? 0. : 1.5));
    mesh.AddPoint(std::cos(t), std::sin(t), 0.1 * (i % 3));
  }
  for (int i = 0; i < triangles; ++i)
  {
    mesh.AddCell({ 0, 1 + i, 1 + (i + 1) % rim });
  }
  return mesh;
}

Mesh MakeOctahedronSurface()
{
  Mesh mesh("OctahedronSurface");
  mesh.AddPoints(
    { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } });
  mesh.AddCells({ { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 },
    { 3, 1, 5 }, { 0, 3, 5 } });
  return mesh;
}

Mesh MakeIcosahedron()
{
  Mesh mesh("Icosahedron");
  mesh.AddPoint(0, 0, 1.2);
  for (int i = 0; i < 10; ++i)
  {
    const double t = 3.14159265358979 * i / 5.;
    mesh.AddPoint(std::cos(t), std::sin(t), i % 2 ? -0.5 : 0.5);
  }
  mesh.AddPoint(0, 0, -1.2);
  for (int i = 0; i < 10; ++i)
  {
    const int a = 1 + i;
    const int b = 1 + (i + 1) % 10;
    const int c = 1 + (i + 2) % 10;
    mesh.AddCell(i % 2 ? Tuple{ b, a, c } : Tuple{ a, b, c });
    mesh.AddCell(i % 2 ? Tuple{ 11, c, a } : Tuple{ 0, a, c });
  }
  return mesh;
}

Mesh MakeOctahedron(const std::string& name, bool marked)
{
  Mesh mesh(name);
  mesh.AddPoints(
    { { 0, 0, 1 }, { 0, 0, -1 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0.1 } });
  for (int i = 0; i < 4; ++i)
  {
    const int a = 2 + i;
    const int b = 2 + (i + 1) % 4;
    mesh.AddCell(marked || i == 3 ? Tuple{ 0, a, 1, b } : Tuple{ 0, 1, a, b });
  }
  return mesh;
}

Mesh MakeValence4()
{
  Mesh mesh("Valence4");
  mesh.AddPoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.25, 0.2, 0.3 } });
  mesh.AddCells({ { 4, 1, 2, 3 }, { 0, 4, 2, 3 }, { 0, 1, 4, 3 }, { 0, 1, 2, 4 } });
  return mesh;
}

Lattice MakeLattice(const std::string& name, int n, double spacing, unsigned int seed)
{
  std::mt19937 random(seed);
  const int side = n + 1;
  std::vector<vtkIdType> numbers(side * side * side);
  std::iota(numbers.begin(), numbers.end(), 0);
  std::shuffle(numbers.begin(), numbers.end(), random);
  Lattice lattice;
  lattice.Control = Mesh(name);
  lattice.Positions.resize(numbers.size());
  std::vector<double> points(3 * numbers.size());
  auto number = [&](const int p[3]) { return numbers[p[0] + side * (p[1] + side * p[2])]; };
  for (int i = 0; i < side * side * side; ++i)
  {
    const int p[3] = { i % side, i / side % side, i / (side * side) };
    for (int c = 0; c < 3; ++c)
    {
      lattice.Positions[numbers[i]][c] = p[c];
      points[3 * numbers[i] + c] = spacing * p[c];
    }
  }
  lattice.Control.Points = points;
  lattice.Control.Cells.NumberOfPoints = static_cast<vtkIdType>(numbers.size());
  std::vector<Tuple> cells;
  for (int i = 0; i < n * n * n; ++i)
  {
    int axes[3] = { 0, 1, 2 };
    do
    {
      int p[3] = { i % n, i / n % n, i / (n * n) };
      Tuple cell = { number(p) };
      for (int axis : axes)
      {
        ++p[axis];
        cell.push_back(number(p));
      }
      std::shuffle(cell.begin(), cell.end(), random);
      cells.push_back(cell);
    } while (std::next_permutation(axes, axes + 3));
  }
  std::shuffle(cells.begin(), cells.end(), random);
  for (const Tuple& cell : cells)
  {
    lattice.Control.AddCell(cell);
  }
  OrderTets(lattice.Control.Cells, points.data(), nullptr, 0);
  return lattice;
}

Mesh MakeRandom(unsigned int seed)
{
  std::mt19937 random(seed);
  auto chance = [&random](double p) { return random() < p * 4294967296.; };
  auto number = [&random](vtkIdType n) { return static_cast<vtkIdType>(random() % n); };
  Mesh mesh = MakeLattice("Random" + std::to_string(seed), 2, 0.5, seed).Control;
  const std::vector<Tuple> tets = GetCells(mesh.Cells);
  mesh.Cells.Dimensions.clear();
  mesh.Cells.Connectivity.clear();
  const double densities[4] = { 0.15, 0.4, 0.8, 0.98 };
  const double density = densities[seed % 4];
  const double singular = seed % 3 == 0 ? 0.05 : 0.;
  auto take = [&](Tuple cell)
  {
    if (chance(0.5))
    {
      std::shuffle(cell.begin(), cell.end(), random);
    }
    mesh.AddCell(cell);
    if (chance(0.05))
    {
      std::shuffle(cell.begin(), cell.end(), random);
      mesh.AddCell(cell);
    }
  };
  for (const Tuple& tet : tets)
  {
    if (chance(density))
    {
      take(tet);
    }
    for (int size = 1; size < 4; ++size)
    {
      Tuple part = tet;
      std::shuffle(part.begin(), part.end(), random);
      part.resize(size);
      if (chance(0.12))
      {
        take(part);
      }
      if (chance(singular))
      {
        mesh.Singular.insert(Sorted(part));
      }
    }
  }
  for (int i = 0; i < 3; ++i) // cells that the lattice does not have: crowds of tetrahedra
  {
    Tuple cell = tets[number(static_cast<vtkIdType>(tets.size()))];
    const vtkIdType other = number(27);
    if (std::find(cell.begin(), cell.end(), other) == cell.end())
    {
      cell[number(4)] = other;
      cell.resize(2 + number(3));
      take(cell);
    }
  }
  // Equal tetrahedra must mark the same edges, which OrderTets sees to.
  std::uniform_real_distribution<double> jitter(-0.1, 0.1);
  for (double& x : mesh.Points)
  {
    x += seed % 2 ? jitter(random) : 0.;
  }
  OrderTets(mesh.Cells, mesh.Points.data(), nullptr, 0);
  // Only what exists can be singular.
  std::set<Tuple> closure;
  for (const Tuple& cell : GetCells(mesh.Cells))
  {
    for (int pattern = 1; pattern < 1 << cell.size(); ++pattern)
    {
      Tuple face;
      for (std::size_t i = 0; i < cell.size(); ++i)
      {
        if (pattern >> i & 1)
        {
          face.push_back(cell[i]);
        }
      }
      closure.insert(Sorted(face));
    }
  }
  std::set<Tuple> kept;
  std::set_intersection(mesh.Singular.begin(), mesh.Singular.end(), closure.begin(), closure.end(),
    std::inserter(kept, kept.begin()));
  mesh.Singular = kept;
  return mesh;
}

Mesh MakeSimple(const std::string& name, int points, std::initializer_list<Tuple> cells,
  std::initializer_list<Tuple> singular)
{
  Mesh mesh = MakeSpread(name, points);
  mesh.AddCells(cells);
  for (const Tuple& s : singular)
  {
    mesh.Singular.insert(Sorted(s));
  }
  return mesh;
}

Mesh With(Mesh mesh, const std::string& name, std::initializer_list<Tuple> cells,
  std::initializer_list<Tuple> singular)
{
  mesh.Name = name;
  for (const Tuple& cell : cells)
  {
    for (vtkIdType v : cell)
    {
      while (v >= mesh.Cells.NumberOfPoints)
      {
        const double t = static_cast<double>(mesh.Cells.NumberOfPoints);
        mesh.AddPoint(1. + std::sin(3. * t), 2. * std::cos(2. * t), 0.3 * t);
      }
    }
    mesh.AddCell(cell);
  }
  for (const Tuple& s : singular)
  {
    mesh.Singular.insert(Sorted(s));
  }
  return mesh;
}

std::vector<Mesh> MakeZoo()
{
  const Mesh tet = MakeTet("SingleTet");
  const Mesh octahedron = MakeOctahedronSurface();
  const Mesh cube = MakeLattice("KuhnCube", 1, 1., 3).Control;
  std::vector<Mesh> zoo = {
    MakeSimple("Nothing", 0, {}),
    MakeSimple("UnusedPoints", 3, {}),
    MakeSimple("IsolatedVertex", 4, { { 0 }, { 1, 2 }, { 1 }, { 1 } }),
    // curves
    MakeSimple("OpenPolyline", 5, { { 0, 1 }, { 2, 1 }, { 2, 3 }, { 3, 4 } }),
    MakeSimple("ClosedPolyline", 4, { { 0, 1 }, { 1, 2 }, { 3, 2 }, { 3, 0 } }),
    MakeSimple("CrossingLines", 5, { { 0, 1 }, { 2, 0 }, { 0, 3 }, { 4, 0 } }),
    MakeSimple("RepeatedLines", 3, { { 0, 1 }, { 1, 0 }, { 1, 2 }, { 0, 1 } }),
    // surfaces
    octahedron,
    MakeIcosahedron(),
    MakeSimple("TetSurface", 4, { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } }),
    MakeFan("OpenFan", 5, false),
    MakeFan("ClosedFan", 7, true),
    MakeSimple("SingleTriangle", 3, { { 2, 0, 1 } }),
    MakeSimple("BowTie", 7, { { 0, 1, 2 }, { 0, 2, 3 }, { 4, 0, 5 }, { 5, 6, 0 } }),
    MakeSimple("TwoTouchingTriangles", 5, { { 0, 1, 2 }, { 2, 3, 4 } }),
    MakeSimple("ThreeSheets", 5, { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }),
    MakeSimple(
      "ThreeSheetsRelief", 6, { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 }, { 0, 5 }, { 1, 5 } }),
    MakeSimple("RepeatedTriangles", 4, { { 0, 1, 2 }, { 2, 1, 0 }, { 1, 3, 2 }, { 1, 2, 0 } }),
    With(octahedron, "FollowerLines", { { 0, 2 }, { 4, 0 }, { 0, 2 }, { 4 } }),
    With(octahedron, "CreasedSurface", {}, { { 0, 2 }, { 2, 1 }, { 5 } }),
    With(octahedron, "CreaseEnd", {}, { { 0, 2 } }),
    // solids
    tet,
    With(tet, "TwoTets", { { 1, 2, 4, 3 } }),
    With(tet, "TetsSharingVertex", { { 0, 4, 5, 6 } }),
    With(tet, "TetsSharingEdge", { { 0, 1, 4, 5 } }),
    With(tet, "PinchedTets", { { 0, 1, 4, 5 }, { 2, 3, 4, 5 }, { 0, 6, 7, 8 } }),
    With(tet, "CrowdOfTets", { { 0, 1, 2, 4 }, { 5, 2, 1, 0 } }),
    With(tet, "CrowdOfTetsOtherMarks", { { 0, 2, 1, 4 }, { 5, 0, 1, 2 }, { 0, 2, 5, 6 } }),
    With(tet, "RepeatedTets", { { 2, 1, 0, 3 }, { 1, 2, 4, 3 }, { 1, 0, 3, 2 }, { 3, 1, 2 } }),
    With(tet, "FollowerTriangles", { { 0, 1, 2 }, { 3, 2, 1 }, { 1, 0, 2 }, { 0, 3 } }),
    MakeValence4(),
    MakeOctahedron("Octahedron", true),
    MakeOctahedron("OctahedronMixedMarks", false),
    cube,
    MakeLattice("KuhnLattice", 2, 1., 5).Control,
    With(cube, "SingularFaceInside", {}, {}),
    // joints
    With(tet, "FinOnEdge", { { 0, 1, 4 } }),
    With(tet, "FinAtVertex", { { 0, 4, 5 } }),
    With(tet, "FlushFin", { { 0, 1, 4 }, { 1, 2, 4 } }),
    With(tet, "LineOnTet", { { 3, 4 }, { 4, 5 } }),
    With(tet, "LineBetweenTets", { { 0, 4 }, { 4, 5, 6, 7 } }),
    With(tet, "TentOnTet", { { 0, 4 }, { 4, 1 } }),
    With(octahedron, "LineThroughSurface", { { 0, 6 }, { 0, 1 } }),
    With(MakeValence4(), "FinInside", { { 4, 0, 5 }, { 4, 5 } }),
    With(MakeOctahedron("", true), "FinInRegularEdge", { { 0, 1, 6 }, { 1, 0, 7 } }),
    With(MakeOctahedron("", true), "SingularSheetInside", {}, { { 0, 1, 2 }, { 0, 1, 4 } }),
    With(MakeOctahedron("", true), "SingularLineInside", {}, { { 0, 1 }, { 2, 3 }, { 2, 5 } }),
    MakeSimple("EverythingAtOnce", 9,
      { { 0 }, { 0, 1 }, { 2, 0 }, { 0, 2, 3 }, { 3, 4, 0 }, { 0, 5, 6, 7 }, { 5, 6, 7, 8 } }),
  };
  // The four faces of an inner tetrahedron are a closed singular surface.
  for (Mesh& mesh : zoo)
  {
    if (mesh.Name == "SingularFaceInside")
    {
      const Tuple first = GetCells(mesh.Cells)[0];
      for (int i = 0; i < 4; ++i)
      {
        Tuple face = first;
        face.erase(face.begin() + i);
        mesh.Singular.insert(Sorted(face));
      }
    }
  }
  return zoo;
}

const std::vector<Mesh>& GetZoo()
{
  static const std::vector<Mesh> zoo = MakeZoo();
  return zoo;
}

Mesh FindInZoo(const std::string& name)
{
  const std::string random = "Random";
  if (name.compare(0, random.size(), random) == 0)
  {
    return MakeRandom(static_cast<unsigned int>(std::stoi(name.substr(random.size()))));
  }
  for (const Mesh& mesh : GetZoo())
  {
    if (mesh.Name == name)
    {
      return mesh;
    }
  }
  return Mesh("missing: " + name);
}

std::vector<std::string> GetNamesOfZoo(unsigned int randoms)
{
  std::vector<std::string> names;
  for (const Mesh& mesh : GetZoo())
  {
    names.push_back(mesh.Name);
  }
  for (unsigned int seed = 1; seed <= randoms; ++seed)
  {
    names.push_back("Random" + std::to_string(seed));
  }
  return names;
}

std::vector<Mesh> MakeZooAndRandom()
{
  std::vector<Mesh> meshes = GetZoo();
  for (unsigned int seed = 1; seed <= 60; ++seed)
  {
    meshes.push_back(MakeRandom(seed));
  }
  return meshes;
}

}
