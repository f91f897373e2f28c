// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSubdivisionLabelSolid
 * @brief   a smooth solid of many materials from an image of labels
 *
 * Makes tetrahedra or hexahedra of all voxels of an image but the background. Interfaces between
 * labels, and between labels and background, are smooth surfaces that the cells of both sides
 * share; each label keeps the volume that its voxels have.
 *
 * @par Algorithm
 * Blocks of k^3 voxels become one control voxel, with k as small as NumberOfControlCells allows: of
 * the label that most of the voxels have. Where labels have equally many, materials come before
 * background, then the smallest label. At the end of the image blocks have half of k voxels or
 * more, and up to one and a half times k. Then KeepConnected gives blocks to labels that would come
 * apart, parts of few voxels first. The corners of control voxels are smoothed without shrinking
 * (G. Taubin), corners on interfaces along interfaces, corners on curves where interfaces meet
 * along these; none moves farther than MaximumDisplacement, and with FlatBorder corners on the
 * border of the image stay there. Then they are moved as little as possible so that labels have
 * their volumes, and vtkMultiDimensionalSubdivision makes the limit that passes through them, with
 * PreserveInterfaces. The filter measures this solid, corrects the corners for the difference in
 * volume, takes a quarter of the smoothing back around tetrahedra (of a hexahedron: those of a
 * corner and its neighbours) that are thinner than 2 % of the tetrahedra of a cube, and repeats
 * this up to 8 times, mostly twice. Voxels that meet in an edge or a point alone become joints.
 *
 * @par Accuracy
 * Volumes equal the input's voxels to 0.1 %, or 0.5 % where parts are about as thin as a control
 * voxel; of larger differences a warning tells. The distance of the smooth interfaces from the
 * faces of the control voxels is at most about MaximumDisplacement control voxels, both ways. No
 * solid is inverted; of any that is a warning tells.
 *
 * @par Input
 * Port 0: vtkImageData, with any direction matrix, vtkRectilinearGrid or vtkStructuredGrid; corners
 * of voxels around points of a grid lie half-way between points, corners on the border half a voxel
 * outside, and corners are smoothed as if all voxels were cubes. Labels of points: voxels are
 * centred on the points, also on the border, so that the solid is half a voxel larger than the
 * image on each side. Labels of cells: voxels are the cells. Hidden points and cells, and cells
 * with a hidden point, are background. Port 1, not required: a vtkTable with one row for each
 * material. A row is for the label in the column that has the name of the label array, else in the
 * column `Label`, else for the label that is its number, from 0; of several rows for a label the
 * first counts, with a warning. Without a table the field arrays of the image are one if such a
 * column is there.
 *
 * @par Arrays read, by SetInputArrayToProcess
 *  - 0, labels: cell or point array with whole numbers of any type, from -2^63 to 2^64 - 1, one for
 *    each voxel; unset: the active scalars of points, else of cells.
 *
 * @par Output
 * A vtkUnstructuredGrid of VTK_TETRA or VTK_HEXAHEDRON cells, on the limit. Cell arrays: the labels
 * (the active scalars), with name and type of the input's; the other arrays of the voxels but ids,
 * floating point numbers averaged over the voxels of the block that have its label, of others the
 * tuple of the first of these; the columns of the table that have numbers, which replace arrays of
 * the voxels of the same name, with a warning. Field arrays: the image's, and all columns of the
 * table, so also the names of materials.
 *
 * @par Errors
 * The filter gives an error, and no cells, if there are no labels, if a label is no whole number,
 * if voxels have no volume (a spacing is 0 or not finite),
 * or if the output would take more memory than there is.
 * An image of background alone gives no cells, and a warning; labels that coarsening loses, tears
 * apart or joins give a warning, too, and values that are NaN or infinite, which are background.
 *
 * @par Ranks
 * The first rank asks for the whole image and makes the whole output.
 *
 * @sa
 * vtkMultiDimensionalSubdivision
 */
