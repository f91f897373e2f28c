// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/Stamp.h"

#include "Private/ArrayNames.h"
#include "Private/Reading/CellReader.h"
#include "Private/Run/StampFields.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// The numbers of a stamp.
enum StampNumber
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
  NumberOfNumbers
};

constexpr StampFormat Format{ StampName, 1, NumberOfNumbers, Levels, ControlPoints, Points, Cells };

/// A hash of types and connectivity of up to 4096 evenly spaced cells. It has 48 bits, so that a
/// double holds it exactly.
long long HashCells(vtkPointSet* mesh)
{
  constexpr vtkIdType samples = 4096;
  const CellReader reader(mesh);
  const vtkIdType cells = reader.GetNumberOfCells();
  const vtkIdType taken = std::min(cells, samples);
  unsigned long long hash = 14695981039346656037ull;
  auto mix = [&hash](vtkIdType value)
  {
    hash ^= static_cast<unsigned long long>(value);
    hash *= 1099511628211ull;
  };
  std::vector<vtkIdType> scratch;
  for (vtkIdType i = 0; i < taken; ++i)
  {
    const vtkIdType cell = taken < samples ? i : i * cells / samples; // a constant: no division
    const CellIds ids = reader.GetCell(cell, scratch);
    mix(reader.GetGridType(cell, ids.Size));
    std::for_each(ids.Ids, ids.Ids + ids.Size, mix);
  }
  return static_cast<long long>(hash >> 16);
}

}

bool ReadStamp(vtkPointSet* input, StampScheme scheme, Stamp& stamp)
{
  if (!vtkUnstructuredGrid::SafeDownCast(input))
  {
    return false;
  }
  const std::vector<vtkIdType> numbers = ReadStampNumbers(input, Format);
  const bool isUniform = scheme != StampScheme::RedGreen;
  if (numbers.empty() || numbers[Scheme] != static_cast<int>(scheme) ||
    (isUniform && (numbers[TetOrderIsFinal] != 1 || numbers[Projected] != 0)) ||
    numbers[Hash] != HashCells(input))
  {
    return false;
  }
  stamp.Scheme = scheme;
  stamp.TetOrderIsFinal = numbers[TetOrderIsFinal] == 1;
  stamp.Levels = static_cast<int>(numbers[Levels]);
  stamp.NumberOfControlPoints = numbers[ControlPoints];
  return true;
}

bool ReadPartStamp(vtkPointSet* part, Stamp& stamp)
{
  const std::vector<vtkIdType> numbers = ReadFieldIds(Format.Name, part->GetFieldData());
  if (numbers.size() != NumberOfNumbers || numbers[Version] != Format.Version ||
    numbers[Levels] < 0 || numbers[Levels] > MostStampedLevels || numbers[ControlPoints] < 0)
  {
    return false;
  }
  stamp.Scheme = static_cast<StampScheme>(numbers[Scheme]);
  stamp.IsProjected = numbers[Projected] != 0;
  stamp.TetOrderIsFinal = numbers[TetOrderIsFinal] != 0;
  if (stamp.Scheme != StampScheme::RedGreen && (stamp.IsProjected || !stamp.TetOrderIsFinal))
  {
    return false;
  }
  stamp.Levels = static_cast<int>(numbers[Levels]);
  stamp.NumberOfControlPoints = numbers[ControlPoints];
  stamp.NumberOfPoints = numbers[Points];
  stamp.NumberOfCells = numbers[Cells];
  return true;
}

void WriteStamp(const Stamp& stamp, vtkPointSet* output)
{
  const bool isWhole = stamp.NumberOfPoints == 0;
  const std::vector<vtkIdType> numbers{ Format.Version, static_cast<int>(stamp.Scheme),
    stamp.Levels, stamp.Levels % 2, stamp.TetOrderIsFinal, stamp.NumberOfControlPoints,
    isWhole ? output->GetNumberOfPoints() : stamp.NumberOfPoints,
    isWhole ? output->GetNumberOfCells() : stamp.NumberOfCells, HashCells(output),
    stamp.IsProjected };
  output->GetFieldData()->AddArray(MakeField<vtkTypeInt64Array>(Format.Name, numbers));
}

void ReadSingularTuples(vtkPointSet* input, SharpTuples& tuples)
{
  const vtkIdType points = input->GetNumberOfPoints();
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    std::vector<vtkIdType>& ids = tuples.Tuples.Tuples[dimension];
    ids = ReadFieldIds(SingularNames[dimension], input->GetFieldData(), dimension + 1);
    if (std::any_of(
          ids.begin(), ids.end(), [points](vtkIdType id) { return id < 0 || id >= points; }))
    {
      ids.clear();
    }
    if (dimension > 0)
    {
      std::vector<double>& sharpness = tuples.Sharpness[dimension];
      sharpness = ReadFieldValues(SharpnessNames[dimension], input->GetFieldData());
      if ((dimension + 1) * sharpness.size() != ids.size())
      {
        sharpness.clear();
      }
    }
  }
}

void WriteStampedIds(const StampedIds& ids, vtkPointSet* output)
{
  vtkFieldData* data = output->GetFieldData();
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    WriteField<vtkIdTypeArray>(
      SingularNames[dimension], ids.Singular.Tuples.Tuples[dimension], data, dimension + 1);
    if (dimension > 0)
    {
      WriteField<vtkDoubleArray>(
        SharpnessNames[dimension], ids.Singular.Sharpness[dimension], data);
    }
  }
  WriteField<vtkIdTypeArray>(GlobalIdsName, ids.Global, data);
  WriteField<vtkIdTypeArray>(InvertedCellsName, ids.Inverted, data);
  WriteField<vtkIdTypeArray>(FirstInvertedName, ids.FirstInverted, data);
  WriteField<vtkIdTypeArray>(InterpolatedName, ids.Interpolated, data);
}

vtkIdType CountCornersOfPolygon(vtkIdType first, vtkIdType quads, int levels,
  const std::function<vtkIdType(vtkIdType, int)>& vertexOf)
{
  // Corner c of a quad is the first one of its child c, and then of the first child of that.
  const vtkIdType ofCorner = vtkIdType(1) << (2 * (levels - 1));
  const auto centreOf = [&](vtkIdType quad)
  { return levels == 1 ? vertexOf(quad, 2) : vertexOf(quad + ofCorner / 2, 0); };
  vtkIdType corners = 0;
  for (vtkIdType quad = first; quad + ofCorner <= quads && centreOf(quad) == centreOf(first);
    quad += ofCorner)
  {
    ++corners;
  }
  return corners;
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
