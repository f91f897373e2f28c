// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointArrays.h
 * Takes points and point data from level to level. The type of an array decides whether it is
 * smoothed, gathered or dropped.
 */
#ifndef SubdivisionObjects_PointArrays_h
#define SubdivisionObjects_PointArrays_h

#include "Core/Memory/Coordinates.h"
#include "Core/Operators/PackedArrays.h"
#include "Core/Operators/PointOperator.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/Colours.h"
#include "Private/Reading/CellsToSimplices.h"

#include <functional>
#include <string>
#include <vector>

class vtkPointSet;

namespace subdivision
{

struct InterpolationLimits;
template <typename Id>
struct SparseRows;

struct PointArrayOptions
{
  bool InterpolateIntegers = false;
  /// Adds the point array `vtkOriginalPointIds`; `CarryOriginalIds`: with the values that the input
  /// has. See ChooseOriginalIds.
  bool OriginalIds = false;
  bool CarryOriginalIds = false;
  /// Whether arrays of the names of MakeFieldName have weights.
  bool HasMaterialFields = false;
  /// Arrays that the filter makes itself: the input's are left out.
  std::vector<std::string> Replaced;
  /// As in vtkAlgorithm.
  int Precision = 2;
  /// Is told which arrays cannot be used.
  std::function<void(const std::string&)> Warn;

  /// Original ids are written where they are asked for, or the input has some. Ids of the input go
  /// on if an earlier filter of this kind wrote them, and, whoever wrote them, where none are asked
  /// for: so two filters in a row do the same as one.
  void ChooseOriginalIds(vtkPointSet* input, bool areWanted, bool isContinued);
};

/// Whether new points get a mean of its values.
bool IsSmoothed(vtkAbstractArray* array, bool interpolateIntegers);

/// Which values become control values whose limits are the given ones.
struct InterpolationOptions
{
  bool Points = false;
  bool Arrays = false;
  std::vector<std::string> Names; ///< of the arrays; none: all of floating point numbers
  double Weight = 1.;             ///< 0: given values stay control values
  /// Where arrays have weights: the material that each point has of each colour, and how many
  /// materials there are.
  std::vector<int> Materials = {};
  int NumberOfMaterials = 1;
  /// For each point of the input which part of the way from the smoothed limit to the given value
  /// its limit goes; 0: it is free. Null: all go the whole way.
  vtkSmartPointer<vtkDataArray> Chosen = {};
  /// For each point the normal of its limit; zero: it is free. Null: all are free.
  vtkSmartPointer<vtkDataArray> Normals = {};

  bool IsOn() const { return (this->Points || this->Arrays || this->Normals) && this->Weight > 0.; }
  /// The numbers for a stamp.
  std::vector<vtkIdType> GetNumbers() const
  {
    return { (this->Points || this->Normals ? 1 : 0) + (this->Arrays ? 2 : 0) };
  }
};

/// Values of an array beyond a range.
struct Overshoot
{
  std::string Name;
  vtkIdType NumberOfValues;
  vtkIdType Count = 0; ///< of values that exceed the range by more than rounding
  double Most = 0.;    ///< by how much, as a fraction of the range
};

/// Points where the limit of a material's values is not the wanted value.
struct LimitMisses
{
  vtkIdType Count = 0;
  double Most = 0.; ///< the largest distance, as a fraction of the range
};

/// The values of a point array of the input as a contiguous array of type `valueType`, followed by
/// the values of the centres that `cells` adds. It is the array itself if there is nothing to do.
vtkSmartPointer<vtkDataArray> StartValues(
  vtkDataArray* array, int valueType, const SimplicesOfCells& cells);

/**
 * Arrays of floating point numbers, and colours (unsigned char with 3 or 4 components), are
 * smoothed; colours are rounded after each level. Other integers, strings and bits are gathered: an
 * old point keeps its value, a new point on an edge takes the value of the end with the smaller
 * global id, the centre of an octahedron the value of the vertex with the smallest one. Global and
 * pedigree ids are kept where all points are points of the input.
 */
class PointArrays
{
public:
  /// `globalIds` orders the first `numberOfGlobalIds` points; the index orders all others.
  PointArrays(vtkPointSet* input, const SimplicesOfCells& cells, const vtkIdType* globalIds,
    vtkIdType numberOfGlobalIds, const PointArrayOptions& options);

