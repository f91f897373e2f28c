// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestFeaturesMarksSharpness.cxx
 * Creases and surfaces between marked points that stay sharp for some levels are those of lines and
 * triangles with a sharpness.
 */
#include "MarkTools.h"

using namespace feature_tools;

namespace
{

/// Numbers of levels for each point: none, fractions, whole ones, infinitely many.
std::vector<double> AddLevels(vtkPointSet* mesh)
{
  constexpr double values[] = { 0., 0.5, 1., 2.5, std::numeric_limits<double>::infinity(), 2.5 };
  vtkNew<vtkDoubleArray> array;
  array->SetName("Levels");
  std::vector<double> levels;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    levels.push_back(values[p % 6]);
    array->InsertNextValue(levels.back());
  }
  mesh->GetPointData()->AddArray(array);
  return levels;
}

void SetSemiSharp(Filter* filter)
{
  SetMarks(filter);
  SetMeaning(filter, { false, true, true });
  filter->SetInputArrayToProcess(9, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Levels");
}

/// The lines and triangles of `cells` that stay sharp for some levels, and all other cells.
std::vector<Cell> DropSmooth(
  const std::vector<Cell>& cells, const std::vector<double>& levels, std::vector<double>& sharpness)
{
  std::vector<Cell> kept;
  for (const Cell& cell : cells)
  {
    const bool hasSharpness = cell.Type == VTK_LINE || cell.Type == VTK_TRIANGLE;
    double own = hasSharpness ? std::numeric_limits<double>::infinity() : 0.;
    for (const vtkIdType point : cell.Points)
    {
      own = std::min(own, levels[point]);
    }
    if (!hasSharpness || own > 0.)
    {
      kept.push_back(cell);
      sharpness.push_back(own);
    }
  }
  return kept;
}

/// As AddFlagged, but lines and triangles have a sharpness.
Grid AddSharp(
  vtkUnstructuredGrid* mesh, const std::vector<Cell>& cells, const std::vector<double>& sharpness)
{
  const Grid flagged = AddFlagged(mesh, cells);
  vtkDataArray* flags = flagged->GetCellData()->GetArray("Singular");
  vtkNew<vtkDoubleArray> array;
  array->SetName("Sharpness");
  for (vtkIdType c = 0; c < flagged->GetNumberOfCells(); ++c)
  {
    const vtkIdType own = c - mesh->GetNumberOfCells();
    array->InsertNextValue(own < 0 ? 0. : sharpness[own]);
    if (own >= 0 && sharpness[own] > 0.)
    {
      flags->SetComponent(c, 0, 0.);
    }
  }
  flagged->GetCellData()->AddArray(array);
  return flagged;
}

}

TEST(FeaturesMarks, StaySharpForSomeLevelsAsLinesDo)
{
  for (const Grid& mesh : MakeMarkMeshes())
  {
    const std::vector<char> marked = Draw(mesh->GetNumberOfPoints(), 0.7, 3);
    std::vector<double> sharpness;
    const std::vector<Cell> cells =
      DropSmooth(FindMarked(mesh, ExecuteQuietly(mesh, 0, {}), marked, { false, true, true }),
        AddLevels(mesh), sharpness);
    AddMarks(mesh, marked);
    const Grid flagged = AddSharp(mesh, cells, sharpness);
    for (const bool limit : { false, true })
    {
      for (const int levels : { 0, 1, 3 })
      {
        const Grid made = ExecuteQuietly(mesh, levels,
          [&](Filter* filter)
          {
            filter->SetProjectToLimit(limit);
            SetSemiSharp(filter);
          });
        ExpectSame(made,
          ExecuteQuietly(flagged, levels,
            [&](Filter* filter)
            {
              filter->SetProjectToLimit(limit);
              SetCellArray(filter, 4, "Sharpness");
            }));
        if (HasFatalFailure())
        {
          return;
        }
      }
    }
    // The same by geometry.
    const Grid geometry = MakeGrid(std::vector<Point>(mesh->GetNumberOfPoints()), cells);
    vtkNew<vtkDoubleArray> array;
    array->SetName("Sharpness");
    for (const double value : sharpness)
    {
      array->InsertNextValue(value);
    }
    geometry->GetCellData()->AddArray(array);
    const Grid made = ExecuteQuietly(mesh, 2,
      [&](Filter* filter)
      {
        filter->SetInputDataObject(2, geometry);
        filter->SetCreasePointsToSameId();
      });
    ExpectSame(made,
      ExecuteQuietly(flagged, 2, [](Filter* filter) { SetCellArray(filter, 4, "Sharpness"); }));
  }
}

TEST(FeaturesMarks, ThatStaySharpForSomeLevelsGoOn)
{
  for (const Grid& mesh : MakeMarkMeshes())
  {
    AddMarks(mesh, Draw(mesh->GetNumberOfPoints(), 0.7, 3));
    AddLevels(mesh);
    const Configure detecting = [](Filter* filter)
    {
      SetSemiSharp(filter);
      filter->SetDetectFeatures(true);
    };
    const Grid once = ExecuteQuietly(mesh, 4, detecting);
    const Grid first = ExecuteQuietly(mesh, 1, detecting);
    EXPECT_EQ(Compare(once, ExecuteQuietly(ExecuteQuietly(first, 2, detecting), 1, {})), "");
    EXPECT_EQ(Compare(once, ExecuteQuietly(first, 3, {})), "");
    // A cache that has seen the same cells with another sharpness.
    vtkNew<Filter> filter;
    vtkNew<Messages> messages; // random solids are thin
    messages->Watch(filter);
    filter->SetNumberOfLevels(2);
    filter->SetVolumeSchemeToBoxSpline();
    SetSemiSharp(filter);
    filter->SetInputDataObject(mesh);
    filter->Update();
    const Grid other = DeepCopy(mesh);
    other->GetPointData()->GetArray("Levels")->Fill(1.);
    filter->SetInputDataObject(other);
    filter->Update();
    EXPECT_EQ(Compare(filter->GetOutput(), ExecuteQuietly(other, 2, SetSemiSharp)), "");
  }
}
