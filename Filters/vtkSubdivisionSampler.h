// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSubdivisionSampler
 * @brief   the smooth object on the points of an image
 *
 * Samples the smooth object that vtkMultiDimensionalSubdivision makes of a control mesh after
 * infinitely many levels. Each point of the image gets the values of all arrays where it lies in
 * the object, the material there, and whether it is inside. So programs for images and volumes can
 * take a solid with its materials.
 *
 * @par Algorithm
 * Cells of a coarse level, whose points and middles of edges lie on the limit, become quadratic
 * simplices that fit together, whatever types the cells have. Their deviation from the limit is
 * measured at points of the next level, and is taken to fall to a quarter with each: it
 * falls to an eighth where the object is smooth, and less at extraordinary vertices. Levels go on
 * until it is within Tolerance. Each row of the image is cut with
 * the hull of a simplex, and each sample between is found there by Newton's method, from where its
 * neighbour is. So there are no gaps and no cells to look for.
 *
 * @par Input
 * What vtkMultiDimensionalSubdivision reads, with its options; blocks and ranks, too. The cell
 * array at index 1 (`MaterialId` if none is given) has the materials.
 *  - Port 3, optional: a vtkImageData whose grid the output has. It must not be rotated.
 *
 * @par Arrays read, by SetInputArrayToProcess
 *  - 12, point array of the thickness of surfaces, curves and points, floating point numbers.
 *    Unset: none, Thickness holds for all.
 *
 * @par Output
 * A vtkImageData. Point arrays:
 *  - all point arrays of floating point numbers, with their type and components; 0 outside. The
 *    active scalars of the mesh are active, if there is no `Material`.
 *  - `Material`, with a material array only, of its type; outside 0 or, if that is a material, one
 *    less than the least (of unsigned types one more than the largest). It is active.
 *  - `Coverage` (float), with GenerateCoverage: the part of the voxel around the sample that is
 *    inside of solids; with a material array a component for each material, named by it, in
 *    ascending order.
 *  - `Distance` (float), with GenerateDistance: how far the sample is away from the outside of
 *    solids, negative inside of them, or outside from surfaces, curves and points without their
 *    thickness, what is nearer; up to DistanceBand.
 *  - `vtkValidPointMask` (char): 1 inside of the object, else 0.
 *
 * @par Surfaces, curves and points
 * They have a thickness; samples that are nearer than half of it have their values at the nearest
 * point. A sample is of a point before a curve, of a curve before a surface, and of a surface
 * before a solid. OutputDimensions leaves dimensions out.
 *
 * @par Boundaries
 * A sample on a face between two cells is of the first one, a sample on the boundary is inside.
 * Samples in a part of a solid that is turned inside out may be of any cell there.
 *
 * @par Complexity
 * Time grows with the samples in the object, not with all, and the pieces. Memory is that of the
 * output and of the last level, which has at most MaximumCellsOfLevel cells. Distances take some 15
 * looks at a triangle for each sample in the band, as `Coverage` takes 64 for a voxel.
 *
 * @par Threads and ranks
 * The same bits for any number of threads, and for any part of the image that is asked for. Ranks
 * that share a mesh each sample their own cells in the whole image, and join these images.
 *
 * @par Errors
 * Those of vtkMultiDimensionalSubdivision; a spacing, bounds or grid that is not usable; an image
 * of more than MaximumNumberOfSamples points, or of more bytes than there are, before it is made,
 * with a spacing that would do. Then the output is empty. A warning tells if
 * Tolerance was not reached, if there is nothing to sample, if thicknesses are negative, and if an
 * array of points has the name of one of the image, which leaves it out.
 *
 * @sa
 * vtkMultiDimensionalSubdivision vtkSubdivisionMeasures vtkResampleToImage
 */
#ifndef vtkSubdivisionSampler_h
#define vtkSubdivisionSampler_h

#include "vtkMultiDimensionalSubdivision.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string>

class vtkBoundingBox;
class vtkImageData;

namespace subdivision
{
struct SampleGrid;
struct SampledObject;
}

class VTKSUBDIVISIONOBJECTS_EXPORT vtkSubdivisionSampler : public vtkMultiDimensionalSubdivision
{
public:
  static vtkSubdivisionSampler* New();
  vtkTypeMacro(vtkSubdivisionSampler, vtkMultiDimensionalSubdivision);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The output.
  vtkImageData* GetOutput();