  /// Coordinates of the current points in double, for choices that depend on them. Their tie is for
  /// single precision if the points of the input or of the output have it.
  Coordinates GetCoordinates();
  double GetTie() const { return this->Tie; }

  /// The points at the current level. ReusePoints gives the points of the output where they are
  /// known from an earlier execution, so that no step is applied to points.
  vtkDataArray* GetPoints() const { return this->Points; }
  void ReusePoints(vtkDataArray* result) { this->FinalPoints = result; }

  /// Whether some array has weights (MaterialFields.h), by which its values are divided after each
  /// operator.
  bool HasWeights() const { return this->Options.HasMaterialFields; }
  /// Takes away the values of colours that the masks of the points do not have; without masks does
  /// nothing.
  void KeepColours(const std::vector<ColourMask>& masks);
  /// Whether some array is not smoothed.
  bool GathersSome() const { return this->HasGathered; }
  /// Applies an operator to all arrays. Rows of rules and rings tell from which current point a row
  /// takes its values in arrays that are not smoothed.
  void Advance(const PointOperator& operation);
  /// The same for an operator of other rows: `origin(row)` is that point.
  using OriginOfRow = std::function<vtkIdType(vtkIdType)>;
  /// `goesOn`: the next call is Advance again, and nobody asks for values before; both operators
  /// have blocks of rows only.
  void Advance(const PointOperator& operation, const OriginOfRow& origin, bool goesOn = false);
  /// The same for rows that copy a point: `origin(row)`. The first `staying` ones are the points
  /// that the next operator keeps, in their order.
  void Take(const PointOperator& operation, const OriginOfRow& origin, vtkIdType staying);
  /// Says that an operator left points out: of its first `staying` rows each keeps an old point,
  /// `origin(row)`.
  void Renumber(const OriginOfRow& origin, vtkIdType staying);
  /// Applies an operator that has one row for each point, such as limit rows. Does nothing if there
  /// are no rows.
  void Project(const PointOperator& operation);

  /// Replaces the given values by control values. `limit` has the limits of the current points. If
  /// `limits` knows other parts of the mesh, all call this together.
  /// `warn` gets messages on arrays that cannot be used, or for which the solver does not converge.
  void Interpolate(const PointOperator& limit, const InterpolationOptions& options,
    const InterpolationLimits& limits, const std::function<void(const std::string&)>& warn);
  /// Moves control points so that limits have the normals of the options, and, with Points, pass
  /// through the chosen points. `rows`: of the limits, and of their two tangents.
  void TurnLimits(const SparseRows<long long>* rows, const InterpolationOptions& options,
    const InterpolationLimits& limits, const std::function<void(const std::string&)>& warn);
  /// The current values of a point array of the input; null if it is not smoothed.
  vtkDataArray* FindCurrent(vtkAbstractArray* given) const;
  /// How far the current values of each array exceed the range that the array had before
  /// Interpolate. `counted`: whether the value of a point counts; empty: all do. `colours`: of
  /// which a point has values; empty: there are none.
  std::vector<Overshoot> FindOvershoot(
    const std::vector<char>& counted, const std::vector<ColourMask>& colours) const;

  /// Whether the current values of materials are the values that Interpolate was given. Steps take
  /// other proportions than limits where materials only touch. `counted`: as in FindOvershoot.
  LimitMisses FindMisses(const std::vector<char>& counted) const;

