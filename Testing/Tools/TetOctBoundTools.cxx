// SPDX-License-Identifier: BSD-3-Clause
#include "TetOctBoundTools.h"

namespace bound_tools
{
namespace
{

constexpr int Faces[8][3] = { { 0, 2, 4 }, { 1, 4, 2 }, { 0, 4, 3 }, { 1, 3, 4 }, { 0, 5, 2 },
  { 1, 2, 5 }, { 0, 3, 5 }, { 1, 5, 3 } };
constexpr int MiddlePairs[6][2] = { { 0, 1 }, { 2, 3 }, { 0, 3 }, { 1, 2 }, { 0, 2 }, { 1, 3 } };

Point Mean(const Point& a, const Point& b)
{
  return { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]) };
}

/// The children of one solid.
class Splitter
{
public:
  /// `first`: the first of the cells that the solid's first cell was split into.
  Splitter(const TetOctSolid& solid, vtkIdType first, vtkUnstructuredGrid* next,
    std::vector<TetOctSolid>& made)
    : Solid(solid)
    , Next(next)
    , Made(made)
    , First(first)
  {
  }

  void Split()
  {
    if (!this->Solid.IsOct())
    {
      for (int v = 0; v < 4; ++v)
      {
        const Ids child = GetCell(this->Next, this->First + v);
        EXPECT_EQ(child[v], this->Solid.Points[v]);
        for (int w = 0; w < 4; ++w)
        {
          this->Known[Key(v, w)] = child[w];
        }
        this->Add(this->First + v, { { v, 0 }, { v, 1 }, { v, 2 }, { v, 3 } });
      }
      std::vector<std::pair<int, int>> middles;
      for (const auto& pair : MiddlePairs)
      {
        middles.emplace_back(pair[0], pair[1]);
      }
      this->Add(this->First + 4, middles);
      return;
    }
    for (int f = 0; f < 8; ++f)
    {
      const Ids child = GetCell(this->Next, this->First + 24 + f);
      const int* face = Faces[f];
      this->Known[{ -1, -1 }] = child[0];
      for (int i = 0; i < 3; ++i)
      {
        this->Known[Key(face[i], face[(i + 1) % 3])] = child[1 + i];
      }
    }
    for (int v = 0; v < 6; ++v)
    {
      this->Known[{ v, v }] = this->Solid.Points[v];
      std::vector<std::pair<int, int>> points;
      for (int w = 0; w < 6; ++w)
      {
        points.emplace_back(w == (v ^ 1) ? std::pair<int, int>{ -1, -1 } : Key(v, w));
      }
      this->Add(this->First + 4 * v, points);
    }
    for (int f = 0; f < 8; ++f)
    {
      const int* face = Faces[f];
      this->Add(this->First + 24 + f,
        { { -1, -1 }, Key(face[0], face[1]), Key(face[1], face[2]), Key(face[2], face[0]) });
    }
  }

private:
  /// A vertex as v, v; the middle of an edge by its ends; the centre as -1, -1.
  using Name = std::pair<int, int>;
  static Name Key(int v, int w) { return { std::min(v, w), std::max(v, w) }; }

  void Add(vtkIdType cell, const std::vector<Name>& names)
  {
    TetOctSolid child{ cell, this->Solid.Of, {}, {} };
    for (const Name& given : names)
    {
      const Name name = given.first < 0 ? given : Key(given.first, given.second);
      child.Points.push_back(this->Known.at(name));
      const auto& places = this->Solid.Places;
      child.Places.push_back(name.first < 0 ? Mean(places[0], places[1])
                                            : Mean(places[name.first], places[name.second]));
    }
    std::set<vtkIdType> read;
    for (vtkIdType c = cell; c < cell + (child.IsOct() ? 4 : 1); ++c)
    {
      const Ids ids = GetCell(this->Next, c);
      read.insert(ids.begin(), ids.end());
    }
    EXPECT_EQ(read, std::set<vtkIdType>(child.Points.begin(), child.Points.end()));
    this->Made.push_back(child);
  }

  const TetOctSolid& Solid;
  vtkUnstructuredGrid* Next;
  std::vector<TetOctSolid>& Made;
  const vtkIdType First;
  std::map<Name, vtkIdType> Known;
};

/// The weights of the corners of a cell at a place; a negative one if it is not in the cell.
std::array<double, 4> WeighCorners(const TetOctSolid& solid, const Ids& cell, const Point& place)
{
  std::array<double, 4> weights{};
  if (!solid.IsOct())
  {
    return { { 1. - place[0] - place[1] - place[2], place[0], place[1], place[2] } };
  }
  double left = 1.;
  std::array<int, 4> vertices{};
  std::array<int, 3> counts{};
  for (int k = 0; k < 4; ++k)
  {
    const auto found = std::find(solid.Points.begin(), solid.Points.end(), cell[k]);
    vertices[k] = static_cast<int>(found - solid.Points.begin());
    ++counts[vertices[k] / 2];
  }
  const auto along = [&](int k) { return (vertices[k] % 2 ? -1. : 1.) * place[vertices[k] / 2]; };
  for (int k = 0; k < 4; ++k)
  {
    if (counts[vertices[k] / 2] == 1)
    {
      weights[k] = along(k);
      left -= weights[k];
    }
  }
  for (int k = 0; k < 4; ++k)
  {
    if (counts[vertices[k] / 2] == 2)
    {
      weights[k] = 0.5 * (left + along(k));
    }
  }
  return weights;
}

}

