// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSubdivisionDeformation
 * @brief   smooth deformation of whatever lies inside a control mesh of solid cells, or in a plane
 *
 * Bends a detailed object by moving the few points of a coarse mesh of tetrahedra around it, or of
 * polygons in its plane. The object is any vtkPointSet: a surface, a point cloud, a fine volume.
 *
 * @par Algorithm
 * S. Schaefer, J. Hakenberg and J. Warren, "Smooth Subdivision of Tetrahedral Meshes", section 3.
 * The control mesh at rest is subdivided NumberOfLevels times, as vtkMultiDimensionalSubdivision
 * does it. Each point of the object is found in a cell of the result, and the barycentric
 * coordinates that it has there are kept: with them each point is a fixed mean of control points
 * (equation 1). The same means of the deformed control points are the deformed object. An affine
 * map of the control mesh is the same affine map of the object inside, up to rounding; at rest
 * nothing moves. Which cells there are, and which rules they follow, is decided at rest.
 *
 * @par Control meshes in a plane
 * A control mesh without solids, for instance in the plane of an image, holds the points that lie
 * on it. With SurfaceScheme = LOOP it is subdivided as by vtkMultiDimensionalSubdivision. With
 * CATMULL_CLARK it is subdivided as by vtkSurfaceSubdivision with its scheme of this name and its
 * other defaults: polygons of any size become quads, creases and corners follow flags and sharpness
 * (arrays 0 and 4), PreserveInterfaces and DetectFeatures, and boundary points of one polygon stay
 * where they are. Each quad of the subdivided mesh holds points as two triangles, cut where both
 * lie inside it, and the deformation is linear on these: it is continuous, and exact at all points
 * of the subdivided mesh. Without levels, larger polygons are cut into triangles too.
 *
 * @par Inputs
 *  - port 0, the object: any vtkPointSet (the output has its type), vtkImageData or
 *    vtkRectilinearGrid (the output is a vtkStructuredGrid), or a composite of these, each of which
 *    is deformed by itself.
 *  - port 1, not required, the control mesh at rest: vtkUnstructuredGrid, vtkPolyData or structured
 * data, with the cells, arrays and options of features that vtkSubdivisionAlgorithm describes; cell
 * arrays are read from this mesh.
 *  - port 2, the control mesh deformed: the same points and cells in the same order.
 * Without port 1 the rest mesh is a cage around the object, as vtkSubdivisionCageSource makes it
 * around an input with its defaults: all of the object is inside the smoothed cage. It has as many
 * boxes along each axis as port 2, which has to be such a cage with its points moved.
 * Any of the three may change with time. Ports 1 and 2 take composite data sets of such meshes too:
 * whatever JoinBlocks is, all blocks are one control mesh, in which points of the same global id
 * or, without ids, of the same coordinates are one point. The parts that several ranks have
 * (Controller) are gathered on all ranks. So each rank has the whole of both control meshes, and
 * deforms its own part of port 0.
 *
 * @par Points and cells
 * A point belongs to the tetrahedron with the smallest id among all that hold it; barycentric
 * coordinates may be below zero by 1e-10, by 1e-5 if points are in single precision. Surfaces and
 * curves beside solids hold no points, but OutsidePoints = OUTSIDE_NEAREST may bind points to them.
 * In a control mesh without solids they hold the points that lie on them, up to the same parts of
 * the diagonal of the mesh: so triangles in the plane of an image deform this image.
 *
 * @par Arrays
 * All arrays of port 0 are in the output, and so are its cells. With TransformVectors the active
 * vectors and tangents, of points and of cells, are multiplied by the Jacobian matrix of the map of
 * the tetrahedron that holds the point, active normals by its inverse transpose and made as long as
 * 1, if they are of a floating type. A cell takes the mean of the matrices of its points. A point
 * outside, or on a surface, has the identity matrix or, if OUTSIDE_NEAREST binds it to a
 * tetrahedron, the matrix of the tetrahedron. All other arrays pass unchanged.
 *
 * @par Kept between executions
 * The operators of all levels, the subdivided mesh at rest and a search tree, for a rest mesh of
 * equal content; and for each input of the last update its rows of at most 4 entries, and composed
 * rows over the control points where these are fewer bytes to read. The filter recognises an input
 * by the content of its points (512 bits of checksum for each half megabyte). When only the
 * deformed mesh changes, the work is one product with each operator and one with the rows. Then
 * the points of an output of a megabyte or more take the memory of the output before, unless others
 * still have its points: they never change, and nothing of them is kept between runs.
 *
 * @par Complexity
 * The first execution: linear in the size of the subdivided mesh, O(p log n) for p points in n
 * cells. Later ones: linear in the size of these. Memory: about 28 bytes for each point, 76 for one
 * that is bound to the nearest place, and for each tetrahedron of the subdivided mesh about 60
 * bytes, 85 if points were searched for the nearest place.
 *
 * @par Threads and ghosts
 * Threaded by vtkSMPTools; the output is the same, bit for bit, for any number of threads. Ghost
 * points and cells of port 0 are deformed like all others.
 *
 * @par Errors
 * The filter gives an error, with the input as output, if the deformed mesh is not connected, or
 * without a rest mesh is no cage, if rest and deformed mesh differ in points or cells, if a
 * deformed control point is not finite, if there are points outside and OutsidePoints is
 * OUTSIDE_ERROR, if the rest mesh has a solid and SurfaceScheme is CATMULL_CLARK, or if the rest
 * mesh cannot be subdivided within MaximumNumberOfCells or the memory. It warns if the rest mesh
 * has no cells (the output is the input), or inverted or flat solid cells, if the deformed mesh
 * turns cells inside out, and of points outside when they are looked up for the first time.
 *
 * InterpolateIntegers, InterpolatePoints, InterpolateArrays, InterfaceValues, GenerateOriginalIds
 * and GenerateGlobalIds have no effect here.
 *
 * @sa
 * vtkMultiDimensionalSubdivision vtkSurfaceSubdivision vtkSubdivisionCageSource
 * vtkSubdivisionModelSource
 */
