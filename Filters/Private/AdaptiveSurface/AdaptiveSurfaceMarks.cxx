// SPDX-License-Identifier: BSD-3-Clause
#include "Private/AdaptiveSurface/AdaptiveSurfaceMarks.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Sorting.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace subdivision
{

/// The new faces, or the new segments without faces, in the form in which RefinementCriteria reads
/// cells.
template <typename Id>
class AdaptiveSurfaceMarks<Id>::Candidates
{
public:
  Candidates(const AdaptiveSurfaceMarks& marks, bool isFaces)
    : Marks(marks)
    , IsFaces(isFaces)
  {
  }
  const std::vector<Id>& GetAll() const
  {
    return this->IsFaces ? this->Marks.Faces : this->Marks.Segments;
  }
  vtkIdType GetSize() const { return static_cast<vtkIdType>(this->GetAll().size()); }
  Id Get(vtkIdType i) const { return this->GetAll()[i]; }
  Row<Id> GetPoints(vtkIdType i) const
  {
    const Id* points = this->IsFaces ? this->Marks.Mesh.GetVertices(this->Get(i))
                                     : this->Marks.Mesh.GetSegmentAt(this->Get(i)).Ends;
    return { points, points + (this->IsFaces ? 3 : 2) };
  }
  vtkIdType GetInputCell(vtkIdType i) const
  {
    return this->IsFaces ? this->Marks.FaceCells[this->Marks.Carriers[this->Get(i)].GetSmallest()]
                         : this->Marks.SegmentCells[this->Marks.GetRoot(this->Get(i))];
  }
  int GetLevel(vtkIdType i) const
  {
    return this->IsFaces ? this->Marks.Mesh.GetLevel(this->Get(i))
                         : this->Marks.Mesh.GetSegmentAt(this->Get(i)).Level;
  }
  /// The number of levels between a face or segment and the parts that a split makes of it.
  int GetStep() const { return this->IsFaces ? 1 : 2; }

private:
  const AdaptiveSurfaceMarks& Marks;
  const bool IsFaces; ///< or segments
};

template <typename Id>
AdaptiveSurfaceMarks<Id>::AdaptiveSurfaceMarks(const AdaptiveSqrtThree<Id>& mesh,
  const AdaptiveSqrtThreeRows<Id>& rows, const RefinementOptions& options,
  RefinementCriteria& criteria, const std::vector<vtkIdType>& faceCells,
  const std::vector<vtkIdType>& segmentCells, const AdaptiveScope* scope)
  : Mesh(mesh)
  , Options(options)
  , Criteria(criteria)
  , FaceCells(faceCells)
  , SegmentCells(segmentCells)
  , Scope(scope)
  , Carriers(mesh)
{
  for (ContinuedArray* array : criteria.GetPointArrays())
  {
    const bool isCoordinates = this->Arrays.empty();
    const bool isAttribute = array == &criteria.GetAttribute();
    const bool ofLimit =
      isCoordinates ? options.ReadsShape() : isAttribute && options.AttributeErrorOfLimit;
    this->Attribute = isAttribute ? static_cast<int>(this->Arrays.size()) : this->Attribute;
    this->Arrays.emplace_back(mesh, rows, *array, ofLimit);
  }
}

// ------------------------------------------------------------------------------------------------
// New faces, vertices and segments

/// The control segment of which a segment is a part.
template <typename Id>
Id AdaptiveSurfaceMarks<Id>::GetRoot(Id segment) const
{
  while (this->Mesh.GetSegmentAt(segment).Parent >= 0)
  {
    segment = this->Mesh.GetSegmentAt(segment).Parent;
  }
  return segment;
}

/// Adds the faces, vertices and segments that are new since the last call.
template <typename Id>
void AdaptiveSurfaceMarks<Id>::Update()
{
  const auto& made = this->Mesh.GetNewFaces();
  const vtkIdType given = this->Mesh.GetNumberOfControlVertices();
  this->Faces.assign(made.begin() + this->KnownFaces, made.end());
  const bool isFirst = this->KnownVertices == 0;
  for (vtkIdType f = this->Mesh.GetNumberOfControlFaces() - 1; isFirst && f >= 0; --f)
  {
    this->Faces.push_back(static_cast<Id>(f));
  }
  StableSort(this->Faces,
    [this](Id a, Id b)
    {
      const int first = this->Mesh.GetLevel(a);
      const int second = this->Mesh.GetLevel(b);
      return first != second ? second > first : b > a;
    });
  this->KnownFaces = static_cast<vtkIdType>(made.size());
  this->Carriers.Continue();
  std::vector<Id> vertices(this->Mesh.GetNumberOfVertices() - this->KnownVertices);
  std::iota(vertices.begin(), vertices.end(), static_cast<Id>(this->KnownVertices));
  StableSort(vertices,
    [&](Id a, Id b)
    {
      const int first = a < given ? -1 : this->Mesh.GetAdded(a).Level;
      const int second = b < given ? -1 : this->Mesh.GetAdded(b).Level;
      return second > first;
    });
  for (AdaptiveSurfaceValues<Id>& values : this->Arrays)
  {
    values.Add(vertices, this->Faces, this->KnownSegments);
  }
  this->Faces.erase(std::remove_if(this->Faces.begin(), this->Faces.end(),
                      [this](Id face) { return !this->IsInScope(face); }),
    this->Faces.end());
  this->KnownVertices = this->Mesh.GetNumberOfVertices();
  this->Segments.clear();
  this->Open.clear();
  for (; this->KnownSegments < this->Mesh.GetNumberOfSegments(); ++this->KnownSegments)
  {
    const Id at = static_cast<Id>(this->KnownSegments);
    if (this->Scope && !this->Scope->Segments[this->GetRoot(at)])
    {
      continue;
    }
    const auto& segment = this->Mesh.GetSegmentAt(at);
    bool isOpen = false;
    for (Id i = 0; i < segment.NumberOfSides; ++i)
    {
      isOpen = isOpen || this->Mesh.GetSide(segment, i) < 0;
    }
    if (isOpen || segment.NumberOfSides == 0)
    {
      (isOpen ? this->Open : this->Segments).push_back(at);
    }
  }
}

// ------------------------------------------------------------------------------------------------
// Errors

namespace
{

/// The factor by which an error may be larger beside the places where it is measured: three on an
/// edge, but only the centre of a face. It multiplies the factor of RefinementCriteria. It comes
/// from experiments and is no bound: with 1.1 a few of 200 random meshes have errors that are too
/// large, with this value none has.
constexpr double FewPlaces = 1.2;

/// Whether the foot of the perpendicular from a place lies beyond an edge of a triangle.
bool IsBeyond(const double* const x[3], int edge, const double* place)
{
  double sides[3][3];
  double normal[3];
  double toPlace[3];
  const double* begin = x[edge];
  vtkMath::Subtract(x[(edge + 1) % 3], begin, sides[0]);
  vtkMath::Subtract(x[(edge + 2) % 3], begin, sides[1]);
  vtkMath::Subtract(place, begin, sides[2]);
  vtkMath::Cross(sides[0], sides[1], normal);
  vtkMath::Cross(sides[0], sides[2], toPlace);
  return vtkMath::Dot(normal, toPlace) < 0.;
}

}

/// The geometric error of a face at a place on the limit.
template <typename Id>
double AdaptiveSurfaceMarks<Id>::GetErrorAt(Id face, const double* place) const
{
  const Id* vertices = this->Mesh.GetVertices(face);
  const double* const corners[3] = { this->Arrays[0].GetLimit(vertices[0]),
    this->Arrays[0].GetLimit(vertices[1]), this->Arrays[0].GetLimit(vertices[2]) };
  return FewPlaces * this->Criteria.GetGeometricError(corners, 3, place);
}

/// The geometric error over an edge between two faces.
template <typename Id>
double AdaptiveSurfaceMarks<Id>::GetShapeError(Id corner, Scratch& scratch) const
{
  const AdaptiveSurfaceValues<Id>& points = this->Arrays[0];
  const int size = points.FindPlaces(corner, scratch.Rows, scratch.Places.data());
  if (size == 0)
  {
    return 0.;
  }
  auto getLimit = [&](Id at) { return points.GetLimit(this->Mesh.GetVertex(at)); };
  const double* const ends[2] = { getLimit(corner), getLimit(this->Mesh.Next(corner)) };
  const double* const opposites[2] = { getLimit(this->Mesh.Previous(corner)),
    getLimit(this->Mesh.Previous(this->Mesh.GetTwin(corner))) };
  double error = 0.;
  for (int i = 0; i < size; ++i)
  {
    error = std::max(
      error, this->Criteria.GetErrorOverEdge(ends, opposites, 2, scratch.Places.data() + 3 * i));
  }
  return FewPlaces * error;
}

/// The attribute error of an edge: the largest difference between values on the limit and the
/// linear interpolation between its ends.
template <typename Id>
double AdaptiveSurfaceMarks<Id>::GetAttributeError(
  const double* const ends[2], int size, const double* places, bool& hasNoValue) const
{
  const AdaptiveSurfaceValues<Id>& values = this->Arrays[this->Attribute];
  double error = 0.;
  for (int i = 0; i < size; ++i)
  {
    const double at = AdaptiveSurfaceValues<Id>::Places[i];
    const double weights[2] = { 1. - at, at };
    const double own = FewPlaces *
      this->Criteria.GetAttributeErrorAtLimit(ends, weights, places + i * values.GetComponents());
    hasNoValue = hasNoValue || own < 0.;
    error = std::max(error, own);
  }
  return error;
}

/// The error of an edge for criteria that ask for the limit.
template <typename Id>
double AdaptiveSurfaceMarks<Id>::GetLimitError(Id corner, Scratch& scratch, bool& hasNoValue) const
{
  if (this->Mesh.IsFixed(corner))
  {
    return this->GetSegmentError(this->Mesh.GetSegment(corner), scratch, hasNoValue);
  }
  double error = this->Arrays[0].IsOfLimit() ? this->GetShapeError(corner, scratch) : 0.;
  if (this->Attribute >= 0 && this->Arrays[this->Attribute].IsOfLimit())
  {
    const AdaptiveSurfaceValues<Id>& values = this->Arrays[this->Attribute];
    const double* const ends[2] = { values.GetLimit(this->Mesh.GetVertex(corner)),
      values.GetLimit(this->Mesh.GetVertex(this->Mesh.Next(corner))) };
    double* places = scratch.Places.data();
    const int size = values.FindPlaces(corner, scratch.Rows, places);
    error = std::max(error, this->GetAttributeError(ends, size, places, hasNoValue));
  }
  return error;
}

/// The same for an edge on a curve.
template <typename Id>
double AdaptiveSurfaceMarks<Id>::GetSegmentError(
  Id segment, Scratch& scratch, bool& hasNoValue) const
{
  const Id* ends = this->Mesh.GetSegmentAt(segment).Ends;
  double error = 0.;
  for (std::size_t i = 0; i < this->Arrays.size(); ++i)
  {
    const AdaptiveSurfaceValues<Id>& values = this->Arrays[i];
    if (!values.IsOfLimit())
    {
      continue;
    }
    const double* const chord[2] = { values.GetLimit(ends[0]), values.GetLimit(ends[1]) };
    const double* places = scratch.Places.data();
    const int size = values.FindPlacesOfSegment(segment, scratch.Places.data());
    for (int k = 0; i == 0 && k < size; ++k)
    {
      error =
        std::max(error, FewPlaces * this->Criteria.GetGeometricError(chord, 2, places + 3 * k));
    }
    if (i > 0)
    {
      error = std::max(error, this->GetAttributeError(chord, size, places, hasNoValue));
    }
  }
  return error;
}

template <typename Id>
void AdaptiveSurfaceMarks<Id>::JudgeEdge(
  Id a, Id b, double atLimit, bool noValueAtLimit, int bit, Verdict& verdict) const
{
  bool hasNoValue = false;
  const double error = std::max(atLimit, this->Criteria.GetEdgeError(a, b, hasNoValue));
  verdict.HasNoValue = verdict.HasNoValue || hasNoValue || noValueAtLimit;
  verdict.IsTooShort = verdict.IsTooShort || this->Criteria.IsTooShort(a, b);
  verdict.Error = std::max(verdict.Error, error);
  verdict.Edges |= static_cast<unsigned char>(error > 1. ? 1 << bit : 0);
}

template <typename Id>
typename AdaptiveSurfaceMarks<Id>::Verdict AdaptiveSurfaceMarks<Id>::JudgeFace(
  Id face, Scratch& scratch) const
{
  Verdict verdict;
  const Id* corners = this->Mesh.GetVertices(face);
  for (int i = 0; i < 3; ++i)
  {
    bool hasNoValue = false;
    const double atLimit =
      this->Options.ReadsLimit() ? this->GetLimitError(3 * face + i, scratch, hasNoValue) : 0.;
    this->JudgeEdge(corners[i], corners[(i + 1) % 3], atLimit, hasNoValue, i, verdict);
  }
  if (this->Arrays[0].IsOfLimit() && !this->Mesh.IsCut(face))
  {
    this->JudgeInside(face, scratch, verdict);
  }
  return verdict;
}

/// Measures a face at its centre. If the error is too large the face is to be split, and a third of
/// it remains as a triangle at each edge whose other face is not split. So this also finds the
/// edges whose third would have too large an error. Over the thirds the limit is taken as
/// quadratic: its heights over the middles of the three edges determine it.
template <typename Id>
void AdaptiveSurfaceMarks<Id>::JudgeInside(Id face, Scratch& scratch, Verdict& verdict) const
{
  const AdaptiveSurfaceValues<Id>& points = this->Arrays[0];
  const Id* corners = this->Mesh.GetVertices(face);
  const double* x[3] = { points.GetLimit(corners[0]), points.GetLimit(corners[1]),
    points.GetLimit(corners[2]) };
  verdict.Error = std::max(verdict.Error, this->GetErrorAt(face, points.GetCentre(face)));
  if (verdict.Error <= 1.)
  {
    return;
  }
  double heights[3];
  // The height of the centre is 4/9 of the sum of these heights, which gives the height over an
  // edge whose other face is not there.
  double rest = 9. / 4. * RefinementCriteria::GetHeight(x, points.GetCentre(face));
  int unknown = 0;
  for (int i = 0; i < 3; ++i)
  {
    const bool isKnown = points.FindPlaces(3 * face + i, scratch.Rows, scratch.Places.data()) > 0;
    heights[i] = isKnown ? RefinementCriteria::GetHeight(x, scratch.Places.data()) : 0.;
    rest -= heights[i];
    unknown += isKnown ? 0 : 1;
  }
  for (int i = 0; i < 3; ++i)
  {
    heights[i] += this->Mesh.GetTwin(3 * face + i) == -1 ? rest / unknown : 0.;
  }
  double length = 0.;
  for (int i = 0; i < 3; ++i)
  {
    length = std::max(length, std::sqrt(vtkMath::Distance2BetweenPoints(x[i], x[(i + 1) % 3])));
  }
  for (int i = 0; i < 3; ++i)
  {
    const double own = heights[i];
    const double next = heights[(i + 1) % 3];
    const double last = heights[(i + 2) % 3];
    const double fromBegin = 2. / 9. * (own + last) - next / 9.;
    const double fromEnd = 2. / 9. * (own + next) - last / 9.;
    const double largest = std::max({ std::abs(own), std::abs(fromBegin), std::abs(fromEnd),
      4. / 9. * std::abs(own + fromBegin + fromEnd) });
    const double error = FewPlaces * this->Criteria.GetGeometricError(largest, length);
    // If the centre of the face is beyond edge i, the third there would overlap the face across
    // this edge.
    const bool isTooFar = error > 1. || IsBeyond(x, i, points.GetCentre(face));
    verdict.Edges |= static_cast<unsigned char>(isTooFar ? 1 << i : 0);
  }
}

template <typename Id>
typename AdaptiveSurfaceMarks<Id>::Verdict AdaptiveSurfaceMarks<Id>::JudgeSegment(
  Id segment, Scratch& scratch) const
{
  Verdict verdict;
  const Id* ends = this->Mesh.GetSegmentAt(segment).Ends;
  bool hasNoValue = false;
  const double atLimit = this->GetSegmentError(segment, scratch, hasNoValue);
  this->JudgeEdge(ends[0], ends[1], atLimit, hasNoValue, 0, verdict);
  return verdict;
}

template <typename Id>
std::vector<AdaptiveMark<Id>> AdaptiveSurfaceMarks<Id>::Find(AdaptiveNotes& notes)
{
  this->Update();
  std::size_t components = 1;
  for (const AdaptiveSurfaceValues<Id>& values : this->Arrays)
  {
    components = std::max(components, static_cast<std::size_t>(values.GetComponents()));
  }
  std::vector<AdaptiveMark<Id>> marks;
  for (const bool isFaces : { true, false })
  {
    const Candidates candidates(*this, isFaces);
    const vtkIdType size = candidates.GetSize();
    Buffer<double> values(this->Criteria.ReadsFunction() ? size : 0);
    if (!values.empty())
    {
      Buffer<double> centroids(3 * size);
      this->Criteria.EvaluateFunction(candidates, 0, size, centroids, values);
    }
    Buffer<Verdict> verdicts(size);
    ForRanges(size,
      [&](vtkIdType begin, vtkIdType end)
      {
        Scratch scratch;
        scratch.Places.resize(3 * components);
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Id at = candidates.Get(i);
          verdicts[i] = isFaces ? this->JudgeFace(at, scratch) : this->JudgeSegment(at, scratch);
          const double error = this->Criteria.GetCellError(
            candidates, i, candidates.GetPoints(i), values.empty() ? nullptr : values.data() + i);
          if (error > 1.)
          {
            verdicts[i].Edges = 7; // no third of it is to remain
          }
          verdicts[i].Error = std::max(verdicts[i].Error, error);
        }
      });
    ForEachInTurn(size,
      [&](vtkIdType i)
      {
        const Verdict& verdict = verdicts[i];
        if (verdict.HasNoValue && candidates.GetLevel(i) == 0)
        {
          this->AddWithoutValue(candidates.GetPoints(i), notes);
        }
        if (candidates.GetLevel(i) + candidates.GetStep() > this->Options.MaximumLevel ||
          !(verdict.Error > 1.))
        {
          return;
        }
        // On level 0 this is no reason: limits of control vertices may be close together where the
        // surface between them is large.
        if (verdict.IsTooShort && candidates.GetLevel(i) > 0)
        {
          ++notes.TooShort;
          return;
        }
        this->AddMarks(candidates.Get(i), isFaces, verdict, marks);
      });
  }
  Scratch scratch;
  scratch.Places.resize(3 * components);
  this->AddMarksOfOpen(scratch, marks);
  return marks;
}

