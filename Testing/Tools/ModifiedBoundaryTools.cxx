// SPDX-License-Identifier: BSD-3-Clause
#include "ModifiedBoundaryTools.h"

#include "RandomSurfaces.h"

#include "vtkSurfaceSubdivision.h"

namespace modified_boundary_tools
{

using surfacetools::Model;

void SetAngles(vtkSubdivisionAlgorithm* filter)
{
  filter->SetInputArrayToProcess(10, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, AngleName);
}

Grid Execute(vtkPointSet* input, int levels, const Configure& configure)
{
  vtkNew<Filter> filter;
  filter->SetVolumeSchemeToBoxSpline();
  filter->SetNumberOfLevels(levels);
  SetAngles(filter.Get());
  if (configure)
  {
    configure(filter);
  }
  return UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
}

vtkSmartPointer<vtkPolyData> MakeCreased(unsigned seed, bool hasCreases)
{
  std::mt19937 random(seed);
  Model model = surfacetools::RandomSurface(seed).Get();
  std::map<std::pair<vtkIdType, vtkIdType>, int> counts;
  for (const auto& face : model.Faces)
  {
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      ++counts[std::minmax(face[k], face[(k + 1) % face.size()])];
    }
  }
  std::set<vtkIdType> border;
  for (const auto& [edge, count] : counts)
  {
    if (count == 1)
    {
      border.insert({ edge.first, edge.second });
    }
  }
  std::map<vtkIdType, int> creases;
  model.Lines.clear();
  for (const auto& [edge, count] : counts)
  {
    const bool isInside = border.count(edge.first) == 0 && border.count(edge.second) == 0;
    if (hasCreases && isInside && count == 2 && random() % 3 == 0 && creases[edge.first] < 2 &&
      creases[edge.second] < 2)
    {
      ++creases[edge.first];
      ++creases[edge.second];
      model.Lines.push_back({ edge.first, edge.second });
    }
  }
  const auto input = surfacetools::MakeInput(model);
  vtkNew<vtkCellArray> corners;
  for (const vtkIdType vertex : border)
  {
    if (random() % 6 == 0)
    {
      corners->InsertNextCell(1, &vertex);
    }
  }
  const vtkIdType flagged = corners->GetNumberOfCells() + input->GetNumberOfLines();
  input->SetVerts(corners);
  vtkNew<vtkIntArray> flags;
  flags->SetName("Singular");
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    flags->InsertNextValue(cell < flagged);
  }
  input->GetCellData()->Initialize();
  input->GetCellData()->AddArray(flags);
  input->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>(AngleName, 1, input->GetNumberOfPoints(), 0., 360., seed));
  return input;
}

vtkSmartPointer<vtkPolyData> MakeSemiSharp(unsigned seed)
{
  const auto input = MakeCreased(seed, true);
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  vtkDataArray* flags = input->GetCellData()->GetArray("Singular");
  const vtkIdType vertices = input->GetNumberOfVerts();
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    const bool isLine = cell >= vertices && cell < vertices + input->GetNumberOfLines();
    const double values[] = { 0., 1., 2., std::numeric_limits<double>::infinity() };
    sharpness->InsertNextValue(isLine ? values[(seed + cell) % 4] : 0.);
    flags->SetComponent(cell, 0, cell < vertices ? 1. : 0.);
  }
  input->GetCellData()->AddArray(sharpness);
  return input;
}

std::vector<Point> Collect(vtkPointSet* mesh, vtkIdType points, const char* array)
{
  std::vector<Point> found;
  const auto add = [&](vtkIdType i)
  {
    found.emplace_back();
    array ? mesh->GetPointData()->GetArray(array)->GetTuple(i, found.back().data())
          : mesh->GetPoint(i, found.back().data());
  };
  for (vtkIdType i = 0; i < points; ++i)
  {
    add(i);
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    std::for_each(ids->begin(), ids->end(), add);
  }
  return found;
}

double GetDifference(const std::vector<Point>& a, const std::vector<Point>& b)
{
  EXPECT_EQ(a.size(), b.size());
  double most = 0.;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      most = std::max(most, std::abs(a[i][c] - b[i][c]));
    }
  }
  return most;
}

void ExpectSameSurfaces(vtkPolyData* input, int levels, bool limit, bool normals)
{
  vtkNew<vtkSurfaceSubdivision> loop;
  loop->SetInputData(input);
  loop->SetNumberOfLevels(levels);
  loop->SetProjectToLimit(limit);
  loop->SetGenerateLimitNormals(normals);
  loop->SetCreaseEndToDart();
  SetAngles(loop.Get());
  const char* sharpness = input->GetCellData()->HasArray("Sharpness") ? "Sharpness" : "None";
  loop->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, sharpness);
  loop->Update();
  const Grid main = Execute(input, levels,
    [=](Filter* filter)
    {
      filter->SetProjectToLimit(limit);
      filter->SetGenerateLimitNormals(normals);
      filter->SetCreaseEndToDart();
      filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, sharpness);
    });
  const vtkIdType points = input->GetNumberOfPoints();
  EXPECT_LT(GetDifference(Collect(main, points), Collect(loop->GetOutput(), points)), 1e-12)
    << levels << " levels";
  if (normals)
  {
    EXPECT_LT(GetDifference(Collect(main, points, "LimitNormals"),
                Collect(loop->GetOutput(), points, "LimitNormals")),
      1e-9);
  }
}

vtkSmartPointer<vtkPolyData> WithoutCorners(vtkPolyData* input)
{
  const auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->SetPoints(input->GetPoints());
  copy->SetPolys(input->GetPolys());
  copy->GetPointData()->ShallowCopy(input->GetPointData());
  return copy;
}

Grid MakeBox()
{
  const Grid box = MakeMixedBox(2);
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  for (vtkIdType cell = 0; cell < box->GetNumberOfCells(); ++cell)
  {
    sharpness->InsertNextValue(
      box->GetCellType(cell) == VTK_LINE ? 0.75 * static_cast<double>(cell % 4) : 0.);
  }
  box->GetCellData()->AddArray(sharpness);
  box->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>(AngleName, 1, box->GetNumberOfPoints(), -100., 360., 3));
  return box;
}

void UseFeatures(Filter* filter)
{
  filter->DetectFeaturesOn();
  filter->SetFeatureAngle(50.);
  filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
}

}
