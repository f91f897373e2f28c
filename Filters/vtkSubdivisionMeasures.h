// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSubdivisionMeasures
 * @brief   lengths, areas, volumes and integrals of a smooth object
 *
 * Measures the smooth object that vtkMultiDimensionalSubdivision makes of a control mesh after
 * infinitely many levels: lengths of curves, areas of surfaces, volumes of solids, centroids,
 * tensors of inertia, integrals, means and extremes of all arrays, for the whole and for each
 * material. Each number comes with a remainder, which says how far it may be away from the truth.
 * The output is a table.
 *
 * @par Algorithm
 * Levels 0, 1, 2 and so on are made with all points on the limit, and integrals over their cells
 * are summed exactly (Gauss). Where the object is smooth the error of a level has powers of 1/4;
 * Richardson's extrapolation removes the first two. Levels end at MaximumLevel, where the next one
 * would have more cells than MaximumCellsOfLevel, or when all remainders of integrals are within
 * Tolerance. A volume depends on the boundary only.
 *
 * @par Remainders
 * The remainder of an integral is a weighted sum of what the last levels changed, and at least what
 * rounding may leave. It is an estimate, not a proof; weights are such that it held on random
 * meshes. Components of a centroid or tensor share the largest. Extremes are those of points on the
 * limit; their remainder says how much higher the limit may be between them, if it bends there as
 * much as it did between the points of the level before.
 *
 * @par Input
 * What vtkMultiDimensionalSubdivision reads, with its options. The cell array at index 1
 * (`MaterialId` if none is given) has the materials; without one there are no rows of materials.
 *
 * @par Arrays read, by SetInputArrayToProcess
 *  - 11, point array of the density, floating point numbers: masses, centroids, tensors, integrals
 *    and means are weighted by it. Unset: none, all is weighted by 1.
 *
 * @par Output
 * A vtkTable with a row for each dimension that has cells (0: points, whose measure is their
 * number) and, after it, rows of its materials. Cells that are faces of others count in their own
 * dimension.
 *  - `Dimension` (int).
 *  - `AllMaterials` (unsigned char) and `Material` (double), with a material array only: 1 and 0 in
 *    the row of all materials, else 0 and the material.
 *  - `Measure` (double): length, area or volume. Solids that are turned inside out in the control
 *    mesh count as if they were not.
 *  - `Mass`, with a density only: its integral.
 *  - `Centroid` (three components), and `Inertia` (six: XX, YY, ZZ, XY, YZ, XZ): the tensor about
 *    the centroid, with negative products outside the diagonal. 0 where there is no mass.
 *  - For each point array of floating point numbers, A, with its components: `AIntegral`, `AMean`,
 *    `AMinimum`, `AMaximum`.
 *  - For each of these columns but the first three the same name with `Remainder` appended.
 *  - `MeasuredLevels` (field data, int): the last level.
 *
 * @par Boundaries
 * The surface schemes of vtkSurfaceSubdivision are not available here; triangles are Loop surfaces
 * and quads Catmull-Clark surfaces, as in vtkMultiDimensionalSubdivision. Options of its output
 * (NumberOfLevels, ProjectToLimit, limit normals, tangents, classification, error bounds, Bezier
 * cells, ids) have no effect. OutputDimensions leaves rows out.
 *
 * @par Complexity
 * As vtkMultiDimensionalSubdivision with ProjectToLimit takes for the last level, and a third more.
 *
 * @par Threads and ranks
 * The same bits for any number of threads. Ranks each sum their cells, and all get the same table,
 * which is that of one process but for rounding. Ghost cells do not count.
 *
 * @par Errors
 * Those of vtkMultiDimensionalSubdivision; a density array that is missing, has several components
 * or no floating point numbers; blocks or ranks with different point arrays. Then the table is
 * empty.
 *
 * @sa
 * vtkMultiDimensionalSubdivision vtkMassProperties vtkIntegrateAttributes
 */
#ifndef vtkSubdivisionMeasures_h
#define vtkSubdivisionMeasures_h

#include "vtkMultiDimensionalSubdivision.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

