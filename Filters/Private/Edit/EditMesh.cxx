// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Edit/EditMesh.h"

#include "Core/Operators/ApplyRows.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Edit/EditWeights.h"
#include "Private/Edit/LocalFrames.h"

#include "vtkCellData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace subdivision
{
namespace
{

/// The transform as a matrix of 3 rows of 4 numbers.
void FindTransform(const EditOptions& options, double matrix[12])
{
  vtkNew<vtkTransform> transform;
  transform->Translate(options.Translation);
  transform->Translate(options.Centre);
  transform->RotateZ(options.Rotation[2]);
  transform->RotateX(options.Rotation[0]);
  transform->RotateY(options.Rotation[1]);
  transform->Scale(options.Scale);
  transform->Translate(-options.Centre[0], -options.Centre[1], -options.Centre[2]);
  std::copy_n(transform->GetMatrix()->GetData(), 12, matrix);
}

void Multiply(const double* matrix, const double* in, double* out)
{
  for (int row = 0; row < 3; ++row)
  {
    out[row] = vtkMath::Dot(matrix + 3 * row, in);
  }
}

/// Displacements by the transform, of weight 1.
Buffer<double> FindDisplacements(vtkPointSet* base, const EditOptions& options)
{
  double matrix[12];
  FindTransform(options, matrix);
  vtkDataArray* points = base->GetPoints()->GetData();
  Buffer<double> moves(3 * base->GetNumberOfPoints());
  ForEach(base->GetNumberOfPoints(),
    [&](vtkIdType i)
    {
      double x[3];
      points->GetTuple(i, x);
      for (int row = 0; row < 3; ++row)
      {
        moves[3 * i + row] = vtkMath::Dot(matrix + 4 * row, x) + matrix[4 * row + 3] - x[row];
      }
    });
  return moves;
}

/// Multiplies displacements of the mesh at rest by the local maps to the input. Returns false after
/// an error.
bool FollowFrames(const EditedMesh& mesh, const EditOptions& options, Buffer<double>& moves)
{
  const bool fromArrays = HasFrameArrays(mesh.Rest) && HasFrameArrays(mesh.Readable);
  const FramedMesh rest(mesh.Rest, fromArrays, options);
  const FramedMesh moved(mesh.Readable, fromArrays, options);
  if (!rest.IsUsable() || !moved.IsUsable())
  {
    return false;
  }
  const Buffer<double> maps = FindLocalMaps(mesh.Rest, rest, moved);
  ForEach(moves.size() / 3,
    [&](vtkIdType i)
    {
      double turned[3];
      Multiply(maps.data() + 9 * i, moves.data() + 3 * i, turned);
      std::copy_n(turned, 3, moves.data() + 3 * i);
    });
  return true;
}

/// Displacements along the axes of each point, in multiples of a length. Returns false after an
/// error.
bool MoveAlongFrames(
  const EditedMesh& mesh, const EditOptions& options, double unit, Buffer<double>& moves)
{
  const FramedMesh framed(mesh.Readable, HasFrameArrays(mesh.Readable), options);
  if (!framed.IsUsable())
  {
    return false;
  }
  moves = Buffer<double>(3 * mesh.Readable->GetNumberOfPoints());
  ForEach(moves.size() / 3,
    [&](vtkIdType i)
    {
      double axes[9];
      framed.FindAxes(i, axes);
      for (int c = 0; c < 3; ++c)
      {
        moves[3 * i + c] = unit *
          (options.Translation[0] * axes[c] + options.Translation[1] * axes[3 + c] +
            options.Translation[2] * axes[6 + c]);
      }
    });
  return true;
}

void RemoveNormals(vtkDataSetAttributes* data)
{
  int indices[vtkDataSetAttributes::NUM_ATTRIBUTES];
  data->GetAttributeIndices(indices);
  if (indices[vtkDataSetAttributes::NORMALS] >= 0)
  {
    data->RemoveArray(indices[vtkDataSetAttributes::NORMALS]);
  }
}

/// Whether an array of a type of floating point numbers can hold a number.
bool CanHold(int type, double value)
{
  constexpr double mostOfFloats = std::numeric_limits<float>::max();
  return std::abs(value) <= (type == VTK_FLOAT ? mostOfFloats : std::numeric_limits<double>::max());
}

/// Adds the weighted displacements to the points. Returns false after an error.
bool Move(vtkPointSet* input, const Buffer<double>& moves, const Buffer<double>& weights,
  const EditOptions& options, vtkPointSet* output)
{
  vtkDataArray* from = input->GetPoints()->GetData();
  const int type = from->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE;
  Buffer<double> values(moves.size());
  ForEach(weights.size(),
    [&](vtkIdType i)
    {
      double* x = values.data() + 3 * i;
      from->GetTuple(i, x);
      for (int c = 0; weights[i] > 0. && c < 3; ++c)
      {
        x[c] += weights[i] * moves[3 * i + c];
      }
    });
  for (const vtkIdType i : InTurn(values.size()))
  {
    if (!CanHold(type, values[i]) && std::isfinite(from->GetComponent(i / 3, i % 3)))
    {
      options.Fail("Point " + std::to_string(i / 3) +
        " would move farther than its coordinates can hold: the output is the input. Set "
        "Translation, Scale and Centre to smaller numbers.");
      return false;
    }
  }
  const auto to = MakeArray(type, 3, weights.size());
  StoreDoubles(values.data(), to->GetVoidPointer(0), type, values.size());
  CopyLooks(from, to);
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  points->SetData(to);
  output->SetPoints(points);
  RemoveNormals(output->GetPointData());
  RemoveNormals(output->GetCellData());
  for (const char* name : { LimitNormalsName, LimitTangentNames[0], LimitTangentNames[1] })
  {
    output->GetPointData()->RemoveArray(name);
  }
  return true;
}

/// The array that is painted: a copy, or a new one with zeros; null, after a warning, if it has no
/// numbers.
vtkSmartPointer<vtkDataArray> StartPainted(
  vtkDataSetAttributes* data, const std::string& name, vtkIdType size, const EditOptions& options)
{
  vtkAbstractArray* found = data->GetAbstractArray(name.c_str());
  auto* numbers = vtkDataArray::SafeDownCast(found);
  if (found && (!numbers || numbers->GetNumberOfTuples() != size))
  {
    options.Warn("The array \"" + name +
      "\" cannot be painted: it has no numbers, or not one tuple for each point or cell. Name "
      "another one.");
    return nullptr;
  }
  vtkSmartPointer<vtkDataArray> painted;
  if (numbers)
  {
    painted.TakeReference(numbers->NewInstance());
    painted->DeepCopy(numbers);
    return painted;
  }
  painted = MakeArray(options.AddsIds ? VTK_INT : VTK_DOUBLE, 1, size);
  painted->SetName(name.c_str());
  painted->Fill(0.);
  return painted;
}

/// What is painted of points or cells: integers where it is chosen, others by weights.
struct PaintedParts
{
  Buffer<unsigned char> AreChosen;
  Buffer<double> Weights; ///< 1 where it is chosen
};

/// Paints one array. Returns false after an error.
bool PaintArray(const std::string& name, const PaintedParts& parts, const EditOptions& options,
  vtkDataSetAttributes* data)
{
  const auto array = StartPainted(data, name, parts.Weights.size(), options);
  if (!array)
  {
    return true;
  }
  const bool blends = array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT;
  const double value = blends ? options.PaintedValue : std::round(options.PaintedValue);
  if (blends ? !CanHold(array->GetDataType(), value)
             : !(value >= array->GetDataTypeMin() && value <= array->GetDataTypeMax()))
  {
    options.Fail("PaintedValue is beyond the range of the array \"" + name +
      "\": the output is the input. Set it to a smaller number.");
    return false;
  }
  if (value != options.PaintedValue)
  {
    options.Warn("The array \"" + name +
      "\" has integers: PaintedValue is rounded. Set it to a whole number, or paint an array of "
      "floating point numbers.");
  }
  const int components = array->GetNumberOfComponents();
  for (const vtkIdType i : InTurn(parts.Weights.size()))
  {
    const double weight = blends ? parts.Weights[i] : parts.AreChosen[i];
    for (int c = 0; weight > 0. && c < components; ++c)
    {
      const double before = weight < 1. ? array->GetComponent(i, c) : value;
      array->SetComponent(i, c, (1. - weight) * before + weight * value);
    }
  }
  data->AddArray(array); // in the place of an array of this name, active as it was
  return true;
}

/// Paints all arrays. Returns false after an error.
bool Paint(
  const EditedMesh& mesh, PaintedParts ofPoints, const EditOptions& options, vtkPointSet* output)
{
  PaintedParts parts;
  vtkDataSetAttributes* data = output->GetPointData();
  if (options.PaintsCells)
  {
    parts.AreChosen = FindEditedCells(mesh.GetBase(), mesh.Selected, ofPoints.AreChosen);
    parts.Weights =
      FindCellWeights(mesh.GetBase(), parts.AreChosen, ofPoints.Weights, options.FalloffRadius);
    data = output->GetCellData();
  }
  else
  {
    parts = std::move(ofPoints);
  }
  return std::all_of(options.PaintedArrays.begin(), options.PaintedArrays.end(),
    [&](const std::string& name) { return PaintArray(name, parts, options, data); });
}

/// Whether the mesh at rest has as many points and cells.
bool Fits(const EditedMesh& mesh, const EditOptions& options)
{
  const bool fits = !mesh.Rest ||
    (mesh.Rest->GetNumberOfPoints() == mesh.Readable->GetNumberOfPoints() &&
      mesh.Rest->GetNumberOfCells() == mesh.Readable->GetNumberOfCells());
  if (!fits)
  {
    options.Fail("The mesh at rest has " + std::to_string(mesh.Rest->GetNumberOfPoints()) +
      " points and " + std::to_string(mesh.Rest->GetNumberOfCells()) + " cells, the input " +
      std::to_string(mesh.Readable->GetNumberOfPoints()) + " and " +
      std::to_string(mesh.Readable->GetNumberOfCells()) +
      ": the output is the input. Connect what the input was before its control mesh was moved.");
  }
  return fits;
}

}

bool EditOptions::MovesPoints() const
{
  const auto are = [](const double(&values)[3], double value)
  { return values[0] == value && values[1] == value && values[2] == value; };
  const bool turns = !are(this->Rotation, 0.) || !are(this->Scale, 1.);
  return !are(this->Translation, 0.) || turns;
}

bool EditMesh(
  vtkPointSet* input, const EditedMesh& mesh, const EditOptions& options, vtkPointSet* output)
{
  output->ShallowCopy(input);
  if (!input->GetPoints() || input->GetNumberOfPoints() == 0)
  {
    return true;
  }
  if (!Fits(mesh, options))
  {
    return false;
  }
  vtkPointSet* base = mesh.GetBase();
  auto points = FindEditedPoints(base, mesh.Selected);
  const bool isAlone = options.IsLocal && !mesh.Rest;
  const double unit = isAlone ? FindMeanLength(base, points) : 1.;
  auto weights = FindWeights(base, points, unit * options.FalloffRadius, options);
  if (options.Progress && options.Progress(0.3))
  {
    return false;
  }
  if (options.MovesPoints())
  {
    Buffer<double> moves;
    const bool areFound = isAlone ? MoveAlongFrames(mesh, options, unit, moves)
                                  : (moves = FindDisplacements(base, options), !options.IsLocal) ||
        FollowFrames(mesh, options, moves);
    if (!areFound)
    {
      return false;
    }
    if (!Move(input, moves, weights, options, output))
    {
      return false;
    }
  }
  return Paint(mesh, { std::move(points), std::move(weights) }, options, output);
}

}
