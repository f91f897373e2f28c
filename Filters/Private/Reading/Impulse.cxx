// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/Impulse.h"

#include "Core/Memory/Buffer.h"
#include "Private/Reading/ReadableMesh.h"

#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

namespace subdivision
{

vtkSmartPointer<vtkDataObject> AddImpulse(vtkDataObject* readable, vtkIdType point, bool& found)
{
  found = false;
  const bool isAlone = !vtkCompositeDataSet::SafeDownCast(readable);
  return ChangeMeshes(readable,
    [&](vtkDataObject* object, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      auto* mesh = vtkPointSet::SafeDownCast(object);
      if (!mesh)
      {
        return object;
      }
      const vtkIdType size = mesh->GetNumberOfPoints();
      auto* ids = vtkIdTypeArray::SafeDownCast(mesh->GetPointData()->GetGlobalIds());
      const bool hasIds = ids && ids->GetNumberOfTuples() == size;
      vtkNew<vtkDoubleArray> impulse;
      impulse->SetName("BasisFunction");
      impulse->SetNumberOfTuples(size);
      Fill(impulse->GetPointer(0), size, 0.);
      for (const vtkIdType i : InTurn(hasIds ? size : 0))
      {
        if (ids->GetValue(i) == point)
        {
          impulse->SetValue(i, 1.);
          found = true;
        }
      }
      if (!hasIds && isAlone && point < size)
      {
        impulse->SetValue(point, 1.);
        found = true;
      }
      const auto copy = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
      copy->ShallowCopy(mesh);
      copy->GetPointData()->AddArray(impulse);
      return copy;
    });
}

}
