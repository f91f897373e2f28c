// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Measures/Measures.h"

#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Reading/ReadableMesh.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace subdivision
{

namespace
{

bool IsMeasured(vtkDataArray* values)
{
  return values && values->GetName() &&
    (values->GetDataType() == VTK_FLOAT || values->GetDataType() == VTK_DOUBLE);
}

/// Parts of the largest summand that rounding may leave.
constexpr double Double = 1e-14;
constexpr double Single = 1e-6;

/// Of the change of a level in the remainder, where the last level is one of the first.
constexpr double FirstWeights[] = { 0., 2., 2., 0.5 };

}

Estimate Extrapolate(const std::vector<double>& levels, double scale, double precision)
{
  // The column of a level: the sums of the levels up to it without the first powers of 1/4.
  const auto find = [&](std::size_t level, std::size_t powers)
  {
    std::vector<double> column(levels.begin() + (level - powers), levels.begin() + level + 1);
    double factor = 1.;
    for (std::size_t p = 1; p <= powers; ++p)
    {
      factor *= 4.;
      for (std::size_t i = 0; i + p <= powers; ++i)
      {
        column[i] = column[i + 1] + (column[i + 1] - column[i]) / (factor - 1.);
      }
    }
    return column[0];
  };
  const std::size_t last = levels.size() - 1;
  // Of a series that may converge slower than it should: what the last levels changed, with as much
  // weight as random meshes need so that the truth is not farther away.
  const auto change = [&](std::size_t level, std::size_t powers)
  { return std::abs(find(level, powers) - find(level - 1, powers)); };
  const double value = find(last, std::min<std::size_t>(last, 2));
  double remainder = last < 4 ? FirstWeights[last] * change(last, 0) : 0.;
  remainder += last == 2 || last == 3 ? FirstWeights[last] / 4. * change(last - 1, 0) : 0.;
  double weight = 1.;
  for (std::size_t level = last; level >= 2 && level + 2 >= last; --level)
  {
    remainder += weight * change(level, 1);
    weight /= 2.;
  }
  return { value, std::max(remainder, precision * scale), scale };
}

bool MeasuredLevels::FindInput(vtkUnstructuredGrid* mesh, MomentInput& input) const
{
  input.Mesh = mesh;
  input.Origin = this->Origin;
  input.Parents = mesh->GetCellData()->GetArray(OriginalCellIdsName);
  for (const Array& array : this->Arrays)
  {
    vtkDataArray* const values = mesh->GetPointData()->GetArray(array.Name.c_str());
    if (!values || values->GetNumberOfComponents() != array.Components)
    {
      this->Options.Fail("Point array \"" + array.Name + "\" is not in all blocks: leave it out.");
      return false;
    }
    input.Values.push_back(values);
  }
  return this->Options.FindArrays(mesh, input.Material, input.Density);
}

void MeasuredLevels::ReadArrays(const std::vector<vtkUnstructuredGrid*>& meshes)
{
  for (vtkUnstructuredGrid* mesh : meshes)
  {
    vtkPointData* const data = mesh->GetPointData();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* const values = data->GetArray(i);
      if (IsMeasured(values))
      {
        this->Arrays.push_back({ values->GetName(), values->GetNumberOfComponents() });
        this->Precision = values->GetDataType() == VTK_FLOAT ? Single : this->Precision;
        this->Components += values->GetNumberOfComponents();
      }
    }
    if (mesh->GetNumberOfPoints() > 0)
    {
      break; // FindInput sees to the others
    }
  }
}

void MeasuredLevels::FindSize(const std::vector<vtkUnstructuredGrid*>& meshes)
{
  vtkBoundingBox box;
  for (vtkUnstructuredGrid* mesh : meshes)
  {
    if (mesh->GetNumberOfPoints() > 0)
    {
      box.AddBounds(mesh->GetBounds());
    }
  }
  if (this->Options.Controller)
  {
    std::vector<double> bounds(6);
    box.GetBounds(bounds.data());
    const auto all = GatherFromRanks(this->Options.Controller, bounds);
    for (std::size_t i = 0; i < all.size(); i += 6)
    {
      box.AddBounds(all.data() + i);
    }
  }
  if (box.IsValid())
  {
    box.GetCenter(this->Origin.data());
    this->Size = box.GetDiagonalLength() / 2.;
  }
}

