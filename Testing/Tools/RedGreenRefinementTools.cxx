// SPDX-License-Identifier: BSD-3-Clause
#include "RedGreenRefinementTools.h"

namespace red_green_refinement_tools
{

Grid Refine(vtkDataObject* input, const Configure& configure, Messages* messages)
{
  vtkNew<Filter> filter;
  filter->RefineByAttributeErrorOff();
  configure(filter);
  // Meshes of the zoo and of files may have parts that touch only.
  UpdateInSilence(filter, input, messages, { "come apart there" });
  return filter->GetOutput();
}

Grid HalveAll(vtkDataObject* input, int levels, const Configure& configure, Messages* messages)
{
  return Refine(
    input,
    [&](Filter* filter)
    {
      filter->RefineByEdgeLengthOn();
      filter->SetMaximumEdgeLength(0.);
      filter->SetMaximumLevel(levels);
      if (configure)
      {
        configure(filter);
      }
    },
    messages);
}

double GetDifference(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b, bool sort)
{
  if (a->GetNumberOfCells() != b->GetNumberOfCells())
  {
    return std::numeric_limits<double>::infinity();
  }
  double difference = 0.;
  vtkDataArray* values = a->GetPointData()->GetArray("V");
  vtkDataArray* others = b->GetPointData()->GetArray("V");
  for (vtkIdType i = 0; i < a->GetNumberOfCells(); ++i)
  {
    Ids x = GetCell(a, i);
    Ids y = GetCell(b, i);
    if (x.size() != y.size())
    {
      return std::numeric_limits<double>::infinity();
    }
    if (sort)
    {
      std::sort(x.begin(), x.end());
      std::sort(y.begin(), y.end());
    }
    for (std::size_t k = 0; k < x.size(); ++k)
    {
      const Point p = GetPoint(a, x[k]);
      const Point q = GetPoint(b, y[k]);
      difference = std::max(difference, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
      for (int c = 0; c < values->GetNumberOfComponents(); ++c)
      {
        difference = std::max(
          difference, std::abs(values->GetComponent(x[k], c) - others->GetComponent(y[k], c)));
      }
    }
  }
  return difference;
}

Grid MakeGrid(const coretest::Mesh& mesh)
{
  const int types[] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_TETRA };
  std::vector<Point> points(mesh.Points.size() / 3);
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    points[i / 3][i % 3] = mesh.Points[i];
  }
  std::vector<Cell> cells;
  for (const coretest::Tuple& cell : coretest::GetCells(mesh.Cells))
  {
    cells.push_back({ types[cell.size() - 1], cell });
  }
  return multi_dimensional_subdivision_tools::MakeGrid(points, cells);
}

void AddWantedLevels(vtkUnstructuredGrid* grid, int most, unsigned seed, double part)
{
  std::mt19937 random(seed);
  vtkNew<vtkIntArray> levels;
  levels->SetName("WantedLevel");
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    const bool wanted = random() < part * 4294967296.;
    levels->InsertNextValue(wanted ? static_cast<int>(random() % (most + 1)) : 0);
  }
  grid->GetCellData()->AddArray(levels);
}

void AddWeights(vtkUnstructuredGrid* grid)
{
  const vtkIdType points = grid->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("Weights");
  weights->SetNumberOfComponents(static_cast<int>(points));
  weights->SetNumberOfTuples(points);
  weights->Fill(0.);
  for (vtkIdType i = 0; i < points; ++i)
  {
    weights->SetComponent(i, static_cast<int>(i), 1.);
  }
  grid->GetPointData()->AddArray(weights);
}

