// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Measures/CellMoments.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Vectors.h"
#include "Private/Reading/SolidCells.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace subdivision
{

using namespace vectors;

namespace
{

constexpr vtkIdType BlockSize = 1024;
constexpr int DensityColumn = 3; ///< of a corner, after its coordinates
constexpr int ValueColumns = 4;

int GetDimension(int type)
{
  return type == VTK_VERTEX                    ? 0
    : type == VTK_LINE                         ? 1
    : type == VTK_TRIANGLE || type == VTK_QUAD ? 2
    : GetFaceTable(type)                       ? 3
                                               : -1; // does not come out of the filter
}

/// The ends of the edge of the level before that a new point halves.
class HalvedEdges
{
public:
  HalvedEdges(vtkUnstructuredGrid* mesh, vtkIdType old)
    : Old(old < 0 ? mesh->GetNumberOfPoints() : old)
    , Ends(std::max<vtkIdType>(mesh->GetNumberOfPoints() - this->Old, 0), { -1, -1 })
  {
    vtkNew<vtkIdList> ids;
    for (const vtkIdType c : InTurn(this->Ends.empty() ? vtkIdType(0) : mesh->GetNumberOfCells()))
    {
      mesh->GetCellPoints(c, ids);
      for (const vtkIdType end : *ids)
      {
        for (const vtkIdType point : *ids)
        {
          this->Add(end, point);
        }
      }
    }
  }
  /// Whether `point` halves an edge between `ends`.
  bool Find(vtkIdType point, std::array<vtkIdType, 2>& ends) const
  {
    if (point < this->Old)
    {
      return false;
    }
    ends = this->Ends[point - this->Old];
    return ends[0] >= 0 && ends[1] >= 0;
  }

private:
  /// The middle of an edge is in cells with its ends, and no other old points; middles of faces and
  /// of cells see more of them.
  void Add(vtkIdType end, vtkIdType point)
  {
    if (end >= this->Old || point < this->Old)
    {
      return;
    }
    auto& ends = this->Ends[point - this->Old];
    if (ends[0] == -1)
    {
      ends[0] = end;
    }
    else if (ends[0] >= 0 && ends[0] != end && ends[1] != end)
    {
      ends =
        ends[1] < 0 ? std::array<vtkIdType, 2>{ ends[0], end } : std::array<vtkIdType, 2>{ -2, -2 };
    }
  }

  vtkIdType Old;
  std::vector<std::array<vtkIdType, 2>> Ends;
};

/// Sums over cells.
class MomentSums
{
public:
  explicit MomentSums(const MomentInput& input)
    : Input(input)
    , Edges(input.Mesh, input.NumberOfOldPoints)
  {
    for (vtkDataArray* values : input.Values)
    {
      this->Components += values->GetNumberOfComponents();
    }
    this->Width = ValueColumns + this->Components;
  }

  MomentRow MakeRow() const
  {
    MomentRow row;
    row.Sums.assign(IntegralMoments + this->Components, 0.);
    row.Largest.assign(
      4 * static_cast<std::size_t>(this->Components), -std::numeric_limits<double>::infinity());
    return row;
  }
  void AddCells(const vtkIdType* cells, vtkIdType size, MomentRow& row) const
  {
    Scratch scratch;
    for (vtkIdType i = 0; i < size; ++i)
    {
      scratch.Sign = this->GetSign(cells[i]);
      this->Read(cells[i], scratch);
      this->AddExtremes(scratch, row);
      this->ForSimplices(this->Input.Mesh->GetCellType(cells[i]), scratch,
        [&](int corners) { this->AddSimplex(corners, scratch, row); });
    }
    row.Cells += static_cast<double>(size);
  }
  /// Adds the derivatives of a cell to the rows of its points.
  void AddGradients(vtkIdType cell, std::vector<double>& rows) const
  {
    Scratch scratch;
    scratch.Sign = this->GetSign(cell);
    this->Read(cell, scratch);
    this->ForSimplices(this->Input.Mesh->GetCellType(cell), scratch,
      [&](int corners) { this->AddSimplexGradients(corners, scratch, rows); });
  }

private:
  /// Corners of a cell.
  struct Mean
  {
    std::array<int, 8> Corners;
    int Size;
  };
  struct Scratch
  {
    double Sign = 1.;
    vtkNew<vtkIdList> Ids;
    std::vector<double> Corners; ///< a row for each: coordinates, density, values
    std::vector<double> Simplex; ///< the same
    std::array<Mean, 4> Means;   ///< of the corners of the simplex; without, it is the cell
    int NumberOfMeans = 0;
    std::vector<double> Values;
  };

  double GetSign(vtkIdType cell) const
  {
    return this->Input.Signs
      ? (*this->Input.Signs)[static_cast<std::size_t>(this->Input.Parents->GetComponent(cell, 0))]
      : 1.;
  }

  /// Appends the values of a point.
  void AddValues(vtkIdType point, std::vector<double>& values) const
  {
    for (vtkDataArray* array : this->Input.Values)
    {
      const std::size_t begin = values.size();
      values.resize(begin + array->GetNumberOfComponents());
      array->GetTuple(point, values.data() + begin);
    }
  }
  void Read(vtkIdType cell, Scratch& scratch) const
  {
    this->Input.Mesh->GetCellPoints(cell, scratch.Ids);
    scratch.Corners.clear();
    for (const vtkIdType id : *scratch.Ids)
    {
      std::array<double, ValueColumns> corner;
      this->Input.Mesh->GetPoint(id, corner.data());
      for (int k = 0; k < 3; ++k)
      {
        corner[k] -= this->Input.Origin[k];
      }
      corner[DensityColumn] = this->Input.Density ? this->Input.Density->GetComponent(id, 0) : 1.;
      scratch.Corners.insert(scratch.Corners.end(), corner.begin(), corner.end());
      this->AddValues(id, scratch.Corners);
    }
  }

  /// Appends the mean of some corners to the simplex, or the only one.
  void AddMean(const int* corners, std::size_t size, Scratch& scratch) const
  {
    Mean& mean = scratch.Means[scratch.NumberOfMeans++];
    mean.Size = static_cast<int>(size);
    std::copy(corners, corners + size, mean.Corners.begin());
    const std::size_t begin = scratch.Simplex.size();
    scratch.Simplex.resize(begin + this->Width, 0.);
    for (std::size_t i = 0; i < size; ++i)
    {
      for (int c = 0; c < this->Width; ++c)
      {
        scratch.Simplex[begin + c] += scratch.Corners[corners[i] * this->Width + c];
      }
    }
    for (int c = 0; c < this->Width; ++c)
    {
      scratch.Simplex[begin + c] /= static_cast<double>(size);
    }
  }

  /// Calls act(corners) for the simplices of a cell.
  template <typename Act>
  void ForSimplices(int type, Scratch& scratch, const Act& act) const
  {
    const auto size = static_cast<int>(scratch.Ids->GetNumberOfIds());
    const SolidFaces* const faces = GetFaceTable(type);
    if (type != VTK_QUAD && (!faces || type == VTK_TETRA))
    {
      scratch.Simplex = scratch.Corners;
      scratch.NumberOfMeans = 0;
      act(size);
      return;
    }
    std::vector<int> all(size);
    std::iota(all.begin(), all.end(), 0);
    // The middle of the cell, and a triangle of each edge and the middle of its face.
    for (int f = 0; f < (faces ? faces->NumberOfFaces : 1); ++f)
    {
      std::vector<int> face = all;
      if (faces)
      {
        face.assign(faces->Faces[f], faces->Faces[f] + (faces->Faces[f][3] < 0 ? 3 : 4));
      }
      const std::size_t triangles = face.size() == 3 ? 1 : face.size();
      for (std::size_t i = 0; i < triangles; ++i)
      {
        scratch.Simplex.clear();
        scratch.NumberOfMeans = 0;
        if (faces)
        {
          this->AddMean(all.data(), all.size(), scratch);
        }
        this->AddMean(&face[i], 1, scratch);
        this->AddMean(&face[(i + 1) % face.size()], 1, scratch);
        triangles == 1 ? this->AddMean(&face[2], 1, scratch)
                       : this->AddMean(face.data(), face.size(), scratch);
        act(faces ? 4 : 3);
      }
    }
  }

  /// The length, area or signed volume of a simplex.
  double FindMeasure(int corners, const Scratch& scratch) const
  {
    double edges[3][3] = {};
    for (int i = 0; i + 1 < corners; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        edges[i][k] = scratch.Simplex[(i + 1) * this->Width + k] - scratch.Simplex[k];
      }
    }
    if (corners < 3)
    {
      return corners == 1 ? 1. : std::hypot(edges[0][0], edges[0][1], edges[0][2]);
    }
    double cross[3];
    vtkMath::Cross(edges[0], edges[1], cross);
    return corners == 3 ? vtkMath::Norm(cross) / 2.
                        : scratch.Sign * vtkMath::Dot(cross, edges[2]) / 6.;
  }

  /// Adds the integrals over a simplex of products of up to three linear functions.
  void AddSimplex(int corners, const Scratch& scratch, MomentRow& row) const
  {
    const double measure = this->FindMeasure(corners, scratch);
    const auto value = [&](int i, int column) { return scratch.Simplex[i * this->Width + column]; };
    const auto sum = [&](const auto& function)
    {
      double total = 0.;
      for (int i = 0; i < corners; ++i)
      {
        total += function(i);
      }
      return total;
    };
    const double ofDensity = sum([&](int i) { return value(i, DensityColumn); });
    const auto pair = [&](int a)
    {
      const double ofA = sum([&](int i) { return value(i, a); });
      const double both = sum([&](int i) { return value(i, a) * value(i, DensityColumn); });
      return measure * (ofA * ofDensity + both) / (corners * (corners + 1.));
    };
    const auto triple = [&](int a, int b)
    {
      const auto sumOf = [&](int c, int d)
      { return sum([&](int i) { return value(i, c) * value(i, d); }); };
      const double ofA = sum([&](int i) { return value(i, a); });
      const double ofB = sum([&](int i) { return value(i, b); });
      const double all =
        sum([&](int i) { return value(i, a) * value(i, b) * value(i, DensityColumn); });
      return measure *
        (ofA * ofB * ofDensity + sumOf(a, b) * ofDensity + sumOf(a, DensityColumn) * ofB +
          sumOf(b, DensityColumn) * ofA + 2. * all) /
        (corners * (corners + 1.) * (corners + 2.));
    };
    row.Sums[MeasureMoment] += measure;
    row.Sums[MassMoment] += measure * ofDensity / corners;
    for (int k = 0; k < 3; ++k)
    {
      row.Sums[FirstMoments + k] += pair(k);
      row.Sums[SecondMoments + k] += triple(k, k);
      row.Sums[SecondMoments + 3 + k] += k == 2 ? triple(0, 2) : triple(k, k + 1);
    }
    for (int c = 0; c < this->Components; ++c)
    {
      row.Sums[IntegralMoments + c] += pair(ValueColumns + c);
    }
  }

  /// The derivatives of the measure of a simplex by its corners.
  std::array<Vector, 4> FindSlopes(int corners, const Scratch& scratch) const
  {
    const auto edge = [&](int from, int to)
    {
      Vector difference;
      for (int k = 0; k < 3; ++k)
      {
        difference[k] =
          scratch.Simplex[to * this->Width + k] - scratch.Simplex[from * this->Width + k];
      }
      return difference;
    };
    std::array<Vector, 4> slopes{};
    if (corners == 2)
    {
      slopes[1] = edge(0, 1);
      vtkMath::Normalize(slopes[1].data());
    }
    else if (corners == 3)
    {
      Vector normal = Cross(edge(0, 1), edge(0, 2));
      vtkMath::Normalize(normal.data());
      slopes[1] = Scale(0.5, Cross(normal, edge(2, 0)));
      slopes[2] = Scale(0.5, Cross(normal, edge(0, 1)));
    }
    else if (corners == 4)
    {
      for (int i = 1; i < 4; ++i)
      {
        slopes[i] = Scale(scratch.Sign / 6., Cross(edge(0, i % 3 + 1), edge(0, (i + 1) % 3 + 1)));
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      slopes[0][k] = -(slopes[1][k] + slopes[2][k] + slopes[3][k]);
    }
    return slopes;
  }

  /// Of what AddSimplex sums, as FindMomentGradients lists it.
  void AddSimplexGradients(int corners, const Scratch& scratch, std::vector<double>& rows) const
  {
    const double measure = this->FindMeasure(corners, scratch);
    const auto slopes = this->FindSlopes(corners, scratch);
    const auto value = [&](int i, int column) { return scratch.Simplex[i * this->Width + column]; };
    const bool hasDensity = this->Input.Density != nullptr;
    const double pairs = corners * (corners + 1.);
    std::vector<double> sums(this->Width, 0.);     // of the corners
    std::vector<double> products(this->Width, 0.); // with the density
    for (int i = 0; i < corners; ++i)
    {
      for (int c = DensityColumn; c < this->Width; ++c)
      {
        sums[c] += value(i, c);
        products[c] += value(i, c) * value(i, DensityColumn);
      }
    }
    const double density = sums[DensityColumn];
    std::vector<double> row;
    const auto append = [&](const Vector& slope)
    { row.insert(row.end(), slope.begin(), slope.end()); };
    for (int i = 0; i < corners; ++i)
    {
      row.clear();
      append(slopes[i]);
      if (hasDensity)
      {
        append(Scale(density / corners, slopes[i]));
        row.push_back(measure / corners);
      }
      int first = ValueColumns;
      for (vtkDataArray* array : this->Input.Values)
      {
        const int end = first + array->GetNumberOfComponents();
        for (int c = first; c < end; ++c)
        {
          append(Scale((sums[c] * density + products[c]) / pairs, slopes[i]));
        }
        row.push_back(measure * (density + value(i, DensityColumn)) / pairs);
        for (int c = first; hasDensity && c < end; ++c)
        {
          row.push_back(measure * (sums[c] + value(i, c)) / pairs);
        }
        first = end;
      }
      this->Spread(row, i, scratch, rows);
    }
  }
  /// Gives the derivatives by a corner of a simplex to the points whose mean it is.
  void Spread(const std::vector<double>& row, int corner, const Scratch& scratch,
    std::vector<double>& rows) const
  {
    const Mean own{ { corner }, 1 };
    const Mean& mean = scratch.NumberOfMeans > 0 ? scratch.Means[corner] : own;
    for (int m = 0; m < mean.Size; ++m)
    {
      const std::size_t begin = row.size() * scratch.Ids->GetId(mean.Corners[m]);
      for (std::size_t i = 0; i < row.size(); ++i)
      {
        rows[begin + i] += row[i] / mean.Size;
      }
    }
  }

  /// How far values at the middles of old edges are away from linear ones tells how far the limit
  /// may be away from them inside the cell.
  void AddExtremes(Scratch& scratch, MomentRow& row) const
  {
    const vtkIdType size = scratch.Ids->GetNumberOfIds();
    std::array<vtkIdType, 2> ends;
    for (int c = 0; c < this->Components; ++c)
    {
      double largest[2] = { -std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity() };
      double bend = 0.;
      for (vtkIdType i = 0; i < size; ++i)
      {
        const double value = scratch.Corners[i * this->Width + ValueColumns + c];
        largest[0] = std::max(largest[0], value);
        largest[1] = std::max(largest[1], -value);
        if (this->Edges.Find(scratch.Ids->GetId(i), ends))
        {
          scratch.Values.clear();
          this->AddValues(ends[0], scratch.Values);
          this->AddValues(ends[1], scratch.Values);
          const double middle = (scratch.Values[c] + scratch.Values[this->Components + c]) / 2.;
          bend = std::max(bend, std::abs(value - middle));
        }
      }
      for (int i = 0; i < 4; ++i)
      {
        double& most = row.Largest[4 * c + i];
        most = std::max(most, largest[i % 2] + (i < 2 ? 0. : bend));
      }
    }
  }

  const MomentInput& Input;
  HalvedEdges Edges;
  int Components = 0;
  int Width = 0;
};

/// The cells of each row, but for ghosts.
std::map<std::pair<int, double>, std::vector<vtkIdType>> ListCells(const MomentInput& input)
{
  std::map<std::pair<int, double>, std::vector<vtkIdType>> lists;
  vtkUnsignedCharArray* const ghosts = input.Mesh->GetCellGhostArray();
  constexpr int notOwn = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  for (const vtkIdType c : InTurn(input.Mesh->GetNumberOfCells()))
  {
    const int dimension = GetDimension(input.Mesh->GetCellType(c));
    if (dimension >= 0 && !(ghosts && (ghosts->GetValue(c) & notOwn) != 0))
    {
      lists[{ dimension, input.Material ? input.Material->GetComponent(c, 0) : 0. }].push_back(c);
    }
  }
  return lists;
}

/// Adds the sums of blocks, one after another, with the parts that rounding left out.
void AddSums(const std::vector<MomentRow>& blocks, MomentRow& row)
{
  std::vector<double> left(row.Sums.size(), 0.);
  for (const MomentRow& block : blocks)
  {
    for (std::size_t i = 0; i < left.size(); ++i)
    {
      const double sum = row.Sums[i] + block.Sums[i];
      left[i] += std::abs(row.Sums[i]) < std::abs(block.Sums[i])
        ? (block.Sums[i] - sum) + row.Sums[i]
        : (row.Sums[i] - sum) + block.Sums[i];
    }
    row.Add(block);
  }
  for (std::size_t i = 0; i < left.size(); ++i)
  {
    row.Sums[i] += left[i];
  }
}

}

void MomentRow::Add(const MomentRow& other)
{
  this->Cells += other.Cells;
  for (std::size_t i = 0; i < this->Sums.size(); ++i)
  {
    this->Sums[i] += other.Sums[i];
  }
  for (std::size_t i = 0; i < this->Largest.size(); ++i)
  {
    this->Largest[i] = std::max(this->Largest[i], other.Largest[i]);
  }
}

void AddMoments(const MomentInput& input, MomentRows& rows)
{
  const MomentSums sums(input);
  for (const auto& [key, cells] : ListCells(input))
  {
    const auto size = static_cast<vtkIdType>(cells.size());
    std::vector<MomentRow> blocks((size + BlockSize - 1) / BlockSize, sums.MakeRow());
    ForRangesOfBlocks(static_cast<vtkIdType>(blocks.size()),
      [&, list = cells.data()](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType b = begin; b < end; ++b)
        {
          const vtkIdType first = b * BlockSize;
          sums.AddCells(list + first, std::min(BlockSize, size - first), blocks[b]);
        }
      });
    AddSums(blocks, rows.try_emplace(key, sums.MakeRow()).first->second);
  }
}

