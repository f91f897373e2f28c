// SPDX-License-Identifier: BSD-3-Clause
// Normals at the limit have one side in each part of a surface, the same on all partitions, however
// its cells are oriented.
#include "PartitionTools.h"
#include "Turns.h"

#include "Private/AdaptiveSurface/AdaptiveSurface.h"
#include "Private/RedGreen/RedGreenRefinement.h"
#include "Private/Run/KeptEntries.h"
#include "Private/Surface/SurfaceSubdivision.h"
#include "Private/Uniform/UniformSubdivision.h"

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;
using subdivision::SurfaceOptions;

namespace
{

constexpr int Length = 24;
constexpr int Width = 3;
constexpr int HalfTurns[] = { 0, 1, 2 };

/// A closed band of quads or triangles, turned over so many times; a second one stands on its
/// middle line, so that edges there have four faces. Every other cell or so is reversed.
Mesh MakeBands(int halfTurns, bool quads)
{
  const auto mesh = Mesh::Take(vtkPolyData::New());
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  vtkNew<vtkCellArray> polys;
  std::mt19937 chance(17 + static_cast<unsigned>(halfTurns));
  const auto add = [&](std::vector<vtkIdType> cell)
  {
    if (chance() % 2 == 0)
    {
      std::reverse(cell.begin(), cell.end());
    }
    polys->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  };
  const double pi = std::acos(-1.);
  for (int band = 0; band < 2; ++band)
  {
    const int rows = band == 0 ? 2 * Width : Width;
    std::vector<std::vector<vtkIdType>> ids;
    for (int i = 0; i <= Length; ++i)
    {
      const double angle = 2. * pi * i / Length;
      const double turn = 0.5 * halfTurns * angle + 0.5 * pi * band;
      ids.emplace_back();
      for (int j = 0; j <= rows; ++j)
      {
        const double across = 0.3 * (band == 0 ? j - Width : j);
        const bool isShared = band == 1 && j == 0;
        if (i == Length) // the first line again, in a band of one side the other way
        {
          const int same = band == 0 && halfTurns % 2 == 1 ? rows - j : j;
          ids.back().push_back(ids[0][static_cast<size_t>(same)]);
        }
        else if (isShared)
        {
          ids.back().push_back(vtkIdType(i) * (2 * Width + 1) + Width);
        }
        else
        {
          const double radius = 5. + across * std::cos(turn);
          ids.back().push_back(points->InsertNextPoint(
            radius * std::cos(angle), radius * std::sin(angle), across * std::sin(turn)));
        }
      }
      for (int j = 0; i > 0 && j < rows; ++j)
      {
        const auto at = [&ids, i, j](int back, int next)
        { return ids[static_cast<size_t>(i - back)][static_cast<size_t>(j + next)]; };
        if (quads)
        {
          add({ at(1, 0), at(0, 0), at(0, 1), at(1, 1) });
        }
        else
        {
          add({ at(1, 0), at(0, 0), at(0, 1) });
          add({ at(1, 0), at(0, 1), at(1, 1) });
        }
      }
    }
  }
  auto* surface = vtkPolyData::SafeDownCast(mesh);
  surface->SetPoints(points);
  surface->SetPolys(polys);
  NumberCells(mesh);
  return mesh;
}

/// test(mesh, partition) for all bands and partitions.
template <typename Test>
void ForBands(const Test& test)
{
  for (const int halfTurns : HalfTurns)
  {
    for (const bool quads : { false, true })
    {
      const Mesh mesh = MakeBands(halfTurns, quads);
      for (const Partition& partition : CommonPartitions)
      {
        SCOPED_TRACE(std::string(partition.Name) + ", half turns " + std::to_string(halfTurns) +
          (quads ? ", quads" : ", triangles"));
        turns::IsNextInTurn() ? test(mesh, partition) : void();
        if (testing::Test::HasFailure())
        {
          return;
        }
      }
    }
  }
}

/// The triangles of a band as a grid.
Mesh MakeGrid(vtkPointSet* surface)
{
  const Mesh mesh = subdivision::MakeMesh(false);
  vtkNew<vtkCellArray> cells;
  cells->DeepCopy(vtkPolyData::SafeDownCast(surface)->GetPolys());
  vtkUnstructuredGrid::SafeDownCast(mesh)->SetCells(VTK_TRIANGLE, cells);
  mesh->SetPoints(surface->GetPoints());
  NumberCells(mesh);
  return mesh;
}

subdivision::UniformOptions MakeUniformOptions()
{
  subdivision::UniformOptions options;
  options.GenerateLimitNormals = true;
  options.Warn = [](const std::string&) {};
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  return options;
}

std::vector<Mesh> RunParts(const std::vector<Mesh>& parts, const Partition& partition,
  bool isOfSurfaces, int layers, subdivision::RunOptions& options,
  const subdivision::FilterWork& work)
{
  subdivision::DistributionOptions distribution;
  distribution.IsOfSurfaces = isOfSurfaces;
  distribution.Layers = layers;
  std::vector<Mesh> outputs;
  EXPECT_TRUE(RunOnParts(parts, partition, distribution, options, work, outputs));
  return outputs;
}

}

