// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestCurvedMany.cxx
 * Curved cells of all models and of files from elsewhere: random places find no negative
 * determinant where Valid is 1. Levels are nested, and values may jump.
 */
#include "CurvedTools.h"
#include "FileTools.h"
#include "Turns.h"
#include "vtkSubdivisionModelSource.h"

#include <filesystem>

using namespace curved_tools;

namespace
{

/// The determinant of the Jacobian by VTK's derivatives.
double FindExactDeterminant(vtkCell* cell, const Point& at, std::vector<double>& derivatives)
{
  const auto size = static_cast<std::size_t>(cell->GetNumberOfPoints());
  derivatives.resize(3 * size);
  cell->InterpolateDerivs(at.data(), derivatives.data());
  double jacobian[3][3] = {};
  for (std::size_t n = 0; n < size; ++n)
  {
    double p[3];
    cell->GetPoints()->GetPoint(static_cast<vtkIdType>(n), p);
    for (std::size_t k = 0; k < 3; ++k)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        jacobian[k][c] += derivatives[size * k + n] * p[c];
      }
    }
  }
  return vtkMath::Determinant3x3(jacobian);
}

/// What was found in the cells of one mesh.
struct Counts
{
  vtkIdType Solids = 0;
  vtkIdType Invalid = 0;
  vtkIdType Places = 0;
};

/// Draws places in the solids of a grid, some in each.
Counts CheckPlaces(vtkUnstructuredGrid* grid, vtkIdType places, std::mt19937& random)
{
  Counts found;
  vtkDataArray* valid = grid->GetCellData()->GetArray("Valid");
  vtkDataArray* scaled = grid->GetCellData()->GetArray("ScaledJacobian");
  if (!valid)
  {
    return found;
  }
  const vtkIdType each = 1 + places / std::max<vtkIdType>(1, grid->GetNumberOfCells());
  vtkNew<vtkGenericCell> cell;
  std::vector<double> derivatives;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    grid->GetCell(c, cell);
    if (cell->GetCellDimension() < 3)
    {
      EXPECT_EQ(valid->GetComponent(c, 0), 1.);
      continue;
    }
    ++found.Solids;
    const bool isValid = valid->GetComponent(c, 0) == 1.;
    EXPECT_EQ(isValid, scaled->GetComponent(c, 0) > 0.) << c;
    found.Invalid += isValid ? 0 : 1;
    double first = 0.; // wedges are in use in both orders
    for (vtkIdType i = 0; isValid && i < each && found.Places < places; ++i, ++found.Places)
    {
      const Point at = DrawPlace(cell, random);
      double value = FindExactDeterminant(cell, at, derivatives);
      if (cell->GetCellType() == VTK_QUADRATIC_PYRAMID) // VTK has wrong derivatives of it
      {
        value = FindDeterminant(cell, at);
      }
      first = i == 0 && cell->GetCellType() == VTK_QUADRATIC_WEDGE ? value : first;
      EXPECT_GT(first < 0. ? -value : value, 0.) << c;
    }
  }
  return found;
}

/// The least determinant of a solid with straight edges, as a part of its size.
double FindLeastOfStraight(vtkCell* cell, std::mt19937& random)
{
  const std::size_t corners = CountCorners(cell);
  vtkNew<vtkGenericCell> straight;
  straight->SetCellType(corners == 4 ? VTK_TETRA
      : corners == 8                 ? VTK_HEXAHEDRON
      : corners == 6                 ? VTK_WEDGE
                                     : VTK_PYRAMID);
  for (std::size_t i = 0; i < corners; ++i)
  {
    double p[3];
    cell->GetPoints()->GetPoint(static_cast<vtkIdType>(i), p);
    straight->GetPoints()->SetPoint(static_cast<vtkIdType>(i), p);
  }
  double bounds[6];
  straight->GetPoints()->ComputeBounds();
  straight->GetPoints()->GetBounds(bounds);
  const double size =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  double least = 1e300;
  for (int i = 0; i < 500; ++i)
  {
    Point at = DrawPlace(straight, random);
    if (i % 2 == 0 && corners != 5) // most are least at corners
    {
      std::copy_n(straight->GetParametricCoords() + 3 * (i / 2 % corners), 3, at.begin());
    }
    least = std::min(least, FindDeterminant(straight, at));
  }
  return least / (size * size * size);
}

/// A mesh as curved cells: each solid that is not valid is in an error, each move in a warning. The
/// first cell that the error names is inside out, or flat, even where it is straight.
Counts CheckMesh(vtkUnstructuredGrid* input, const std::string& name, int levels, int order,
  vtkIdType places, std::mt19937& random)
{
  const std::string which =
    name + ", levels " + std::to_string(levels) + ", order " + std::to_string(order);
  SCOPED_TRACE(which);
  std::cout << which << std::flush;
  vtkNew<Filter> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputData(input);
  filter->SetNumberOfLevels(levels);
  SetOrder(filter, order);
  filter->Update();
  const Counts found = CheckPlaces(filter->GetOutput(), places, random);
  std::string told;
  for (const auto* texts : { &messages->Warnings, &messages->Errors })
  {
    for (const std::string& text : *texts)
    {
      told += text.find("curved solids") != std::string::npos ? "\n  " + text : "";
    }
  }
  std::cout << ": " << found.Solids << " solids, " << found.Invalid << " not valid, "
            << found.Places << " places" << told << "\n";
  const std::string named = "even with straight edges, the first is cell ";
  const std::size_t at = told.find(named);
  EXPECT_EQ(found.Invalid > 0, at != std::string::npos);
  if (at != std::string::npos)
  {
    const vtkIdType cell = std::stoll(told.substr(at + named.size()));
    EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("Valid")->GetComponent(cell, 0), 0.);
    EXPECT_LT(FindLeastOfStraight(filter->GetOutput()->GetCell(cell), random), 1e-6);
  }
  return found;
}

}

