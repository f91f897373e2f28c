// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSubdivisionOperator
 * @brief   the sparse matrix by which a filter moves points
 *
 * Subdivision is linear: the points of the output are S times the points of the input, and so are
 * smoothed arrays. ComputeOperator of vtkMultiDimensionalSubdivision and vtkSurfaceSubdivision
 * fills an object of this class with S, for all levels that the filter makes, and the limit if
 * ProjectToLimit is on. Who fits control points to data, or solves equations on the smooth object,
 * needs S itself.
 *
 * @par Rows
 * A row for each point of the output, a column for each point of the input: row i has the entries
 * from offsets[i] up to but without offsets[i + 1]; ids has their columns, weights their values.
 * This is the format CSR of scipy.sparse.csr_matrix. No column occurs twice in a row of S, and
 * columns are not sorted. The weights of a row sum to 1 but for rounding.
 *
 * @par Prolongation
 * ComputeProlongation fills it with one factor, from the nodes of curved cells to the nodes of the
 * next level.
 *
 * @par Factors
 * The filter makes one level after the other, and sums the values of a ring before it weights them.
 * S has other products and other sums, so that S times points is the output but for rounding. The
 * factors of S have the products and sums of the filter. Multiply with factor 0, the result with
 * factor 1, and so on, and sum each row in double, in the order of its entries, starting with 0:
 * the result is the output, bit for bit, for arrays in double, where no input cell got a point at
 * its centre. scipy.sparse multiplies in this way. Factor 0 copies the points of the input and adds
 * the centres of split cells; each operator of the filter follows as one factor, or as two: the
 * first copies its values and adds sums of rings, the second weights them. Arrays in float are
 * rounded after each operator.
 *
 * @sa
 * vtkMultiDimensionalSubdivision vtkSurfaceSubdivision
 */
#ifndef vtkSubdivisionOperator_h
#define vtkSubdivisionOperator_h

#include "vtkObject.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

#include <memory> // for std::unique_ptr

class vtkDoubleArray;
class vtkIdTypeArray;

namespace subdivision
{
class MatrixFactors;
}

class VTKSUBDIVISIONOBJECTS_EXPORT vtkSubdivisionOperator : public vtkObject
{
public:
  static vtkSubdivisionOperator* New();
  vtkTypeMacro(vtkSubdivisionOperator, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of points of the output and of the input; 0 before an operator was computed.
   */
  vtkIdType GetNumberOfRows() const;
  vtkIdType GetNumberOfColumns() const;
  ///@}

  /**
   * Gives the rows of S. Does nothing before an operator was computed.
   */
  void GetRows(vtkIdTypeArray* offsets, vtkIdTypeArray* ids, vtkDoubleArray* weights) const;

  ///@{
  /**
   * Gives the factors of S. A factor has a column for each row of the one before it.
   */
  int GetNumberOfFactors() const;
  void GetFactor(
    int factor, vtkIdTypeArray* offsets, vtkIdTypeArray* ids, vtkDoubleArray* weights) const;
  ///@}

  /**
   * Multiplies the transpose of S with values that have a tuple for each row; they have one for
   * each column then. This makes derivatives by points of the input of those by points of the
   * output. Returns false, and changes nothing, if there is another number of tuples.
   */
  bool MultiplyTransposed(vtkDoubleArray* values) const;

protected:
  vtkSubdivisionOperator();
  ~vtkSubdivisionOperator() override;

private:
  friend class vtkSubdivisionAlgorithm; // which fills it
  friend class vtkUniformSubdivisionAlgorithm;
  std::unique_ptr<subdivision::MatrixFactors> Factors;

  vtkSubdivisionOperator(const vtkSubdivisionOperator&) = delete;
  void operator=(const vtkSubdivisionOperator&) = delete;
};

#endif
