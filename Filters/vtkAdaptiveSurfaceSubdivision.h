// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveSurfaceSubdivision
 * @brief   subdivides a surface by the sqrt(3) scheme where criteria ask for it
 *
 * Splits the triangles of a vtkPolyData only where detail is needed, and puts all points on the
 * smooth limit surface. There is never a hanging node.
 *
 * @par Algorithm
 * L. Kobbelt, "sqrt(3)-Subdivision", section 4. A split puts a point at a triangle's centre; an
 * edge between two triangles of the same generation that are both split is flipped. Every triangle
 * is one of the uniform mesh of its generation, or a third of one, so that shapes do not get worse
 * with the number of rounds. Before a triangle is split its neighbours are brought to its
 * generation; boundaries, creases and lines are cut into thirds in every second step, on all their
 * sides at once. All points, and all arrays that are smoothed, are on the limit, exact to rounding:
 * where everything is split vtkSurfaceSubdivision with SQRT_THREE and ProjectToLimit gives the same
 * points, with the same ids.
 *
 * @par Criteria
 * The criteria of vtkRefinementAlgorithm, with its arrays (5 to 7), and with the defaults
 * RefineByGeometricError (here 1 by default) and RefineByAttributeError (here 0 by default). All of
 * them look at limits (vtkRedGreenRefinement takes edge lengths, jumps and centres of cells from
 * the mesh before the limit). A level is one step, which makes three triangles of one; lines are
 * cut in every second step. Where a criterion of cells asks for a triangle, the triangles across
 * its edges are split too. Where it asks for a cell of the input, it asks for all triangles that
 * lie in this cell.
 *
 * The geometric error of a triangle is the largest distance from the limit at its centre and at
 * three places of each of its edges (of a boundary edge or line at these places alone), made larger
 * by a third for places between; GeometricTolerance allows it. This is an estimate and no bound; in
 * 580 runs on 160 rough random meshes mesh and limit were nowhere farther from each other than 0.98
 * times GeometricTolerance.
 *
 * @par Input and output
 * As in vtkSurfaceSubdivision with its scheme SQRT_THREE: polygons that are no triangles are split
 * into triangles first, and boundaries, creases, corners and lines follow the rules of that scheme.
 * Line cells are creases with any flag or sharpness, and an end of a crease is a corner, so that
 * CreaseEnd changes nothing; joints are sharp whatever Type1Rule to Type3Rule are.
 *
 * @par Arrays written
 * Always `vtkOriginalCellIds`, and the cell array `Generation` (unsigned char: twice the number of
 * steps that made a cell, plus 1 if it is a third of a split triangle whose old edge is still
 * there). On request `vtkOriginalPointIds`, and `LimitNormals`, `LimitTangent1`, `LimitTangent2`
 * (points, 3 components).
 *
 * @par Filters in a row
 * The next filter takes the output for a mesh like any other.
 *
 * @par Complexity
 * Rounds cost in proportion to the triangles that they split, and about 280 bytes are needed for
 * each triangle of the output.
 *
 * @par Threads and ghosts
 * Threaded by vtkSMPTools; the output is the same, bit for bit, for any number of threads. Hidden
 * cells are left out; ghost cells are refined like others. The partitions of several ranks
 * (Controller) are refined as one surface, whatever their borders: triangles, points and arrays are
 * the same as one rank makes of the whole. But at MaximumNumberOfCells, which counts the cells of
 * all ranks together, the last round leaves out all places below one error, and so more of them. A
 * rank needs three layers of the triangles of others, and exchanges splits in each round, mostly
 * once or twice.
 *
 * @par Errors
 * See vtkRefinementAlgorithm.
 *
 * @sa
 * vtkSurfaceSubdivision vtkRedGreenRefinement (for adaptive Loop subdivision, by its Placement
 * LIMIT)
 */
#ifndef vtkAdaptiveSurfaceSubdivision_h
#define vtkAdaptiveSurfaceSubdivision_h

#include "vtkRefinementAlgorithm.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

class VTKSUBDIVISIONOBJECTS_EXPORT vtkAdaptiveSurfaceSubdivision : public vtkRefinementAlgorithm
{
public:
  static vtkAdaptiveSurfaceSubdivision* New();
  vtkTypeMacro(vtkAdaptiveSurfaceSubdivision, vtkRefinementAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The output.
  vtkPolyData* GetOutput() { return this->GetPolyDataOutput(); }

  ///@{
  /**
   * Whether to output unit normals of the limit surface (`LimitNormals`, the active normals of the
   * output) or two tangents (`LimitTangent1`, `LimitTangent2`), as in vtkSurfaceSubdivision. Off by
   * default.
   */
  vtkSetMacro(GenerateLimitNormals, bool);
  vtkGetMacro(GenerateLimitNormals, bool);
  vtkBooleanMacro(GenerateLimitNormals, bool);
  vtkSetMacro(GenerateTangents, bool);
  vtkGetMacro(GenerateTangents, bool);
  vtkBooleanMacro(GenerateTangents, bool);
  ///@}

  ///@{
  /**
   * Whether the output's cells are stored with 32-bit ids where they fit. Off by default.
   */
  vtkSetMacro(Use32BitIds, bool);
  vtkGetMacro(Use32BitIds, bool);
  vtkBooleanMacro(Use32BitIds, bool);
  ///@}

protected:
  vtkAdaptiveSurfaceSubdivision();
  ~vtkAdaptiveSurfaceSubdivision() override;

  bool IsOfSurfaces() const override { return true; }
  bool HasOriginalCellIds() const override { return true; }
  bool HasInterfaces() const override { return true; }
  int GetLayersOfCells() const override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  bool GenerateLimitNormals = false;
  bool GenerateTangents = false;
  bool Use32BitIds = false;

private:
  vtkAdaptiveSurfaceSubdivision(const vtkAdaptiveSurfaceSubdivision&) = delete;
  void operator=(const vtkAdaptiveSurfaceSubdivision&) = delete;
};

#endif