#ifndef vtkSubdivisionLabelSolid_h
#define vtkSubdivisionLabelSolid_h

#include "vtkSubdivisionAlgorithm.h"     // for Schemes
#include "vtkSubdivisionObjectsModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

class vtkDataArray;
class vtkDataSet;
class vtkTable;
namespace subdivision
{
struct LabelSolidOptions;
}

class VTKSUBDIVISIONOBJECTS_EXPORT vtkSubdivisionLabelSolid : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkSubdivisionLabelSolid* New();
  vtkTypeMacro(vtkSubdivisionLabelSolid, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The table of materials, input port 1.
   */
  void SetMaterialsConnection(vtkAlgorithmOutput* output);

  ///@{
  /**
   * The label of voxels that are left out. Default 0.
   */
  vtkSetMacro(BackgroundLabel, vtkIdType);
  vtkGetMacro(BackgroundLabel, vtkIdType);
  ///@}

  ///@{
  /**
   * How many control voxels there may be without the background, 0 or more; default 20000. 0: one
   * for each voxel of the image. Each becomes 6 tetrahedra or one hexahedron, and these 8 on each
   * level.
   */
  vtkSetClampMacro(NumberOfControlCells, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(NumberOfControlCells, vtkIdType);
  ///@}

  ///@{
  /**
   * Whether blocks of voxels are given to labels so that a connected piece of a label stays
   * connected, where it has the most voxels of some blocks: each has voxels of the piece. On by
   * default. If off, a warning tells of labels that come apart.
   */
  vtkSetMacro(KeepConnected, bool);
  vtkGetMacro(KeepConnected, bool);
  vtkBooleanMacro(KeepConnected, bool);
  ///@}

  enum Connectivities
  {
    FACES,
    CORNERS
  };
  ///@{
  /**
   * Which voxels of a label are connected: by FACES (0; 6 neighbours), or also by edges and
   * CORNERS (1, the default; 26 neighbours), where voxels connected by faces stay so.
   */
  vtkSetClampMacro(Connectivity, int, FACES, CORNERS);
  vtkGetMacro(Connectivity, int);
  void SetConnectivityToFaces() { this->SetConnectivity(FACES); }
  void SetConnectivityToCorners() { this->SetConnectivity(CORNERS); }
  ///@}

  ///@{
  /**
   * Whether the solid stays flat where it ends at the border of the image, with sharp edges around
   * these faces. On by default. If off, it is round there, as if there were background beyond.
   */
  vtkSetMacro(FlatBorder, bool);
  vtkGetMacro(FlatBorder, bool);
  vtkBooleanMacro(FlatBorder, bool);
  ///@}

  enum CellTypes
  {
    TETRAHEDRA,
    HEXAHEDRA
  };
  ///@{
  /**
   * Whether control voxels are cut into TETRAHEDRA (0, the default), or stay HEXAHEDRA (1), which
   * are smoothed with the VolumeScheme HYBRID of vtkMultiDimensionalSubdivision. At level 0 the
   * hexahedra are the control voxels, with their corners on the smooth interfaces.
   */
  vtkSetClampMacro(CellType, int, TETRAHEDRA, HEXAHEDRA);
  vtkGetMacro(CellType, int);
  void SetCellTypeToTetrahedra() { this->SetCellType(TETRAHEDRA); }
  void SetCellTypeToHexahedra() { this->SetCellType(HEXAHEDRA); }
  ///@}

  ///@{
  /**
   * Number of subdivision steps, 0 to 20, default 1. Points are on the limit whatever it is.
   */
  vtkSetClampMacro(NumberOfLevels, int, 0, 20);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

  ///@{
  /**
   * How solids are split and smoothed inside: BOX_SPLINE (0, the default) or TET_OCT (1; adds the
   * cell array `OctahedronId`), as in vtkMultiDimensionalSubdivision. Interfaces are the same. It
   * is not read for HEXAHEDRA.
   */
  vtkSetClampMacro(
    VolumeScheme, int, vtkSubdivisionAlgorithm::BOX_SPLINE, vtkSubdivisionAlgorithm::TET_OCT);
  vtkGetMacro(VolumeScheme, int);
  void SetVolumeSchemeToBoxSpline() { this->SetVolumeScheme(vtkSubdivisionAlgorithm::BOX_SPLINE); }
  void SetVolumeSchemeToTetOct() { this->SetVolumeScheme(vtkSubdivisionAlgorithm::TET_OCT); }
  ///@}

  enum OutputCellTypes
  {
    LINEAR_CELLS,
    QUADRATIC_CELLS,
    LAGRANGE_CELLS
  };
  ///@{
  /**
   * Which cells the output has: LINEAR_CELLS (0, the default), or curved ones for solvers,
   * QUADRATIC_CELLS (1) and LAGRANGE_CELLS (2) of CellOrder, as vtkUniformSubdivisionAlgorithm
   * makes, proves and repairs them. The linear cells have the volumes of the voxels.
   */
  vtkSetClampMacro(OutputCells, int, LINEAR_CELLS, LAGRANGE_CELLS);
  vtkGetMacro(OutputCells, int);
  void SetOutputCellsToLinear() { this->SetOutputCells(LINEAR_CELLS); }
  void SetOutputCellsToQuadratic() { this->SetOutputCells(QUADRATIC_CELLS); }
  void SetOutputCellsToLagrange() { this->SetOutputCells(LAGRANGE_CELLS); }
  ///@}

  ///@{
  /**
   * The order of LAGRANGE_CELLS, 1 to 6, default 2.
   */
  vtkSetClampMacro(CellOrder, int, 1, 6);
  vtkGetMacro(CellOrder, int);
  ///@}

  ///@{
  /**
   * How often corners are smoothed, each time by a step inwards and one outwards: 0 to 1000,
   * default 20. With 0 the solid follows the stairs of the voxels.
   */
  vtkSetClampMacro(NumberOfSmoothingSteps, int, 0, 1000);
  vtkGetMacro(NumberOfSmoothingSteps, int);
  ///@}

  ///@{
  /**
   * How far smoothing may move a corner, in control voxels, 0 to 1, default 0.55. Above 0.5
   * opposite sides of a part that is one voxel thin could meet; the filter takes smoothing back
   * there.
   */
  vtkSetClampMacro(MaximumDisplacement, double, 0., 1.);
  vtkGetMacro(MaximumDisplacement, double);
  ///@}

protected:
  vtkSubdivisionLabelSolid();
  ~vtkSubdivisionLabelSolid() override;

  /// Indices of SetInputArrayToProcess.
  enum ArrayIndices
  {
    LABELS_ARRAY
  };

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkIdType BackgroundLabel = 0;
  vtkIdType NumberOfControlCells = 20000;
  bool KeepConnected = true;
  int Connectivity = CORNERS;
  bool FlatBorder = true;
  int CellType = TETRAHEDRA;
  int NumberOfLevels = 1;
  int VolumeScheme = vtkSubdivisionAlgorithm::BOX_SPLINE;
  int OutputCells = LINEAR_CELLS;
  int CellOrder = 2;
  int NumberOfSmoothingSteps = 20;
  double MaximumDisplacement = .55;

private:
  /// Sets the array of labels of `options`. Returns false after an error.
  bool FindLabels(vtkDataSet* image, subdivision::LabelSolidOptions& options);
  /// With the options of the filter, and the materials of the table, if there is one. Returns
  /// whether it finished.
  bool MakeSolid(vtkDataSet* image, vtkTable* table, subdivision::LabelSolidOptions& options,
    vtkUnstructuredGrid* output);

  vtkSubdivisionLabelSolid(const vtkSubdivisionLabelSolid&) = delete;
  void operator=(const vtkSubdivisionLabelSolid&) = delete;
};

#endif
