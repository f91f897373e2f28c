// SPDX-License-Identifier: BSD-3-Clause
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkSubdivisionModelSource.h"

#include "vtkCompositeDataIterator.h"
#include "vtkExecutive.h"
#include "vtkPointSet.h"

#include <cstring>

namespace multi_dimensional_subdivision_tools
{

Grid MakeGrid(const std::vector<Point>& points, const std::vector<Cell>& cells, int type)
{
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataType(type);
  for (const Point& p : points)
  {
    coordinates->InsertNextPoint(p.data());
  }
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkCellArray> ids;
  for (const Cell& cell : cells)
  {
    types->InsertNextValue(static_cast<unsigned char>(cell.Type));
    ids->InsertNextCell(static_cast<vtkIdType>(cell.Points.size()), cell.Points.data());
  }
  auto grid = Grid::New();
  grid->SetPoints(coordinates);
  grid->SetCells(types, ids);
  return grid;
}

std::vector<Ids> GetCells(vtkUnstructuredGrid* grid)
{
  std::vector<Ids> cells;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    cells.push_back(GetCell(grid, i));
  }
  return cells;
}

double GetSignedVolume(vtkPointSet* grid, const Ids& tet)
{
  const Point p = GetPoint(grid, tet[0]);
  double d[3][3];
  for (int i = 0; i < 3; ++i)
  {
    const Point q = GetPoint(grid, tet[i + 1]);
    for (int c = 0; c < 3; ++c)
    {
      d[i][c] = q[c] - p[c];
    }
  }
  return (d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
           d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
           d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0])) /
    6.;
}

void Messages::Execute(vtkObject*, unsigned long event, void* data)
{
  const std::string text = static_cast<const char*>(data);
  const bool isOfShape = text.find("smoothing turned inside out") != std::string::npos;
  auto& list = event != vtkCommand::WarningEvent ? this->Errors
    : isOfShape                                  ? this->Inversions
                                                 : this->Warnings;
  list.push_back(text);
}

void Messages::Watch(vtkAlgorithm* filter)
{
  filter->AddObserver(vtkCommand::WarningEvent, this);
  filter->AddObserver(vtkCommand::ErrorEvent, this);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this);
}

int Messages::CountWarnings(const std::string& part) const
{
  return static_cast<int>(std::count_if(this->Warnings.begin(), this->Warnings.end(),
    [&part](const std::string& text) { return text.find(part) != std::string::npos; }));
}

void Set(vtkMultiDimensionalSubdivision* filter, const Options& options)
{
  filter->SetNumberOfLevels(options.Levels);
  filter->SetGenerateOriginalIds(options.OriginalIds);
  filter->SetGenerateClassification(options.Classification);
  filter->SetInterpolateIntegers(options.Integers);
  filter->SetOutputPointsPrecision(options.Precision);
  filter->SetMaximumNumberOfCells(options.MaximumNumberOfCells);
}

void UpdateInSilence(vtkAlgorithm* filter, vtkDataObject* input, Messages* messages,
  const std::vector<const char*>& but)
{
  vtkNew<Messages> own;
  (messages ? messages : own.Get())->Watch(filter);
  filter->SetInputDataObject(input);
  filter->Update();
  for (const auto* list : { &own->Warnings, &own->Errors })
  {
    for (const std::string& text : *list)
    {
      EXPECT_TRUE(std::any_of(but.begin(), but.end(),
        [&](const char* part) { return text.find(part) != std::string::npos; }))
        << "unexpected: " << text;
    }
  }
}

Grid LoadModel(int model, int precision)
{
  vtkNew<vtkSubdivisionModelSource> source;
  source->SetModel(model);
  source->SetOutputPointsPrecision(precision);
  source->Update();
  return DeepCopy(source->GetOutput());
}

void SetGlobalIds(vtkPointSet* mesh, const Ids& ids)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName("ids");
  for (const vtkIdType id : ids)
  {
    array->InsertNextValue(id);
  }
  mesh->GetPointData()->SetGlobalIds(array);
}

Grid Subdivide(vtkDataObject* input, const Options& options, Messages* messages)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToBoxSpline();
  Set(filter, options);
  // Points of random meshes may lie in edges of others; TestHangingNodes.cxx has the rules.
  UpdateInSilence(filter, input, messages, { "lies inside an edge", "lie inside an edge" });
  return filter->GetOutput();
}

