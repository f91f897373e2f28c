// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenRefinementRandom.cxx
 * vtkRedGreenRefinement with any options on any complex: no error, nothing that is not finite, and
 * conforming where points stay where they are.
 */
#include "RedGreenRefinementTools.h"

#include "vtkSphere.h"

using namespace red_green_refinement_tools;

namespace
{

class Chance
{
public:
  explicit Chance(unsigned seed)
    : Random(seed)
  {
  }
  unsigned operator()(unsigned choices) { return this->Random() % choices; }

private:
  std::mt19937 Random;
};

/// A random complex; for some seeds with cells that repeat points, with points that coincide, very
/// large or very small, and with values that are not finite.
Grid MakeInput(unsigned seed, Chance& pick)
{
  coretest::Mesh mesh = coretest::MakeRandom(seed);
  for (vtkIdType& point : mesh.Cells.Connectivity)
  {
    point = seed % 3 == 0 && pick(12) == 0 ? pick(27) : point;
  }
  const double scale = seed % 7 == 5 ? 1e150 : seed % 7 == 6 ? 1e-150 : 1.;
  for (double& x : mesh.Points)
  {
    x = scale * (seed % 4 == 1 && pick(20) == 0 ? mesh.Points[0] : x);
  }
  const Grid grid = MakeGrid(mesh);
  AddRandomNumbers(grid);
  AddWantedLevels(grid, 3, seed, 0.1);
  AddValues(grid);
  if (seed % 5 == 0)
  {
    grid->GetPointData()->GetArray("V")->SetComponent(
      pick(27), 0, std::numeric_limits<double>::quiet_NaN());
  }
  if (seed % 5 == 1)
  {
    AddGlobalIds(grid, seed);
  }
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    const double values[] = { 0., 0.5, 2., std::numeric_limits<double>::infinity() };
    sharpness->InsertNextValue(values[pick(4)]);
  }
  grid->GetCellData()->AddArray(sharpness);
  grid->GetCellData()->AddArray(
    MakeArray<vtkIntArray>("Flags", 1, grid->GetNumberOfCells(), 0., 1.3, seed));
  return grid;
}

void SetCriteria(Filter* filter, Chance& pick)
{
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(0.5);
  filter->SetRefineByAttributeError(pick(4) == 0);
  filter->SetAttributeErrorKind(static_cast<int>(pick(2)));
  filter->SetAttributeTolerance(0.1 * pick(10));
  filter->SetInputArrayToProcess(5, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "V");
  filter->SetRefineByArrayRange(pick(4) == 0);
  filter->SetArrayRange(0., pick(4));
  filter->SetInputArrayToProcess(6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "V");
  filter->SetRefineByFunction(pick(4) == 0);
  filter->SetImplicitFunction(sphere);
  filter->SetRefineByEdgeLength(pick(5) == 0);
  filter->SetMaximumEdgeLength(0.3 * pick(4));
  filter->SetRefineByGeometricError(pick(4) == 0);
  filter->SetGeometricTolerance(0.02 * pick(4));
  filter->SetRelativeTolerance(pick(2) > 0);
  filter->SetRefineByWantedLevel(pick(3) == 0);
  filter->SetMaximumLevel(static_cast<int>(pick(5)));
  filter->SetMaximumNumberOfCells(500 + pick(3000));
}

void SetFeatures(Filter* filter, Chance& pick)
{
  filter->SetCreaseEnd(static_cast<int>(pick(2)));
  filter->SetLoopWeights(static_cast<int>(pick(2)));
  filter->SetEmbeddedCells(static_cast<int>(pick(3)));
  filter->SetDetectFeatures(pick(2) > 0);
  filter->SetType1Rule(static_cast<int>(pick(5)));
  filter->SetType2Rule(static_cast<int>(pick(2)));
  filter->SetType3Rule(static_cast<int>(pick(2)));
  filter->SetInterpolateIntegers(pick(2) > 0);
  filter->SetGenerateOriginalIds(pick(2) > 0);
  const char* arrays[] = { "Flags", "WantedLevel", nullptr, nullptr, "Sharpness" };
  filter->SetPreserveInterfaces(true);
  for (int index : { 0, 1, 4 })
  {
    if (index == 1 || pick(2) > 0)
    {
      filter->SetInputArrayToProcess(
        index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, arrays[index]);
    }
  }
}

}

TEST(RedGreenRandom, AnyOptionsOnAnyComplex)
{
  int compared = 0;
  for (unsigned seed = 1; seed <= 300; ++seed)
  {
    Chance pick(seed);
    const Grid input = MakeInput(seed, pick);
    Grid current = input;
    bool isInPlace = true;
    const unsigned filters = 1 + pick(3);
    for (unsigned k = 0; k < filters; ++k)
    {
      vtkNew<Messages> messages;
      const bool isLimit = pick(3) == 0;
      current = Refine(
        current,
        [&](Filter* filter)
        {
          SetCriteria(filter, pick);
          SetFeatures(filter, pick);
          filter->SetPlacement(isLimit);
          // Where the limit is asked for, a filter's cells are those of its own input.
          isInPlace = isInPlace && !isLimit && !filter->GetRefineByGeometricError() &&
            filter->GetAttributeErrorKind() == Filter::JUMP;
        },
        messages);
      EXPECT_TRUE(messages->Errors.empty()) << seed;
      vtkIdType bad = 0;
      for (const Ids& cell : GetCells(current))
      {
        for (vtkIdType id : cell)
        {
          const Point p = GetPoint(current, id);
          bad += std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) ? 0 : 1;
        }
      }
      EXPECT_EQ(bad, 0) << seed;
    }
    // Only inputs of which no cell is passed over, and whose volumes are numbers.
    if (isInPlace && seed % 3 > 0 && seed % 7 < 5 && seed % 4 != 1)
    {
      EXPECT_EQ(CheckConformity(input, current), "") << seed;
      ++compared;
    }
  }
  EXPECT_GT(compared, 12);
}