TEST(PartitionsSides, OfSurfaces)
{
  int turn = 0;
  ForBands(
    [&turn](const Mesh& mesh, const Partition& partition)
    {
      for (const auto scheme :
        { subdivision::SurfaceSchemeKind::Loop, subdivision::SurfaceSchemeKind::CatmullClark,
          subdivision::SurfaceSchemeKind::SqrtThree })
      {
        SurfaceOptions options;
        options.Scheme = scheme;
        options.GenerateLimitNormals = true;
        options.GenerateTangents = true;
        options.Warn = [](const std::string&) {};
        options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
        const auto subdivide = [&options](vtkPointSet* input, vtkPointSet* output)
        {
          return SubdivideSurface(
            vtkPolyData::SafeDownCast(input), options, vtkPolyData::SafeDownCast(output));
        };
        options.Levels = 2;
        const Mesh whole = subdivision::MakeMesh(true);
        EXPECT_TRUE(subdivide(mesh, whole));
        std::vector<Mesh> parts = Cut(mesh, partition);
        const bool goesOn = scheme != subdivision::SurfaceSchemeKind::SqrtThree;
        const int filters = goesOn ? 1 + turn++ % 2 : 1;
        options.Levels = 2 / filters;
        for (int i = 0; i < filters; ++i)
        {
          parts = RunParts(parts, partition, true, 2, options, subdivide);
        }
        ExpectWhole(whole, parts);
      }
    });
}

TEST(PartitionsSides, OfAdaptiveSurfaces)
{
  ForBands(
    [](const Mesh& mesh, const Partition& partition)
    {
      SurfaceOptions options;
      options.Scheme = subdivision::SurfaceSchemeKind::SqrtThree;
      options.Levels = 0;
      options.GenerateLimitNormals = true;
      options.Warn = [](const std::string&) {};
      options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
      subdivision::RefinementOptions criteria;
      criteria.ByCurvature = true;
      criteria.MaximumAngle = 10.;
      criteria.MaximumLevel = 3;
      const auto refine = [&](vtkPointSet* input, vtkPointSet* output)
      {
        return RefineSurface(
          vtkPolyData::SafeDownCast(input), options, criteria, vtkPolyData::SafeDownCast(output));
      };
      const Mesh whole = subdivision::MakeMesh(true);
      EXPECT_TRUE(refine(mesh, whole));
      ExpectWhole(whole,
        RunParts(Cut(mesh, partition), partition, true, subdivision::LayersOfAdaptiveSurface,
          options, refine));
    });
}

