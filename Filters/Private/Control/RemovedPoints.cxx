// SPDX-License-Identifier: BSD-3-Clause
// Removes the points that MergeCoincidentPoints has merged with others.
#include "Private/Control/CoincidentPoints.h"

#include "Core/Operators/MatrixFactors.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Reading/ReadableMesh.h"
#include "Private/Reading/UnusedPoints.h"
#include "Private/Values/PointCopies.h"

#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <type_traits>
#include <unordered_map>
#include <utility>

namespace subdivision
{
vtkSmartPointer<vtkDataObject> RemoveMergedPoints(vtkDataObject* merged,
  const std::function<void(vtkPointSet*, vtkPointSet*)>& change,
  const std::function<void(const std::string&)>& warn, PointSources& sources)
{
  return ChangeMeshes(merged,
    [&](vtkDataObject* object, unsigned int block) -> vtkSmartPointer<vtkDataObject>
    {
      auto* mesh = vtkPointSet::SafeDownCast(object);
      vtkIdTypeArray* stands = GetMergedPoints(mesh);
      if (!stands)
      {
        return object;
      }
      const auto copy = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
      copy->ShallowCopy(mesh);
      change(mesh, copy);
      vtkPointData* data = copy->GetPointData();
      data->RemoveArray(MergedPointsName);
      for (int a = data->GetNumberOfArrays() - 1; a >= 0; --a)
      {
        if (!HasTuples(data->GetAbstractArray(a), mesh->GetNumberOfPoints(), "point", warn))
        {
          data->RemoveArray(a);
        }
      }
      std::vector<vtkIdType> kept;
      std::vector<vtkIdType> places;
      for (const vtkIdType i : InTurn(mesh->GetNumberOfPoints()))
      {
        places.push_back(static_cast<vtkIdType>(kept.size()));
        if (stands->GetValue(i) == i)
        {
          kept.push_back(i);
        }
      }
      if (kept.size() < places.size())
      {
        TakePoints(copy, kept,
          [&](vtkIdType, auto* begin, auto* end)
          {
            for (auto* id = begin; id != end; ++id)
            {
              const bool exists = *id >= 0 && *id < static_cast<vtkIdType>(places.size());
              *id = exists ? static_cast<std::decay_t<decltype(*id)>>(places[*id]) : -1;
            }
          });
        sources[block] = std::move(kept);
      }
      return copy;
    });
}

vtkSmartPointer<vtkPointSet> FollowMergedPoints(vtkPointSet* mesh, vtkDataObject* merged)
{
  std::unordered_map<vtkIdType, vtkIdType> now; // by the ids before
  ChangeMeshes(merged,
    [&](vtkDataObject* object, unsigned int block) -> vtkSmartPointer<vtkDataObject>
    {
      auto* with = vtkPointSet::SafeDownCast(object);
      vtkIdTypeArray* stands = GetMergedPoints(with);
      const vtkIdType size = stands ? stands->GetNumberOfValues() : 0;
      const std::vector<vtkIdType> ids =
        size > 0 ? ReadIdsOf(with->GetPointData(), size) : std::vector<vtkIdType>();
      vtkIdType kept = 0;
      for (const vtkIdType i : InTurn(size))
      {
        const vtkIdType stand = stands->GetValue(i);
        if (!ids.empty() && stand != i)
        {
          now[ids[i]] = ids[stand];
        }
        else if (ids.empty() && block == 0) // blocks need ids
        {
          now[i] = stand == i ? kept++ : now[stand]; // the first of them stands
        }
      }
      return object;
    });
  if (now.empty())
  {
    return mesh;
  }
  std::vector<vtkIdType> ids = ReadIdsOf(mesh->GetPointData(), mesh->GetNumberOfPoints());
  vtkNew<vtkIdTypeArray> followed;
  followed->SetName(MergedPointsName);
  for (const vtkIdType i : InTurn(mesh->GetNumberOfPoints()))
  {
    const vtkIdType id = ids.empty() ? i : ids[i];
    const auto found = now.find(id);
    followed->InsertNextValue(found == now.end() ? id : found->second);
  }
  const auto copy = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
  copy->ShallowCopy(mesh);
  copy->GetPointData()->SetGlobalIds(followed);
  return copy;
}

void AppendSources(const PointSources& sources, vtkDataObject* mesh, MatrixFactors* factors)
{
  const auto kept = sources.find(0);
  auto* points = vtkDataSet::SafeDownCast(mesh);
  if (!factors || kept == sources.end() || !points)
  {
    return;
  }
  const auto size = static_cast<vtkIdType>(kept->second.size());
  MatrixFactors::Matrix choice;
  choice.NumberOfColumns = points->GetNumberOfPoints();
  choice.Offsets = Buffer<long long>(size + 1);
  choice.Columns = Buffer<long long>(size);
  choice.Weights = Buffer<double>(size, 1.);
  ForEach(size + 1, [&](vtkIdType i) { choice.Offsets[i] = i; });
  CopyInThreads(kept->second.data(), size, choice.Columns.data());
  factors->Append(std::move(choice));
}

void RestoreOriginalPoints(vtkDataObject* output, const PointSources& sources)
{
  ChangeMeshes(output,
    [&](vtkDataObject* data, unsigned int block) -> vtkSmartPointer<vtkDataObject>
    {
      auto* mesh = vtkPointSet::SafeDownCast(data);
      auto* ids = mesh
        ? vtkIdTypeArray::SafeDownCast(mesh->GetPointData()->GetArray(OriginalPointIdsName))
        : nullptr;
      const auto of = sources.find(block);
      for (vtkIdType i = 0; ids && of != sources.end() && i < ids->GetNumberOfValues(); ++i)
      {
        const vtkIdType id = ids->GetValue(i);
        const bool exists = id >= 0 && id < static_cast<vtkIdType>(of->second.size());
        ids->SetValue(i, exists ? of->second[static_cast<std::size_t>(id)] : -1);
      }
      return data;
    });
}

}
