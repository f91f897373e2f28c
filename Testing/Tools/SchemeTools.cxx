// SPDX-License-Identifier: BSD-3-Clause
#include "SchemeTools.h"

namespace surfacetools
{

Weights ToWeights(const RowBlock<int>& rows)
{
  Weights weights;
  for (std::size_t i = 0; i < rows.GetNumberOfEntries(); ++i)
  {
    weights[rows.GetColumns()[i]] += rows.GetWeights()[i];
  }
  return weights;
}

void ExpectRow(const Weights& row, const Weights& expected, const std::string& what)
{
  Weights differences = expected;
  for (const auto& entry : row)
  {
    differences[entry.first] -= entry.second;
  }
  for (const auto& entry : differences)
  {
    EXPECT_NEAR(entry.second, 0., 1e-14) << what << ", column " << entry.first;
  }
}

Weights Flatten(Weights row, int k, double s, double first, double last)
{
  for (auto& entry : row)
  {
    entry.second *= 1. - s;
  }
  row[0] += s * (1. - first - last);
  row[1] += s * first;
  row[1 + k] += s * last;
  return row;
}

SurfaceFeatures GiveShape(
  std::size_t points, const std::vector<int>& vertices, double angle, double flatness)
{
  SurfaceFeatures features;
  features.Angles.assign(points, -1.);
  features.Flatness.assign(points, -1.);
  for (int vertex : vertices)
  {
    features.Angles[vertex] = angle;
    features.Flatness[vertex] = flatness;
  }
  return features;
}

void ClassifyModel(const Model& model, const SurfaceScheme<int>& scheme, SurfaceFeatures features,
  SurfaceLevel<int>& level)
{
  features.Corners.assign(model.Points.size(), 0);
  for (vtkIdType corner : model.Corners)
  {
    features.Corners[corner] = 1;
  }
  features.SharpEdges.assign(static_cast<std::size_t>(level.Mesh.GetNumberOfEdges()), 0);
  for (int line : level.Lines)
  {
    features.SharpEdges[line / 2] = 1;
  }
  level.Tags = ClassifySurface(level.Mesh, scheme, features, model.Points.data()->data());
}

SchemeRows::SchemeRows(
  SurfaceSchemeKind scheme, const Model& model, const SurfaceFeatures& features)
  : Level(MakeLevel(model.Points.size(), model.Faces, model.Lines))
  , Modified(MakeSurfaceScheme<int>(scheme, true))
  , Plain(MakeSurfaceScheme<int>(scheme, false))
{
  ClassifyModel(model, *this->Modified, features, this->Level);
}

Weights SchemeRows::GetRow(vtkIdType at, bool modified) const
{
  RowBlock<int> rows;
  const auto& scheme = modified ? this->Modified : this->Plain;
  scheme->AppendRows(this->Level, this->Level.Tags, at, at + 1, rows);
  return ToWeights(rows);
}

int SchemeRows::FindEdge(int a, int b) const
{
  const PolygonMesh<int>& mesh = this->Level.Mesh;
  int e = 0;
  while (e < mesh.GetNumberOfEdges() &&
    std::minmax(mesh.EdgeVertices[2 * e], mesh.EdgeVertices[2 * e + 1]) != std::minmax(a, b))
  {
    ++e;
  }
  EXPECT_LT(e, mesh.GetNumberOfEdges()) << "no edge " << a << " " << b;
  return e % static_cast<int>(mesh.GetNumberOfEdges());
}

}
