// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/Classification.h"

#include "Private/Arrays/Arrays.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace subdivision
{

void AddRules(const Buffer<Stratum>& vertices, const Buffer<Stratum>& edges, vtkPointSet* input,
  vtkUnstructuredGrid* output)
{
  vtkNew<vtkUnsignedCharArray> rules;
  vtkNew<vtkUnsignedCharArray> types;
  rules->SetName(RuleName);
  types->SetName(TypeName);
  const vtkIdType size = output->GetNumberOfPoints();
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
  AddInstead(input->GetPointData(), rules, output->GetPointData());
  AddInstead(input->GetPointData(), types, output->GetPointData());
}

}
