// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bezier/ValueRanges.h"

#include "Private/Reading/ReadableMesh.h"

#include "vtkCharArray.h"
#include "vtkDoubleArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{

ValueRanges::ValueRanges(vtkDataObject* data, vtkMultiProcessController* controller)
{
  ChangeMeshes(data,
    [this](vtkDataObject* object, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      auto* mesh = vtkPointSet::SafeDownCast(object);
      if (mesh && mesh->GetPoints())
      {
        this->Add("", mesh->GetPoints()->GetData());
        for (int a = 0; a < mesh->GetPointData()->GetNumberOfArrays(); ++a)
        {
          vtkDataArray* array = mesh->GetPointData()->GetArray(a);
          if (array && array->GetName())
          {
            this->Add(array->GetName(), array);
          }
        }
      }
      return object;
    });
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    this->Join(controller);
  }
}

void ValueRanges::Add(const std::string& name, vtkDataArray* array)
{
  for (int c = 0; c < array->GetNumberOfComponents() && array->GetNumberOfTuples() > 0; ++c)
  {
    double range[2];
    array->GetFiniteRange(range, c);
    this->Extend(name, static_cast<std::size_t>(c), { range[0], range[1] });
  }
}

void ValueRanges::Extend(const std::string& name, std::size_t component, const Range& range)
{
  auto& ranges = this->Arrays[name];
  ranges.resize(std::max(ranges.size(), component + 1), { VTK_DOUBLE_MAX, VTK_DOUBLE_MIN });
  ranges[component] = { std::min(ranges[component].first, range.first),
    std::max(ranges[component].second, range.second) };
}

/// Each rank sends its names, one after the other with a zero behind each, and its numbers: the
/// component, and both ends of its range.
void ValueRanges::Join(vtkMultiProcessController* controller)
{
  vtkNew<vtkCharArray> names;
  vtkNew<vtkDoubleArray> numbers;
  for (const auto& [name, ranges] : this->Arrays)
  {
    for (std::size_t c = 0; c < ranges.size(); ++c)
    {
      for (const char letter : name)
      {
        names->InsertNextValue(letter);
      }
      names->InsertNextValue('\0');
      numbers->InsertNextValue(static_cast<double>(c));
      numbers->InsertNextValue(ranges[c].first);
      numbers->InsertNextValue(ranges[c].second);
    }
  }
  vtkNew<vtkCharArray> allNames;
  vtkNew<vtkDoubleArray> allNumbers;
  controller->AllGatherV(names, allNames);
  controller->AllGatherV(numbers, allNumbers);
  const char* name = allNames->GetPointer(0);
  for (vtkIdType i = 0; i < allNumbers->GetNumberOfValues(); i += 3)
  {
    const std::string text = name;
    name += text.size() + 1;
    this->Extend(text, static_cast<std::size_t>(allNumbers->GetValue(i)),
      { allNumbers->GetValue(i + 1), allNumbers->GetValue(i + 2) });
  }
}

double ValueRanges::GetTolerance(const char* name, double part, bool isSingle) const
{
  const auto ranges = this->Arrays.find(name ? name : "");
  double longest = 0.;
  double squares = 0.;
  double largest = 0.;
  if (ranges != this->Arrays.end())
  {
    for (const auto& [least, most] : ranges->second)
    {
      const double length = std::max(0., most - least);
      longest = std::max(longest, length);
      squares += length * length;
      if (most >= least) // there are values
      {
        largest = std::max({ largest, std::abs(least), std::abs(most) });
      }
    }
  }
  const double rounding = isSingle ? 1e-6 : 1e-12;
  return std::max(part * (name ? longest : std::sqrt(squares)), rounding * largest);
}

}
