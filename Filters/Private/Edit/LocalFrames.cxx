// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Edit/LocalFrames.h"

#include "Private/ArrayNames.h"
#include "Private/Reading/CellsToSimplices.h"
#include "Private/Uniform/UniformSubdivision.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace subdivision
{
namespace
{

/// A tangent that is shorter than this part of the other, and a height over a plane below this part
/// of the lengths in it, may be rounding.
constexpr double Flat = 1e-6;

vtkDataArray* FindVectorArray(vtkPointSet* mesh, const char* name)
{
  vtkDataArray* array = mesh->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == 3 &&
      array->GetNumberOfTuples() >= mesh->GetNumberOfPoints()
    ? array
    : nullptr;
}

/// Sets to[0..2] to the vectors of a plane or a curve and a third one, whose length is their mean.
void Complete(double* vectors)
{
  double* third = vectors + 6;
  vtkMath::Cross(vectors, vectors + 3, third);
  const double area = vtkMath::Norm(third);
  vtkMath::MultiplyScalar(third, 1. / std::sqrt(area));
}

bool SpanPlane(const double* vectors)
{
  double normal[3];
  vtkMath::Cross(vectors, vectors + 3, normal);
  return vtkMath::Norm(normal) > Flat * vtkMath::Norm(vectors) * vtkMath::Norm(vectors + 3);
}

/// Sums for the linear map that takes vectors v to vectors u as well as possible: of u v^T, and of
/// v v^T.
struct MapSums
{
  double Both[9] = {};
  double Own[9] = {};

  void Add(const double* v, const double* u)
  {
    for (int i = 0; i < 3; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Both[3 * i + k] += u[i] * v[k];
        this->Own[3 * i + k] += v[i] * v[k];
      }
    }
  }
  /// Returns false where the vectors are nearly in a plane.
  bool Solve(double* map) const
  {
    double inverse[9];
    const double* m = this->Own;
    const auto cofactor = [m](int r, int c)
    {
      const int r1 = (r + 1) % 3;
      const int r2 = (r + 2) % 3;
      const int c1 = (c + 1) % 3;
      const int c2 = (c + 2) % 3;
      return m[3 * r1 + c1] * m[3 * r2 + c2] - m[3 * r1 + c2] * m[3 * r2 + c1];
    };
    const double determinant =
      m[0] * cofactor(0, 0) + m[1] * cofactor(0, 1) + m[2] * cofactor(0, 2);
    const double size = (m[0] + m[4] + m[8]) / 3.;
    if (!(determinant > Flat * size * size * size))
    {
      return false;
    }
    for (int i = 0; i < 3; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        inverse[3 * i + k] = cofactor(k, i) / determinant;
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        map[3 * i + k] = this->Both[3 * i] * inverse[k] + this->Both[3 * i + 1] * inverse[3 + k] +
          this->Both[3 * i + 2] * inverse[6 + k];
      }
    }
    return true;
  }
};

void SetIdentity(double* map)
{
  for (int i = 0; i < 9; ++i)
  {
    map[i] = i % 4 == 0 ? 1. : 0.;
  }
}

/// The smallest rotation that turns v to u, times the ratio of their lengths (O. Rodrigues).
void TurnTangent(const double* v, const double* u, double* map)
{
  double from[3] = { v[0], v[1], v[2] };
  double to[3] = { u[0], u[1], u[2] };
  const double ratio = vtkMath::Norm(u) / vtkMath::Norm(v);
  vtkMath::Normalize(from);
  vtkMath::Normalize(to);
  double axis[3];
  vtkMath::Cross(from, to, axis);
  const double cosine = vtkMath::Dot(from, to);
  const bool isOpposite = cosine <= Flat - 1.;
  const double skew[9] = { 0., -axis[2], axis[1], axis[2], 0., -axis[0], -axis[1], axis[0], 0. };
  for (int i = 0; i < 9; ++i)
  {
    const double square = axis[i / 3] * axis[i % 3] - (i % 4 == 0 ? vtkMath::Dot(axis, axis) : 0.);
    map[i] = (i % 4 == 0 ? 1. : 0.) + (isOpposite ? 0. : skew[i] + square / (1. + cosine));
    map[i] *= ratio;
  }
}

/// Adds the edges around points inside solids.
void AddEdges(
  vtkPointSet* mesh, const FramedMesh& rest, const FramedMesh& moved, std::vector<MapSums>& sums)
{
  const SimplicesOfCells cells = CellsToSimplices(mesh, nullptr, PlainIds::InPlace);
  const SimplexView view = cells.GetView();
  const vtkIdType points = mesh->GetNumberOfPoints();
  const vtkIdType* ids = view.Connectivity;
  for (const vtkIdType s : InTurn(view.NumberOfSimplices))
  {
    const int size = view.Dimensions[s] + 1;
    for (int i = 0; size == 4 && i < size; ++i)
    {
      for (int k = 0; ids[i] < points && rest.IsInside(ids[i]) && k < size; ++k)
      {
        if (k == i || ids[k] >= points)
        {
          continue;
        }
        double ends[4][3];
        rest.GetPoint(ids[i], ends[0]);
        rest.GetPoint(ids[k], ends[1]);
        moved.GetPoint(ids[i], ends[2]);
        moved.GetPoint(ids[k], ends[3]);
        vtkMath::Subtract(ends[1], ends[0], ends[1]);
        vtkMath::Subtract(ends[3], ends[2], ends[3]);
        sums[ids[i]].Add(ends[1], ends[3]);
      }
    }
    ids += size;
  }
}

}