bool MeasuredLevels::AddControl(vtkDataObject* made)
{
  const auto meshes = ListGrids(made);
  this->FindSize(meshes);
  this->ReadArrays(meshes);
  bool isGood = true;
  for (vtkUnstructuredGrid* mesh : meshes)
  {
    MomentInput input;
    isGood = isGood && (mesh->GetNumberOfPoints() == 0 || this->FindInput(mesh, input));
    this->HasMaterial |= input.Material != nullptr;
    this->HasDensity |= input.Density != nullptr;
    input.Values.clear();
    this->Signs.push_back(isGood && input.Mesh ? FindSigns(input) : std::vector<signed char>());
    this->NumbersOfPoints.push_back(-1);
  }
  if (this->Options.Controller) // a rank may have nothing, and none goes on without the others
  {
    const auto all = GatherFromRanks(this->Options.Controller,
      { isGood ? 0. : 1., this->HasMaterial ? 1. : 0., this->HasDensity ? 1. : 0. });
    for (std::size_t i = 0; i < all.size(); i += 3)
    {
      isGood &= all[i] == 0.;
      this->HasMaterial |= all[i + 1] > 0.;
      this->HasDensity |= all[i + 2] > 0.;
    }
  }
  this->IsRead = isGood;
  return isGood;
}

bool MeasuredLevels::AddLevel(vtkDataObject* made)
{
  const auto meshes = ListGrids(made);
  MomentRows rows;
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    MomentInput input;
    if (meshes[i]->GetNumberOfPoints() == 0)
    {
      continue;
    }
    if (!this->FindInput(meshes[i], input))
    {
      return false;
    }
    input.Signs = &this->Signs[i];
    input.NumberOfOldPoints = this->NumbersOfPoints[i];
    AddMoments(input, rows);
    this->NumbersOfPoints[i] = meshes[i]->GetNumberOfPoints();
  }
  if (this->Options.Controller && !this->ShareRows(rows))
  {
    return false;
  }
  this->Levels.push_back(std::move(rows));
  return true;
}

bool MeasuredLevels::FindGradients(vtkDataObject* made, MeasureGradients& gradients) const
{
  const auto meshes = ListGrids(made);
  MomentInput input;
  if (meshes.size() != 1 || !this->FindInput(meshes[0], input))
  {
    return false;
  }
  input.Signs = &this->Signs[0];
  const auto rows = FindMomentGradients(
    input, gradients.Dimension, gradients.OfAllMaterials ? nullptr : &gradients.Material);
  gradients.OfLevel = vtkSmartPointer<vtkDoubleArray>::New();
  const vtkIdType points = meshes[0]->GetNumberOfPoints();
  gradients.OfLevel->SetNumberOfComponents(
    static_cast<int>(static_cast<vtkIdType>(rows.size()) / std::max<vtkIdType>(points, 1)));
  gradients.OfLevel->SetNumberOfTuples(points);
  std::copy(rows.begin(), rows.end(), gradients.OfLevel->GetPointer(0));
  return true;
}

/// Each rank gets the sums of all, added in the order of the ranks.
bool MeasuredLevels::ShareRows(MomentRows& rows) const
{
  std::vector<double> own;
  for (const auto& [key, row] : rows)
  {
    own.insert(own.end(),
      { static_cast<double>(this->Components), static_cast<double>(key.first), key.second,
        row.Cells });
    own.insert(own.end(), row.Sums.begin(), row.Sums.end());
    own.insert(own.end(), row.Largest.begin(), row.Largest.end());
  }
  const auto all = GatherFromRanks(this->Options.Controller, own);
  rows.clear();
  for (auto at = all.begin(); at != all.end();)
  {
    if (at[0] != all[0])
    {
      this->Options.Fail("The ranks have different point arrays: give all the same.");
      return false;
    }
    const auto components = static_cast<std::ptrdiff_t>(at[0]);
    const Key key{ static_cast<int>(at[1]), at[2] };
    const auto sums = at + 4;
    const auto largest = sums + IntegralMoments + components;
    const MomentRow row{ at[3], { sums, largest }, { largest, largest + 4 * components } };
    at = largest + 4 * components;
    const auto [place, isNew] = rows.try_emplace(key, row);
    if (!isNew)
    {
      place->second.Add(row);
    }
  }
  return true;
}

double MeasuredLevels::CountNextCells() const
{
  double cells = 0.;
  for (const auto& [key, row] : this->Levels.back())
  {
    cells += row.Cells * std::pow(2., key.first);
  }
  return cells;
}

MomentRow MeasuredLevels::TakeRow(int level, const Key& key, bool ofAllMaterials) const
{
  const MomentRows& rows = this->Levels[level];
  if (!ofAllMaterials)
  {
    return rows.at(key);
  }
  auto at = rows.lower_bound({ key.first, -std::numeric_limits<double>::infinity() });
  MomentRow sum = at->second;
  for (++at; at != rows.end() && at->first.first == key.first; ++at)
  {
    sum.Add(at->second);
  }
  return sum;
}

