// SPDX-License-Identifier: BSD-3-Clause
#include "JoinedArrays.h"
#include "Messages.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkVariant.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace subdivide
{
namespace
{

constexpr int Associations[] = { vtkDataObject::POINT, vtkDataObject::CELL };

bool IsLike(vtkAbstractArray* a, vtkAbstractArray* b)
{
  return a->GetName() && b->GetName() && std::string(a->GetName()) == b->GetName() &&
    a->GetDataType() == b->GetDataType() &&
    a->GetNumberOfComponents() == b->GetNumberOfComponents();
}

vtkSmartPointer<vtkAbstractArray> MakeEmpty(vtkAbstractArray* like, vtkIdType size)
{
  auto made =
    vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(like->GetDataType()));
  made->SetNumberOfComponents(like->GetNumberOfComponents());
  made->SetNumberOfTuples(size);
  if (auto* numbers = vtkDataArray::SafeDownCast(made))
  {
    numbers->Fill(0.);
  }
  return made;
}

/// The values of a field array as one text, to compare them.
std::string TextOf(vtkAbstractArray* array)
{
  std::string text;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    text += array->GetVariantValue(i).ToString() + "\n";
  }
  return text;
}

/// What a filter says about its run, for the next filter, is not true of blocks that are joined.
bool IsOfRun(const char* name)
{
  return name && std::string(name).rfind("Subdivision", 0) == 0;
}

/// Adds arrays of new names; `lost` are the names of arrays with other values.
void AddFields(vtkFieldData* from, vtkFieldData* to, std::set<std::string>& lost)
{
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    vtkAbstractArray* first = array->GetName() ? to->GetAbstractArray(array->GetName()) : nullptr;
    if (IsOfRun(array->GetName()))
    {
      continue;
    }
    if (!first)
    {
      to->AddArray(array);
    }
    else if (!IsLike(first, array) || TextOf(first) != TextOf(array))
    {
      lost.insert(array->GetName());
    }
  }
}

}

JoinedArrays::JoinedArrays(const std::vector<vtkSmartPointer<vtkDataSet>>& sets)
{
  // Those who append pass over data sets without points, with their arrays.
  std::copy_if(sets.begin(), sets.end(), std::back_inserter(this->Sets),
    [](vtkDataSet* set) { return set->GetNumberOfPoints() > 0; });
  for (vtkDataSet* set : this->Sets)
  {
    for (int association : Associations)
    {
      this->Collect(set, association);
    }
  }
}

void JoinedArrays::Collect(vtkDataSet* set, int association)
{
  std::vector<Entry>& entries = this->Entries[association];
  vtkDataSetAttributes* data = set->GetAttributes(association);
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = data->GetAbstractArray(a);
    if (!array->GetName() ||
      std::any_of(entries.begin(), entries.end(),
        [&](const Entry& entry) { return IsLike(entry.Like, array); }))
    {
      continue;
    }
    std::string name = array->GetName();
    while (std::any_of(
      entries.begin(), entries.end(), [&](const Entry& entry) { return entry.Name == name; }))
    {
      name += "'";
    }
    entries.push_back({ name, array });
  }
}

vtkAbstractArray* JoinedArrays::Find(vtkDataSet* set, int association, const Entry& entry)
{
  vtkAbstractArray* array =
    set->GetAttributes(association)->GetAbstractArray(entry.Like->GetName());
  return array && IsLike(array, entry.Like) ? array : nullptr;
}

vtkSmartPointer<vtkDataSet> JoinedArrays::Complete(vtkDataSet* set) const
{
  auto copy = vtkSmartPointer<vtkDataSet>::Take(set->NewInstance());
  copy->CopyStructure(set);
  for (int association : Associations)
  {
    for (const Entry& entry : this->Entries[association])
    {
      vtkAbstractArray* array = Find(set, association, entry);
      vtkSmartPointer<vtkAbstractArray> own = array;
      if (!array || entry.Name != array->GetName())
      {
        own = MakeEmpty(entry.Like, set->GetNumberOfElements(association));
        own->SetName(entry.Name.c_str());
      }
      if (array && own != array)
      {
        own->DeepCopy(array);
        own->SetName(entry.Name.c_str());
      }
      copy->GetAttributes(association)->AddArray(own);
    }
  }
  return copy;
}

void JoinedArrays::Finish(vtkDataSet* joined) const
{
  std::set<std::string> lost;
  for (vtkDataSet* set : this->Sets)
  {
    for (int association : Associations)
    {
      vtkDataSetAttributes* data = joined->GetAttributes(association);
      for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
      {
        vtkAbstractArray* active = set->GetAttributes(association)->GetAbstractAttribute(type);
        for (const Entry& entry : this->Entries[association])
        {
          if (active && IsLike(active, entry.Like) && !data->GetAbstractAttribute(type))
          {
            data->SetActiveAttribute(entry.Name.c_str(), type);
          }
        }
      }
    }
    AddFields(set->GetFieldData(), joined->GetFieldData(), lost);
  }
  for (const std::string& name : lost)
  {
    Tell("warning",
      "blocks have different field arrays \"" + name +
        "\", and the file takes that of the first block; .vtm files keep all");
  }
}

}