  /**
   * An image whose grid the output has; null: none. It goes before all options of the grid.
   */
  void SetGridConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(3, output); }

  ///@{
  /**
   * How many samples the longest side of the image has, if Spacing is 0. 2 to 100000, default 128.
   * Where Margin would leave fewer than two for the object, it is smaller.
   */
  vtkSetClampMacro(NumberOfSamples, int, 2, 100000);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * The distance of samples along all axes. Default 0: it follows from NumberOfSamples.
   */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Whether the image covers SamplingBounds, and not the object with Margin samples around it. Off
   * by default.
   */
  vtkSetMacro(UseSamplingBounds, bool);
  vtkGetMacro(UseSamplingBounds, bool);
  vtkBooleanMacro(UseSamplingBounds, bool);
  ///@}

  ///@{
  /**
   * The smallest and largest x, y and z of the image, for UseSamplingBounds. Default 0 to 1 along
   * each axis.
   */
  vtkSetVector6Macro(SamplingBounds, double);
  vtkGetVector6Macro(SamplingBounds, double);
  ///@}

  ///@{
  /**
   * How many samples the image has around the object. 0 to 1000, default 1.
   */
  vtkSetClampMacro(Margin, int, 0, 1000);
  vtkGetMacro(Margin, int);
  ///@}

  ///@{
  /**
   * How far pieces may be away from the limit, in parts of the distance of samples. 0 to 1, default
   * 0.1.
   */
  vtkSetClampMacro(Tolerance, double, 0., 1.);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * The last level that is made for Tolerance. 1 to 8, default 5.
   */
  vtkSetClampMacro(MaximumLevel, int, 1, 8);
  vtkGetMacro(MaximumLevel, int);
  ///@}

  ///@{
  /**
   * No level of more cells is made, but for the first. 1 to 1000000000, default 5000000.
   */
  vtkSetClampMacro(MaximumCellsOfLevel, int, 1, 1000000000);
  vtkGetMacro(MaximumCellsOfLevel, int);
  ///@}

  ///@{
  /**
   * The thickness of surfaces, curves and points, as a length, 0 or more, default 0: twice the
   * distance of samples. An array (index 12) goes before it.
   */
  vtkSetClampMacro(Thickness, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(Thickness, double);
  ///@}

  ///@{
  /**
   * Whether to output `Coverage`. Off by default.
   */
  vtkSetMacro(GenerateCoverage, bool);
  vtkGetMacro(GenerateCoverage, bool);
  vtkBooleanMacro(GenerateCoverage, bool);
  ///@}

  ///@{
  /**
   * Whether to output `Distance`. Off by default.
   */
  vtkSetMacro(GenerateDistance, bool);
  vtkGetMacro(GenerateDistance, bool);
  vtkBooleanMacro(GenerateDistance, bool);
  ///@}

  ///@{
  /**
   * The largest distance, as a length: samples that are farther away have it, with their sign. 0 or
   * more, default 0: three times the distance of samples.
   */
  vtkSetClampMacro(DistanceBand, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(DistanceBand, double);
  ///@}

  ///@{
  /**
   * An image of more samples is an error, which tells a spacing that would do. 1 or more, default
   * 2000 million. The panels of ParaView, which show no numbers of 64 bits, set it as a double, cut
   * to a whole number.
   */
  vtkSetClampMacro(MaximumNumberOfSamples, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfSamples, vtkIdType);
  void SetMaximumNumberOfSamplesAsDouble(double samples);
  ///@}

protected:
  vtkSubdivisionSampler();
  ~vtkSubdivisionSampler() override;

  enum SampleArrayIndices
  {
    THICKNESS_ARRAY = 12
  };

  vtkSmartPointer<vtkDataObject> Finish(vtkDataObject* made) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  /// The grid may need the input, which is updated then.
  int ExecuteInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int ComputeInputUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int NumberOfSamples = 128;
  double Spacing = 0.;
  bool UseSamplingBounds = false;
  double SamplingBounds[6] = { 0., 1., 0., 1., 0., 1. };
  int Margin = 1;
  double Tolerance = 0.1;
  int MaximumLevel = 5;
  int MaximumCellsOfLevel = 5000000;
  double Thickness = 0.;
  bool GenerateCoverage = false;
  bool GenerateDistance = false;
  double DistanceBand = 0.;
  vtkIdType MaximumNumberOfSamples = 2000000000;

private:
  /// Makes the pieces that are fine enough for the grid, and the grid, unless they are there.
  bool MakeObject(vtkInformationVector** inputVector);
  bool MakeLevels(vtkInformationVector** inputVector);
  void UpdateInputs();
  /// Puts SamplingBounds into `box` if they are wanted. Returns false after an error, as FindGrid.
  bool FindBounds(vtkBoundingBox& box);
  /// The grid of the image at port 3, or of the options; `box`: of the object.
  bool FindGrid(
    vtkInformationVector** inputVector, vtkBoundingBox box, subdivision::SampleGrid& grid);
  /// Fails where the grid of the object in that box has too many samples. The first level is not
  /// enough: later boxes are larger.
  bool CheckSize(
    vtkInformationVector** inputVector, vtkBoundingBox box, const subdivision::SampleGrid& grid);
  /// What helps if an image has more than `most` samples.
  std::string Advise(vtkInformationVector** inputVector, vtkBoundingBox box, double most,
    const subdivision::SampleGrid& grid);
  bool FindArrays();
  void WarnOfNames();
  void WarnOfLevel(bool isEnough);
  void FailSampling(const std::string& text);

  std::unique_ptr<subdivision::SampledObject> Object;
  bool HasFailed = false;

  vtkSubdivisionSampler(const vtkSubdivisionSampler&) = delete;
  void operator=(const vtkSubdivisionSampler&) = delete;
};

#endif
