// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Features.h
 * Singularities, materials and joints as the user wants them: options, and cell arrays read as one
 * value for each simplex.
 */
#ifndef SubdivisionObjects_Features_h
#define SubdivisionObjects_Features_h

#include "Core/Solids/Scheme/SemiSharp.h"
#include "Core/Solids/Strata/Singularities.h"
#include "Core/Solids/Strata/Strata.h"
#include "Private/Reading/CellsToSimplices.h"
#include "Private/Run/Marks.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

namespace subdivision
{

enum class EmbeddedRule
{
  Follow,
  SingularInside,
  Singular
};

struct FeatureOptions
{
  bool DartEnds = false;
  LoopWeights Weights = LoopWeights::Warren;
  bool ModifiedBoundary = true; ///< SectorEdges.h
  EmbeddedRule Embedded = EmbeddedRule::Follow;
  bool PreserveInterfaces = false;
  bool DetectFeatures = false;
  double FeatureAngle = 30.;
  JointRule Type1 = JointRule::Blend;
  JointRule Type2 = JointRule::Blend;
  JointRule Type3 = JointRule::Blend;
  bool MergesPoints = false; ///< no warning tells of points at one place
  bool ClosesNodes = false;  ///< no warning tells of points that hang
  std::string JoiningCure;   ///< OpenPointOptions::Cure
  /// Cell arrays of the input, null where there is none. Their length and type were checked.
  vtkSmartPointer<vtkDataArray> Singular;
  vtkSmartPointer<vtkDataArray> Material;
  vtkSmartPointer<vtkDataArray> Part;
  vtkSmartPointer<vtkDataArray> Rules;
  vtkSmartPointer<vtkDataArray> Sharpness;
  /// A point array of the input, with angles of corners in degrees for ModifiedBoundary.
  vtkSmartPointer<vtkDataArray> CornerAngles;

  MarkOptions Marks;
};

/// The number of each cell's material: equal for equal values, in the order of the values, NaN
/// first. `keys` gets one of each number, in the same order: equal for equal values, whichever
/// other values there are.
std::vector<int> NumberMaterials(vtkDataArray* array, std::vector<vtkIdType>* keys = nullptr);

/// One value for each simplex; empty where the array is not set or not used.
struct FeatureValues
{
  std::vector<unsigned char> Singular;
  std::vector<int> Material; ///< NumberMaterials
  std::vector<int> Part;
  std::vector<unsigned char> Rules;
  std::vector<double> Sharpness; ///< finite and not negative, lines and triangles only
};

/// Reads the arrays for the simplices of the input. `warn` gets messages on values without effect.
FeatureValues ReadFeatureValues(const FeatureOptions& options, const SimplicesOfCells& cells,
  const std::function<void(const std::string&)>& warn);

/// Warns of equal cells of which one is flagged as singular and the other is not.
template <typename Id>
void WarnOfContradictions(const FeatureOptions& options, const FeatureValues& values,
  const SimplicesOfCells& cells, const SimplicialComplex<Id>& complex,
  const std::vector<CellRun>& runs, const std::function<void(const std::string&)>& warn);

/// The sharpness of each edge and face of the complex; empty where there is none.
template <typename Id>
SolidSharpness FindSharpness(const FeatureValues& values, const SimplicialComplex<Id>& complex,
  const std::vector<CellRun>& runs);

/// Lifts values to the control simplices from their children after `levels` steps. Returns false if
/// children of one simplex have different values.
bool LiftFeatureValues(
  const SimplexList& control, int levels, const FeatureValues& values, FeatureValues& lifted);

/// The angles of corners for ModifiedBoundary, by point, in radians; -1: none. Points beyond them,
/// the centres of split cells, have none either.
std::vector<double> ReadCornerAngles(const FeatureOptions& options);

/// Encodes all choices but FeatureAngle as numbers, which a cache compares. Instead of the angle
/// the cache compares which edges are features.
std::vector<long long> EncodeChoices(const FeatureOptions& options, const FeatureValues& values);

/// Options for BuildStrata; `runs` are runs of the simplices that the values belong to.
template <typename Id>
StrataOptions MakeStrataOptions(const FeatureOptions& options, const FeatureValues& values,
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs);

}

#endif
