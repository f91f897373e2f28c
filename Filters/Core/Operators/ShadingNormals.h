// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadingNormals.h
 * Normals for points without tangent plane, which would be drawn black without a normal
 * (Mathematics 8).
 *
 * A point with facets (polygons) gets the mean of their normals weighted by area, or, where these
 * cancel, the normal of the first facet that has an area. A point with lines only gets a direction
 * perpendicular to the first line that has a length; a point without facets and lines gets the z
 * axis. These two directions are arbitrary, as no other is better.
 */
#ifndef SubdivisionObjects_ShadingNormals_h
#define SubdivisionObjects_ShadingNormals_h

#include "Core/Memory/Buffer.h"

#include <unordered_map>

namespace subdivision
{

class ShadingNormals
{
public:
  /// `points` and `normals` have three numbers for each point. Only normals of points in `missing`
  /// are written.
  ShadingNormals(const double* points, const Buffer<unsigned char>& missing, double* normals)
    : Points(points)
    , Missing(missing)
    , Normals(normals)
  {
  }

  bool IsMissing(vtkIdType point) const { return this->Missing[point] != 0; }

  /// Adds a polygon; the order of calls decides which facet is the first. `turned` reverses the
  /// normal.
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
    for (int i = 0; i < size; ++i)
    {
      if (this->IsMissing(corners[i]))
      {
        this->AddTo(corners[i], normal);
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
  void AddPoint(vtkIdType point)
  {
    if (this->IsMissing(point))
    {
      this->Sums[point];
    }
  }
  /// Writes the normals of all missing points at which something was added.
  void Fill();

private:
  struct Sum
  {
    double Facets[3] = { 0., 0., 0. };
    double First[3] = { 0., 0., 0. }; ///< of the first facet with an area
    double Line[3] = { 0., 0., 0. };  ///< along the first line with a length
    double Area = 0.;
  };
  double Get(vtkIdType point, int c) const { return this->Points[3 * point + c]; }
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c, double sign, double normal[3]) const;
  void AddTo(vtkIdType point, const double normal[3]);
  void Write(const Sum& sum, double normal[3]) const;

  const double* Points;
  const Buffer<unsigned char>& Missing;
  double* Normals;
  std::unordered_map<vtkIdType, Sum> Sums;
};

}

#endif
