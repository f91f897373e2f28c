// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MultiDimensionalSubdivisionTools.h
 * Small meshes, a way to run the filter that misses no message, and a comparison bit for bit.
 */
#ifndef SubdivisionObjects_MultiDimensionalSubdivisionTools_h
#define SubdivisionObjects_MultiDimensionalSubdivisionTools_h

#include "Precompiled.h"

#include "vtkMultiDimensionalSubdivision.h"

#include "vtkBitArray.h"
#include "vtkCellType.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

namespace multi_dimensional_subdivision_tools
{

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;
using Ids = std::vector<vtkIdType>;
using Point = std::array<double, 3>;

struct Cell
{
  int Type;
  Ids Points;
};

Grid MakeGrid(
  const std::vector<Point>& points, const std::vector<Cell>& cells, int type = VTK_DOUBLE);

inline Ids GetCell(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  grid->GetCellPoints(cell, ids);
  return Ids(ids->begin(), ids->end());
}

std::vector<Ids> GetCells(vtkUnstructuredGrid* grid);

inline Point GetPoint(vtkPointSet* grid, vtkIdType i)
{
  Point p;
  grid->GetPoint(i, p.data());
  return p;
}

/// Of a tetrahedron; negative where it is inverted.
double GetSignedVolume(vtkPointSet* grid, const Ids& tet);

/// What a filter said.
class Messages : public vtkCommand
{
public:
  static Messages* New() { return new Messages; }
  vtkTypeMacro(Messages, vtkCommand);
  void Execute(vtkObject*, unsigned long event, void* data) override;
  void Watch(vtkAlgorithm* filter);
  int CountWarnings(const std::string& part) const;

  std::vector<std::string> Warnings;
  std::vector<std::string> Errors;
  /// Warnings that depend on shapes alone: random meshes have solids too thin to be smoothed.
  std::vector<std::string> Inversions;
};

/// Runs a filter. Without `messages` it may not say anything but warnings with one of these parts.
void UpdateInSilence(vtkAlgorithm* filter, vtkDataObject* input, Messages* messages = nullptr,
  const std::vector<const char*>& but = {});

/// Runs a filter, which may warn but not fail, and copies its output.
template <typename Output, typename FilterClass>
vtkSmartPointer<Output> UpdateWithoutErrors(FilterClass* filter, vtkDataObject* input)
{
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(input);
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty());
  const auto output = vtkSmartPointer<Output>::New();
  output->DeepCopy(filter->GetOutput());
  return output;
}

struct Options
{
  int Levels = 1;
  bool OriginalIds = false;
  bool Classification = false;
  bool Integers = false;
  int Precision = vtkAlgorithm::DEFAULT_PRECISION;
  vtkIdType MaximumNumberOfCells = 500000000;
};

void Set(vtkMultiDimensionalSubdivision* filter, const Options& options);

Grid LoadModel(int model, int precision = vtkAlgorithm::DEFAULT_PRECISION);

/// A copy with points in double precision.
template <typename Mesh = vtkUnstructuredGrid>
vtkSmartPointer<Mesh> InDouble(vtkPointSet* mesh)
{
  const auto copy = vtkSmartPointer<Mesh>::New();
  copy->DeepCopy(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(mesh->GetPoints());
  copy->SetPoints(points);
  return copy;
}

inline Point GetTuple(vtkDataSet* mesh, const char* name, vtkIdType i)
{
  Point p{};
  mesh->GetPointData()->GetArray(name)->GetTuple(i, p.data());
  return p;
}

void SetGlobalIds(vtkPointSet* mesh, const Ids& ids);

/// Runs the filter, which cuts all cells. Without `messages` it may not say anything.
Grid Subdivide(vtkDataObject* input, const Options& options, Messages* messages = nullptr);

inline Grid Subdivide(vtkDataObject* input, int levels)
{
  Options options;
  options.Levels = levels;
  return Subdivide(input, options);
}

std::string CompareValues(vtkAbstractArray* a, vtkAbstractArray* b);

std::string CompareArrays(vtkFieldData* a, vtkFieldData* b, const std::string& where);

/// The meshes of a data object: itself, or its blocks.
std::vector<vtkSmartPointer<vtkPointSet>> GetMeshes(vtkDataObject* data);

/// The first difference found, empty if there is none. Cells are compared by what they are, arrays
/// by name; blocks one after the other.
std::string Compare(vtkDataObject* a, vtkDataObject* b, bool withStamp = true);

/// What is made with one thread, and bit for bit with four.
template <typename Make>
auto MakeInThreads(const Make& make)
{
  const std::string before = vtkSMPTools::GetBackend();
  EXPECT_TRUE(vtkSMPTools::SetBackend("STDThread"));
  vtkSMPTools::Initialize(1);
  const auto one = make();
  vtkSMPTools::Initialize(4);
  EXPECT_EQ(Compare(one, make()), "");
  vtkSMPTools::SetBackend(before.c_str());
  vtkSMPTools::Initialize(0);
  return one;
}

template <typename Mesh = vtkSmartPointer<vtkPointSet>>
vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks(const std::vector<Mesh>& meshes)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const Mesh& mesh : meshes)
  {
    blocks->SetBlock(blocks->GetNumberOfBlocks(), mesh);
  }
  return blocks;
}

/// Gives `array` a name, components and values that differ.
template <typename Array>
vtkSmartPointer<Array> MakeArray(
  const char* name, int components, vtkIdType tuples, double low, double high, unsigned seed)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  std::mt19937 random(seed);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int k = 0; k < components; ++k)
    {
      array->SetComponent(i, k, low + (high - low) * (random() / 4294967296.));
    }
  }
  return array;
}

vtkSmartPointer<vtkStringArray> MakeNames(const char* name, vtkIdType tuples);

/// Arrays of every kind on points, cells and the grid.
void AddArrays(vtkUnstructuredGrid* grid);

/// Global ids in random order, not starting at 0.
void AddGlobalIds(vtkUnstructuredGrid* grid, unsigned seed);

inline void RemoveStamp(vtkUnstructuredGrid* grid)
{
  grid->GetFieldData()->RemoveArray("Subdivision");
  grid->GetFieldData()->RemoveArray("SubdivisionGlobalIds");
  grid->GetFieldData()->RemoveArray("SubdivisionInvertedCells");
}

inline Grid DeepCopy(vtkUnstructuredGrid* grid)
{
  auto copy = Grid::New();
  copy->DeepCopy(grid);
  return copy;
}

/// A box of n^3 cubes: hexahedra, wedges, pyramids' worth of tets in turns, with shells, lines and
/// vertices on it, some twice, and a fin that leaves it.
Grid MakeMixedBox(int n, int type = VTK_DOUBLE);

}

#endif