std::vector<TetOctSolid> ListControlTets(vtkUnstructuredGrid* control)
{
  std::vector<TetOctSolid> solids;
  for (vtkIdType c = 0; c < control->GetNumberOfCells(); ++c)
  {
    if (control->GetCellType(c) == VTK_TETRA)
    {
      solids.push_back({ c, static_cast<std::size_t>(c), GetCell(control, c),
        { { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 0., 0., 1. } } });
    }
  }
  return solids;
}

std::vector<TetOctSolid> SplitTetOct(
  const std::vector<TetOctSolid>& solids, vtkUnstructuredGrid* mesh, vtkUnstructuredGrid* next)
{
  Ids firsts{ 0 }; // a cell of dimension d becomes 2^d cells
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    const auto dimension = static_cast<int>(GetCell(mesh, c).size()) - 1;
    firsts.push_back(firsts.back() + (vtkIdType(1) << dimension));
  }
  std::vector<TetOctSolid> made;
  for (const TetOctSolid& solid : solids)
  {
    Splitter(solid, firsts[solid.Cell], next, made).Split();
  }
  return made;
}

std::vector<TetOctSolid> Restart(std::vector<TetOctSolid> solids)
{
  for (std::size_t i = 0; i < solids.size(); ++i)
  {
    solids[i].Of = i;
    for (std::size_t v = 0; v < solids[i].Points.size(); ++v)
    {
      Point place{};
      if (solids[i].IsOct())
      {
        place[v / 2] = v % 2 ? -1. : 1.;
      }
      else if (v > 0)
      {
        place[v - 1] = 1.;
      }
      solids[i].Places[v] = place;
    }
  }
  return solids;
}

PlacedPoints PlaceTetOctPoints(vtkUnstructuredGrid* coarse, const std::vector<TetOctSolid>& solids,
  const std::vector<TetOctSolid>& fine)
{
  PlacedPoints placed;
  std::set<std::pair<std::size_t, vtkIdType>> known;
  for (const TetOctSolid& part : fine)
  {
    const TetOctSolid& solid = solids[part.Of];
    for (std::size_t v = 0; v < part.Points.size(); ++v)
    {
      if (!known.insert({ part.Of, part.Points[v] }).second)
      {
        continue;
      }
      for (vtkIdType c = solid.Cell; c < solid.Cell + (solid.IsOct() ? 4 : 1); ++c)
      {
        const auto weights = WeighCorners(solid, GetCell(coarse, c), part.Places[v]);
        if (*std::min_element(weights.begin(), weights.end()) > -1e-9)
        {
          placed[c].push_back({ part.Points[v], weights });
        }
      }
    }
  }
  return placed;
}

std::vector<TetOctSolid> FindTetOctSolids(
  vtkDataObject* input, int levels, const Configure& configure)
{
  std::vector<TetOctSolid> solids;
  Grid before;
  for (int level = 0; level <= levels; ++level)
  {
    const Grid mesh = Execute(input, level,
      [&](Filter* filter)
      {
        filter->SetVolumeSchemeToTetOct();
        if (configure)
        {
          configure(filter);
        }
      });
    solids = level == 0 ? ListControlTets(mesh) : SplitTetOct(solids, before, mesh);
    before = mesh;
  }
  return solids;
}

void ExpectTetOctBounds(vtkDataObject* input, int levels, int steps, const Configure& configure,
  bool projects, Tightness& tightness)
{
  const Configure both = [&](Filter* filter)
  {
    filter->SetVolumeSchemeToTetOct();
    if (configure)
    {
      configure(filter);
    }
  };
  const auto bounded = MakeBounded<Filter>(input, levels, steps, both, projects);
  std::vector<TetOctSolid> solids = Restart(FindTetOctSolids(input, levels, configure));
  std::vector<TetOctSolid> fine = solids;
  Grid before = bounded.Coarse;
  for (int step = 1; step <= steps; ++step)
  {
    const Grid mesh = Execute(input, levels + step, both);
    fine = SplitTetOct(fine, before, mesh);
    before = mesh;
  }
  const PlacedPoints placed = PlaceTetOctPoints(bounded.Coarse, solids, fine);
  ExpectBounds(bounded.Coarse, bounded.Fine, steps, tightness, 1e-12, &placed);
}

}
