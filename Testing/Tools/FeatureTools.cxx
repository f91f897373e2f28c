// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureTools.h"

namespace feature_tools
{

Grid Execute(vtkDataObject* input, int levels, const Configure& configure, Messages* messages)
{
  vtkNew<Filter> filter;
  filter->SetVolumeSchemeToBoxSpline();
  filter->SetNumberOfLevels(levels);
  if (configure)
  {
    configure(filter);
  }
  UpdateInSilence(filter, input, messages);
  return filter->GetOutput();
}

Configure And(const Configure& a, const Configure& b)
{
  return [a, b](Filter* filter)
  {
    a(filter);
    b(filter);
  };
}

MatrixRow Blend(double weight, const MatrixRow& sharp, const MatrixRow& smooth)
{
  MatrixRow row;
  for (const auto& entry : weight > 0. ? sharp : MatrixRow())
  {
    row[entry.first] += weight * entry.second;
  }
  for (const auto& entry : weight < 1. ? smooth : MatrixRow())
  {
    row[entry.first] += (1. - weight) * entry.second;
  }
  return row;
}

std::set<std::pair<vtkIdType, vtkIdType>> GetEdges(vtkUnstructuredGrid* grid)
{
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  for (const Ids& cell : GetCells(grid))
  {
    for (vtkIdType a : cell)
    {
      for (vtkIdType b : cell)
      {
        if (a < b)
        {
          edges.emplace(a, b);
        }
      }
    }
  }
  return edges;
}

Matrix::Matrix(vtkUnstructuredGrid* input, const Configure& configure, Messages* messages)
  : Size(input->GetNumberOfPoints())
{
  const Grid copy = DeepCopy(input);
  vtkNew<vtkDoubleArray> impulses;
  impulses->SetName("impulses");
  impulses->SetNumberOfComponents(static_cast<int>(this->Size));
  impulses->SetNumberOfTuples(this->Size);
  impulses->Fill(0.);
  for (vtkIdType i = 0; i < this->Size; ++i)
  {
    impulses->SetComponent(i, static_cast<int>(i), 1.);
  }
  copy->GetPointData()->AddArray(impulses);
  const auto plain = [&](Filter* filter)
  {
    filter->ModifiedBoundaryOff(); // masks are those of the paper
    if (configure)
    {
      configure(filter);
    }
  };
  this->Output = Execute(copy, 1, plain, messages);
  this->Edges = GetEdges(this->Output);
}

MatrixRow Matrix::Edge(vtkIdType a, vtkIdType b) const
{
  for (vtkIdType i = this->Size; i < this->Output->GetNumberOfPoints(); ++i)
  {
    if (this->Edges.count({ a, i }) && this->Edges.count({ b, i }))
    {
      return this->GetRow(i);
    }
  }
  ADD_FAILURE() << "no edge " << a << " " << b;
  return {};
}

MatrixRow Matrix::GetRow(vtkIdType point) const
{
  MatrixRow row;
  vtkDataArray* impulses = this->Output->GetPointData()->GetArray("impulses");
  for (vtkIdType i = 0; i < this->Size; ++i)
  {
    const double weight = impulses->GetComponent(point, static_cast<int>(i));
    if (weight != 0.)
    {
      row[i] = weight;
    }
  }
  return row;
}

MatrixRow MakeRow(const Ids& own, double ownWeight, const Ids& ring, double ringWeight)
{
  MatrixRow row;
  for (vtkIdType i : own)
  {
    row[i] = ownWeight;
  }
  for (vtkIdType i : ring)
  {
    row[i] = ringWeight;
  }
  return row;
}

testing::AssertionResult Near(const MatrixRow& actual, const MatrixRow& expected)
{
  bool same = actual.size() == expected.size();
  for (const auto& entry : expected)
  {
    const auto found = actual.find(entry.first);
    same = same && found != actual.end() && std::abs(found->second - entry.second) <= 2e-16;
  }
  if (same)
  {
    return testing::AssertionSuccess();
  }
  auto result = testing::AssertionFailure();
  for (const auto* row : { &actual, &expected })
  {
    result << (row == &actual ? "is" : ", not");
    for (const auto& entry : *row)
    {
      result << " " << entry.first << ":" << entry.second;
    }
  }
  return result;
}

Grid MakeFan(int n, const std::vector<Cell>& more)
{
  std::vector<Point> points = { { 0, 0, 0.3 } };
  std::vector<Cell> cells;
  for (vtkIdType i = 1; i <= n; ++i)
  {
    const double t = 6.283185307179586 * static_cast<double>(i) / n;
    points.push_back({ std::cos(t), std::sin(t), i % 2 ? 0.01 : 0. });
    cells.push_back({ VTK_TRIANGLE, { 0, i, i % n + 1 } });
  }
  cells.insert(cells.end(), more.begin(), more.end());
  return MakeGrid(points, cells);
}

Grid MakeOctahedron(const std::vector<Cell>& more)
{
  const std::vector<Point> points = { { 0.01, 0.02, 0.03 }, { 1, 0, 0 }, { -1.1, 0, 0 },
    { 0, 1.2, 0 }, { 0, -1.3, 0 }, { 0, 0, 1.4 }, { 0, 0, -1.5 } };
  const vtkIdType around[5] = { 1, 3, 2, 4, 1 };
  std::vector<Cell> cells;
  for (int i = 0; i < 4; ++i)
  {
    cells.push_back({ VTK_TETRA, { 0, around[i], around[i + 1], 5 } });
  }
  for (int i = 0; i < 4; ++i)
  {
    cells.push_back({ VTK_TETRA, { 0, around[i + 1], around[i], 6 } });
  }
  cells.insert(cells.end(), more.begin(), more.end());
  return MakeGrid(points, cells);
}

Grid MakeKuhnBox(int n, double noise, unsigned seed)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  std::mt19937 random(seed);
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        auto shift = [&] { return noise * (random() / 4294967296. - 0.5); };
        points.push_back({ i + shift(), j + shift(), k + shift() });
      }
    }
  }
  auto at = [n](const std::array<int, 3>& p)
  { return vtkIdType(p[0] + (n + 1) * (p[1] + (n + 1) * p[2])); };
  for (int cube = 0; cube < n * n * n; ++cube)
  {
    std::array<int, 3> axes = { 0, 1, 2 };
    do
    {
      std::array<int, 3> corner = { cube % n, cube / n % n, cube / n / n };
      Ids tet = { at(corner) };
      for (int axis : axes)
      {
        ++corner[axis];
        tet.push_back(at(corner));
      }
      const bool odd = (axes[0] > axes[1]) ^ (axes[0] > axes[2]) ^ (axes[1] > axes[2]);
      if (odd)
      {
        std::swap(tet[2], tet[3]);
      }
      cells.push_back({ VTK_TETRA, tet });
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  return MakeGrid(points, cells);
}

Grid MakeSwappedLevel(int volumeScheme)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToBoxSpline();
  filter->SetInputData(MakeKuhnBox(2));
  filter->SetNumberOfLevels(3);
  filter->SetVolumeScheme(volumeScheme);
  filter->Update();
  const Grid level = DeepCopy(filter->GetOutput());
  const vtkIdType size = level->GetNumberOfCells();
  EXPECT_GT(size, 4 * 4096);
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < size; ++i)
  {
    const Ids cell = GetCell(level, i == 1 ? 2 : i == 2 ? 1 : i);
    cells->InsertNextCell(4, cell.data());
  }
  level->SetCells(VTK_TETRA, cells);
  vtkNew<vtkIntArray> flags;
  flags->SetName("Singular");
  for (vtkIdType i = 0; i < size; ++i)
  {
    flags->InsertNextValue(i < 512);
  }
  level->GetCellData()->AddArray(flags);
  return level;
}