TEST(PartitionsSides, OfSurfacesAmongSolids)
{
  ForBands(
    [](const Mesh& surface, const Partition& partition)
    {
      if (surface->GetCell(0)->GetNumberOfPoints() != 3)
      {
        return;
      }
      const Mesh mesh = MakeGrid(surface);
      subdivision::UniformOptions options = MakeUniformOptions();
      const auto subdivide = [&options](vtkPointSet* input, vtkPointSet* output)
      { return SubdivideUniformly(input, options, vtkUnstructuredGrid::SafeDownCast(output)); };
      options.Levels = 2;
      const Mesh whole = subdivision::MakeMesh(false);
      EXPECT_TRUE(subdivide(mesh, whole));
      for (const int filters : { 1, 2 })
      {
        std::vector<Mesh> parts = Cut(mesh, partition);
        options.Levels = 2 / filters;
        for (int i = 0; i < filters; ++i)
        {
          parts = RunParts(parts, partition, false, 2, options, subdivide);
        }
        ExpectWhole(whole, parts);
      }
    });
}

TEST(PartitionsSides, OfRedGreenRefinement)
{
  ForBands(
    [](const Mesh& surface, const Partition& partition)
    {
      if (surface->GetCell(0)->GetNumberOfPoints() != 3)
      {
        return;
      }
      const Mesh mesh = MakeGrid(surface);
      subdivision::RedGreenOptions options;
      options.Warn = [](const std::string&) {};
      options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
      options.LimitPlacement = true;
      options.GenerateLimitNormals = true;
      options.Criteria.ByEdgeLength = true;
      options.Criteria.MaximumEdgeLength = 0.8;
      options.Criteria.MaximumLevel = 2;
      const auto refine = [&options](vtkPointSet* input, vtkPointSet* output)
      { return RefineRedGreen(input, options, vtkUnstructuredGrid::SafeDownCast(output)); };
      const Mesh whole = subdivision::MakeMesh(false);
      EXPECT_TRUE(refine(mesh, whole));
      ExpectWhole(whole, RunParts(Cut(mesh, partition), partition, false, 2, options, refine));
    });
}

TEST(PartitionsSides, FollowACellThatAnotherPartReverses)
{
  const Partition& partition = CommonPartitions[0];
  std::vector<subdivision::KeptEntries> caches(static_cast<size_t>(partition.Parts));
  subdivision::UniformOptions options = MakeUniformOptions();
  options.Levels = 1;
  const auto subdivide = [&](vtkPointSet* input, vtkPointSet* output)
  {
    subdivision::UniformOptions own = options;
    subdivision::OtherPartitions* others = options.Others;
    own.Cache = others ? &caches[static_cast<size_t>(others->GetPartition())] : nullptr;
    return SubdivideUniformly(input, own, vtkUnstructuredGrid::SafeDownCast(output));
  };
  const Mesh mesh = MakeGrid(MakeBands(0, false));
  const std::vector<int> partOf = CutInSlabs(mesh, partition.Parts);
  const auto check = [&]
  {
    options.Others = nullptr;
    const Mesh whole = subdivision::MakeMesh(false);
    EXPECT_TRUE(subdivide(mesh, whole));
    ExpectWhole(whole,
      RunParts(Cut(mesh, partOf, partition.Parts, KnownBy::GlobalIds), partition, false, 2, options,
        subdivide));
    for (subdivision::KeptEntries& cache : caches)
    {
      cache.ForgetUnused();
    }
  };
  check();
  // The first cell of all decides on the side of the others.
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(0, ids);
  const vtkIdType reversed[3] = { ids->GetId(2), ids->GetId(1), ids->GetId(0) };
  vtkUnstructuredGrid::SafeDownCast(mesh)->GetCells()->ReplaceCellAtId(0, 3, reversed);
  check();
  EXPECT_EQ(3, caches[0].NumberOfBuilds + caches[1].NumberOfBuilds); // one part was kept
}
