// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/Stamp.h"

#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"

#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace subdivision
{
namespace
{

constexpr int FormatVersion = 1;

enum Field
{
  Version,
  Scheme,
  Levels,
  Parity,
  TetOrderIsFinal,
  ControlPoints,
  Points,
  Cells,
  Hash,
  Projected,
  NumberOfFields
};

/// A hash of types and connectivity of up to 4096 evenly spaced cells. It has 48 bits, so that a
/// double holds it exactly.
long long HashCells(vtkPointSet* mesh)
{
  constexpr vtkIdType samples = 4096;
  const vtkIdType cells = mesh->GetNumberOfCells();
  const vtkIdType taken = std::min(cells, samples);
  unsigned long long hash = 14695981039346656037ull;
  auto mix = [&hash](vtkIdType value)
  {
    hash ^= static_cast<unsigned long long>(value);
    hash *= 1099511628211ull;
  };
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < taken; ++i)
  {
    const vtkIdType cell = taken < samples ? i : i * cells / taken;
    mesh->GetCellPoints(cell, ids);
    mix(mesh->GetCellType(cell));
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      mix(ids->GetId(k));
    }
  }
  return static_cast<long long>(hash >> 16);
}

}

bool ReadStamp(vtkPointSet* input, StampScheme scheme, Stamp& stamp)
{
  vtkDataArray* array = input->GetFieldData()->GetArray(StampName);
  if (!vtkUnstructuredGrid::SafeDownCast(input) || !array || array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != NumberOfFields)
  {
    return false;
  }
  auto get = [array](Field field) { return ToId(array->GetComponent(field, 0)); };
  const bool isUniform = scheme != StampScheme::RedGreen;
  if (get(Version) != FormatVersion || get(Scheme) != static_cast<int>(scheme) ||
    (isUniform && (get(TetOrderIsFinal) != 1 || get(Projected) != 0)) ||
    get(Points) != input->GetNumberOfPoints() || get(Cells) != input->GetNumberOfCells() ||
    get(Hash) != HashCells(input) || get(Levels) < 0 || get(Levels) > 20 ||
    get(ControlPoints) < 0 || get(ControlPoints) > get(Points))
  {
    return false;
  }
  stamp.Scheme = scheme;
  stamp.TetOrderIsFinal = get(TetOrderIsFinal) == 1;
  stamp.Levels = static_cast<int>(get(Levels));
  stamp.NumberOfControlPoints = get(ControlPoints);
  return true;
}

void WriteStamp(const Stamp& stamp, vtkUnstructuredGrid* output)
{
  vtkNew<vtkTypeInt64Array> array;
  array->SetName(StampName);
  array->SetNumberOfTuples(NumberOfFields);
  const vtkIdType values[NumberOfFields] = { FormatVersion, static_cast<int>(stamp.Scheme),
    stamp.Levels, stamp.Levels % 2, stamp.TetOrderIsFinal, stamp.NumberOfControlPoints,
    output->GetNumberOfPoints(), output->GetNumberOfCells(), HashCells(output), stamp.IsProjected };
  for (int i = 0; i < NumberOfFields; ++i)
  {
    array->SetValue(i, values[i]);
  }
  output->GetFieldData()->AddArray(array);
}

namespace
{
constexpr const char* SingularNames[3] = { "SubdivisionSingularVertices",
  "SubdivisionSingularLines", "SubdivisionSingularTriangles" };
}

void ReadSingularTuples(vtkPointSet* input, SimplexTuples& tuples)
{
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    std::vector<vtkIdType>& ids = tuples.Tuples[dimension];
    ids.clear();
    vtkDataArray* array = input->GetFieldData()->GetArray(SingularNames[dimension]);
    if (!array || array->GetNumberOfComponents() != dimension + 1)
    {
      continue;
    }
    ids.resize(array->GetNumberOfValues());
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c <= dimension; ++c)
      {
        ids[i * (dimension + 1) + c] = ToId(array->GetComponent(i, c));
      }
    }
    const vtkIdType points = input->GetNumberOfPoints();
    if (std::any_of(
          ids.begin(), ids.end(), [points](vtkIdType id) { return id < 0 || id >= points; }))
    {
      ids.clear();
    }
  }
}

void WriteSingularTuples(const SimplexTuples& tuples, vtkUnstructuredGrid* output)
{
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    const std::vector<vtkIdType>& ids = tuples.Tuples[dimension];
    output->GetFieldData()->RemoveArray(SingularNames[dimension]);
    if (!ids.empty())
    {
      vtkNew<vtkIdTypeArray> array;
      array->SetName(SingularNames[dimension]);
      array->SetNumberOfComponents(dimension + 1);
      array->SetNumberOfTuples(static_cast<vtkIdType>(ids.size()) / (dimension + 1));
      std::copy(ids.begin(), ids.end(), array->GetPointer(0));
      output->GetFieldData()->AddArray(array);
    }
  }
}

void WriteIds(const char* name, const std::vector<vtkIdType>& ids, vtkUnstructuredGrid* output)
{
  output->GetFieldData()->RemoveArray(name);
  if (!ids.empty())
  {
    vtkNew<vtkIdTypeArray> array;
    array->SetName(name);
    array->SetNumberOfTuples(static_cast<vtkIdType>(ids.size()));
    std::copy(ids.begin(), ids.end(), array->GetPointer(0));
    output->GetFieldData()->AddArray(array);
  }
}

bool FindControlMesh(const SimplexView& descendants, const Stamp& stamp, SimplexList& control)
{
  control = SimplexList();
  control.NumberOfPoints = stamp.NumberOfControlPoints;
  const vtkIdType size = descendants.NumberOfSimplices;
  vtkIdType entry = 0;
  for (vtkIdType i = 0; i < size;)
  {
    const int dimension = descendants.Dimensions[i];
    const vtkIdType children = vtkIdType(1) << (dimension * stamp.Levels);
    if (children > size - i ||
      std::any_of(descendants.Dimensions + i, descendants.Dimensions + i + children,
        [dimension](unsigned char d) { return d != dimension; }))
    {
      return false;
    }
    control.Dimensions.push_back(static_cast<unsigned char>(dimension));
    // Corner c of a simplex is corner c of its child c, which is corner c of child c of that child,
    // and so on.
    const vtkIdType others = dimension == 0 ? 0 : (children - 1) / ((1 << dimension) - 1);
    for (int corner = 0; corner <= dimension; ++corner)
    {
      const vtkIdType child = corner * others;
      const vtkIdType point = descendants.Connectivity[entry + child * (dimension + 1) + corner];
      if (point >= stamp.NumberOfControlPoints)
      {
        return false;
      }
      control.Connectivity.push_back(point);
    }
    i += children;
    entry += children * (dimension + 1);
  }
  return true;
}

}
