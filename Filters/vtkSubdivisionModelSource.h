// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSubdivisionModelSource
 * @brief   built-in control meshes that mix solids, surfaces and curves
 *
 * The source makes one of eight small control meshes (fewer than 600 cells) of the kind that
 * multi-dimensional subdivision is made for: parts of different dimensions in one simplicial
 * complex, joined where they share points. Subdivide one with vtkMultiDimensionalSubdivision to see
 * the shape that it controls.
 *
 * @par Models:
 * The number after each part is its MaterialId.
 * - MixedDimensions, a flower: a curve as stem (0), surfaces as petals and leaves (1), a solid head
 *   (2).
 * - Screw, of fewer than 20 points: four surfaces as blades (0) along the twisted edges of a solid
 *   core (1).
 * - SpringAndValve: a solid cap (0), a solid spiral (1) that grows out of it, and around the axis a
 *   surface (2) that hangs from the cap.
 * - Ship: surfaces as hull (0), decks (1) and deckhouse (3), a solid bow (2), curves as mast and
 *   bowsprit (4). At the decks three and more surfaces meet.
 * - MechanicalPart: a solid plate (0) with a round hole, sharp and rounded corners, and a
 *   surface as handle (1). It comes with its singular cells.
 * - Character, a hero: a solid body (0), a solid head and beads (1), surfaces as limbs (2),
 *   cape and ears (3), curves as antennae and hair (4), solid goggles (5). It is symmetric.
 * - MaterialBlock: a solid block of 2 x 2 x 3 cubes, six tetrahedra each, with tensions that change
 *   strongly from vertex to vertex, and two materials (0, 1) that meet in a step.
 * - Cylinder: a solid (0) around the z axis, of radius 1.5 and height 3, whose two rims (1) are
 *   creases, so that its ends stay flat: a control mesh for vtkSubdivisionDeformation.
 *
 * @par Output:
 * A vtkUnstructuredGrid of cells of type VTK_VERTEX, VTK_LINE, VTK_TRIANGLE and VTK_TETRA. It is a
 * valid complex: cells meet only in common faces, no two points coincide, every point is used, and
 * tetrahedra have positive volume. Lengths have no unit.
 *
 * @par Arrays:
 * - point data `Tension` (vtkDoubleArray, one component, the active scalars): a property
 *   that varies in space, for subdivision to blend. It has no unit.
 * - cell data `MaterialId` (vtkIntArray, one component): the part, see the list above.
 * - cell data `Singular` (vtkIntArray, one component): 1 for vertices, lines and triangles where
 *   subdivision is to keep a corner, a crease or a flat face, else 0. Only two models have such
 *   cells, all of which are faces of tetrahedra. MechanicalPart: the flat top, bottom and end, the
 *   eight edges of each rim of the hole, the edges of the end and its four corners; nothing is
 *   flagged where the plate is to become round, at the other end. Cylinder: the eight edges of each
 *   rim.
 *
 * @par Errors:
 * Every value of every option gives a mesh. Too little memory is an error, and the output empty.
 *
 * @par Complexity, threads:
 * Constant time and memory; serial. The output is the same on every machine, bit for bit:
 * coordinates and tensions are multiples of 1/10000.
 *
 * @sa
 * vtkMultiDimensionalSubdivision vtkSubdivisionDeformation
 */
#ifndef vtkSubdivisionModelSource_h
#define vtkSubdivisionModelSource_h

#include "vtkSubdivisionObjectsModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

class VTKSUBDIVISIONOBJECTS_EXPORT vtkSubdivisionModelSource : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkSubdivisionModelSource* New();
  vtkTypeMacro(vtkSubdivisionModelSource, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The models. The description of the class has a list of them.
   */
  enum ModelType
  {
    MIXED_DIMENSIONS = 0,
    SCREW,
    SPRING_AND_VALVE,
    SHIP,
    MECHANICAL_PART,
    CHARACTER,
    MATERIAL_BLOCK,
    CYLINDER,
    NUMBER_OF_MODELS
  };

  ///@{
  /**
   * Which model to make, MIXED_DIMENSIONS (0, the default) to CYLINDER (7).
   */
  vtkSetClampMacro(Model, int, MIXED_DIMENSIONS, CYLINDER);
  vtkGetMacro(Model, int);
  void SetModelToMixedDimensions() { this->SetModel(MIXED_DIMENSIONS); }
  void SetModelToScrew() { this->SetModel(SCREW); }
  void SetModelToSpringAndValve() { this->SetModel(SPRING_AND_VALVE); }
  void SetModelToShip() { this->SetModel(SHIP); }
  void SetModelToMechanicalPart() { this->SetModel(MECHANICAL_PART); }
  void SetModelToCharacter() { this->SetModel(CHARACTER); }
  void SetModelToMaterialBlock() { this->SetModel(MATERIAL_BLOCK); }
  void SetModelToCylinder() { this->SetModel(CYLINDER); }
  ///@}

  ///@{
  /**
   * The name of a model, such as "MixedDimensions"; null for a number that is no model.
   */
  static const char* GetModelName(int model);
  const char* GetModelAsString() { return vtkSubdivisionModelSource::GetModelName(this->Model); }
  ///@}

  ///@{
  /**
   * Precision of the output points, as in vtkAlgorithm: SINGLE_PRECISION (0) for float,
   * DOUBLE_PRECISION (1, the default) or DEFAULT_PRECISION (2) for double.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

protected:
  vtkSubdivisionModelSource();
  ~vtkSubdivisionModelSource() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Model = MIXED_DIMENSIONS;
  int OutputPointsPrecision = DOUBLE_PRECISION;

private:
  vtkSubdivisionModelSource(const vtkSubdivisionModelSource&) = delete;
  void operator=(const vtkSubdivisionModelSource&) = delete;
};

#endif
