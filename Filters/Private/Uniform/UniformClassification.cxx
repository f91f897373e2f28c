// SPDX-License-Identifier: BSD-3-Clause
// The arrays of GenerateClassification.
#include "Private/Uniform/UniformRun.h"

#include "Private/Arrays/Arrays.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace subdivision
{

/// Adds both arrays of points. `vertices` and `edges` are the strata of the level before, whose
/// edges have the new points.
void UniformRun::AddClassification(const Buffer<Stratum>& vertices, const Buffer<Stratum>& edges)
{
  if (!this->Options.GenerateClassification)
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> rules;
  vtkNew<vtkUnsignedCharArray> types;
  rules->SetName(RuleName);
  types->SetName(TypeName);
  const vtkIdType size = this->Output->GetNumberOfPoints();
  rules->SetNumberOfTuples(size);
  types->SetNumberOfTuples(size);
  ForEach(size,
    [&](vtkIdType i)
    {
      const vtkIdType edge = i - vertices.size();
      const Stratum stratum = edge < 0 ? vertices[i]
        : edge < edges.size()          ? edges[edge]
                                       : Stratum(Rule::Solid); // the centre of an octahedron
      const bool regular = stratum.GetRule() == Rule::RegularEdge;
      rules->SetValue(i, static_cast<unsigned char>(regular ? Rule::Solid : stratum.GetRule()));
      types->SetValue(i, static_cast<unsigned char>(stratum.GetType()));
    });
  AddInstead(this->Input->GetPointData(), rules, this->Output->GetPointData());
  AddInstead(this->Input->GetPointData(), types, this->Output->GetPointData());
}

}
