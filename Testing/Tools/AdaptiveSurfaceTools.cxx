// SPDX-License-Identifier: BSD-3-Clause
#include "AdaptiveSurfaceTools.h"

namespace surfacetools
{

void Adaptive::SplitTo(int level)
{
  for (int face = 0; face < this->Mesh.GetNumberOfFaces(); ++face)
  {
    if (this->Mesh.IsThere(face) && this->Mesh.GetLevel(face) < level)
    {
      this->Mesh.Split(face);
    }
  }
  for (int segment = 0; segment < this->Mesh.GetNumberOfSegments(); ++segment)
  {
    if (this->Mesh.GetSegmentAt(segment).Level + 2 <= level &&
      this->Mesh.GetSegmentAt(segment).NumberOfSides == 0)
    {
      this->Mesh.Cut(segment);
    }
  }
}

void Adaptive::SplitAtRandom(unsigned seed, int rounds, int maximumLevel)
{
  std::mt19937 random(seed);
  for (int round = 0; round < rounds; ++round)
  {
    const int size = static_cast<int>(this->Mesh.GetNumberOfFaces());
    for (int i = 0; i < 3; ++i)
    {
      const int face = static_cast<int>(random() % static_cast<unsigned>(size));
      if (this->Mesh.IsThere(face) && this->Mesh.GetLevel(face) < maximumLevel)
      {
        this->Mesh.Split(face);
      }
    }
  }
}

Adaptive::Result Adaptive::Finish()
{
  const AdaptiveSqrtThreeOutput<int> output(this->Mesh);
  Result result;
  result.Triangles.resize(output.GetNumberOfTriangles());
  result.Generations.resize(result.Triangles.size());
  result.Faces.resize(result.Triangles.size());
  output.WriteTriangles(
    result.Triangles.data()->data(), result.Generations.data(), result.Faces.data());
  const AdaptiveSqrtThreeRows<int> rows(this->Mesh, this->Control.Level, *this->Control.Scheme);
  const AdaptiveSqrtThreeLimit<int> limit(rows, output.GetVertexLevels());
  EXPECT_EQ(limit.GetNumberOfRows(), this->Mesh.GetNumberOfVertices());
  result.Points.resize(limit.GetNumberOfRows());
  limit.Apply(this->Control.Points.data()->data(), result.Points.data()->data(), 3);
  return result;
}

}
