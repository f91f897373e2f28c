// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AdaptiveSurfaceValues.h
 * Computes the limit values of an array while an adaptive sqrt(3) mesh grows: at its vertices, and
 * at the points that its faces would get if they were split.
 */
#ifndef SubdivisionObjects_AdaptiveSurfaceValues_h
#define SubdivisionObjects_AdaptiveSurfaceValues_h

#include "Core/Surfaces/SqrtThree/AdaptiveSqrtThreeRows.h"
#include "Private/Criteria/RefinementCriteria.h"

#include <vector>

namespace subdivision
{

template <typename Id>
class AdaptiveSurfaceValues
{
public:
  /// `array` has the values of the control vertices and gets the limits of all vertices. `ofLimit`:
  /// a criterion also needs limits at the points that faces would get.
  AdaptiveSurfaceValues(const AdaptiveSqrtThree<Id>& mesh, const AdaptiveSqrtThreeRows<Id>& rows,
    ContinuedArray& array, bool ofLimit)
    : Mesh(mesh)
    , Rows(rows)
    , Array(array)
    , Components(array.GetComponents())
    , IsSmooth(array.IsSmooth() || ofLimit)
    , OfLimit(ofLimit)
  {
  }
  int GetComponents() const { return this->Components; }
  bool IsOfLimit() const { return this->OfLimit; }

  /// Computes the values of new vertices and faces, both sorted by level, and of the segments from
  /// `firstSegment` on.
  void Add(const std::vector<Id>& vertices, const std::vector<Id>& faces, vtkIdType firstSegment)
  {
    this->AddVertices(vertices);
    if (this->OfLimit)
    {
      this->AddCentres(faces, firstSegment);
    }
  }

  const double* GetLimit(Id vertex) const
  {
    return this->Nodes.data() + (2 * static_cast<vtkIdType>(vertex) + 1) * this->Components;
  }
  const double* GetCentre(Id face) const
  {
    return this->Centres.data() + static_cast<vtkIdType>(face) * this->Components;
  }
  const double* GetThird(Id segment, bool isSecond) const
  {
    return this->Thirds.data() +
      (2 * static_cast<vtkIdType>(segment) + (isSecond ? 1 : 0)) * this->Components;
  }
  /// The parameters on an edge at which FindPlaces gives limits.
  static constexpr double Places[3] = { 1. / 2., 1. / 3., 2. / 3. };
  /**
   * Writes the limits at Places and returns how many of them are known: none where the other face
   * of the edge is not there, only the middle where a face is cut, else three. The thirds are
   * points of later levels and so exact; the middle follows from them and the ends
   * (FindMiddleOfThirds). A cubic curve that meets its chord in all three places is straight.
   */
  int FindPlaces(Id corner, RowBlock<Id>& rows, double* places) const;
  int FindPlacesOfSegment(Id segment, double* places) const;
  /**
   * The middle alone, from points of the next level; false where the other face is not there. The
   * centres P and Q of the two faces and the opposite vertices C and D lie at equal distances on a
   * line that crosses the middle of the edge. So this is 9/16 (P + Q) - 1/16 (C + D), up to fourth
   * order.
   */
  bool FindMiddle(Id corner, double* middle) const;

private:
  const double* GetFirstCentre(Id face) const
  {
    return this->FirstCentres.data() + static_cast<vtkIdType>(face) * this->Components;
  }
  void Add(const double* value, double weight, double* sum) const
  {
    for (int c = 0; c < this->Components; ++c)
    {
      sum[c] += weight * value[c];
    }
  }
  void AddPosition(Id vertex, int level, double weight, double* sum) const;
  bool FindRegularThirds(Id corner, double* thirds) const;
  void FindMiddleOfThirds(Id begin, Id end, const double* thirds, double* middle) const;
  int GetLevel(Id vertex) const
  {
    return vertex < this->Mesh.GetNumberOfControlVertices()
      ? -1
      : static_cast<int>(this->Mesh.GetAdded(vertex).Level);
  }
  void AddVertices(const std::vector<Id>& vertices);
  vtkIdType FindOrigin(Id vertex) const;
  void AddCentres(const std::vector<Id>& faces, vtkIdType firstSegment);

  const AdaptiveSqrtThree<Id>& Mesh;
  const AdaptiveSqrtThreeRows<Id>& Rows;
  ContinuedArray& Array;
  int Components;
  bool IsSmooth;
  bool OfLimit;
  std::vector<vtkIdType> Origins; ///< the control vertex whose value each vertex has, if not smooth
  std::vector<double> Nodes;      ///< first value and limit of each vertex
  std::vector<double> Centres;
  std::vector<double> FirstCentres; ///< their first values
  std::vector<double> Thirds;       ///< two for each segment
};

}

#endif
