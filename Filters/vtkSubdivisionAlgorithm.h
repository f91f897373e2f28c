// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSubdivisionAlgorithm
 * @brief   what the subdivision filters for unstructured grids have in common
 *
 * The input is a vtkUnstructuredGrid or vtkPolyData, seen as a simplicial complex whose cells may
 * have any dimension from 0 to 3 (Chang & Qin, "A Framework for Multi-dimensional Adaptive
 * Subdivision Objects", section 2). The output is a vtkUnstructuredGrid of VTK_VERTEX, VTK_LINE,
 * VTK_TRIANGLE and VTK_TETRA cells.
 *
 * @par Cells
 * Read are VTK_VERTEX, VTK_POLY_VERTEX, VTK_LINE, VTK_POLY_LINE, VTK_TRIANGLE, VTK_TRIANGLE_STRIP,
 * VTK_PIXEL, VTK_QUAD, VTK_POLYGON, VTK_TETRA, VTK_VOXEL, VTK_HEXAHEDRON, VTK_WEDGE and VTK_PYRAMID.
 * What is no simplex is split conformingly: two cells that share a quad take the same diagonal,
 * which is the one that the triangles of a neighbour have already, else the one through the smallest
 * global id (the point id where the input has no global ids). Polygons are cut by ears in their mean
 * plane. A centre point is added only to a solid cell whose face diagonals allow no other split.
 *
 * @par Bad cells
 * Passed over, with one warning for each kind that counts them and names the first: cells of another
 * type, with point ids out of range, with a point that is not finite, or with repeated point ids (of
 * a solid, polygon, poly line or strip only the degenerate pieces go). Their neighbours act as if
 * they were not there. Cells that are inverted or have no size are kept, and so are unused points.
 *
 * @par Ghosts
 * Hidden cells take no part and are not in the output. Cell ghost types go to the children, point
 * ghost types are rebuilt from the cells'. Results at the borders of partitions are not yet the same
 * as without partitions; a warning says so where there are duplicate cells.
 */
#ifndef vtkSubdivisionAlgorithm_h
#define vtkSubdivisionAlgorithm_h

#include "vtkSubdivisionObjectsModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

class VTKSUBDIVISIONOBJECTS_EXPORT vtkSubdivisionAlgorithm : public vtkUnstructuredGridAlgorithm
{
public:
  vtkTypeMacro(vtkSubdivisionAlgorithm, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether integer point arrays are smoothed and rounded, like colours, too. Off by default: a new
   * point takes the value of the edge's end whose global id is smaller, so that labels stay labels.
   */
  vtkSetMacro(InterpolateIntegers, bool);
  vtkGetMacro(InterpolateIntegers, bool);
  vtkBooleanMacro(InterpolateIntegers, bool);
  ///@}

  ///@{
  /**
   * Whether to output the cell array `vtkOriginalCellIds` and the point array `vtkOriginalPointIds`
   * (vtkIdTypeArray, one component): the cell or point of this filter's input that each came from,
   * -1 for new points. On the output of another filter of this kind they are carried on. Off by
   * default.
   */
  vtkSetMacro(GenerateOriginalIds, bool);
  vtkGetMacro(GenerateOriginalIds, bool);
  vtkBooleanMacro(GenerateOriginalIds, bool);
  ///@}

  ///@{
  /**
   * Precision of the output points: vtkAlgorithm::DEFAULT_PRECISION (that of the input; the
   * default), SINGLE_PRECISION or DOUBLE_PRECISION.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * The filter stops with an error, before it takes any memory for them, if the output would have
   * more cells than this. Default 500 million.
   */
  vtkSetClampMacro(MaximumNumberOfCells, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfCells, vtkIdType);
  ///@}

protected:
  vtkSubdivisionAlgorithm();
  ~vtkSubdivisionAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  bool InterpolateIntegers = false;
  bool GenerateOriginalIds = false;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  vtkIdType MaximumNumberOfCells = 500000000;

private:
  vtkSubdivisionAlgorithm(const vtkSubdivisionAlgorithm&) = delete;
  void operator=(const vtkSubdivisionAlgorithm&) = delete;
};

#endif