std::vector<double> MeasuredLevels::MakeFigures(const MomentRow& row) const
{
  const double mass = row.Sums[MassMoment];
  const auto divide = [mass](double sum)
  { return std::abs(mass) > std::numeric_limits<double>::min() ? sum / mass : 0.; };
  std::array<double, 3> centroid;
  for (int k = 0; k < 3; ++k)
  {
    centroid[k] = divide(row.Sums[FirstMoments + k]);
  }
  std::array<double, 6> second;
  for (int k = 0; k < 3; ++k)
  {
    const int i = k == 2 ? 0 : k;
    const int j = k == 2 ? 2 : k + 1;
    second[k] = row.Sums[SecondMoments + k] - mass * centroid[k] * centroid[k];
    second[3 + k] = row.Sums[SecondMoments + 3 + k] - mass * centroid[i] * centroid[j];
  }
  std::vector<double> figures{ row.Sums[MeasureMoment], mass, this->Origin[0] + centroid[0],
    this->Origin[1] + centroid[1], this->Origin[2] + centroid[2], second[1] + second[2],
    second[0] + second[2], second[0] + second[1], -second[3], -second[4], -second[5] };
  figures.insert(figures.end(), row.Sums.begin() + IntegralMoments, row.Sums.end());
  for (int c = 0; c < this->Components; ++c)
  {
    figures.push_back(divide(row.Sums[IntegralMoments + c]));
  }
  return figures;
}

std::vector<Estimate> MeasuredLevels::FindLimits(const Key& key, bool ofAllMaterials) const
{
  std::vector<std::vector<double>> levels; // of figures
  MomentRow last;
  for (int level = 0; level < this->GetNumberOfLevels(); ++level)
  {
    last = this->TakeRow(level, key, ofAllMaterials);
    const auto figures = this->MakeFigures(last);
    levels.resize(figures.size());
    for (std::size_t i = 0; i < figures.size(); ++i)
    {
      levels[i].push_back(figures[i]);
    }
  }
  const std::vector<double> scales = this->FindScales(last);
  std::vector<Estimate> limits;
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    limits.push_back(
      Extrapolate(levels[i], scales[i], i < IntegralMoments ? Double : this->Precision));
  }
  // By chance one component may change little: those of a vector or tensor share the largest.
  for (const auto& [first, end] : { std::pair(int(FirstMoments), int(SecondMoments)),
         std::pair(int(SecondMoments), int(IntegralMoments)) })
  {
    double largest = 0.;
    for (int i = first; i < end; ++i)
    {
      largest = std::max(largest, limits[i].Remainder);
    }
    for (int i = first; i < end; ++i)
    {
      limits[i].Remainder = largest;
    }
  }
  for (int c = 0; c < this->Components; ++c)
  {
    const double scale = scales[levels.size() + c];
    for (const int i : { 1, 0 }) // the least, the largest
    {
      const double largest = last.Largest[4 * c + i];
      const double beyond = last.Largest[4 * c + 2 + i] - largest;
      limits.push_back(
        { i == 1 ? -largest : largest, std::max(beyond, this->Precision * scale), scale });
    }
  }
  return limits;
}

std::vector<double> MeasuredLevels::FindScales(const MomentRow& row) const
{
  const double mass = std::abs(row.Sums[MassMoment]);
  const double far = std::hypot(this->Origin[0], this->Origin[1], this->Origin[2]) + this->Size;
  std::vector<double> scales{ std::abs(row.Sums[MeasureMoment]), mass, far, far, far };
  scales.insert(scales.end(), 6, mass * this->Size * this->Size);
  std::vector<double> sizes;
  for (int c = 0; c < this->Components; ++c)
  {
    sizes.push_back(std::max(std::abs(row.Largest[4 * c]), std::abs(row.Largest[4 * c + 1])));
    scales.push_back(mass * sizes.back());
  }
  scales.insert(scales.end(), sizes.begin(), sizes.end()); // of means
  scales.insert(scales.end(), sizes.begin(), sizes.end()); // of extremes
  return scales;
}

bool MeasuredLevels::IsEnough() const
{
  int dimension = -1;
  for (const auto& [key, row] : this->Levels.back())
  {
    if (key.first == dimension)
    {
      continue;
    }
    dimension = key.first;
    const auto limits = this->FindLimits(key, true);
    const std::size_t integrals = limits.size() - 2 * this->Components;
    if (std::any_of(limits.begin(), limits.begin() + static_cast<std::ptrdiff_t>(integrals),
          [this](const Estimate& limit)
          { return limit.Remainder > this->Options.Tolerance * limit.Scale; }))
    {
      return false;
    }
  }
  return true;
}

}
