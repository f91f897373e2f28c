// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditTools.h
 * Selections, and runs of vtkSubdivisionEdit.
 */
#ifndef SubdivisionObjects_EditTools_h
#define SubdivisionObjects_EditTools_h

#include "FeatureTools.h"
#include "SelectionTools.h"

#include "vtkInformation.h"
#include "vtkSphereSource.h"
#include "vtkSubdivisionEdit.h"
#include "vtkSubdivisionModelSource.h"
#include "vtkTrivialProducer.h"

namespace edit_tools
{

using namespace feature_tools;

using namespace selection_tools;

/// Null: no connection.
inline void Connect(vtkAlgorithm* filter, int port, vtkDataObject* data)
{
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(data);
  filter->SetInputConnection(port, data ? producer->GetOutputPort() : nullptr);
}

inline vtkPointSet* GetData(vtkSubdivisionEdit* edit)
{
  return vtkPointSet::SafeDownCast(edit->GetOutputDataObject(0));
}

/// A copy of the output, which is made without a message.
inline Grid Edit(vtkSubdivisionEdit* edit, vtkDataObject* input, vtkSelection* selection,
  vtkDataObject* rest = nullptr)
{
  Connect(edit, 1, selection);
  Connect(edit, 2, rest);
  UpdateInSilence(edit, input);
  const auto copy = Grid::New();
  copy->DeepCopy(GetData(edit));
  return copy;
}

inline double GetDistance(const Point& a, const Point& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// A coarse sphere of triangles, in double precision.
inline vtkSmartPointer<vtkPolyData> MakeSurface()
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(6);
  source->SetPhiResolution(5);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  const vtkSmartPointer<vtkPolyData> sphere = source->GetOutput();
  sphere->GetPointData()->Initialize();
  return sphere;
}

/// The cells of dimension 3, on the same points.
inline Grid TakeSolids(vtkUnstructuredGrid* mesh)
{
  const auto solids = Grid::New();
  solids->SetPoints(mesh->GetPoints());
  solids->Allocate(mesh->GetNumberOfCells());
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    if (mesh->GetCellType(c) == VTK_TETRA)
    {
      const Ids ids = GetCell(mesh, c);
      solids->InsertNextCell(VTK_TETRA, 4, ids.data());
    }
  }
  return solids;
}

}

#endif
