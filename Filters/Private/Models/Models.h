// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Models.h
 * The control meshes of vtkSubdivisionModelSource, one function each. What they show is told in the
 * documentation of that class.
 */
#ifndef SubdivisionObjects_Models_h
#define SubdivisionObjects_Models_h

#include "Private/Models/ModelBuilder.h"

namespace subdivision
{

void BuildMixedDimensions(ModelBuilder& model);
void BuildScrew(ModelBuilder& model);
void BuildSpringAndValve(ModelBuilder& model);
void BuildShip(ModelBuilder& model);
void BuildMechanicalPart(ModelBuilder& model);
void BuildCharacter(ModelBuilder& model);
void BuildMaterialBlock(ModelBuilder& model);
void BuildCylinder(ModelBuilder& model);

}

#endif