bool HasFrameArrays(vtkPointSet* mesh)
{
  return FindVectorArray(mesh, LimitNormalsName) && FindVectorArray(mesh, LimitTangentNames[0]) &&
    FindVectorArray(mesh, LimitTangentNames[1]);
}

FramedMesh::FramedMesh(vtkPointSet* mesh, bool fromArrays, const RunOptions& options)
  : Mesh(mesh)
  , Bends(3 * mesh->GetNumberOfPoints(), 0.)
{
  vtkNew<vtkUnstructuredGrid> made;
  vtkPointSet* from = mesh;
  if (!fromArrays)
  {
    UniformOptions uniform;
    uniform.MaximumNumberOfCells = options.MaximumNumberOfCells;
    uniform.Progress = options.Progress;
    uniform.Warn = [](const std::string&) {}; // the filters that subdivide the output warn
    uniform.Fail = options.Fail;
    uniform.Levels = 0;
    uniform.GenerateLimitNormals = true;
    uniform.GenerateTangents = true;
    uniform.KeepsTypesIfPossible = true;
    if (!SubdivideUniformly(mesh, uniform, made))
    {
      return;
    }
    from = made;
  }
  this->Normals = FindVectorArray(from, LimitNormalsName);
  this->Tangents[0] = FindVectorArray(from, LimitTangentNames[0]);
  this->Tangents[1] = FindVectorArray(from, LimitTangentNames[1]);
  const SimplicesOfCells cells = CellsToSimplices(mesh, nullptr, PlainIds::InPlace);
  const SimplexView view = cells.GetView();
  const vtkIdType* ids = view.Connectivity;
  for (const vtkIdType s : InTurn(view.NumberOfSimplices))
  {
    if (view.Dimensions[s] == 1)
    {
      double ends[2][3];
      this->GetPoint(ids[0], ends[0]);
      this->GetPoint(ids[1], ends[1]);
      for (int c = 0; c < 3; ++c)
      {
        this->Bends[3 * ids[0] + c] += ends[1][c] - ends[0][c];
        this->Bends[3 * ids[1] + c] += ends[0][c] - ends[1][c];
      }
    }
    ids += view.Dimensions[s] + 1;
  }
}

void FramedMesh::GetPoint(vtkIdType point, double* x) const
{
  this->Mesh->GetPoints()->GetData()->GetTuple(point, x);
}

bool FramedMesh::IsInside(vtkIdType point) const
{
  double normal[3];
  this->Normals->GetTuple(point, normal);
  return normal[0] == 0. && normal[1] == 0. && normal[2] == 0.;
}

int FramedMesh::FindVectors(vtkIdType point, double* vectors) const
{
  this->Tangents[0]->GetTuple(point, vectors);
  this->Tangents[1]->GetTuple(point, vectors + 3);
  const double squared = vtkMath::Dot(vectors, vectors);
  if (!(squared > 0.) || !std::isfinite(squared))
  {
    return 0;
  }
  if (vtkMath::Norm(vectors + 3) > 0.)
  {
    if (!SpanPlane(vectors))
    {
      return 0;
    }
    Complete(vectors);
    return 3;
  }
  const double* bend = this->Bends.data() + 3 * point;
  const double along = vtkMath::Dot(bend, vectors) / squared;
  for (int c = 0; c < 3; ++c)
  {
    vectors[3 + c] = bend[c] - along * vectors[c];
  }
  if (!(vtkMath::Norm(vectors + 3) > Flat * std::sqrt(squared)))
  {
    return 1;
  }
  Complete(vectors);
  return 3;
}

void FramedMesh::FindAxes(vtkIdType point, double* axes) const
{
  double vectors[9];
  if (this->FindVectors(point, vectors) < 3)
  {
    SetIdentity(axes);
    return;
  }
  std::copy_n(vectors, 3, axes);
  std::copy_n(vectors + 6, 3, axes + 6);
  vtkMath::Normalize(axes);
  vtkMath::Normalize(axes + 6);
  vtkMath::Cross(axes + 6, axes, axes + 3);
}

Buffer<double> FindLocalMaps(vtkPointSet* restMesh, const FramedMesh& rest, const FramedMesh& moved)
{
  const vtkIdType size = rest.GetNumberOfPoints();
  std::vector<MapSums> edges(static_cast<std::size_t>(size));
  AddEdges(restMesh, rest, moved, edges);
  Buffer<double> maps(9 * size);
  ForEach(size,
    [&](vtkIdType i)
    {
      double from[9];
      double to[9];
      double* map = maps.data() + 9 * i;
      const int vectors = std::min(rest.FindVectors(i, from), moved.FindVectors(i, to));
      MapSums& sums = edges[static_cast<std::size_t>(i)];
      for (int v = 0; vectors == 3 && v < 3; ++v)
      {
        sums.Add(from + 3 * v, to + 3 * v);
      }
      if (vectors == 1)
      {
        TurnTangent(from, to, map);
      }
      else if (!sums.Solve(map))
      {
        SetIdentity(map);
      }
    });
  return maps;
}

}
