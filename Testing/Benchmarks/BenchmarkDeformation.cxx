// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkDeformation.cxx
 * A lattice of one million points in a cage of 384 tetrahedra: the first execution, and one with
 * moved control points. The limit of the latter: reading the operators and 4 entries of 8 + 4 bytes
 * for each point once, and writing the points, in small pages and in huge ones.
 */
#include "BenchmarkLimit.h"

#include "Private/Deformation/RestMesh.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSubdivisionDeformation.h"

#include <atomic>

namespace benchmarks
{
namespace
{

constexpr vtkIdType NumberOfPoints = 1000000;
constexpr std::size_t BytesWritten = 3 * sizeof(double) * NumberOfPoints;
constexpr int Levels = 3;

vtkPointSet* GetCage()
{
  static const vtkSmartPointer<vtkPointSet> cage = ToVtk(MakeCube(4));
  return cage;
}

vtkPolyData* GetCloud()
{
  static const vtkSmartPointer<vtkPolyData> cloud = []
  {
    vtkNew<vtkDoubleArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(NumberOfPoints);
    // A lattice, like the points of most objects in some order: neighbours follow each other.
    for (vtkIdType i = 0; i < NumberOfPoints; ++i)
    {
      const vtkIdType place[3] = { i % 100, i / 100 % 100, i / 10000 };
      for (int c = 0; c < 3; ++c)
      {
        coordinates->SetValue(3 * i + c, 0.2 + 0.006 * (static_cast<double>(place[c]) + 0.37));
      }
    }
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);
    auto made = vtkSmartPointer<vtkPolyData>::New();
    made->SetPoints(points);
    return made;
  }();
  return cloud;
}

vtkSmartPointer<vtkPointSet> MakeDeformed()
{
  auto deformed = vtkSmartPointer<vtkPointSet>::Take(GetCage()->NewInstance());
  deformed->DeepCopy(GetCage());
  for (vtkIdType i = 0; i < deformed->GetNumberOfPoints(); ++i)
  {
    double x[3];
    deformed->GetPoint(i, x);
    deformed->GetPoints()->SetPoint(i, x[0] + x[2] * x[2], x[1], x[2] - 0.3 * x[0] * x[1]);
  }
  return deformed;
}

Produced RunDeformation(Stopwatch& watch, bool again)
{
  vtkNew<vtkSubdivisionDeformation> filter;
  filter->SetInputData(GetCloud());
  filter->SetRestMeshData(GetCage());
  filter->SetDeformedMeshData(GetCage());
  filter->SetNumberOfLevels(Levels);
  if (again)
  {
    filter->Update();
    filter->SetDeformedMeshData(MakeDeformed());
  }
  watch.Time([&]() { filter->Update(); });
  return { static_cast<double>(NumberOfPoints), static_cast<double>(BytesWritten) };
}

std::size_t GetOperatorSize()
{
  static const std::size_t size = []
  {
    subdivision::DeformationOptions options;
    options.Levels = Levels;
    options.Warn = options.Fail = [](const std::string&) {};
    subdivision::RestMesh rest;
    return rest.Update(GetCage(), options) ? rest.GetOperatorSize() : 0;
  }();
  return size;
}

Produced ReadAndWrite(Stopwatch& watch, Pages pages)
{
  using subdivision::Buffer;
  const vtkIdType words =
    static_cast<vtkIdType>(GetOperatorSize() / 8) + NumberOfPoints * 4 * (8 + 4) / 8;
  const Buffer<long long> kept(words, 1);
  std::atomic<long long> total{ 0 };
  watch.Time(
    [&]()
    {
      subdivision::ForRanges(words,
        [&](vtkIdType begin, vtkIdType end)
        {
          long long sum = 0;
          for (vtkIdType i = begin; i < end; ++i)
          {
            sum += kept[i];
          }
          total += sum;
        });
    });
  benchmark::DoNotOptimize(total.load());
  OutputSize points;
  points.Cells = static_cast<double>(NumberOfPoints);
  points.Bytes = static_cast<double>(BytesWritten);
  points.Arrays = { BytesWritten };
  return RunLimit(watch, points, pages);
}

void RegisterDeformation()
{
  const std::string end = "/million/levels:" + std::to_string(Levels);
  for (int threads : ThreadCounts)
  {
    Register("deformation/first" + end, threads,
      [](Stopwatch& watch) { return RunDeformation(watch, false); });
    Register("deformation/again" + end, threads,
      [](Stopwatch& watch) { return RunDeformation(watch, true); });
    Register("limit/deformation-small" + end, threads,
      [](Stopwatch& watch) { return ReadAndWrite(watch, Pages::Small); });
    Register("limit/deformation-huge" + end, threads,
      [](Stopwatch& watch) { return ReadAndWrite(watch, Pages::Huge); });
  }
}

const Registration Registered(RegisterDeformation);

}
}