Grid MakeRandomComplex(unsigned seed, bool withSolids)
{
  std::mt19937 random(seed);
  auto draw = [&random](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const int n = 7 + draw(8);
  std::vector<Point> points;
  for (int i = 0; i < n; ++i)
  {
    points.push_back({ random() / 4294967296., random() / 4294967296., random() / 4294967296. });
  }
  const int types[4] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_TETRA };
  std::vector<Cell> cells;
  std::vector<int> flags;
  std::map<Ids, int> flagOf; // the same for equal cells
  const int count = 6 + draw(20);
  for (int i = 0; i < count; ++i)
  {
    const int dimension = draw(withSolids ? 4 : 3);
    Ids ids(n);
    std::iota(ids.begin(), ids.end(), 0);
    std::shuffle(ids.begin(), ids.end(), random);
    ids.resize(dimension + 1);
    if (i > 0 && draw(3) == 0) // a face of an earlier cell
    {
      ids = cells[draw(i)].Points;
      ids.resize(std::min<std::size_t>(ids.size(), dimension + 1));
    }
    cells.push_back({ types[ids.size() - 1], ids });
    std::sort(ids.begin(), ids.end());
    flags.push_back(flagOf.emplace(ids, ids.size() < 4 && draw(4) == 0).first->second);
  }
  const Grid grid = MakeGrid(points, cells);
  AddCellArray(grid, "Singular", flags);
  std::vector<int> materials;
  std::vector<int> parts;
  std::vector<int> rules;
  for (int i = 0; i < count; ++i)
  {
    materials.push_back(draw(2));
    parts.push_back(draw(4) - 1);
    rules.push_back(draw(2) ? 0 : draw(7));
  }
  AddCellArray(grid, "MaterialId", materials);
  AddCellArray(grid, "Part", parts);
  AddCellArray(grid, "Rule", rules);
  return grid;
}

Configure RandomOptions(unsigned seed)
{
  std::mt19937 random(seed);
  std::array<int, 11> bits;
  for (int& bit : bits)
  {
    bit = static_cast<int>(random() >> 8);
  }
  return [bits](Filter* filter)
  {
    filter->SetGenerateClassification(true);
    filter->SetCreaseEnd(bits[0] % 2);
    filter->SetEmbeddedCells(bits[1] % 3);
    filter->SetPreserveInterfaces(bits[2] % 2);
    filter->SetType1Rule(bits[3] % 5);
    filter->SetType2Rule(bits[4] % 3);
    filter->SetType3Rule(bits[5] % 2);
    SetCellArray(filter, 2, bits[6] % 2 ? "Part" : "None");
    SetCellArray(filter, 3, bits[7] % 2 ? "Rule" : "None");
    filter->SetDetectFeatures(bits[8] % 2);
    filter->SetLoopWeights(bits[9] % 2);
    filter->SetModifiedBoundary(bits[10] % 2);
  };
}

}
