// SPDX-License-Identifier: BSD-3-Clause
#include "HybridReference.h"

#include <algorithm>

namespace hybridtest
{

namespace
{

void Add(Row& row, double factor, const Row& other)
{
  for (const auto& [id, weight] : other)
  {
    row[id] += factor * weight;
  }
}

/// One step of one mesh: numbers of new points, their linear rows, then their averages.
class Step
{
public:
  explicit Step(const Mesh& mesh)
    : Given(mesh)
    , Whole(mesh)
    , Rules(mesh, this->Whole)
  {
    this->Number();
  }

  Level Run() const;

private:
  void Number();
  void AddPoint(int dimension, const Cell& side);
  int Middle(const Cell& cell, int i, int j) const;
  std::vector<Cell> Split(const Cell& cell) const;
  Row Mean(int point, const std::vector<Cell>& parts) const;
  Row MakeRow(int point, const Stratum& stratum) const;
  std::vector<Row> MakeRows(const Strata& rules, std::map<int, Ids>& curves) const;
  double FindSharpness(const Ids& item) const;
  void BlendRows(std::vector<Row>& rows) const;
  Row BlendVertex(int vertex) const;
  Row BlendEdge(const Ids& edge) const;
  std::set<int> NeighboursOf(int vertex) const;

  const Mesh& Given;
  const Complex Whole;
  const Strata Rules;
  std::map<Ids, int> Points[4]; ///< of edges, quads, cells
  std::vector<Row> Linear;
};

void Step::AddPoint(int dimension, const Cell& side)
{
  const int point = static_cast<int>(this->Linear.size());
  if (this->Points[dimension].emplace(Sorted(side.Corners), point).second)
  {
    Row row;
    for (int corner : side.Corners)
    {
      row[corner] = 1. / static_cast<double>(side.Corners.size());
    }
    this->Linear.push_back(row);
  }
}

void Step::Number()
{
  for (std::size_t i = 0; i < this->Given.Points.size(); ++i)
  {
    this->Linear.push_back({ { static_cast<int>(i), 1. } });
  }
  for (int d = 1; d <= 2; ++d)
  {
    for (const auto& item : this->Whole.GetSides(d))
    {
      if (item.second.Shape != Type::Triangle)
      {
        this->AddPoint(d, item.second);
      }
    }
  }
  for (const Cell& cell : this->Given.Cells)
  {
    if (GetTable(cell.Shape).HasCentre)
    {
      this->AddPoint(3, cell);
    }
  }
}

int Step::Middle(const Cell& cell, int i, int j) const
{
  if (i == j)
  {
    return cell.Corners[i];
  }
  for (int d = 1; d <= 2; ++d)
  {
    for (const Cell& side : Sides(cell, d))
    {
      if (side.Shape != Type::Triangle && Has(side.Corners, cell.Corners[i]) &&
        Has(side.Corners, cell.Corners[j]))
      {
        return this->Points[d].at(Sorted(side.Corners));
      }
    }
  }
  return this->Points[3].at(Sorted(cell.Corners));
}

std::vector<Cell> Step::Split(const Cell& cell) const
{
  const Table& table = GetTable(cell.Shape);
  const int corners = static_cast<int>(cell.Corners.size());
  std::vector<Cell> children;
  for (int i = 0; i < corners - (cell.Shape == Type::Pyramid); ++i)
  {
    Cell child = { cell.Shape, {}, cell.Material };
    for (int j = 0; j < corners; ++j)
    {
      child.Corners.push_back(this->Middle(cell, i, j));
    }
    children.push_back(child);
  }
  Ids names = cell.Corners;
  for (int d = 1; d <= 2; ++d)
  {
    for (const Cell& side : Sides(cell, d))
    {
      if (side.Shape != Type::Triangle)
      {
        names.push_back(this->Points[d].at(Sorted(side.Corners)));
      }
    }
  }
  if (table.HasCentre)
  {
    names.push_back(this->Points[3].at(Sorted(cell.Corners)));
  }
  for (const auto& [shape, locals] : table.Inner)
  {
    children.push_back({ shape, Named({ cell.Shape, names }, locals), cell.Material });
  }
  if (cell.Shape == Type::Wedge)
  {
    std::rotate(children.begin() + 3, children.begin() + 6, children.begin() + 7);
  }
  return children;
}

Row Step::Mean(int point, const std::vector<Cell>& parts) const
{
  Row sum;
  double total = 0.;
  std::vector<double> shares;
  for (const Cell& part : parts)
  {
    for (const Cell& fine : this->Split(part))
    {
      const auto found = std::find(fine.Corners.begin(), fine.Corners.end(), point);
      if (found == fine.Corners.end())
      {
        continue;
      }
      const double weight = Centroid(fine, found - fine.Corners.begin(), shares);
      total += weight;
      for (std::size_t j = 0; j < shares.size(); ++j)
      {
        Add(sum, weight * shares[j], this->Linear[fine.Corners[j]]);
      }
    }
  }
  Row mean;
  Add(mean, 1. / total, sum);
  return mean;
}

Row Step::MakeRow(int point, const Stratum& stratum) const
{
  if (stratum.Dimension == 0)
  {
    return this->Linear[point];
  }
  Row row;
  Add(row, stratum.Weight, this->Mean(point, stratum.Parts));
  Add(row, 1. - stratum.Weight,
    stratum.Along.empty() ? this->Linear[point] : this->Mean(point, stratum.Along));
  return row;
}

std::set<int> Step::NeighboursOf(int vertex) const
{
  std::set<int> neighbours;
  for (int k = 1; k <= 3; ++k)
  {
    for (const Cell& edge : Complex::SidesAt(this->Whole.CellsAt({ vertex }, k), { vertex }, 0, 1))
    {
      neighbours.insert(edge.Corners.begin(), edge.Corners.end());
    }
  }
  neighbours.erase(vertex);
  return neighbours;
}

Row Step::BlendVertex(int vertex) const
{
  Row row = { { vertex, 9. / 16 } };
  const std::set<int> neighbours = this->NeighboursOf(vertex);
  for (int other : neighbours)
  {
    row[other] = 7. / (16. * static_cast<double>(neighbours.size()));
  }
  return row;
}

Row Step::BlendEdge(const Ids& edge) const
{
  std::vector<Row> around;
  const std::set<int> others = this->NeighboursOf(edge[1]);
  for (int first : this->NeighboursOf(edge[0]))
  {
    if (others.count(first) > 0)
    {
      around.push_back({ { first, 1. } });
    }
  }
  std::vector<Cell> cells = this->Whole.CellsAt(edge, 2);
  const std::vector<Cell> solids = this->Whole.CellsAt(edge, 3);
  cells.insert(cells.end(), solids.begin(), solids.end());
  for (const Cell& face : Complex::SidesAt(cells, edge, 1, 2))
  {
    if (face.Shape == Type::Quad)
    {
      around.emplace_back();
      for (int corner : face.Corners)
      {
        around.back()[corner] = Has(edge, corner) ? 0. : 0.5;
      }
    }
  }
  Row row;
  const double middle = around.empty() ? 1. : 5. / 8;
  Add(row, middle, { { edge[0], 0.5 }, { edge[1], 0.5 } });
  for (const Row& one : around)
  {
    Add(row, (1. - middle) / static_cast<double>(around.size()), one);
  }
  return row;
}

std::vector<Row> Step::MakeRows(const Strata& rules, std::map<int, Ids>& curves) const
{
  std::vector<Row> rows = this->Linear;
  for (std::size_t i = 0; i < this->Given.Points.size(); ++i)
  {
    const int vertex = static_cast<int>(i);
    const Stratum stratum = rules.OfVertex(vertex);
    rows[i] = stratum.Blends ? this->BlendVertex(vertex) : this->MakeRow(vertex, stratum);
    for (std::size_t k = 0; stratum.Dimension == 1 && k < 2; ++k)
    {
      curves[vertex].push_back(this->Points[1].at(Sorted(stratum.Parts[k].Corners)));
    }
  }
  for (const auto& [edge, point] : this->Points[1])
  {
    const Stratum stratum = rules.OfEdge(edge);
    rows[point] = stratum.Blends ? this->BlendEdge(edge) : this->MakeRow(point, stratum);
    if (stratum.Dimension == 1)
    {
      curves[point] = edge;
    }
  }
  for (const auto& [quad, point] : this->Points[2])
  {
    rows[point] = this->MakeRow(point, rules.OfQuad(quad));
  }
  return rows;
}

/// The mean sharpness of sharp edges at a vertex or edge, or else of sharp faces at a vertex, edge
/// or face.
double Step::FindSharpness(const Ids& item) const
{
  double sums[2] = { 0., 0. };
  int counts[2] = { 0, 0 };
  for (const auto& [part, sharpness] : this->Given.Sharpness)
  {
    const int isFace = part.size() > 2 ? 1 : 0;
    const bool isIn =
      std::all_of(item.begin(), item.end(), [&](int corner) { return Has(part, corner); });
    // A diagonal of a quad is no edge, so that all edges in the corners of a face are its own.
    sums[isFace] += isIn ? sharpness : 0.;
    counts[isFace] += isIn ? 1 : 0;
  }
  const int kind = counts[0] > 0 ? 0 : 1;
  return counts[kind] > 0 ? sums[kind] / counts[kind] : 0.;
}

/// Blends the rows with those of the same mesh whose sharp parts are singular.
void Step::BlendRows(std::vector<Row>& rows) const
{
  Mesh sharp = this->Given;
  for (const auto& part : this->Given.Sharpness)
  {
    sharp.Singular.insert(part.first);
  }
  std::map<int, Ids> curves;
  const std::vector<Row> others = this->MakeRows(Strata(sharp, this->Whole), curves);
  const auto blend = [&](const Ids& item, int point)
  {
    const double weight = std::min(1., this->FindSharpness(item));
    Row row;
    Add(row, 1. - weight, rows[point]);
    Add(row, weight, others[point]);
    rows[point] = row;
  };
  for (std::size_t i = 0; i < this->Given.Points.size(); ++i)
  {
    blend({ static_cast<int>(i) }, static_cast<int>(i));
  }
  for (int d = 1; d <= 2; ++d)
  {
    for (const auto& [item, point] : this->Points[d])
    {
      blend(item, point);
    }
  }
}

Level Step::Run() const
{
  Level level;
  level.Rows = this->MakeRows(this->Rules, level.Fine.Curves);
  if (!this->Given.Sharpness.empty())
  {
    this->BlendRows(level.Rows);
  }
  for (const Row& row : level.Rows)
  {
    Point sum = {};
    for (const auto& [id, weight] : row)
    {
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += weight * this->Given.Points[id][c];
      }
    }
    level.Fine.Points.push_back(sum);
  }
  level.Fine.Joint = this->Given.Joint;
  level.Fine.HasDarts = this->Given.HasDarts;
  level.Fine.HasLoopWeights = this->Given.HasLoopWeights;
  for (const Cell& cell : this->Given.Cells)
  {
    const std::vector<Cell> children = this->Split(cell);
    level.Fine.Cells.insert(level.Fine.Cells.end(), children.begin(), children.end());
  }
  const auto forChildren = [this](const Ids& side, const auto& use)
  {
    const int dimension = std::min(static_cast<int>(side.size()), 3) - 1;
    for (const Cell& child : this->Split(this->Whole.GetSides(dimension).at(side)))
    {
      use(Sorted(child.Corners));
    }
  };
  for (const Ids& singular : this->Given.Singular)
  {
    forChildren(singular, [&](const Ids& child) { level.Fine.Singular.insert(child); });
  }
  for (const auto& part : this->Given.Sharpness)
  {
    const double left = part.second - 1.;
    if (left > 0.)
    {
      forChildren(part.first, [&](const Ids& child) { level.Fine.Sharpness[child] = left; });
    }
  }
  return level;
}

/// At a joint the first step may read neighbours that lie in no cell of the vertex.
bool IsJoint(const Mesh& mesh, int vertex)
{
  const Complex whole(mesh);
  return Strata(mesh, whole).OfVertex(vertex).Blends;
}

bool HasApexAt(const Mesh& mesh, int vertex)
{
  return std::any_of(mesh.Cells.begin(), mesh.Cells.end(), [vertex](const Cell& cell)
    { return cell.Shape == Type::Pyramid && cell.Corners[4] == vertex; });
}

Row FindLimit(const Mesh& mesh, int vertex, bool isFirst)
{
  const Level level = Refine(mesh);
  Row limit;
  if (HasApexAt(mesh, vertex) || (isFirst && IsJoint(mesh, vertex)))
  {
    for (const auto& [id, weight] : FindLimit(level.Fine, vertex, false))
    {
      Add(limit, weight, level.Rows[id]);
    }
    return limit;
  }
  // The child at the vertex has its corners in the order of its parent, and is the only one there.
  std::map<int, int> fineOf{ { vertex, vertex } };
  std::size_t next = 0;
  for (const Cell& cell : mesh.Cells)
  {
    while (Has(cell.Corners, vertex) && !Has(level.Fine.Cells[next].Corners, vertex))
    {
      ++next;
    }
    for (std::size_t j = 0; Has(cell.Corners, vertex) && j < cell.Corners.size(); ++j)
    {
      fineOf[cell.Corners[j]] = level.Fine.Cells[next].Corners[j];
    }
    next += Has(cell.Corners, vertex);
  }
  limit[vertex] = 1.;
  for (int power = 0; power < 200; ++power)
  {
    Row following;
    for (const auto& [id, weight] : limit)
    {
      Add(following, weight, level.Rows[fineOf.at(id)]);
    }
    limit = following;
  }
  return limit;
}

}

Level Refine(const Mesh& mesh)
{
  return Step(mesh).Run();
}

Row LimitRow(const Mesh& mesh, int vertex)
{
  return FindLimit(mesh, vertex, true);
}

}
