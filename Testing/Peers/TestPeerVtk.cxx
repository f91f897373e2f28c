// SPDX-License-Identifier: BSD-3-Clause
// VTK's own Loop and Butterfly subdivision on closed meshes: what ours makes. Its points are single
// precision, so that coordinates are compared as they arrive in a point array of doubles.
#include "PeerTools.h"

#include "vtkButterflySubdivisionFilter.h"
#include "vtkDoubleArray.h"
#include "vtkLoopSubdivisionFilter.h"

namespace
{

using namespace peertools;

template <typename Filter>
Model SubdivideTheirs(const Model& model, int levels)
{
  const auto input = surfacetools::MakeInput(model);
  vtkNew<vtkDoubleArray> exact;
  exact->SetName("exact");
  exact->SetNumberOfComponents(3);
  for (const Point& point : model.Points)
  {
    exact->InsertNextTuple(point.data());
  }
  input->GetPointData()->AddArray(exact);
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  filter->SetNumberOfSubdivisions(levels);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* points = output->GetPointData()->GetArray("exact");
  Model made;
  made.Points.resize(static_cast<std::size_t>(points->GetNumberOfTuples()));
  for (std::size_t i = 0; i < made.Points.size(); ++i)
  {
    points->GetTuple(static_cast<vtkIdType>(i), made.Points[i].data());
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < output->GetNumberOfPolys(); ++c)
  {
    output->GetCellPoints(c, ids);
    made.Faces.emplace_back(ids->begin(), ids->end());
  }
  return made;
}

TEST(PeerVtk, ModifiedButterfly)
{
  ExpectSameOnClosedMeshes(vtkSurfaceSubdivision::MODIFIED_BUTTERFLY, true,
    SubdivideTheirs<vtkButterflySubdivisionFilter>);
}

TEST(PeerVtk, LoopWithHisWeights)
{
  ExpectSameOnClosedMeshes(
    vtkSurfaceSubdivision::LOOP, true, SubdivideTheirs<vtkLoopSubdivisionFilter>, WithLoopWeights);
}

TEST(PeerVtk, PlainBoundary)
{
  ExpectSameOnTube(
    vtkSurfaceSubdivision::LOOP, true, SubdivideTheirs<vtkLoopSubdivisionFilter>, WithLoopWeights);
}

}
