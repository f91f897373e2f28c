// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SampledImage.h
 * Puts quadratic pieces on the points of an image.
 */
#ifndef SubdivisionObjects_SampledImage_h
#define SubdivisionObjects_SampledImage_h

#include "Private/Samples/PieceSamples.h"
#include "Private/Samples/QuadraticPieces.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkPointSet;

namespace subdivision
{

struct SolidFace;

/// A mesh on the limit, which becomes samples.
struct SampledMesh
{
  vtkPointSet* Mesh = nullptr;
  QuadraticPieces Pieces;
  vtkDataArray* Material = nullptr;  ///< of its cells
  vtkDataArray* Thickness = nullptr; ///< of its points, instead of the number for all
};

struct SampleOptions
{
  SampleGrid Grid;           ///< the extent is that of the output
  bool HasThickness = false; ///< surfaces, curves and points are sampled
  double Thickness = 0.;     ///< theirs, where meshes have no array
  double Tolerance = 0.;     ///< of the flat parts of surfaces and curves, as a length
  bool HasCoverage = false;
  double Band = 0.; ///< of distances: farther samples have this one
  /// The outside of solids, if there are distances; else null.
  const std::vector<SolidFace>* Outside = nullptr;
  double MaterialOutside = 0.;
  /// Where ranks share an object, what is before what at each sample, the least first: less
  /// dimensions, then what is nearer; NothingThere outside. Else null.
  std::vector<double>* Order = nullptr;
  /// There also: distances from surfaces, curves and points, which are joined later; else null.
  std::vector<float>* Others = nullptr;
  std::function<void(double)> Tell; ///< how much of the image is done, 0 to 1
};

constexpr double NothingThere = 4.;

/// Names of the arrays that samples have besides those of the input.
constexpr const char* SampledMaterialName = "Material";
constexpr const char* SampledCoverageName = "Coverage";
constexpr const char* SampledDistanceName = "Distance";
constexpr const char* SampledMaskName = "vtkValidPointMask";

/// An order of materials: ascending, then those that are not a number, which are equal.
inline bool IsBeforeMaterial(double a, double b)
{
  return a < b || (!std::isnan(a) && std::isnan(b));
}
/// The materials of pieces of a dimension in that order.
std::vector<double> ListMaterials(const std::vector<SampledMesh>& meshes, int dimension);

/**
 * Fills an image that has its extent with arrays: floating point numbers of the points of the first
 * mesh, by name, materials, coverage by each of `materials` (or one), and the mask. A sample is of
 * the curve, surface or point that is nearest if it is within half of the thickness, else of the
 * first tetrahedron that it is in; else all is 0. The part of a voxel that is inside is counted at
 * 64 places where a face between materials or the outside may pass.
 */
void SamplePieces(const std::vector<SampledMesh>& meshes, const std::vector<double>& materials,
  const SampleOptions& options, vtkImageData* image);

/// Whether a point array is smoothed, and so sampled.
bool IsSampled(vtkDataArray* values);
/// Whether an array of the output that is none of the input has this name.
bool IsOwnName(
  const std::vector<SampledMesh>& meshes, bool hasCoverage, bool hasDistance, const char* name);

/// How many bytes a sample of the output has.
vtkIdType CountBytesOfSample(
  const std::vector<SampledMesh>& meshes, std::size_t materials, const SampleOptions& options);

}

#endif
