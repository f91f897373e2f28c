// SPDX-License-Identifier: BSD-3-Clause
// Binds points to places of the limit of the rest mesh.
#include "Private/Deformation/EmbeddedPoints.h"

#include "Core/Memory/Loops.h"
#include "Private/Places/PlaceOutput.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{

std::unique_ptr<EmbeddedPoints> EmbedOnLimit(
  vtkDataArray* points, bool slopes, const DeformationOptions& options, RestMesh& rest)
{
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  coordinates->GetData()->DeepCopy(points);
  vtkNew<vtkPolyData> targets;
  targets->SetPoints(coordinates);
  vtkNew<vtkPolyData> found;
  auto embedded = std::make_unique<EmbeddedPoints>();
  embedded->Rule = options.Outside;
  PlaceRequest request;
  request.Targets = targets;
  request.Output = found;
  request.HasDerivatives = slopes;
  request.Rows = &embedded->OnLimit;
  if (!rest.FindPlaces(request, options))
  {
    return nullptr;
  }
  // A point is inside if it is as near to the limit as the search for its place is exact.
  double reach = 0.;
  for (const vtkIdType i : InTurn(3 * rest.GetNumberOfPoints()))
  {
    reach = std::max(reach, std::abs(rest.GetPoints()[i]));
  }
  reach *= points->GetDataType() == VTK_FLOAT || rest.IsSingle() ? SingleTie : 1e-9;
  vtkDataArray* distances = found->GetPointData()->GetArray("Distance");
  embedded->IsLeft.resize(static_cast<std::size_t>(coordinates->GetNumberOfPoints()), 0);
  ForEachInTurn(coordinates->GetNumberOfPoints(),
    [&](vtkIdType i)
    {
      double x[3];
      coordinates->GetPoint(i, x);
      const bool isFinite = std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
      if (isFinite && distances->GetComponent(i, 0) <= reach)
      {
        return;
      }
      embedded->IsLeft[i] = !isFinite || options.Outside != OutsideRule::Nearest;
      embedded->NumberNotFinite += !isFinite;
      embedded->Outside.push_back(i);
      const double* nearest = found->GetPoint(i);
      for (int c = 0; c < 3; ++c)
      {
        embedded->Remainders.push_back(x[c] - (embedded->IsLeft[i] ? 0. : nearest[c]));
      }
    });
  return embedded;
}

}
