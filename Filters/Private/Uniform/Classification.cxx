// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/Classification.h"

#include "Private/Arrays/Arrays.h"
#include "Private/Uniform/UniformRun.h"

#include "vtkCellData.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace subdivision
{

void AddRules(
  const std::function<Stratum(vtkIdType)>& ofPoint, vtkPointSet* input, vtkPointSet* output)
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
      const Stratum stratum = ofPoint(i);
      const bool regular = stratum.GetRule() == Rule::RegularEdge;
      rules->SetValue(i, static_cast<unsigned char>(regular ? Rule::Solid : stratum.GetRule()));
      types->SetValue(i, static_cast<unsigned char>(stratum.GetType()));
    });
  AddInstead(input->GetPointData(), rules, output->GetPointData());
  AddInstead(input->GetPointData(), types, output->GetPointData());
}

/// Adds both arrays of points. `vertices` and `edges` are the strata of the level before, whose
/// edges have the new points.
void UniformRun::AddClassification(const Buffer<Stratum>& vertices, const Buffer<Stratum>& edges)
{
  if (this->Options.GenerateClassification)
  {
    AddRules(
      [&](vtkIdType i)
      {
        const vtkIdType edge = i - vertices.size();
        return edge < 0         ? vertices[i]
          : edge < edges.size() ? edges[edge]
                                : Stratum(Rule::Solid); // the centre of an octahedron
      },
      this->Input, this->Output);
  }
}

void TellInverted(const InvertedCells& found, vtkIdType cells, const RunOptions& options)
{
  const std::string text = std::to_string(found.Count) + " of " + std::to_string(cells) +
    " cells are solids that smoothing turned inside out, the first is cell " +
    std::to_string(found.First) +
    ": the control mesh is too thin there. Make its solids less flat, or take fewer levels; "
    "GenerateClassification marks these cells (Inverted).";
  if (found.Count > cells / 100000)
  {
    options.Warn(text);
  }
  else if (found.Count > 0) // so few are information: no window opens for it
  {
    vtkLogF(INFO, "%s", text.c_str());
  }
}

void AddToCells(const char* name, const std::vector<unsigned char>& values, vtkPointSet* input,
  vtkPointSet* output)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  AddInstead(input->GetCellData(), array, output->GetCellData());
}

}
