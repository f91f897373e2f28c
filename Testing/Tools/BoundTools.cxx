// SPDX-License-Identifier: BSD-3-Clause
#include "BoundTools.h"

#include "Private/Bezier/BezierPatches.h"

namespace bound_tools
{
namespace
{

using subdivision::FrameNode;
using subdivision::PatchShape;
using subdivision::Root;
using subdivision::SplitRoots;

/// The weights of the corners at a point of the lattice.
std::array<double, 4> WeighCorners(const PatchShape& shape, const FrameNode& point, int all)
{
  const double x = static_cast<double>(point[0]) / all;
  const double y = static_cast<double>(point[1]) / all;
  const double z = static_cast<double>(point[2]) / all;
  return shape.Corners == shape.Dimension + 1
    ? std::array<double, 4>{ { 1. - x - y - z, x, y, z } }
    : std::array<double, 4>{ { (1. - x) * (1. - y), x * (1. - y), x * y, (1. - x) * y } };
}

/// act(point, weights) for each point of the lattice of a cell.
template <typename Act>
void ForLattice(const PatchShape& shape, int steps, const Act& act)
{
  const int all = 1 << steps;
  const bool isQuad = shape.Corners != shape.Dimension + 1;
  for (int i = 0; i <= all; ++i)
  {
    for (int j = 0; j <= (shape.Dimension > 1 ? all : 0); ++j)
    {
      for (int k = 0; k <= (shape.Dimension > 2 ? all : 0); ++k)
      {
        if (isQuad || i + j + k <= all)
        {
          act(FrameNode{ { i, j, k } }, WeighCorners(shape, { { i, j, k } }, all));
        }
      }
    }
  }
}

/// The largest distance of each cell.
std::vector<double> FindDistances(vtkPointSet* mesh, vtkDataArray* coarse, vtkDataArray* fine,
  const SplitRoots* roots, int steps, const PlacedPoints* placed, vtkIdType& samples)
{
  const int components = coarse->GetNumberOfComponents();
  std::vector<double> distances;
  for (vtkIdType r = 0; r < mesh->GetNumberOfCells(); ++r)
  {
    double most = 0.;
    const auto add = [&](vtkIdType point, const std::array<double, 4>& weights, const Ids& corners)
    {
      double squares = 0.;
      for (int c = 0; c < components; ++c)
      {
        double difference = fine->GetComponent(point, c);
        for (std::size_t k = 0; k < corners.size(); ++k)
        {
          difference -= weights[k] * coarse->GetComponent(corners[k], c);
        }
        squares += difference * difference;
      }
      most = std::max(most, std::sqrt(squares));
      ++samples;
    };
    if (placed && placed->count(r) > 0)
    {
      vtkNew<vtkIdList> ids;
      mesh->GetCellPoints(r, ids);
      const Ids corners(ids->begin(), ids->end());
      for (const PlacedPoint& point : placed->at(r))
      {
        add(point.Point, point.Weights, corners);
      }
    }
    else if (roots->GetRoot(r).Shape == subdivision::CellShape::Vertex)
    {
      const vtkIdType id = roots->GetPoints(roots->GetRoot(r)).Ids[0];
      add(id, { { 1., 0., 0., 0. } }, { id });
    }
    else
    {
      const Root& root = roots->GetRoot(r);
      const PatchShape& shape = subdivision::GetPatchShape(root);
      Ids corners;
      for (const FrameNode& corner : shape.CornerPoints)
      {
        corners.push_back(roots->GetPoint(root, subdivision::GetWhole(root).At(corner, 2)));
      }
      ForLattice(shape, steps, [&](const FrameNode& point, const std::array<double, 4>& weights)
        { add(roots->GetPoint(root, point), weights, corners); });
    }
    distances.push_back(most);
  }
  return distances;
}

}

Grid WithValues(vtkPointSet* mesh)
{
  const auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(mesh->GetPoints());
  grid->SetPoints(points);
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    mesh->GetCellPoints(c, ids);
    grid->InsertNextCell(mesh->GetCellType(c), ids);
  }
  grid->GetCellData()->ShallowCopy(mesh->GetCellData());
  vtkNew<vtkDoubleArray> copy;
  copy->DeepCopy(points->GetData());
  copy->SetName("Copy");
  grid->GetPointData()->AddArray(copy);
  const vtkIdType size = mesh->GetNumberOfPoints();
  grid->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("One", 1, size, -1., 1., 7));
  grid->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("Two", 2, size, 0., 100., 8));
  return grid;
}

double Tightness::GetMedian()
{
  const auto middle = this->Ratios.begin() + static_cast<std::ptrdiff_t>(this->Ratios.size() / 2);
  std::nth_element(this->Ratios.begin(), middle, this->Ratios.end());
  return *middle;
}

double Tightness::GetLargest() const
{
  return *std::max_element(this->Ratios.begin(), this->Ratios.end());
}