#ifndef vtkSubdivisionDeformation_h
#define vtkSubdivisionDeformation_h

#include "vtkSubdivisionAlgorithm.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

#include <memory> // for std::unique_ptr

namespace subdivision
{
class Deformation;
}

class VTKSUBDIVISIONOBJECTS_EXPORT vtkSubdivisionDeformation : public vtkSubdivisionAlgorithm
{
public:
  static vtkSubdivisionDeformation* New();
  vtkTypeMacro(vtkSubdivisionDeformation, vtkSubdivisionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Inputs 1 and 2, as connections or as data.
   */
  void SetRestMeshConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetRestMeshData(vtkDataObject* mesh) { this->SetInputData(1, mesh); }
  void SetDeformedMeshConnection(vtkAlgorithmOutput* output)
  {
    this->SetInputConnection(2, output);
  }
  void SetDeformedMeshData(vtkDataObject* mesh) { this->SetInputData(2, mesh); }
  ///@}

  ///@{
  /**
   * How often the control mesh is subdivided, 0 to 20, default 2. The deformation is piecewise
   * linear on the cells of that level: more levels make it smoother, and each makes 8 times as many
   * cells. 0: linear on the control mesh itself.
   */
  vtkSetClampMacro(NumberOfLevels, int, 0, 20);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

  ///@{
  /**
   * How solids are split and smoothed: BOX_SPLINE (0, the default), TET_OCT (1; the paper's own
   * scheme, which prefers no direction), LINEAR (2; not smoothed) or HYBRID (3; a lattice of
   * hexahedra stays one, and deforms as a tricubic B-spline), see vtkMultiDimensionalSubdivision.
   * With HYBRID, too, cells of the last level hold points as tetrahedra.
   */
  vtkSetClampMacro(VolumeScheme, int, BOX_SPLINE, HYBRID);
  vtkGetMacro(VolumeScheme, int);
  void SetVolumeSchemeToBoxSpline() { this->SetVolumeScheme(BOX_SPLINE); }
  void SetVolumeSchemeToTetOct() { this->SetVolumeScheme(TET_OCT); }
  void SetVolumeSchemeToLinear() { this->SetVolumeScheme(LINEAR); }
  void SetVolumeSchemeToHybrid() { this->SetVolumeScheme(HYBRID); }
  ///@}

  enum SurfaceSchemes
  {
    LOOP,
    CATMULL_CLARK
  };
  ///@{
  /**
   * How the surfaces of a control mesh are split and smoothed: LOOP (0, the default; quads and
   * polygons become triangles first, and solids are welcome) or CATMULL_CLARK (1; polygons become
   * quads, for control meshes without solids), see above.
   */
  vtkSetClampMacro(SurfaceScheme, int, LOOP, CATMULL_CLARK);
  vtkGetMacro(SurfaceScheme, int);
  void SetSurfaceSchemeToLoop() { this->SetSurfaceScheme(LOOP); }
  void SetSurfaceSchemeToCatmullClark() { this->SetSurfaceScheme(CATMULL_CLARK); }
  ///@}

  enum Embeddings
  {
    CELLS_OF_LEVEL,
    LIMIT
  };
  ///@{
  /**
   * To what points are bound: CELLS_OF_LEVEL (0, the default) or LIMIT (1). With LIMIT each point
   * keeps its place on the limit: the deformation, and its derivatives for vectors, are as smooth
   * as the scheme, and NumberOfLevels is not read. The first execution searches for the places, as
   * vtkSubdivisionLimitProbe does, which takes much longer; later ones are one product.
   */
  vtkSetClampMacro(Embedding, int, CELLS_OF_LEVEL, LIMIT);
  vtkGetMacro(Embedding, int);
  void SetEmbeddingToCellsOfLevel() { this->SetEmbedding(CELLS_OF_LEVEL); }
  void SetEmbeddingToLimit() { this->SetEmbedding(LIMIT); }
  ///@}

  enum OutsidePointsRules
  {
    OUTSIDE_LEAVE,
    OUTSIDE_NEAREST,
    OUTSIDE_ERROR
  };
  ///@{
  /**
   * Points outside the subdivided rest mesh: OUTSIDE_LEAVE (0, the default; they stay where they
   * are), OUTSIDE_NEAREST (1; they move as their nearest point of the mesh does, a surface or curve
   * counts too) or OUTSIDE_ERROR (2; an error, and the output is the input).
   * GetNumberOfOutsidePoints tells their number. Points with coordinates that are not finite are
   * outside, and never move.
   */
  vtkSetClampMacro(OutsidePoints, int, OUTSIDE_LEAVE, OUTSIDE_ERROR);
  vtkGetMacro(OutsidePoints, int);
  void SetOutsidePointsToLeave() { this->SetOutsidePoints(OUTSIDE_LEAVE); }
  void SetOutsidePointsToNearest() { this->SetOutsidePoints(OUTSIDE_NEAREST); }
  void SetOutsidePointsToError() { this->SetOutsidePoints(OUTSIDE_ERROR); }
  ///@}

  ///@{
  /**
   * Whether active vectors, tangents and normals turn and stretch with the object, see above; else
   * they pass unchanged. On by default.
   */
  vtkSetMacro(TransformVectors, bool);
  vtkGetMacro(TransformVectors, bool);
  vtkBooleanMacro(TransformVectors, bool);
  ///@}

  /**
   * How often a rest mesh was subdivided, and how often points were looked up in it.
   */
  vtkIdType GetNumberOfTopologyBuilds() const;
  vtkIdType GetNumberOfLocationBuilds() const;

  /**
   * How many points were outside in the last update.
   */
  vtkIdType GetNumberOfOutsidePoints() const;

protected:
  vtkSubdivisionDeformation();
  ~vtkSubdivisionDeformation() override;

  bool CanJoinSides() const override { return false; } // both meshes keep their points

  int FillInputPortInformation(int port, vtkInformation* info) override;
  /// The output is of the input's type.
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int ExecuteInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int ComputeInputUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int NumberOfLevels = 2;
  int VolumeScheme = BOX_SPLINE;
  int SurfaceScheme = LOOP;
  int Embedding = CELLS_OF_LEVEL;
  int OutsidePoints = OUTSIDE_LEAVE;
  bool TransformVectors = true;

private:
  /// The cage around an object that has the lattice of a deformed one; null if that is none.
  vtkSmartPointer<vtkPointSet> MakeCage(vtkDataObject* object, vtkPointSet* deformed) const;

  std::unique_ptr<subdivision::Deformation> Work;

  vtkSubdivisionDeformation(const vtkSubdivisionDeformation&) = delete;
  void operator=(const vtkSubdivisionDeformation&) = delete;
};

#endif