  /// Whether current point a has the smaller global id.
  bool IsEarlier(vtkIdType a, vtkIdType b) const;

  /// Says that the current points are no points of the input: global ids do not order them, and
  /// their original id is -1.
  void ForgetInputPoints();

  /// Sets normals that the filter made, three numbers for each current point, in the type of the
  /// points. Finish adds them to the output as LimitNormals, its active normals.
  void SetLimitNormals(const Buffer<double>& normals);
  /// Takes the arrays of an earlier output with the same points; null: there are none.
  void ReuseLimitNormals(vtkDataArray* normals) { this->Normals = normals; }
  bool HasLimitNormals() const { return this->Normals != nullptr; }
  /// The same with two tangents of each point, as LimitTangent1 and LimitTangent2.
  void SetLimitTangents(const Buffer<double> (&tangents)[2]);

  /// Leaves out the normals of the input, even if no point moves here: points of other partitions
  /// do.
  void LeaveOutNormals() { this->LeavesNormals = true; }

  void Finish(vtkPointSet* output);

  /// Bytes that one point takes, to estimate sizes.
  double GetBytesPerPoint() const;

private:
  struct Entry
  {
    int Source;                            ///< index in the input's point data
    vtkSmartPointer<vtkDataArray> Current; ///< smoothed so far; null: gathered at the end
    bool IsNormals = false; ///< neither: normals of the input hold only where no point moved
    bool AreIds = false;    ///< neither: global and pedigree ids hold only where no point is new
  };
  /// An array to interpolate, or all arrays that have the values of one, each for one colour.
  struct Interpolated
  {
    std::string Name;
    std::vector<std::size_t> Entries; ///< none: the points
    bool HasWeights = false;
    bool IsReplaced = false; ///< others have its values for each colour
    /// The least and the largest value of each component before Interpolate.
    std::vector<double> Range = {};
    /// Where others have weights: the values before, of each point and field, and whether there
    /// are any. Empty if the solver did not converge.
    Buffer<double> Given = {};
  };

  bool HasWeights(const Entry& entry) const
  {
    return this->Options.HasMaterialFields && entry.Current && IsWeighted(entry.Current->GetName());
  }
  void FindInterpolated(
    const InterpolationOptions& options, const std::function<void(const std::string&)>& warn);
  std::vector<vtkSmartPointer<vtkDataArray>*> ListSmoothed();
  void AdvanceSmoothed(const PointOperator& operation,
    const PointOperator::User& also = PointOperator::User(), bool goesOn = false);
  template <typename Id>
  void FindOrigins(const RingRows<Id>& rows, vtkIdType* origins) const;
  void StartOrigins();
  void AddOriginalIds(vtkPointSet* output) const;

  vtkPointSet* Input;
  const SimplicesOfCells& Cells;
  const vtkIdType* GlobalIds;
  vtkIdType NumberOfGlobalIds;
  PointArrayOptions Options;
  vtkIdType NumberOfPoints;
  double Tie;
  vtkSmartPointer<vtkDataArray> Points;
  vtkSmartPointer<vtkDataArray> FinalPoints; ///< null unless they are known beforehand
  vtkSmartPointer<vtkDataArray> Normals;
  vtkSmartPointer<vtkDataArray> Tangents[2];
  std::vector<Entry> Entries;
  PackedArrays Packed;                     ///< values of arrays that are empty for now
  std::vector<Interpolated> ToInterpolate; ///< in an order that all parts of a mesh have
  bool HasGathered = false;
  vtkIdType NumberOfInputPoints;      ///< the first points are points of the input
  std::vector<vtkIdType> TakenPoints; ///< which ones, where Take has chosen
  bool HasMoved = false;              ///< an operator was applied
  bool LeavesNormals = false;         ///< even if none was
  Buffer<vtkIdType> Origins;          ///< the input point whose values each point takes
  Buffer<double> Doubles;             ///< the points, where they are not in double
};

}

#endif