Ids FindSamePoints(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* other)
{
  const auto getWeights = [](vtkUnstructuredGrid* from, vtkIdType point)
  {
    vtkDataArray* weights = from->GetPointData()->GetArray("Weights");
    std::vector<double> key(weights->GetNumberOfComponents());
    weights->GetTuple(point, key.data());
    return key;
  };
  std::map<std::vector<double>, vtkIdType> known;
  for (vtkIdType i = 0; i < other->GetNumberOfPoints(); ++i)
  {
    known[getWeights(other, i)] = i;
  }
  Ids same;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const auto found = known.find(getWeights(grid, i));
    same.push_back(found == known.end() ? -1 : found->second);
  }
  return same;
}

std::set<vtkIdType> FindParts(
  vtkDataArray* numbersOfCorners, const Ids& corners, const double* numbers)
{
  const std::size_t size = corners.size();
  double rows[4][5];
  for (std::size_t k = 0; k < 4; ++k)
  {
    for (std::size_t i = 0; i < size; ++i)
    {
      rows[k][i] = numbersOfCorners->GetComponent(corners[i], static_cast<int>(k));
    }
    rows[k][size] = numbers[k];
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    for (std::size_t k = i + 1; k < 4; ++k)
    {
      if (std::abs(rows[k][i]) > std::abs(rows[i][i]))
      {
        std::swap(rows[k], rows[i]);
      }
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      const double factor = k == i ? 0. : rows[k][i] / rows[i][i];
      for (std::size_t c = 0; c <= size; ++c)
      {
        rows[k][c] -= factor * rows[i][c];
      }
    }
  }
  std::set<vtkIdType> parts;
  double sum = 0.;
  for (std::size_t i = 0; i < size; ++i)
  {
    const double weight = rows[i][size] / rows[i][i];
    const double dyadic = std::round(4096. * weight) / 4096.; // of up to twelve levels
    sum += dyadic;
    if (std::abs(weight - dyadic) > 1e-6 || dyadic < 0.)
    {
      parts.insert(-1);
    }
    if (dyadic > 0.)
    {
      parts.insert(corners[i]);
    }
  }
  if (sum != 1.)
  {
    parts.insert(-1);
  }
  return parts;
}

double GetFarthest(vtkUnstructuredGrid* from, vtkUnstructuredGrid* to)
{
  const auto read = [](vtkUnstructuredGrid* grid)
  {
    vtkDataArray* values = grid->GetPointData()->GetArray("V");
    std::vector<std::vector<double>> places;
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      const Point p = GetPoint(grid, i);
      places.emplace_back(p.begin(), p.end());
      for (int c = 0; c < values->GetNumberOfComponents(); ++c)
      {
        places.back().push_back(values->GetComponent(i, c));
      }
    }
    return places;
  };
  const auto others = read(to);
  double most = 0.;
  for (const auto& own : read(from))
  {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& other : others)
    {
      double distance = 0.;
      for (std::size_t k = 0; k < own.size(); ++k)
      {
        distance = std::max(distance, std::abs(own[k] - other[k]));
      }
      least = std::min(least, distance);
    }
    most = std::max(most, least);
  }
  return most;
}

