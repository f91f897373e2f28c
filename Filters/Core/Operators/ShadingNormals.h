// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadingNormals.h
 * Normals for points without tangent plane, which would be drawn black without a normal
 * (Mathematics 8).
 *
 * A point with facets (polygons) gets the mean of their normals weighted by area, or, where these
 * cancel, the normal of the largest facet. A point with lines only gets a direction perpendicular
 * to them: to the chord of their other ends if there are two, so that a curve has the normal of its
 * tangent, else to the longest one. A point without facets and lines gets the z axis. Where several
 * directions are as good, the choice depends on coordinates and never on numbers of points or on
 * the order of calls.
 */
#ifndef SubdivisionObjects_ShadingNormals_h
#define SubdivisionObjects_ShadingNormals_h

#include "Core/Memory/Buffer.h"

#include <array>
#include <vector>

namespace subdivision
{

/// A unit vector perpendicular to a vector of any length, in the plane of the vector and that axis
/// to which it is least parallel; the z axis for a vector without length or direction.
void FindPerpendicular(const double vector[3], double normal[3]);

class ShadingNormals
{
public:
  /// `points` and `normals` have three numbers for each point. Only normals of points in `missing`
  /// are written.
  ShadingNormals(const double* points, const Buffer<unsigned char>& missing, double* normals)
    : Points(points)
    , Missing(missing)
    , Normals(normals)
    , Found(missing.size(), 0)
  {
  }

  bool IsMissing(vtkIdType point) const { return this->Missing[point] != 0; }

  /// Adds a polygon. `turned` reverses the normal.
  template <typename Id>
  void AddFacet(const Id* corners, int size, bool turned)
  {
    bool isMissing = false;
    for (int i = 0; i < size; ++i)
    {
      isMissing = isMissing || this->IsMissing(corners[i]);
    }
    if (!isMissing)
    {
      return;
    }
    double normal[3] = { 0., 0., 0. };
    for (int i = 2; i < size; ++i)
    {
      this->AddTriangle(corners[0], corners[i - 1], corners[i], turned ? -1. : 1., normal);
    }
    const bool isFacet = this->AddNormal(normal);
    for (int i = 0; i < size; ++i)
    {
      if (this->IsMissing(corners[i]))
      {
        this->AddToFacet(corners[i], isFacet);
      }
    }
  }
  /// Adds a boundary triangle of the solid whose fourth vertex is `inside`. Its normal points out
  /// of the solid.
  template <typename Id>
  void AddFacetOfSolid(const Id* corners, Id inside)
  {
    double normal[3] = { 0., 0., 0. };
    this->AddTriangle(corners[0], corners[1], corners[2], 1., normal);
    double height = 0.;
    for (int c = 0; c < 3; ++c)
    {
      height += normal[c] * (this->Get(inside, c) - this->Get(corners[0], c));
    }
    this->AddFacet(corners, 3, height > 0.);
  }
  void AddLine(vtkIdType a, vtkIdType b);
  /// From now on a point takes the first of its lines only: where others may end elsewhere in other
  /// parts of the mesh.
  void TakeFirstLines() { this->FirstLines = true; }
  void AddPoint(vtkIdType point)
  {
    if (this->IsMissing(point))
    {
      this->Found[point] |= IsThere;
    }
  }
  /// Writes the normals of all missing points at which something was added.
  void Fill();

private:
  using Vector = std::array<double, 3>;
  /// Something at a point: the number of a facet, or the vector to the other end of a line.
  template <typename T>
  struct Part
  {
    vtkIdType Point;
    T What;
  };
  enum : unsigned char
  {
    IsThere = 1,
    HasLine = 2
  };
  double Get(vtkIdType point, int c) const { return this->Points[3 * point + c]; }
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c, double sign, double normal[3]) const;
  bool AddNormal(const double normal[3]);
  void AddToFacet(vtkIdType point, bool isFacet);

  const double* Points;
  const Buffer<unsigned char>& Missing;
  double* Normals;
  bool FirstLines = false;
  Buffer<unsigned char> Found;         ///< what lies at each point
  std::vector<Vector> FacetNormals;    ///< twice as long as facets are large
  std::vector<Part<vtkIdType>> Facets; ///< at points
  std::vector<Part<Vector>> Lines;
};

}

#endif
