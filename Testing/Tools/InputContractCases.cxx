// SPDX-License-Identifier: BSD-3-Clause
#include "InputContractCases.h"

#include "vtkBitArray.h"
#include "vtkCharArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkTable.h"

namespace input_contract
{
namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinite = std::numeric_limits<double>::infinity();

template <typename Array>
vtkSmartPointer<Array> MakeNamed(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

template <typename Array>
vtkSmartPointer<Array> MakeFilled(const char* name, vtkIdType tuples, double value)
{
  auto array = MakeNamed<Array>(name, 1, tuples);
  array->FillComponent(0, value);
  return array;
}

Case Scale(double factor)
{
  return [factor](Trial& trial)
  {
    for (Point& p : trial.Points)
    {
      for (double& x : p)
      {
        x *= factor;
      }
    }
  };
}

Case MoveLast(const Point& to)
{
  return [to](Trial& trial) { trial.Points[4] = to; };
}

/// Cells beside the two tetrahedra.
Case Add(const std::vector<Cell>& cells)
{
  return [cells](Trial& trial)
  { trial.Cells.insert(trial.Cells.end(), cells.begin(), cells.end()); };
}

Case AddToPoints(const std::function<vtkSmartPointer<vtkAbstractArray>()>& make)
{
  return [make](Trial& trial)
  { trial.Change = [make](vtkUnstructuredGrid* grid) { grid->GetPointData()->AddArray(make()); }; };
}

Case AddToCells(
  const std::function<vtkSmartPointer<vtkAbstractArray>()>& make, const Configure& set = nullptr)
{
  return [=](Trial& trial)
  {
    trial.Set = set;
    trial.Change = [make](vtkUnstructuredGrid* grid) { grid->GetCellData()->AddArray(make()); };
  };
}

/// The tetrahedra have points of their own, so far apart.
void PartAt(Trial& trial, double distance)
{
  const double z = 1. + distance;
  trial.Points.insert(trial.Points.end(), { { z, 0, 0 }, { 0, z, 0 }, { 0, 0, z } });
  trial.Cells[1].Points = { 5, 6, 7, 4 };
}

/// Points that become one have the values 0 and 1.
void MergeValues(Trial& trial, int rule)
{
  PartAt(trial, 0.);
  trial.Change = [](vtkUnstructuredGrid* grid)
  {
    const auto values = MakeFilled<vtkDoubleArray>("values", 8, 0.);
    std::fill(values->GetPointer(4), values->GetPointer(4) + 4, 1.);
    grid->GetPointData()->AddArray(values);
  };
  trial.Set = [rule](Filter* filter)
  {
    filter->MergePointsOn();
    filter->SetMergedValues(rule);
  };
}

/// Triangles beside one another, of which one has a point in the middle of the edge.
void AddHanging(Trial& trial)
{
  trial.Points = { { 0, 0, 0 }, { 2, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 1, -1, 0 } };
  trial.Cells = { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 3, 0, 4 } },
    { VTK_TRIANGLE, { 1, 3, 4 } } };
}

Case With(const Configure& set)
{
  return [set](Trial& trial) { trial.Set = set; };
}

Case Ghosts(const std::vector<unsigned char>& types)
{
  return AddToCells(
    [types]() -> vtkSmartPointer<vtkAbstractArray>
    {
      const auto array = MakeNamed<vtkUnsignedCharArray>(
        vtkDataSetAttributes::GhostArrayName(), 1, static_cast<vtkIdType>(types.size()));
      std::copy(types.begin(), types.end(), array->GetPointer(0));
      return array;
    });
}

/// The tetrahedra in blocks: each of a block of its own, or, with several `values`, both in a block
/// for each of these; `shift`: how far apart the blocks are along x.
Case InBlocks(
  const std::vector<double>& values, double shift, bool withIds, bool areNeighbours = false)
{
  return [=](Trial& trial)
  {
    const auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    const bool areParts = values.size() == 1 || areNeighbours;
    for (unsigned int b = 0; b < 2; ++b)
    {
      const Cell cell = trial.Cells[b];
      std::vector<Point> points = trial.Points;
      for (Point& p : points)
      {
        p[0] += b * shift;
      }
      const Grid grid = MakeGrid(
        areParts ? std::vector<Point>() : points, areParts ? std::vector<Cell>() : trial.Cells);
      if (areParts)
      {
        std::vector<Point> own;
        for (const vtkIdType id : cell.Points)
        {
          own.push_back(points[id]);
        }
        grid->ShallowCopy(MakeGrid(own, { { VTK_TETRA, { 0, 1, 2, 3 } } }));
      }
      grid->GetPointData()->AddArray(
        MakeFilled<vtkDoubleArray>("values", grid->GetNumberOfPoints(), values[b % values.size()]));
      if (withIds)
      {
        const auto ids = MakeNamed<vtkIdTypeArray>("ids", 1, grid->GetNumberOfPoints());
        std::iota(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues(), 0);
        grid->GetPointData()->SetGlobalIds(ids);
      }
      blocks->SetBlock(b, grid);
    }
    trial.Other = blocks;
  };
}