std::string CompareValues(vtkAbstractArray* a, vtkAbstractArray* b)
{
  if (a->GetDataType() != b->GetDataType())
  {
    return std::string("type ") + a->GetClassName() + " " + b->GetClassName();
  }
  if (a->GetNumberOfComponents() != b->GetNumberOfComponents() ||
    a->GetNumberOfTuples() != b->GetNumberOfTuples())
  {
    return "size";
  }
  auto* x = vtkDataArray::SafeDownCast(a);
  auto* y = vtkDataArray::SafeDownCast(b);
  const vtkIdType values = a->GetNumberOfValues();
  if (values > 0 && x && y && a->GetDataType() != VTK_BIT && x->HasStandardMemoryLayout() &&
    y->HasStandardMemoryLayout())
  {
    const size_t bytes = static_cast<size_t>(values) * a->GetDataTypeSize();
    return std::memcmp(x->GetVoidPointer(0), y->GetVoidPointer(0), bytes) == 0 ? "" : "values";
  }
  for (vtkIdType i = 0; i < values; ++i)
  {
    if (a->GetVariantValue(i).ToString() != b->GetVariantValue(i).ToString())
    {
      return "value " + std::to_string(i);
    }
  }
  return "";
}

std::string CompareArrays(vtkFieldData* a, vtkFieldData* b, const std::string& where)
{
  if (a->GetNumberOfArrays() != b->GetNumberOfArrays())
  {
    return where + ": number of arrays";
  }
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* x = a->GetAbstractArray(i);
    const std::string name = x->GetName() ? x->GetName() : "";
    vtkAbstractArray* y = b->GetAbstractArray(name.c_str());
    if (!y)
    {
      return where + ": " + name + " is missing";
    }
    const std::string difference = CompareValues(x, y);
    if (!difference.empty())
    {
      return where + ": " + name + ": " + difference;
    }
    for (int k = 0; k < x->GetNumberOfComponents(); ++k)
    {
      const char* c = x->GetComponentName(k);
      const char* d = y->GetComponentName(k);
      if (std::string(c ? c : "") != (d ? d : ""))
      {
        return where + ": " + name + ": component name";
      }
    }
  }
  auto* attributes = vtkDataSetAttributes::SafeDownCast(a);
  auto* others = vtkDataSetAttributes::SafeDownCast(b);
  for (int type = 0; attributes && type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    vtkAbstractArray* x = attributes->GetAbstractAttribute(type);
    vtkAbstractArray* y = others->GetAbstractAttribute(type);
    if (std::string(x ? x->GetName() : "") != (y ? y->GetName() : ""))
    {
      return where + ": active attribute " + std::to_string(type);
    }
  }
  return "";
}

std::vector<vtkSmartPointer<vtkPointSet>> GetMeshes(vtkDataObject* data)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return { vtkPointSet::SafeDownCast(data) };
  }
  std::vector<vtkSmartPointer<vtkPointSet>> meshes;
  const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    meshes.emplace_back(vtkPointSet::SafeDownCast(at->GetCurrentDataObject()));
  }
  return meshes;
}

static std::string CompareMeshes(vtkPointSet* a, vtkPointSet* b, bool withStamp)
{
  if (std::string(a->GetClassName()) != b->GetClassName())
  {
    return "class";
  }
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints() ||
    a->GetNumberOfCells() != b->GetNumberOfCells())
  {
    return "number of points or cells";
  }
  if (a->GetPoints() && b->GetPoints())
  {
    const std::string points = CompareValues(a->GetPoints()->GetData(), b->GetPoints()->GetData());
    if (!points.empty())
    {
      return "points: " + points;
    }
  }
  vtkNew<vtkIdList> x;
  vtkNew<vtkIdList> y;
  for (vtkIdType i = 0; i < a->GetNumberOfCells(); ++i)
  {
    a->GetCellPoints(i, x);
    b->GetCellPoints(i, y);
    if (a->GetCellType(i) != b->GetCellType(i) || x->GetNumberOfIds() != y->GetNumberOfIds() ||
      !std::equal(x->begin(), x->end(), y->begin()))
    {
      return "cell " + std::to_string(i);
    }
  }
  std::string difference = CompareArrays(a->GetPointData(), b->GetPointData(), "point data");
  difference += CompareArrays(a->GetCellData(), b->GetCellData(), "cell data");
  difference += withStamp ? CompareArrays(a->GetFieldData(), b->GetFieldData(), "field data") : "";
  return difference;
}

std::string Compare(vtkDataObject* a, vtkDataObject* b, bool withStamp)
{
  const auto some = GetMeshes(a);
  const auto others = GetMeshes(b);
  std::string difference = some.size() == others.size() ? "" : "number of meshes";
  for (std::size_t i = 0; difference.empty() && i < some.size(); ++i)
  {
    difference = CompareMeshes(some[i], others[i], withStamp);
  }
  return difference;
}

