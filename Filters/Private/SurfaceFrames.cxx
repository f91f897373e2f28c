// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFrames.h"

#include "Arrays.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

namespace subdivision
{

void AddLimitFrames(const Buffer<double> (&tangents)[2], int type, const Buffer<vtkIdType>& sources,
  bool normals, bool twoTangents, vtkPolyData* input, vtkPolyData* output)
{
  const vtkIdType size = sources.empty() ? tangents[0].size() / 3 : sources.size();
  auto add = [&](const char* name, const auto& value)
  {
    const auto array = MakeArray(type, 3, size);
    array->SetName(name);
    auto fill = [&](auto* out)
    {
      using T = typename std::remove_pointer<decltype(out)>::type;
      ForEach(size,
        [&](vtkIdType i)
        {
          double result[3];
          value(sources.empty() ? i : sources[i], result);
          for (int c = 0; c < 3; ++c)
          {
            out[3 * i + c] = static_cast<T>(result[c]);
          }
        });
    };
    if (type == VTK_FLOAT)
    {
      fill(static_cast<float*>(array->GetVoidPointer(0)));
    }
    else
    {
      fill(static_cast<double*>(array->GetVoidPointer(0)));
    }
    AddInstead(input->GetPointData(), array, output->GetPointData());
  };
  if (normals)
  {
    add(LimitNormalsName,
      [&](vtkIdType i, double* n)
      {
        const double* a = tangents[0].data() + 3 * i;
        const double* b = tangents[1].data() + 3 * i;
        n[0] = a[1] * b[2] - a[2] * b[1];
        n[1] = a[2] * b[0] - a[0] * b[2];
        n[2] = a[0] * b[1] - a[1] * b[0];
        const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int c = 0; c < 3; ++c)
        {
          n[c] = length > 0. && std::isfinite(length) ? n[c] / length : 0.;
        }
      });
  }
  for (int t = 0; t < 2 && twoTangents; ++t)
  {
    add(LimitTangentNames[t], [&](vtkIdType i, double* out)
      { std::copy(tangents[t].data() + 3 * i, tangents[t].data() + 3 * i + 3, out); });
  }
}

template <typename Id>
void AddLimitFrames(const SurfaceSteps<Id>& steps, vtkDataArray* points,
  const Buffer<vtkIdType>& sources, bool normals, bool twoTangents, vtkPolyData* input,
  vtkPolyData* output)
{
  const int type = points->GetDataType();
  const vtkIdType rows = points->GetNumberOfTuples();
  Buffer<double> tangents[2] = { Buffer<double>(3 * rows), Buffer<double>(3 * rows) };
  Buffer<double> x(3 * rows);
  ForEach(3 * rows,
    [&](vtkIdType i)
    {
      x[i] = type == VTK_FLOAT ? static_cast<const float*>(points->GetVoidPointer(0))[i]
                               : static_cast<const double*>(points->GetVoidPointer(0))[i];
    });
  steps.GetLimit(LimitKind::Tangent1).Apply(x.data(), tangents[0].data(), 3);
  steps.GetLimit(LimitKind::Tangent2).Apply(x.data(), tangents[1].data(), 3);
  AddLimitFrames(tangents, type, sources, normals, twoTangents, input, output);
}

template void AddLimitFrames(const SurfaceSteps<int>&, vtkDataArray*, const Buffer<vtkIdType>&,
  bool, bool, vtkPolyData*, vtkPolyData*);
template void AddLimitFrames(const SurfaceSteps<long long>&, vtkDataArray*,
  const Buffer<vtkIdType>&, bool, bool, vtkPolyData*, vtkPolyData*);

}
