// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExtractDimensions
 * @brief   takes the cells of some dimensions out of a mesh
 *
 * The input is a vtkUnstructuredGrid, a vtkPolyData, or a composite data set of these, and so is
 * the output: it has the cells of the wanted dimensions (vertices, lines, surfaces, solids; of any
 * type that VTK has a class of) in the order of the input, and the points that they use. It is for
 * meshes that mix dimensions, of which VTK's volume mappers draw nothing.
 *
 * Point and cell data follow their points and cells, with ids, ghost types and active attributes.
 * Field data pass through, but for the stamps by which filters of this project recognise their own
 * output: they cannot go on with a part of the cells. With all dimensions the output is the input.
 * A warning tells, on one rank, where there is nothing to extract, and which cells there are. Each
 * rank works on its part by itself. Blocks of other classes pass through.
 *
 * @sa
 * vtkMultiDimensionalSubdivision
 */
#ifndef vtkExtractDimensions_h
#define vtkExtractDimensions_h

#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

class VTKSUBDIVISIONOBJECTS_EXPORT vtkExtractDimensions : public vtkPassInputTypeAlgorithm
{
public:
  static vtkExtractDimensions* New();
  vtkTypeMacro(vtkExtractDimensions, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OutputDimensionFlags
  {
    NO_DIMENSION = 0,
    VERTICES = 1,
    LINES = 2,
    SURFACES = 4,
    SOLIDS = 8,
    ALL_DIMENSIONS = 15
  };
  ///@{
  /**
   * Which cells the output has, a sum of VERTICES (1), LINES (2), SURFACES (4) and SOLIDS (8): from
   * NO_DIMENSION (0) to ALL_DIMENSIONS (15). SOLIDS (8, the default) are the cells that volume
   * rendering needs.
   */
  vtkSetClampMacro(OutputDimensions, int, NO_DIMENSION, ALL_DIMENSIONS);
  vtkGetMacro(OutputDimensions, int);
  ///@}

  ///@{
  /**
   * The same by dimensions, 0 to 3.
   */
  void AddOutputDimension(int dimension);
  void ClearOutputDimensions() { this->SetOutputDimensions(NO_DIMENSION); }
  ///@}

protected:
  vtkExtractDimensions();
  ~vtkExtractDimensions() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int OutputDimensions = SOLIDS;

private:
  vtkExtractDimensions(const vtkExtractDimensions&) = delete;
  void operator=(const vtkExtractDimensions&) = delete;
};

#endif
