// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AdaptiveSurfaceMarks.h
 * What criteria want of an adaptive sqrt(3) mesh: the faces that are to be split. All edges lie on
 * the limit; how far they are from it between their ends follows from points of later levels.
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
  double Error; ///< as a multiple of what is allowed
  Id Face;      ///< -1 - segment
};

/// What was found beside marks.
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
  AdaptiveSurfaceMarks(const AdaptiveSqrtThree<Id>& mesh, const AdaptiveSqrtThreeRows<Id>& rows,
    const RefinementOptions& options, RefinementCriteria& criteria,
    const std::vector<vtkIdType>& faceCells, const std::vector<vtkIdType>& segmentCells);

  /// The marks on all that came into being since the last call.
  std::vector<AdaptiveMark<Id>> Find(AdaptiveNotes& notes);

private:
  class Candidates;
  struct Verdict
  {
    double Error = 0.;
    unsigned char Edges = 0; ///< bits of those whose error is too large
    bool IsTooShort = false;
    bool HasNoValue = false;
  };
  /// What a thread needs to find limits between vertices.
  struct Scratch
  {
    RowBlock<Id> Rows;
    std::vector<double> Places;
  };

  void Update();
  void FindCarriers();
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
  std::vector<AdaptiveSurfaceValues<Id>> Arrays; ///< coordinates first
  int Attribute = -1;                            ///< which of them
  std::vector<Carrier<Id>> Carriers;             ///< of each face, on the control mesh
  std::vector<Id> Faces;                         ///< those that are new
  std::vector<Id> Segments;                      ///< the same of segments without faces,
  std::vector<Id> Open;                          ///< and of those of which a face is not there yet
  vtkIdType KnownVertices = 0;
  vtkIdType KnownFaces = 0; ///< of the list of new ones
  vtkIdType KnownSegments = 0;
};

}

#endif