void ExpectBounds(vtkPointSet* coarse, vtkPointSet* fine, int steps, Tightness& tightness,
  double rounding, const PlacedPoints* placed)
{
  std::unique_ptr<SplitRoots> roots; // of cells that are not placed
  if (!placed || static_cast<vtkIdType>(placed->size()) < coarse->GetNumberOfCells())
  {
    roots = std::make_unique<SplitRoots>(fine, steps);
    ASSERT_EQ(roots->GetNumberOfRoots(), coarse->GetNumberOfCells());
  }
  std::map<std::string, vtkDataArray*> arrays{ { "", coarse->GetPoints()->GetData() } };
  for (const char* name : { "Copy", "One", "Two" })
  {
    if (vtkDataArray* array = coarse->GetPointData()->GetArray(name))
    {
      arrays[name] = array;
    }
  }
  for (const auto& [name, array] : arrays)
  {
    vtkDataArray* bounds = coarse->GetCellData()->GetArray((name + "ErrorBound").c_str());
    ASSERT_NE(bounds, nullptr) << name;
    ASSERT_EQ(bounds->GetNumberOfTuples(), coarse->GetNumberOfCells());
    vtkDataArray* limits =
      name.empty() ? fine->GetPoints()->GetData() : fine->GetPointData()->GetArray(name.c_str());
    double size = 0.;
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      double range[2];
      array->GetRange(range, c);
      size = std::max({ size, std::abs(range[0]), std::abs(range[1]) });
    }
    const std::vector<double> distances =
      FindDistances(coarse, array, limits, roots.get(), steps, placed, tightness.Samples);
    for (std::size_t c = 0; c < distances.size(); ++c)
    {
      const double bound = bounds->GetComponent(static_cast<vtkIdType>(c), 0);
      ASSERT_LE(distances[c], bound + rounding * size) << name << " in cell " << c;
      ASSERT_TRUE(std::isfinite(bound)) << name << " in cell " << c;
      if (distances[c] > 1e-12 * size) // else it is rounding
      {
        tightness.Ratios.push_back(bound / distances[c]);
      }
    }
  }
}

Configure ChooseFeatures(unsigned bits)
{
  return [bits](vtkMultiDimensionalSubdivision* filter)
  {
    filter->SetDetectFeatures(bits % 2 == 0);
    filter->SetEmbeddedCells(static_cast<int>(bits / 2 % 3));
    filter->SetType1Rule(static_cast<int>(bits / 6 % 5));
    filter->SetType2Rule(static_cast<int>(bits / 30 % 2));
  };
}

void ExpectRatios(Tightness& tightness, std::size_t count, double of99)
{
  std::vector<double>& ratios = tightness.Ratios;
  std::sort(ratios.begin(), ratios.end());
  const std::size_t size = ratios.size();
  ASSERT_GT(size, count);
  const double ninetyNine = ratios[size * 99 / 100];
  std::cout << size << " bounds of cells: median " << ratios[size / 2] << ", 99 of 100 "
            << ninetyNine << ", most " << ratios.back() << "\n";
  EXPECT_LT(ninetyNine, of99);
  EXPECT_LE(ratios.back(), 3.);
}

void PlacesOfParts::Add(
  vtkIdType part, const std::array<double, 4>& weights, vtkIdType cell, const Point& parameters)
{
  this->Parts.push_back(part);
  this->Weights.push_back(weights);
  this->Cells->InsertNextValue(cell);
  this->Parameters->InsertNextTuple(parameters.data());
}

std::array<double, 4> DrawWeights(std::mt19937& random, int corners)
{
  std::array<double, 4> weights{};
  double sum = 0.;
  for (int k = 0; k < corners; ++k)
  {
    weights[k] = -std::log(random() / 4294967296. + 1e-12);
    sum += weights[k];
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

void ExpectBoundsAtPlaces(
  vtkMultiDimensionalSubdivision* filter, vtkUnstructuredGrid* output, const PlacesOfParts& places)
{
  vtkNew<vtkPolyData> limits;
  ASSERT_TRUE(filter->EvaluateLimit(places.Cells, places.Parameters, limits));
  vtkDataArray* bounds = output->GetCellData()->GetArray("ErrorBound");
  vtkDataArray* ofOne = output->GetCellData()->GetArray("OneErrorBound");
  ASSERT_NE(bounds, nullptr);
  vtkDataArray* one = output->GetPointData()->GetArray("One");
  vtkDataArray* limitsOfOne = limits->GetPointData()->GetArray("One");
  for (std::size_t i = 0; i < places.Parts.size(); ++i)
  {
    const vtkIdType part = places.Parts[i];
    const Ids corners = GetCell(output, part);
    Point difference = GetPoint(limits, static_cast<vtkIdType>(i));
    double ofValue = limitsOfOne->GetComponent(static_cast<vtkIdType>(i), 0);
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      const Point p = GetPoint(output, corners[k]);
      for (int x = 0; x < 3; ++x)
      {
        difference[x] -= places.Weights[i][k] * p[x];
      }
      ofValue -= places.Weights[i][k] * one->GetComponent(corners[k], 0);
    }
    const double distance = std::hypot(difference[0], std::hypot(difference[1], difference[2]));
    ASSERT_LE(distance, bounds->GetComponent(part, 0) + 1e-11) << i << " in " << part;
    ASSERT_LE(std::abs(ofValue), ofOne->GetComponent(part, 0) + 1e-11) << i << " in " << part;
  }
}

}
