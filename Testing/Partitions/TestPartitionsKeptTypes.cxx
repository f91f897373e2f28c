// SPDX-License-Identifier: BSD-3-Clause
// With KeepCellTypes partitions, simulated in one process, give the cells, values and numbers of
// the whole mesh.
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
/// pyramids around its centre.
Mesh MakeBoxWithPyramids()
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
      cells.push_back({ VTK_PYRAMID, { side->begin(), side->end() } });
      cells.back().Points.push_back(centre);
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

}

TEST(PartitionsKeptTypes, GiveTheWhole)
{
  std::vector<Mesh> meshes = { MakeBoxWithPyramids() };
  for (const Mesh& model : MakeMeshes())
  {
    meshes.push_back(model);
  }
  for (const Mesh& mesh : meshes)
  {
    for (const int levels : turns::Some({ 0, 1, 2 }))
    {
      UniformOptions options;
      options.Scheme = subdivision::StampScheme::Linear;
      options.KeepCellTypes = true;
      options.Levels = levels;
      options.GenerateGlobalIds = true;
      options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
      options.Warn = [](const std::string& message)
      { EXPECT_EQ(std::string::npos, message.find("global ids")) << message; };
      const Mesh whole = subdivision::MakeMesh(false);
      ASSERT_TRUE(Keep(mesh, options, whole));
      subdivision::AddGlobalIds(whole);
      for (const Partition& partition : CommonPartitions)
      {
        SCOPED_TRACE(std::string(partition.Name) + ", levels " + std::to_string(levels) +
          ", mesh of " + std::to_string(mesh->GetNumberOfCells()) + " cells");
        subdivision::DistributionOptions distribution;
        std::vector<Mesh> parts;
        ASSERT_TRUE(RunOnParts(
          Cut(mesh, partition), partition, distribution, options,
          [&options](vtkPointSet* input, vtkPointSet* output)
          { return Keep(input, options, output); }, parts));
        ExpectWhole(whole, parts);
        ExpectIndices(whole, parts);
      }
    }
  }
}