vtkSmartPointer<vtkStringArray> MakeNames(const char* name, vtkIdType tuples)
{
  auto names = vtkSmartPointer<vtkStringArray>::New();
  names->SetName(name);
  names->SetNumberOfValues(tuples);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    names->SetValue(i, "n" + std::to_string(i));
  }
  return names;
}

void AddArrays(vtkUnstructuredGrid* grid)
{
  unsigned seed = 0;
  vtkDataSetAttributes* both[2] = { grid->GetPointData(), grid->GetCellData() };
  for (vtkDataSetAttributes* data : both)
  {
    const vtkIdType size = seed == 0 ? grid->GetNumberOfPoints() : grid->GetNumberOfCells();
    data->AddArray(MakeArray<vtkFloatArray>("float", 1, size, -5, 5, ++seed));
    data->AddArray(MakeArray<vtkDoubleArray>("double", 3, size, -5, 5, ++seed));
    data->AddArray(MakeArray<vtkIntArray>("int", 2, size, -1000, 1000, ++seed));
    data->AddArray(MakeArray<vtkUnsignedCharArray>("byte", 1, size, 0, 255, ++seed));
    data->AddArray(MakeArray<vtkUnsignedCharArray>("rgb", 3, size, 0, 256, ++seed));
    data->AddArray(MakeArray<vtkUnsignedCharArray>("rgba", 4, size, 0, 256, ++seed));
    data->AddArray(MakeArray<vtkBitArray>("bit", 1, size, 0, 1.999, ++seed));
    data->AddArray(MakeNames("string", size));
    data->SetActiveScalars("float");
    data->SetActiveVectors("double");
    data->GetArray("double")->SetComponentName(1, "middle");
  }
  vtkNew<vtkDoubleArray> time;
  time->SetName("TimeValue");
  time->InsertNextValue(0.25);
  grid->GetFieldData()->AddArray(time);
  grid->GetFieldData()->AddArray(MakeNames("names", 2));
}

void AddGlobalIds(vtkUnstructuredGrid* grid, unsigned seed)
{
  std::mt19937 random(seed);
  for (int i = 0; i < 2; ++i)
  {
    Ids ids(i == 0 ? grid->GetNumberOfPoints() : grid->GetNumberOfCells());
    std::iota(ids.begin(), ids.end(), 1000);
    std::shuffle(ids.begin(), ids.end(), random);
    vtkNew<vtkIdTypeArray> array;
    array->SetName("GlobalIds");
    for (vtkIdType id : ids)
    {
      array->InsertNextValue(id);
    }
    i == 0 ? grid->GetPointData()->SetGlobalIds(array) : grid->GetCellData()->SetGlobalIds(array);
  }
}

Grid MakeMixedBox(int n, int type)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  std::mt19937 random(7);
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        auto shift = [&random] { return 0.1 * (random() / 4294967296. - 0.5); };
        points.push_back({ i + shift(), j + shift(), k + shift() });
      }
    }
  }
  auto at = [n](int i, int j, int k) { return vtkIdType(i + (n + 1) * (j + (n + 1) * k)); };
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const vtkIdType c[8] = { at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
          at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1) };
        if ((i + j + k) % 3 == 0)
        {
          cells.push_back({ VTK_WEDGE, { c[0], c[1], c[2], c[4], c[5], c[6] } });
          cells.push_back({ VTK_WEDGE, { c[0], c[2], c[3], c[4], c[6], c[7] } });
        }
        else
        {
          cells.push_back({ VTK_HEXAHEDRON, Ids(c, c + 8) });
        }
        if (k == 0)
        {
          cells.push_back({ VTK_QUAD, { c[0], c[3], c[2], c[1] } });
        }
        if (k == 0 && i == j)
        {
          cells.push_back({ VTK_QUAD, { c[0], c[3], c[2], c[1] } }); // equal to an earlier one
          cells.push_back({ VTK_LINE, { c[0], c[1] } });
          cells.push_back({ VTK_VERTEX, { c[2] } });
        }
      }
    }
  }
  const vtkIdType far = static_cast<vtkIdType>(points.size());
  points.push_back({ -1., -1., 0.5 });
  points.push_back({ -2., -1., 0.5 });
  points.push_back({ -9., 0., 0. }); // unused
  cells.push_back({ VTK_TRIANGLE, { at(0, 0, 0), at(0, 0, 1), far } });
  cells.push_back({ VTK_POLY_LINE, { at(0, 0, 0), far, far + 1 } });
  return MakeGrid(points, cells, type);
}

}
