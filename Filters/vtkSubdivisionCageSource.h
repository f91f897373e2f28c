// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSubdivisionCageSource
 * @brief   a box of tetrahedra, or a cage that hugs an object: the control mesh of a deformation
 *
 * Makes a lattice of boxes in given bounds, or around an input. It is the rest mesh that
 * vtkSubdivisionDeformation needs; moved, it is the deformed mesh too. The cage is the same on each
 * process that asks for the whole of it.
 *
 * @par Input
 * Port 0, not required: any vtkDataSet or composite of these, also in parts on the ranks of the
 * Controller. The box is around all of it, and larger by a quarter of its cells on each side, as
 * smoothing makes a cage smaller: all of the input is inside of the smoothed cage, too. Bounds are
 * ignored then.
 *
 * With Hug the cage has only the boxes of this lattice that the object, with half a box and the
 * margin around it, touches, the boxes that these enclose, and a few more where boxes would meet in
 * an edge or a point alone. The object is all points of the input and the boxes around its cells.
 *
 * @par Output
 * A vtkUnstructuredGrid of VTK_TETRA cells, without arrays. Each box is split into six tetrahedra
 * around its diagonal from the corner of smallest to the corner of largest coordinates (Kuhn's
 * split), so that cells fit together; all are positive. Points are ordered by z, then y, then x.
 *
 * @par Errors
 * The filter gives an error, and no cells, if Bounds are not finite or not ascending, or if the
 * input has no points. A box without length along an axis is an error if Margin is 0.
 *
 * @sa
 * vtkSubdivisionDeformation vtkSubdivisionModelSource
 */
#ifndef vtkSubdivisionCageSource_h
#define vtkSubdivisionCageSource_h

#include "vtkSmartPointer.h"             // for vtkSmartPointer
#include "vtkSubdivisionObjectsModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <vector> // for std::vector

class vtkDataObject;
class vtkMultiProcessController;

class VTKSUBDIVISIONOBJECTS_EXPORT vtkSubdivisionCageSource : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkSubdivisionCageSource* New();
  vtkTypeMacro(vtkSubdivisionCageSource, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How many boxes there are along x, y and z, at least 1 and at most 100; default 2 along each.
   */
  void SetNumberOfCells(int x, int y, int z);
  void SetNumberOfCells(const int n[3]) { this->SetNumberOfCells(n[0], n[1], n[2]); }
  vtkGetVector3Macro(NumberOfCells, int);
  ///@}

  ///@{
  /**
   * The bounds of the box without its margin if there is no input: the smallest and largest x, y
   * and z. Default 0 to 1 along each axis.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * By how much the box is larger on each side, in percent of its longest side, 0 or more;
   * default 5. Around an input the smoothed cage is larger than the input by so much.
   */
  vtkSetClampMacro(Margin, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(Margin, double);
  ///@}

  ///@{
  /**
   * Whether the cage around an input leaves out the boxes that are away from it, see above. More
   * boxes (NumberOfCells) follow its shape better. Off by default.
   */
  vtkSetMacro(Hug, bool);
  vtkGetMacro(Hug, bool);
  vtkBooleanMacro(Hug, bool);
  ///@}

  ///@{
  /**
   * Precision of the output points, as in vtkAlgorithm: SINGLE_PRECISION (0) for float,
   * DOUBLE_PRECISION (1, the default) or DEFAULT_PRECISION (2) for double.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * The ranks that have parts of the input; all of them have to update the source. Null: this
   * process has the whole input. The default is the global controller when the source is made.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

protected:
  vtkSubdivisionCageSource();
  ~vtkSubdivisionCageSource() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int NumberOfCells[3] = { 2, 2, 2 };
  double Bounds[6] = { 0., 1., 0., 1., 0., 1. };
  double Margin = 5.;
  bool Hug = false;
  int OutputPointsPrecision = DOUBLE_PRECISION;
  vtkSmartPointer<vtkMultiProcessController> Controller;

private:
  /// Sets the bounds of all data sets that all ranks have. Returns false if these have no points.
  bool FindBounds(vtkDataObject* input, double* bounds) const;
  /// Which boxes of the lattice hug the input; empty: all. `margin`: in space.
  std::vector<char> FindHugged(vtkDataObject* input, const double* bounds, double margin) const;

  vtkSubdivisionCageSource(const vtkSubdivisionCageSource&) = delete;
  void operator=(const vtkSubdivisionCageSource&) = delete;
};

#endif