std::vector<double> FindMomentGradients(
  const MomentInput& input, int dimension, const double* material)
{
  const MomentSums sums(input);
  const std::size_t ofDensity = input.Density ? 1 : 0;
  std::size_t width = 3 + 4 * ofDensity;
  for (vtkDataArray* array : input.Values)
  {
    width += 1 + (3 + ofDensity) * array->GetNumberOfComponents();
  }
  std::vector<double> rows(width * input.Mesh->GetNumberOfPoints(), 0.);
  for (const auto& [key, cells] : ListCells(input))
  {
    const bool isAsked = key.first == dimension && (!material || key.second == *material);
    for (const vtkIdType c : InTurn(isAsked ? static_cast<vtkIdType>(cells.size()) : 0))
    {
      sums.AddGradients(cells[c], rows);
    }
  }
  return rows;
}

std::vector<signed char> FindSigns(const MomentInput& input)
{
  const MomentSums sums(input);
  std::vector<double> volumes;
  for (const vtkIdType c : InTurn(input.Mesh->GetNumberOfCells()))
  {
    const auto parent = static_cast<std::size_t>(input.Parents->GetComponent(c, 0));
    volumes.resize(std::max(volumes.size(), parent + 1), 0.);
    if (GetDimension(input.Mesh->GetCellType(c)) == 3)
    {
      MomentRow row = sums.MakeRow();
      sums.AddCells(&c, 1, row);
      volumes[parent] += row.Sums[MeasureMoment];
    }
  }
  std::vector<signed char> signs;
  signs.reserve(volumes.size());
  for (const double volume : InTurn(volumes))
  {
    signs.push_back(volume < 0. ? -1 : 1);
  }
  return signs;
}

}
