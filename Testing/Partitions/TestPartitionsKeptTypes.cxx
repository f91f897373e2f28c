// SPDX-License-Identifier: BSD-3-Clause
// Where cells keep their types, partitions, simulated in one process, give the cells, values and
// numbers of the whole mesh.
#include "PartitionTools.h"
#include "Turns.h"

#include "Private/Uniform/UniformSubdivision.h"

#include "vtkCell.h"

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;
using subdivision::UniformOptions;

namespace
{

/// A box of hexahedra, wedges, quads, lines and vertices, with every third hexahedron as six
/// pyramids around its centre. If `givesWay`, some pyramids are two tetrahedra each, so that cells
/// across their bases give way, and beside the box are prisms, each with a quad on the corners of a
/// side in another order, and collapsed hexahedra in a row.
Mesh MakeBoxWithPyramids(bool givesWay)
{
  const Grid box = MakeMixedBox(4);
  std::vector<Point> points;
  for (vtkIdType p = 0; p < box->GetNumberOfPoints(); ++p)
  {
    points.push_back(GetPoint(box, p));
  }
  std::vector<Cell> cells;
  for (vtkIdType c = 0; c < box->GetNumberOfCells(); ++c)
  {
    vtkNew<vtkIdList> ids;
    box->GetCellPoints(c, ids);
    if (box->GetCellType(c) != VTK_HEXAHEDRON || c % 3 != 0)
    {
      cells.push_back({ box->GetCellType(c), { ids->begin(), ids->end() } });
      continue;
    }
    const auto centre = static_cast<vtkIdType>(points.size());
    points.push_back({});
    for (const vtkIdType corner : *ids)
    {
      for (int k = 0; k < 3; ++k)
      {
        points.back()[k] += GetPoint(box, corner)[k] / 8.;
      }
    }
    vtkCell* cell = box->GetCell(c);
    for (int f = 0; f < 6; ++f)
    {
      vtkIdList* side = cell->GetFace(f)->GetPointIds();
      const vtkIdType* s = side->GetPointer(0);
      if (givesWay && f % 4 == 0)
      {
        cells.push_back({ VTK_TETRA, { s[0], s[1], s[2], centre } });
        cells.push_back({ VTK_TETRA, { s[0], s[2], s[3], centre } });
        continue;
      }
      cells.push_back({ VTK_PYRAMID, { side->begin(), side->end() } });
      cells.back().Points.push_back(centre);
    }
  }
  for (int layer = 0; givesWay && layer < 4; ++layer)
  {
    const auto first = static_cast<vtkIdType>(points.size());
    for (int i = 0; i < 6; ++i)
    {
      points.push_back({ 20. + std::cos(i), std::sin(i), 1. * layer });
    }
    const vtkIdType p = first - 6;
    if (layer > 0)
    {
      cells.push_back({ VTK_PENTAGONAL_PRISM,
        { p, p + 1, p + 2, p + 3, p + 4, first, first + 1, first + 2, first + 3, first + 4 } });
      cells.push_back({ VTK_HEXAHEDRON,
        { p, p + 4, p + 5, p + 5, first, first + 4, first + 5, first + layer % 2 } });
      cells.push_back({ VTK_QUAD, { p, first + 1, p + 1, first } });
    }
  }
  const Mesh mesh = MakeGrid(points, cells);
  AddArrays(vtkUnstructuredGrid::SafeDownCast(mesh));
  NumberCells(mesh);
  return mesh;
}

bool Keep(vtkPointSet* input, const UniformOptions& options, vtkPointSet* output)
{
  return SubdivideUniformly(input, options, vtkUnstructuredGrid::SafeDownCast(output));
}

/// Partitions of a mesh give the whole. `set`: further options.
void ExpectTheWhole(const Mesh& mesh, int level, const std::function<void(UniformOptions&)>& set)
{
  UniformOptions options;
  options.KeepCellTypes = true;
  options.Levels = level;
  options.GenerateGlobalIds = true;
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  options.Warn = [](const std::string& message)
  { EXPECT_EQ(std::string::npos, message.find("global ids")) << message; };
  set(options);
  const Mesh whole = subdivision::MakeMesh(false);
  ASSERT_TRUE(Keep(mesh, options, whole));
  subdivision::AddGlobalIds(whole);
  for (const Partition& partition : CommonPartitions)
  {
    SCOPED_TRACE(std::string(partition.Name) + ", levels " + std::to_string(level) + ", mesh of " +
      std::to_string(mesh->GetNumberOfCells()) + " cells");
    subdivision::DistributionOptions distribution;
    std::vector<Mesh> parts;
    ASSERT_TRUE(RunOnParts(
      Cut(mesh, partition), partition, distribution, options,
      [&options](vtkPointSet* input, vtkPointSet* output) { return Keep(input, options, output); },
      parts));
    ExpectWhole(whole, parts);
    ExpectIndices(whole, parts);
  }
}

/// The same for meshes with all types of cells.
void ExpectTheWhole(const std::vector<int>& levels, const std::function<void(UniformOptions&)>& set)
{
  std::vector<Mesh> meshes = { MakeBoxWithPyramids(false), MakeBoxWithPyramids(true) };
  for (const Mesh& model : MakeMeshes())
  {
    meshes.push_back(model);
  }
  for (const Mesh& mesh : meshes)
  {
    for (const int level : levels)
    {
      ExpectTheWhole(mesh, level, set);
    }
  }
}

}

TEST(PartitionsKeptTypes, GiveTheWhole)
{
  ExpectTheWhole(turns::Some({ 0, 1, 2 }),
    [](UniformOptions& options) { options.Scheme = subdivision::StampScheme::Linear; });
}

TEST(PartitionsKeptTypes, AreSmoothedAsTheWhole)
{
  ExpectTheWhole({ 1, 2 }, [](UniformOptions&) {});
}

TEST(PartitionsKeptTypes, LimitsAreThoseOfTheWhole)
{
  ExpectTheWhole({ 1 }, [](UniformOptions& options) { options.ProjectToLimit = true; });
}

TEST(PartitionsKeptTypes, NormalsAreThoseOfTheWhole)
{
  ExpectTheWhole({ 1 }, [](UniformOptions& options) { options.GenerateLimitNormals = true; });
}

TEST(PartitionsKeptTypes, AllPartitionsKeepTypesWhereOneHasThem)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (int i = 0; i <= 20; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      points.push_back({ 1. * i, 1. * (j % 2), 1. * (j / 2) });
    }
    const vtkIdType p = 4 * i;
    if (i < 19)
    {
      cells.push_back({ VTK_TETRA, { p, p + 1, p + 2, p + 4 } });
    }
  }
  cells.push_back({ VTK_HEXAHEDRON, { 76, 80, 81, 77, 78, 82, 83, 79 } });
  const Mesh mesh = MakeGrid(points, cells);
  AddArrays(vtkUnstructuredGrid::SafeDownCast(mesh));
  NumberCells(mesh);
  ExpectTheWhole(mesh, 2,
    [](UniformOptions& options)
    {
      options.KeepCellTypes = false;
      options.KeepsTypesIfPossible = true;
    });
}
