// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AdaptiveSurfaceMarks.h
 * Finds the faces of an adaptive sqrt(3) mesh that the criteria ask to split. All vertices lie on
 * the limit. How far an edge is from it between its ends follows from points of later levels.
 */
#ifndef SubdivisionObjects_AdaptiveSurfaceMarks_h
#define SubdivisionObjects_AdaptiveSurfaceMarks_h

#include "Private/AdaptiveSurface/AdaptiveSurfaceValues.h"

#include <utility>
#include <vector>

namespace subdivision
{

/// A face to be split, or a segment without faces to be cut.
template <typename Id>
struct AdaptiveMark
{
  double Error; ///< as a multiple of the allowed one
  Id Face;      ///< -1 - segment
};

/// The faces and segments that a partition looks at: where its own faces and lines are.
struct AdaptiveScope
{
  std::vector<char> Faces;    ///< 1 for each control face that is its own
  std::vector<char> Segments; ///< and for each control segment at an own face or line
};

/// Findings for the user.
struct AdaptiveNotes
{
  /// Edges of the input with a value that is not finite.
  std::vector<std::pair<vtkIdType, vtkIdType>> WithoutValue;
  /// Faces and segments that were not marked, because no number lies between the ends of an edge.
  vtkIdType TooShort = 0;
};

template <typename Id>
class AdaptiveSurfaceMarks
{
public:
  /// `faceCells`, `segmentCells`: the input cells of control faces and of segments without faces.
  /// `scope`: null to look at everything.
  AdaptiveSurfaceMarks(const AdaptiveSqrtThree<Id>& mesh, const AdaptiveSqrtThreeRows<Id>& rows,
    const RefinementOptions& options, RefinementCriteria& criteria,
    const std::vector<vtkIdType>& faceCells, const std::vector<vtkIdType>& segmentCells,
    const AdaptiveScope* scope);

  /// The marks on faces and segments that are new since the last call.
  std::vector<AdaptiveMark<Id>> Find(AdaptiveNotes& notes);

private:
  class Candidates;
  struct Verdict
  {
    double Error = 0.;
    unsigned char Edges = 0; ///< bits of the edges whose error is too large
    bool IsTooShort = false;
    bool HasNoValue = false;
  };
  /// The memory of a thread to find limits between vertices.
  struct Scratch
  {
    RowBlock<Id> Rows;
    std::vector<double> Places;
  };

  void Update();
  Id GetRoot(Id segment) const;
  bool IsInScope(Id face) const
  {
    return !this->Scope || this->Scope->Faces[this->Carriers[face].GetSmallest()] != 0;
  }
  double GetErrorAt(Id face, const double* place) const;
  double GetShapeError(Id corner, Scratch& scratch) const;
  double GetAttributeError(
    const double* const ends[2], int size, const double* places, bool& hasNoValue) const;
  double GetLimitError(Id corner, Scratch& scratch, bool& hasNoValue) const;
  void JudgeEdge(Id a, Id b, double atLimit, bool noValueAtLimit, int bit, Verdict& verdict) const;
  Verdict JudgeFace(Id face, Scratch& scratch) const;
  void JudgeInside(Id face, Scratch& scratch, Verdict& verdict) const;
  Verdict JudgeSegment(Id segment, Scratch& scratch) const;
  double GetSegmentError(Id segment, Scratch& scratch, bool& hasNoValue) const;
  void AddMarksOfOpen(Scratch& scratch, std::vector<AdaptiveMark<Id>>& marks) const;
  void AddMarks(
    Id at, bool isFace, const Verdict& verdict, std::vector<AdaptiveMark<Id>>& marks) const;
  void AddWithoutValue(const Row<Id>& points, AdaptiveNotes& notes) const;

  const AdaptiveSqrtThree<Id>& Mesh;
  const RefinementOptions& Options;
  RefinementCriteria& Criteria;
  const std::vector<vtkIdType>& FaceCells;
  const std::vector<vtkIdType>& SegmentCells;
  const AdaptiveScope* Scope;
  std::vector<AdaptiveSurfaceValues<Id>> Arrays; ///< coordinates first
  int Attribute = -1;                            ///< which of them
  AdaptiveSqrtThreeCarriers<Id> Carriers;
  std::vector<Id> Faces;    ///< new faces
  std::vector<Id> Segments; ///< new segments without faces
  std::vector<Id> Open;     ///< new segments of which a face is not there yet
  vtkIdType KnownVertices = 0;
  vtkIdType KnownFaces = 0; ///< how many of GetNewFaces were read
  vtkIdType KnownSegments = 0;
};

}

#endif
