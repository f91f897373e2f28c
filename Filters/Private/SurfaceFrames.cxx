// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFrames.h"

#include "Arrays.h"
#include "Core/SurfaceSides.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace subdivision
{

void AddLimitFrames(const TangentPairs& tangents, int type, const Buffer<vtkIdType>& sources,
  bool normals, bool twoTangents, vtkPolyData* input, vtkPolyData* output)
{
  const vtkIdType size = sources.empty() ? tangents.Errors.size() : sources.size();
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
        FindNormal(tangents.Values[0].data() + 3 * i, tangents.Values[1].data() + 3 * i,
          tangents.Errors[i], n);
      });
  }
  for (int t = 0; t < 2 && twoTangents; ++t)
  {
    add(LimitTangentNames[t],
      [&](vtkIdType i, double* out) { std::copy_n(tangents.Values[t].data() + 3 * i, 3, out); });
  }
}

template <typename Id>
void AddLimitFrames(const SurfaceSteps<Id>& steps, vtkDataArray* points,
  const Buffer<vtkIdType>& sources, bool normals, bool twoTangents, vtkPolyData* input,
  vtkPolyData* output)
{
  const int type = points->GetDataType();
  const vtkIdType rows = points->GetNumberOfTuples();
  TangentPairs tangents(rows);
  Buffer<double> x(3 * rows);
  ForEach(3 * rows,
    [&](vtkIdType i)
    {
      x[i] = type == VTK_FLOAT ? static_cast<const float*>(points->GetVoidPointer(0))[i]
                               : static_cast<const double*>(points->GetVoidPointer(0))[i];
    });
  const double unit = type == VTK_FLOAT ? SingleUnit : DoubleUnit;
  auto apply = [&](LimitKind kind, double* values)
  {
    steps.GetLimit(kind).ForRows(
      [&](const RowBlock<Id>& block, vtkIdType first)
      {
        block.Apply(x.data(), values + 3 * first, 3);
        for (std::size_t row = 0; row < block.GetNumberOfRows(); ++row)
        {
          tangents.Errors[first + static_cast<vtkIdType>(row)] +=
            GetTangentError(block, row, x.data(), unit);
        }
      });
  };
  apply(LimitKind::Tangent1, tangents.Values[0].data());
  apply(LimitKind::Tangent2, tangents.Values[1].data());
  const SurfaceLevel<Id>& level = steps.GetLevel(steps.GetNumberOfSteps());
  const Buffer<unsigned char> turned = FindTurnedFaces(level.Mesh);
  ForEach(turned.empty() ? 0 : rows,
    [&](vtkIdType v)
    {
      const Id face = FindFaceOfTangents(level.Mesh, level.Tags, static_cast<Id>(v));
      for (vtkIdType i = 3 * v; i < 3 * v + 3 && face >= 0 && turned[face]; ++i)
      {
        tangents.Values[1][i] = -tangents.Values[1][i];
      }
    });
  AddLimitFrames(tangents, type, sources, normals, twoTangents, input, output);
}

template void AddLimitFrames(const SurfaceSteps<int>&, vtkDataArray*, const Buffer<vtkIdType>&,
  bool, bool, vtkPolyData*, vtkPolyData*);
template void AddLimitFrames(const SurfaceSteps<long long>&, vtkDataArray*,
  const Buffer<vtkIdType>&, bool, bool, vtkPolyData*, vtkPolyData*);

}
