// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadingNormals.h
 * Normals for points that have no tangents, so that they are not drawn black.
 *
 * At joints, corners and whatever else has facets: the mean of the facets' normals, weighted by
 * area, or, where they cancel, that of the first facet that has one. On curves a direction across
 * the first line, and at single points the z axis: nothing is more right there than anything else.
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
  /// Three coordinates and three numbers of the normal for each point; `missing`: whether it is to
  /// be written.
  ShadingNormals(const double* points, const Buffer<unsigned char>& missing, double* normals)
    : Points(points)
    , Missing(missing)
    , Normals(normals)
  {
  }

  bool IsMissing(vtkIdType point) const { return this->Missing[point] != 0; }

  /// In the order of the facets; `turned`: the normal has the other direction.
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
  /// A triangle with a solid behind it, which has the vertex `inside`.
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
  /// Writes the normals of all points that were added and had none.
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