#include <functional> // for std::function
#include <memory>     // for std::unique_ptr
#include <string>

class vtkDataArray;
class vtkPointData;
class vtkTable;
class vtkUnstructuredGrid;

namespace subdivision
{
class MeasuredLevels;
struct MeasureGradients;
}

class VTKSUBDIVISIONOBJECTS_EXPORT vtkSubdivisionMeasures : public vtkMultiDimensionalSubdivision
{
public:
  static vtkSubdivisionMeasures* New();
  vtkTypeMacro(vtkSubdivisionMeasures, vtkMultiDimensionalSubdivision);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The output.
  vtkTable* GetOutput();

  ///@{
  /**
   * The last level that is measured, if no other option ends levels before. 1 to 12, default 6.
   */
  vtkSetClampMacro(MaximumLevel, int, 1, 12);
  vtkGetMacro(MaximumLevel, int);
  ///@}

  ///@{
  /**
   * No level of more cells is measured, except levels 0 and 1. 1 to 1000000000, default 4000000.
   */
  vtkSetClampMacro(MaximumCellsOfLevel, int, 1, 1000000000);
  vtkGetMacro(MaximumCellsOfLevel, int);
  ///@}

  ///@{
  /**
   * Levels end when each remainder is at most this part of the size of its number: of a length,
   * area, volume or mass of itself, of a centroid of the size of the mesh, of a tensor or an
   * integral of the largest that one of that size and mass may have. Extremes do not count. 0 to 1,
   * default 0.0000000001.
   */
  vtkSetClampMacro(Tolerance, double, 0., 1.);
  vtkGetMacro(Tolerance, double);
  ///@}

  /**
   * Finds the derivatives of the numbers in a row of the output, which is updated, by all that the
   * control points have. `gradients` gets arrays (vtkDoubleArray) with a tuple for each point of
   * the input:
   *  - `MeasureByPoints` (3 components): of `Measure` by the place of the point.
   *  - `MassByPoints` (3) and `MassByDensity`, with a density only: of `Mass` by the place and the
   *    density of the point.
   *  - `AIntegralByPoints` (3 for each component of A, one component of A after another),
   *    `AIntegralByValues` (1: of each component by itself) and, with a density,
   *    `AIntegralByDensity` (as many as A has), for each point array A of floating point numbers.
   *
   * They are those of the numbers as they are measured, levels and extrapolation included: exact
   * but for rounding, if the input is in double precision. An integral of the density itself has
   * both derivatives, and the sum counts. It is for one mesh in this process, as ComputeOperator.
   * It takes about as long as an update. Returns false after an error.
   */
  bool ComputeGradients(vtkIdType row, vtkPointData* gradients);

protected:
  vtkSubdivisionMeasures();
  ~vtkSubdivisionMeasures() override;

  enum MeasureArrayIndices
  {
    DENSITY_ARRAY = 11
  };

  bool TearsSeams() const override { return false; }
  vtkSmartPointer<vtkDataObject> Finish(vtkDataObject* made) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int MaximumLevel = 6;
  int MaximumCellsOfLevel = 4000000;
  double Tolerance = 1e-10;

private:
  /// Makes a level, which Finish measures; -1: the cells of the control mesh. Returns whether it
  /// has.
  bool MeasureLevel(int level, vtkInformationVector** inputVector);
  bool MeasureLevels(vtkInformationVector** inputVector, vtkTable* table);
  bool FindArrays(vtkUnstructuredGrid* mesh, vtkDataArray*& material, vtkDataArray*& density);
  void FailMeasuring(const std::string& text);
  /// Calls work() with Levels, and says whether it is done.
  bool Work(const std::function<bool()>& work);
  bool AddGradientsOfLevels(int last);

  std::unique_ptr<subdivision::MeasuredLevels> Levels; ///< while levels are made
  subdivision::MeasureGradients* Gradients = nullptr;  ///< if they are wanted
  bool HasFailed = false;

  vtkSubdivisionMeasures(const vtkSubdivisionMeasures&) = delete;
  void operator=(const vtkSubdivisionMeasures&) = delete;
};

#endif