/// 10^6 places in the cells of all models, at levels 0 to 3.
TEST(CurvedMany, ModelsHaveNoNegativeDeterminant)
{
  std::mt19937 random(3);
  vtkIdType places = 0;
  for (int model = 0; model < vtkSubdivisionModelSource::NUMBER_OF_MODELS; ++model)
  {
    const Grid input = LoadModel(model);
    const int most = input->GetNumberOfCells() < 300 ? 3 : 2;
    for (int levels = 0; levels <= most; ++levels)
    {
      if (turns::IsNextInTurn())
      {
        const std::string name = "model " + std::to_string(model);
        places += CheckMesh(input, name, levels, 0, 60000, random).Places;
        levels == 0 ? void(CheckMesh(input, name, 0, 4, 2000, random)) : void();
      }
    }
  }
  EXPECT_GT(places, turns::GetTurn() < 0 ? 1000000 : 100000);
}

TEST(CurvedMany, SharedFilesHaveNoNegativeDeterminant)
{
  const std::filesystem::path folder = file_tools::GetSharedFile("");
  if (!std::filesystem::is_directory(folder))
  {
    GTEST_SKIP() << folder << " is not there";
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    entry.path().extension() == ".vtu" ? files.push_back(entry.path()) : void();
  }
  std::sort(files.begin(), files.end());
  std::mt19937 random(4);
  int others = 0;
  for (const auto& file : files)
  {
    if (!turns::IsNextInTurn() || !file_tools::WhyNotRead(file.string()).empty())
    {
      continue;
    }
    const Grid input = file_tools::ReadGrid(file.string());
    const vtkIdType cells = input->GetNumberOfCells();
    const int most = cells < 100 ? 3 : cells < 2000 ? 2 : cells < 20000 ? 1 : 0;
    vtkIdType solids = 0;
    for (int levels = 0; levels <= most && cells < 200000 && solids < 10000; ++levels)
    {
      const Counts found = CheckMesh(input, file.filename().string(), levels, 0, 10000, random);
      solids = found.Solids;
      others += found.Invalid > 0 ? 1 : 0;
    }
  }
  std::cout << others << " meshes have solids that are inside out even where they are straight\n";
}

/// The nodes of a level are the first of the next, and these cells are halves of those by
/// parameters.
TEST(CurvedMany, LevelsAreNested)
{
  const Grid input = MakeUprightMixed();
  for (const int order : { 0, 1, 2, 4 })
  {
    const auto make = [&](int levels)
    {
      return Execute(
        input, levels,
        [order](Filter* filter)
        {
          filter->SetVolumeSchemeToBoxSpline();
          SetOrder(filter, order);
        },
        vtkNew<Messages>());
    };
    const Grid coarse = make(0);
    const Grid fine = make(1);
    vtkDataArray* values[2] = { coarse->GetPointData()->GetArray("Scalar"),
      fine->GetPointData()->GetArray("Scalar") };
    ASSERT_LT(coarse->GetNumberOfPoints(), fine->GetNumberOfPoints());
    for (vtkIdType i = 0; i < coarse->GetNumberOfPoints(); ++i)
    {
      // Points may have been repaired in one of both; values are not.
      EXPECT_NEAR(values[0]->GetComponent(i, 0), values[1]->GetComponent(i, 0), 1e-13) << order;
    }
  }
}

/// Where values jump between materials nodes are doubled, and each side has its own values.
TEST(CurvedMany, NodesAreDoubledWhereValuesJump)
{
  const Grid input = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 4, 2, 3 } } });
  const auto add = [&](const char* name, double first, double second)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->InsertNextValue(first);
    array->InsertNextValue(second);
    input->GetCellData()->AddArray(array);
  };
  add("MaterialId", 1, 2);
  add("Density", 3, 7);
  for (const int order : { 0, 4 })
  {
    const auto make = [&](bool jumps)
    {
      return Execute(
        input, 1,
        [&](Filter* filter)
        {
          filter->PreserveInterfacesOn();
          SetOrder(filter, order);
          if (jumps)
          {
            filter->SetInterfaceValuesToDiscontinuous();
            filter->AddFieldOfCells("Density");
          }
        },
        vtkNew<Messages>());
    };
    const Grid joined = make(false);
    const Grid torn = make(true);
    // A triangle after one level, with nodes of one or two levels more.
    const vtkIdType edge = order == 0 ? 4 : 8;
    EXPECT_EQ(torn->GetNumberOfPoints() - joined->GetNumberOfPoints(), (edge + 1) * (edge + 2) / 2);
    vtkDataArray* density = torn->GetPointData()->GetArray("Density");
    ASSERT_NE(density, nullptr);
    for (vtkIdType c = 0; c < torn->GetNumberOfCells(); ++c)
    {
      const double own = torn->GetCellData()->GetArray("Density")->GetComponent(c, 0);
      for (const vtkIdType node : GetCell(torn, c))
      {
        EXPECT_NEAR(density->GetComponent(node, 0), own, 1e-12);
      }
    }
  }
}