double GetVolume(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  const Ids ids = GetCell(grid, cell);
  std::vector<Point> p;
  for (vtkIdType id : ids)
  {
    p.push_back(GetPoint(grid, id));
  }
  Point e[3] = {};
  for (std::size_t i = 1; i < p.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      e[i - 1][c] = p[i][c] - p[0][c];
    }
  }
  auto cross = [](const Point& a, const Point& b)
  {
    return Point{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  };
  auto dot = [](const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  switch (ids.size())
  {
    case 1:
      return 1.;
    case 2:
      return std::sqrt(dot(e[0], e[0]));
    case 3:
      return std::sqrt(dot(cross(e[0], e[1]), cross(e[0], e[1]))) / 2.;
    default:
      return dot(cross(e[0], e[1]), e[2]) / 6.;
  }
}

double GetLargestVolume(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  double longest = 0.;
  const Ids ids = GetCell(grid, cell);
  for (vtkIdType a : ids)
  {
    for (vtkIdType b : ids)
    {
      const Point p = GetPoint(grid, a);
      const Point q = GetPoint(grid, b);
      longest = std::max(longest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    }
  }
  return std::pow(longest, static_cast<double>(ids.size() - 1));
}

std::string Conformity::Check()
{
  this->FindCarriers();
  for (const Ids& cell : GetCells(this->Input))
  {
    this->CountFaces(cell);
  }
  std::map<Ids, int> facets[4];
  std::set<Ids> closure;
  const std::vector<Ids> cells = GetCells(this->Output);
  for (const Ids& cell : cells)
  {
    for (const Ids& face : GetFaces(cell))
    {
      facets[cell.size() - 1][face] += face.size() + 1 == cell.size() ? 1 : 0;
      if (cell.size() > face.size())
      {
        closure.insert(face);
      }
    }
  }
  for (int dimension = 1; dimension < 4; ++dimension)
  {
    for (const auto& [facet, count] : facets[dimension])
    {
      const Ids carrier = this->GetCarrier(facet);
      const bool isInside = static_cast<int>(carrier.size()) == dimension + 1;
      const int wanted = this->CellsAt[dimension][carrier] * (isInside ? 2 : 1);
      if (static_cast<int>(facet.size()) == dimension && count != wanted)
      {
        return Say(facet) + " is in " + std::to_string(count) + " cells of dimension " +
          std::to_string(dimension) + " instead of " + std::to_string(wanted);
      }
    }
  }
  for (const Ids& cell : cells)
  {
    const Ids carrier = this->GetCarrier(cell);
    if (carrier.size() != cell.size() || carrier[0] < 0)
    {
      return Say(cell) + " is not a part of one cell";
    }
    Ids sorted = cell;
    std::sort(sorted.begin(), sorted.end());
    if (this->InLarger.count(carrier) > 0 && cell.size() > 1 && closure.count(sorted) == 0)
    {
      return Say(cell) + " does not lie on the larger cells";
    }
  }
  return this->CheckVolumes();
}

std::string Conformity::Say(const Ids& ids)
{
  std::string text = "(";
  for (vtkIdType id : ids)
  {
    text += " " + std::to_string(id);
  }
  return text + " )";
}

std::vector<Ids> Conformity::GetFaces(Ids cell)
{
  std::sort(cell.begin(), cell.end());
  std::vector<Ids> faces;
  for (int pattern = 1; pattern < 1 << cell.size(); ++pattern)
  {
    Ids face;
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      if (pattern >> i & 1)
      {
        face.push_back(cell[i]);
      }
    }
    faces.push_back(face);
  }
  return faces;
}

void Conformity::FindCarriers()
{
  vtkDataArray* weights = this->Output->GetPointData()->GetArray("Weights");
  this->Carriers.resize(this->Output->GetNumberOfPoints());
  if (!weights)
  {
    this->FindCarriersByNumbers();
    return;
  }
  for (vtkIdType i = 0; i < this->Output->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < weights->GetNumberOfComponents(); ++c)
    {
      if (weights->GetComponent(i, c) > 0.)
      {
        this->Carriers[i].insert(c);
      }
    }
  }
}

void Conformity::FindCarriersByNumbers()
{
  vtkDataArray* given = this->Input->GetPointData()->GetArray("Random");
  vtkDataArray* numbers = this->Output->GetPointData()->GetArray("Random");
  for (vtkIdType i = 0; i < this->Output->GetNumberOfCells(); ++i)
  {
    const Ids corners = GetCell(this->Input, GetOrigin(this->Output, i));
    for (vtkIdType point : GetCell(this->Output, i))
    {
      double own[4];
      numbers->GetTuple(point, own);
      const std::set<vtkIdType> parts = FindParts(given, corners, own);
      if (this->Carriers[point].empty())
      {
        this->Carriers[point] = parts;
      }
      else if (this->Carriers[point] != parts)
      {
        this->Carriers[point].insert(-1); // its cells do not agree where it lies
      }
    }
  }
}