/// Marks the faces that are missing at segments whose error is too large. No new face has such a
/// segment as an edge, so that none of the marks above comes from it.
template <typename Id>
void AdaptiveSurfaceMarks<Id>::AddMarksOfOpen(
  Scratch& scratch, std::vector<AdaptiveMark<Id>>& marks) const
{
  for (const Id at : InTurn(this->Open))
  {
    const auto& segment = this->Mesh.GetSegmentAt(at);
    const Verdict verdict = this->JudgeSegment(at, scratch);
    for (Id i = 0; i < segment.NumberOfSides; ++i)
    {
      if (verdict.Error > 1. && !verdict.IsTooShort &&
        segment.Level + 2 <= this->Options.MaximumLevel && this->Mesh.GetSide(segment, i) < 0)
      {
        marks.push_back({ verdict.Error, this->Mesh.FindMissingSide(segment, i) });
      }
    }
  }
}

/// Marks a face or segment, and the faces across the edges of a face whose error is too large: an
/// edge is replaced only when both of its faces are split.
template <typename Id>
void AdaptiveSurfaceMarks<Id>::AddMarks(
  Id at, bool isFace, const Verdict& verdict, std::vector<AdaptiveMark<Id>>& marks) const
{
  marks.push_back({ verdict.Error, isFace ? at : -1 - at });
  for (int e = 0; e < 3 && isFace; ++e)
  {
    const Id twin = this->Mesh.GetTwin(3 * at + e);
    if ((verdict.Edges & (1 << e)) != 0 && twin >= 0)
    {
      marks.push_back({ verdict.Error, twin / 3 });
    }
  }
}

/// Notes the edges of an input cell with a value that is not finite. For errors at the limit these
/// are all its edges, because the value may belong to a point near the cell.
template <typename Id>
void AdaptiveSurfaceMarks<Id>::AddWithoutValue(const Row<Id>& points, AdaptiveNotes& notes) const
{
  for (auto a = points.begin(); a != points.end(); ++a)
  {
    for (auto b = a + 1; b != points.end(); ++b)
    {
      bool hasNoValue = false;
      this->Criteria.GetEdgeError(*a, *b, hasNoValue);
      if (hasNoValue || this->Options.AttributeErrorOfLimit)
      {
        notes.WithoutValue.emplace_back(std::min(*a, *b), std::max(*a, *b));
      }
    }
  }
}

SUBDIVISION_COMPILE(class AdaptiveSurfaceMarks);

}