Case GlobalIds(const std::vector<vtkIdType>& ids)
{
  return [ids](Trial& trial)
  {
    trial.Change = [ids](vtkUnstructuredGrid* grid)
    {
      const auto array = MakeNamed<vtkIdTypeArray>("ids", 1, static_cast<vtkIdType>(ids.size()));
      std::copy(ids.begin(), ids.end(), array->GetPointer(0));
      grid->GetPointData()->SetGlobalIds(array);
    };
  };
}

void SetSharpness(Filter* filter)
{
  SetCellArray(filter, 4, "Sharpness");
}

Case Sharpness(double value)
{
  return [value](Trial& trial)
  {
    trial.Cells.push_back({ VTK_LINE, { 1, 2 } });
    trial.Set = SetSharpness;
    trial.Change = [value](vtkUnstructuredGrid* grid)
    { grid->GetCellData()->AddArray(MakeFilled<vtkDoubleArray>("Sharpness", 3, value)); };
  };
}

}

const std::map<std::string, Case>& GetCases()
{
  static const std::map<std::string, Case> cases = {
    { "usual", [](Trial&) {} },
    // Coordinates
    { "nan-coordinate", MoveLast({ 1, NaN, 1 }) },
    { "infinite-coordinate", MoveLast({ 1, 1, -Infinite }) },
    { "huge-coordinates", Scale(1e300) },
    { "tiny-coordinates", Scale(1e-300) },
    { "nan-unused-point", [](Trial& trial) { trial.Points.push_back({ NaN, 0, 0 }); } },
    // Ids and types of cells
    { "id-too-large", Add({ { VTK_TETRA, { 0, 1, 2, 5 } } }) },
    { "id-negative", Add({ { VTK_TRIANGLE, { 0, -1, 2 } } }) },
    { "id-repeated", Add({ { VTK_TETRA, { 0, 1, 2, 2 } } }) },
    { "polygon-repeated", Add({ { VTK_POLYGON, { 0, 1, 4, 4, 2 } } }) },
    { "polygon-keyhole",
      [](Trial& trial)
      {
        trial.Points = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 0, 3, 0 }, { 1, 1, 0 },
          { 2, 1, 0 }, { 2, 2, 0 }, { 1, 2, 0 } };
        trial.Cells = { { VTK_POLYGON, { 0, 1, 2, 3, 0, 4, 7, 6, 5, 4 } } };
      } },
    { "hexahedron-collapsed",
      [](Trial& trial)
      {
        trial.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
          { 1, 0, 1 } };
        trial.Cells = { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 5, 4 } } };
      } },
    { "too-few-points", Add({ { VTK_TRIANGLE, { 0, 1 } } }) },
    { "unknown-type", Add({ { VTK_CONVEX_POINT_SET, { 0, 1, 2, 4 } } }) },
    { "empty-cell", Add({ { VTK_EMPTY_CELL, {} } }) },
    { "quadratic-cell",
      [](Trial& trial)
      {
        trial.Points.push_back({ 0.5, 0.5, 0 });
        trial.Cells.push_back({ VTK_QUADRATIC_EDGE, { 1, 2, 5 } });
      } },
    // Shapes
    { "inverted", [](Trial& trial) { trial.Cells[1].Points = { 1, 3, 2, 4 }; } },
    { "flat", MoveLast({ 1. / 3, 1. / 3, 1. / 3 }) },
    { "no-size", [](Trial& trial) { trial.Points.assign(5, { 1, 1, 1 }); } },
    { "duplicate-cell", Add({ { VTK_TETRA, { 3, 2, 1, 0 } } }) },
    { "face-of-a-cell", Add({ { VTK_TRIANGLE, { 0, 1, 2 } } }) },
    { "overlapping-quads",
      Add({ { VTK_QUAD, { 0, 1, 4, 2 } }, { VTK_TRIANGLE, { 0, 1, 4 } },
        { VTK_TRIANGLE, { 0, 1, 2 } } }) },
    { "polygon-crossing", Add({ { VTK_POLYGON, { 0, 2, 1, 4, 3 } } }) },
    // Points
    { "coincident-points",
      [](Trial& trial)
      {
        trial.Points.insert(trial.Points.end(), { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
        trial.Cells[1].Points = { 5, 6, 7, 4 };
      } },
    { "coincident-merged",
      [](Trial& trial)
      {
        GetCases().at("coincident-points")(trial);
        trial.Set = [](Filter* filter) { filter->MergePointsOn(); };
      } },
    { "near-points", [](Trial& trial) { PartAt(trial, 1e-8); } },
    { "near-merged",
      [](Trial& trial)
      {
        PartAt(trial, 1e-8);
        trial.Set = [](Filter* filter)
        {
          filter->MergePointsOn();
          filter->SetMergeTolerance(1e-6);
        };
      } },
    { "merged-values", [](Trial& trial) { MergeValues(trial, Filter::FIRST_VALUE); } },
    { "merged-average", [](Trial& trial) { MergeValues(trial, Filter::AVERAGE_VALUE); } },
    { "merged-kept", [](Trial& trial) { MergeValues(trial, Filter::KEEP_VALUES); } },
    { "hanging-node", [](Trial& trial) { AddHanging(trial); } },
    { "hanging-closed",
      [](Trial& trial)
      {
        AddHanging(trial);
        trial.Set = [](Filter* filter) { filter->CloseHangingNodesOn(); };
      } },
    { "unused-points", [](Trial& trial) { trial.Points.resize(1000, { 5, 5, 5 }); } },
    // Arrays
    { "nan-in-point-array",
      AddToPoints([] { return MakeFilled<vtkDoubleArray>("values", 5, NaN); }) },
    { "value-missing",
      AddToPoints(
        []
        {
          const auto array = MakeFilled<vtkDoubleArray>("values", 5, 1.);
          array->SetComponent(4, 0, NaN);
          return array;
        }) },
    { "value-masked",
      [](Trial& trial)
      {
        AddToPoints([] { return MakeFilled<vtkDoubleArray>("values", 5, 1.); })(trial);
        const auto before = trial.Change;
        trial.Change = [before](vtkUnstructuredGrid* grid)
        {
          before(grid);
          const auto mask = MakeFilled<vtkCharArray>("vtkValidPointMask", 5, 1.);
          mask->SetComponent(4, 0, 0.);
          grid->GetPointData()->AddArray(mask);
        };
      } },
    { "interpolated-value-missing",
      [](Trial& trial)
      {
        AddToPoints(
          []
          {
            const auto array = MakeFilled<vtkDoubleArray>("values", 5, 1.);
            array->SetComponent(4, 0, Infinite);
            return array;
          })(trial);
        With([](Filter* filter) { filter->InterpolateArraysOn(); })(trial);
      } },
    { "infinite-in-cell-array",
      AddToCells([] { return MakeFilled<vtkDoubleArray>("values", 2, Infinite); }) },
    { "point-array-short",
      AddToPoints([] { return MakeFilled<vtkDoubleArray>("values", 4, 1.); }) },
    { "point-array-long", AddToPoints([] { return MakeFilled<vtkDoubleArray>("values", 6, 1.); }) },
    { "cell-array-short", AddToCells([] { return MakeFilled<vtkDoubleArray>("values", 1, 1.); }) },
    { "cell-array-long", AddToCells([] { return MakeFilled<vtkDoubleArray>("values", 3, 1.); }) },
    { "array-empty", AddToPoints([] { return MakeNamed<vtkDoubleArray>("values", 3, 0); }) },
    { "array-without-name",
      AddToPoints(
        []
        {
          const auto array = MakeFilled<vtkDoubleArray>("", 5, 1.);
          array->SetName(nullptr);
          return array;
        }) },
    { "many-components",
      AddToPoints(
        []
        {
          const auto array = MakeNamed<vtkFloatArray>("values", 100000, 5);
          array->Fill(1.);
          return array;
        }) },
    { "strings", AddToPoints([] { return MakeNamed<vtkStringArray>("names", 1, 5); }) },
    { "bits", AddToPoints([] { return MakeFilled<vtkBitArray>("bits", 5, 1.); }) },
    { "lookup-table",
      AddToPoints(
        []
        {
          const auto values = MakeFilled<vtkIntArray>("values", 5, 1.);
          values->SetLookupTable(vtkNew<vtkLookupTable>());
          return values;
        }) },
    { "pedigree-ids",
      [](Trial& trial)
      {
        trial.Change = [](vtkUnstructuredGrid* grid)
        { grid->GetCellData()->SetPedigreeIds(MakeFilled<vtkIdTypeArray>("ids", 2, 7.)); };
      } },
    { "pedigree-ids-short",
      [](Trial& trial)
      {
        trial.Change = [](vtkUnstructuredGrid* grid)
        { grid->GetPointData()->SetPedigreeIds(MakeFilled<vtkIdTypeArray>("ids", 4, 7.)); };
      } },
    { "global-ids-short", GlobalIds({ 7, 8 }) },
    { "global-ids-equal", GlobalIds({ 7, 7, 7, 7, 7 }) },
    // Arrays that options name
    { "array-missing", With([](Filter* filter) { SetCellArray(filter, 0, "None here"); }) },
    { "flags-of-floats",
      AddToCells([] { return MakeFilled<vtkDoubleArray>("flags", 2, 0.5); },
        [](Filter* filter) { SetCellArray(filter, 0, "flags"); }) },
    { "flags-of-strings",
      AddToCells([] { return MakeNamed<vtkStringArray>("flags", 1, 2); },
        [](Filter* filter) { SetCellArray(filter, 0, "flags"); }) },
    { "flags-of-solids",
      AddToCells([] { return MakeFilled<vtkIntArray>("flags", 2, 1.); },
        [](Filter* filter) { SetCellArray(filter, 0, "flags"); }) },
    { "sharpness-nan", Sharpness(NaN) },
    { "sharpness-negative", Sharpness(-1.) },
    { "sharpness-infinite", Sharpness(Infinite) },
    { "no-materials", With([](Filter* filter) { filter->PreserveInterfacesOn(); }) },
    // Ghosts
    { "hidden-cell", Ghosts({ vtkDataSetAttributes::HIDDENCELL, 0 }) },
    { "all-hidden",
      Ghosts({ vtkDataSetAttributes::HIDDENCELL, vtkDataSetAttributes::HIDDENCELL }) },
    { "refined-cell", Ghosts({ vtkDataSetAttributes::REFINEDCELL, 0 }) },
    { "hidden-point",
      [](Trial& trial)
      {
        trial.Change = [](vtkUnstructuredGrid* grid)
        {
          const auto types =
            MakeFilled<vtkUnsignedCharArray>(vtkDataSetAttributes::GhostArrayName(), 5, 0.);
          types->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
          grid->GetPointData()->AddArray(types);
        };
      } },
    { "duplicate-ghost", Ghosts({ vtkDataSetAttributes::DUPLICATECELL, 0 }) },
    { "duplicate-thin",
      [](Trial& trial)
      {
        Ghosts({ vtkDataSetAttributes::DUPLICATECELL, 0 })(trial);
        trial.Set = [](Filter* filter) { filter->SetNumberOfLevels(2); };
      } },
    // Blocks
    { "blocks", InBlocks({ 1. }, 0., false) },
    { "blocks-cases", InBlocks({ 300., 450. }, 0., false) },
    { "blocks-other-values", InBlocks({ 300., 450. }, 0., false, true) },
    { "blocks-same-ids", InBlocks({ 1., 1. }, 100., true) },
    { "ghosts-short", Ghosts({ vtkDataSetAttributes::HIDDENCELL }) },
    // Options
    { "levels-negative", With([](Filter* filter) { filter->SetNumberOfLevels(-3); }) },
    { "levels-above-range",
      With(
        [](Filter* filter)
        {
          filter->SetNumberOfLevels(1000);
          filter->SetMaximumNumberOfCells(1000);
        }) },
    { "maximum-negative", With([](Filter* filter) { filter->SetMaximumNumberOfCells(-1); }) },
    { "angle-nan",
      With(
        [](Filter* filter)
        {
          filter->SetFeatureAngle(NaN);
          filter->DetectFeaturesOn();
        }) },
    { "scheme-out-of-range", With([](Filter* filter) { filter->SetVolumeScheme(77); }) },
    { "bezier-faces",
      [](Trial& trial)
      {
        Add({ { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_LINE, { 0, 1 } } })(trial);
        trial.Set = [](Filter* filter)
        {
          filter->SetOutputCellsToBezier();
          filter->SetBezierTolerance(1.);
        };
      } },
    { "crease-sharpness-short",
      With(
        [](Filter* filter)
        {
          const Grid edge = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 } }, { { VTK_LINE, { 0, 1 } } });
          edge->GetCellData()->AddArray(MakeNamed<vtkDoubleArray>("Sharpness", 1, 0));
          filter->SetInputDataObject(2, edge);
        }) },
    { "interpolated-array-missing",
      With(
        [](Filter* filter)
        {
          filter->InterpolateArraysOn();
          filter->AddInterpolatedArray("None here");
        }) },
    // No mesh
    { "no-input", [](Trial& trial) { trial.HasInput = false; } },
    { "empty-grid",
      [](Trial& trial) { trial.Other = vtkSmartPointer<vtkUnstructuredGrid>::New(); } },
    { "left-handed",
      [](Trial& trial)
      {
        const auto image = vtkSmartPointer<vtkImageData>::New();
        image->SetDimensions(2, 2, 2);
        image->SetDirectionMatrix(-1, 0, 0, 0, 1, 0, 0, 0, 1);
        trial.Other = image;
      } },
    { "no-cells", [](Trial& trial) { trial.Cells.clear(); } },
    { "no-points", [](Trial& trial) { trial.Points.clear(); } },
    { "wrong-class", [](Trial& trial) { trial.Other = vtkSmartPointer<vtkTable>::New(); } },
  };
  return cases;
}

}