Ids Conformity::GetCarrier(const Ids& points) const
{
  std::set<vtkIdType> all;
  for (vtkIdType point : points)
  {
    all.insert(this->Carriers[point].begin(), this->Carriers[point].end());
  }
  return Ids(all.begin(), all.end());
}

void Conformity::CountFaces(const Ids& cell)
{
  for (const Ids& face : GetFaces(cell))
  {
    ++this->CellsAt[cell.size() - 1][face];
    if (face.size() < cell.size())
    {
      this->InLarger.insert(face);
    }
  }
}

std::string Conformity::CheckVolumes()
{
  std::vector<double> sums(this->Input->GetNumberOfCells(), 0.);
  vtkDataArray* origins = this->Output->GetCellData()->GetArray("vtkOriginalCellIds");
  double scale = 0.;
  for (vtkIdType i = 0; i < this->Output->GetNumberOfCells(); ++i)
  {
    const auto origin = static_cast<vtkIdType>(origins->GetComponent(i, 0));
    const double volume = GetVolume(this->Output, i);
    const double whole = GetVolume(this->Input, origin);
    sums[origin] += volume;
    scale = std::max(scale, std::abs(whole));
    const bool isFlat = std::abs(whole) <= 1e-9 * GetLargestVolume(this->Input, origin);
    if (!isFlat && volume * whole <= 0.)
    {
      return "cell " + std::to_string(i) + " is inverted or flat";
    }
  }
  for (vtkIdType i = 0; i < this->Input->GetNumberOfCells(); ++i)
  {
    const double whole =
      this->Input->GetCellType(i) == VTK_VERTEX ? sums[i] : GetVolume(this->Input, i);
    if (std::abs(sums[i] - whole) > 1e-12 * scale)
    {
      return "the parts of cell " + std::to_string(i) + " do not add up";
    }
  }
  return "";
}

Grid RefineToWanted(vtkUnstructuredGrid* input, int maximum)
{
  return Refine(input,
    [maximum](Filter* filter)
    {
      filter->RefineByWantedLevelOn();
      filter->SetMaximumLevel(maximum);
    });
}

Grid RefineByChance(vtkUnstructuredGrid* current, unsigned round, vtkIdType oneIn)
{
  const auto marked = Grid::New();
  marked->ShallowCopy(current);
  std::mt19937 random(round);
  vtkNew<vtkIntArray> wanted;
  wanted->SetName("WantedLevel");
  vtkDataArray* parents = current->GetCellData()->GetArray("GreenParent");
  for (vtkIdType i = 0; i < current->GetNumberOfCells(); ++i)
  {
    const bool goesOn = parents && i > 0 && parents->GetComponent(i, 0) >= 0 &&
      parents->GetComponent(i, 0) == parents->GetComponent(i - 1, 0);
    const int level = random() % oneIn == 0 ? static_cast<int>(round) + 1 : 0;
    wanted->InsertNextValue(goesOn ? wanted->GetValue(i - 1) : level);
  }
  marked->GetCellData()->AddArray(wanted);
  return RefineToWanted(marked, 1);
}

vtkIdType CountKind(vtkUnstructuredGrid* grid, int kind)
{
  vtkDataArray* kinds = grid->GetCellData()->GetArray("RefinementKind");
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < kinds->GetNumberOfTuples(); ++i)
  {
    count += kinds->GetComponent(i, 0) == kind ? 1 : 0;
  }
  return count;
}

void AddValues(vtkUnstructuredGrid* grid, const char* name)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName(name);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(grid, i);
    values->InsertNextValue(p[0] * p[0] * p[0] + p[1]);
  }
  grid->GetPointData()->AddArray(values);
}

int GetFinestLevel(vtkUnstructuredGrid* grid)
{
  double finest = 0.;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    finest = std::max(finest, GetLevel(grid, i));
  }
  return static_cast<int>(finest);
}

}
