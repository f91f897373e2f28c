// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Deformation/RestMesh.h"

#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Uniform/UniformSubdivision.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace subdivision
{
namespace
{

constexpr const char* DeformedName = "DeformedPoints";

// ------------------------------------------------------------------------------------------------
// Equal meshes

bool HasSameCellArray(vtkCellArray* a, vtkCellArray* b)
{
  return a == b ||
    (a && b && HoldsSameValues(a->GetOffsetsArray(), b->GetOffsetsArray()) &&
      HoldsSameValues(a->GetConnectivityArray(), b->GetConnectivityArray()));
}

/// Whether the arrays of the cells are equal. If not, the cells may still be equal.
bool StoresSameCells(vtkPointSet* a, vtkPointSet* b)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(a);
  auto* otherGrid = vtkUnstructuredGrid::SafeDownCast(b);
  if (grid && otherGrid)
  {
    const auto types = GetCellTypes(grid);
    const auto otherTypes = GetCellTypes(otherGrid);
    return (types == otherTypes || (types && otherTypes && HoldsSameValues(types, otherTypes))) &&
      HasSameCellArray(grid->GetCells(), otherGrid->GetCells());
  }
  auto* poly = vtkPolyData::SafeDownCast(a);
  auto* otherPoly = vtkPolyData::SafeDownCast(b);
  return poly && otherPoly && HasSameCellArray(poly->GetVerts(), otherPoly->GetVerts()) &&
    HasSameCellArray(poly->GetLines(), otherPoly->GetLines()) &&
    HasSameCellArray(poly->GetPolys(), otherPoly->GetPolys()) &&
    HasSameCellArray(poly->GetStrips(), otherPoly->GetStrips());
}

bool HasSameArrays(vtkFieldData* a, vtkFieldData* b)
{
  if (a->GetNumberOfArrays() != b->GetNumberOfArrays())
  {
    return false;
  }
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = a->GetArray(i);
    vtkDataArray* other = b->GetArray(i);
    if (!array || !other || array->GetNumberOfComponents() != other->GetNumberOfComponents() ||
      !HoldsSameValues(array, other))
    {
      return false;
    }
  }
  return true;
}

bool IsSameMesh(vtkPointSet* a, vtkPointSet* b)
{
  return HoldsSameValues(a->GetPoints()->GetData(), b->GetPoints()->GetData()) &&
    StoresSameCells(a, b) && HasSameArrays(a->GetPointData(), b->GetPointData()) &&
    HasSameArrays(a->GetCellData(), b->GetCellData()) &&
    HasSameArrays(a->GetFieldData(), b->GetFieldData());
}

// ------------------------------------------------------------------------------------------------
// What is subdivided

/// The mesh with those arrays only that the operators depend on.
vtkSmartPointer<vtkPointSet> MakeControl(vtkPointSet* mesh, const FeatureOptions& features)
{
  auto control = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
  control->CopyStructure(mesh);
  control->GetPointData()->Initialize();
  control->GetCellData()->Initialize();
  if (vtkDataArray* ids = mesh->GetPointData()->GetGlobalIds())
  {
    control->GetPointData()->SetGlobalIds(ids);
  }
  vtkCellData* cells = control->GetCellData();
  cells->AddArray(mesh->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  for (vtkDataArray* array : { features.Singular.Get(), features.Material.Get(),
         features.Part.Get(), features.Rules.Get(), features.Sharpness.Get() })
  {
    cells->AddArray(array);
  }
  vtkFieldData* fields = mesh->GetFieldData();
  vtkNew<vtkFieldData> stamps;
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    const char* name = fields->GetArrayName(i);
    if (name && std::string(name).compare(0, 11, StampName) == 0 && fields->GetArray(i))
    {
      stamps->AddArray(fields->GetArray(i));
    }
  }
  control->SetFieldData(stamps);
  return control;
}

std::vector<double> ListChoices(vtkPointSet* control, const DeformationOptions& options)
{
  const FeatureOptions& features = options.Features;
  const auto encoded = EncodeChoices(features, FeatureValues());
  std::vector<double> choices(encoded.begin(), encoded.end());
  choices.push_back(features.FeatureAngle);
  choices.push_back(options.Levels);
  choices.push_back(static_cast<double>(options.Scheme));
  choices.push_back(static_cast<double>(options.MaximumNumberOfCells));
  for (vtkDataArray* array : { features.Singular.Get(), features.Material.Get(),
         features.Part.Get(), features.Rules.Get(), features.Sharpness.Get() })
  {
    int index = -1;
    if (array)
    {
      control->GetCellData()->GetArray(array->GetName(), index);
    }
    choices.push_back(index);
  }
  return choices;
}

/// Adds the points of the deformed mesh as a point array, so that it is subdivided like the points.
void AddDeformed(vtkPointSet* deformed, vtkPointSet* control)
{
  const vtkIdType size = deformed->GetNumberOfPoints();
  const auto array = MakeArray(VTK_DOUBLE, 3, size);
  array->SetName(DeformedName);
  double* to = static_cast<double*>(array->GetVoidPointer(0));
  ForEach(size, [&](vtkIdType i) { deformed->GetPoints()->GetData()->GetTuple(i, to + 3 * i); });
  control->GetPointData()->AddArray(array);
}

/// The corners of all tetrahedra, or of all other cells as triangles with repeated corners.
Buffer<vtkIdType> GatherCorners(vtkUnstructuredGrid* grid, bool tets)
{
  const vtkIdType cells = grid->GetNumberOfCells();
  auto isWanted = [&](vtkIdType i) { return (grid->GetCellType(i) == VTK_TETRA) == tets; };
  Buffer<vtkIdType> places(cells + 1);
  ForEach(cells, [&](vtkIdType i) { places[i] = isWanted(i) ? 1 : 0; });
  CountsToOffsets(places);
  const vtkIdType corners = tets ? 4 : 3;
  Buffer<vtkIdType> ids(corners * places[cells]);
  auto values = [](vtkDataArray* array)
  { return static_cast<const vtkIdType*>(array->GetVoidPointer(0)); }; // Use32BitIds is off here
  const vtkIdType* connectivity = values(grid->GetCells()->GetConnectivityArray());
  const vtkIdType* offsets = values(grid->GetCells()->GetOffsetsArray());
  ForEach(cells,
    [&](vtkIdType i)
    {
      const vtkIdType begin = offsets[i];
      const vtkIdType size = offsets[i + 1] - begin;
      for (vtkIdType k = 0; k < corners && isWanted(i); ++k)
      {
        ids[corners * places[i] + k] = connectivity[begin + std::min(k, size - 1)];
      }
    });
  return ids;
}

}

std::string CompareCells(vtkPointSet* rest, vtkPointSet* deformed)
{
  auto differ = [](const std::string& what, vtkIdType a, vtkIdType b)
  {
    return "The rest mesh has " + std::to_string(a) + " " + what + ", the deformed mesh " +
      std::to_string(b) + ".";
  };
  if (rest->GetNumberOfPoints() != deformed->GetNumberOfPoints())
  {
    return differ("points", rest->GetNumberOfPoints(), deformed->GetNumberOfPoints());
  }
  if (StoresSameCells(rest, deformed))
  {
    return "";
  }
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIdList> others;
  const vtkIdType both = std::min(rest->GetNumberOfCells(), deformed->GetNumberOfCells());
  for (vtkIdType i = 0; i < both; ++i)
  {
    rest->GetCellPoints(i, ids);
    deformed->GetCellPoints(i, others);
    if (rest->GetCellType(i) != deformed->GetCellType(i) ||
      ids->GetNumberOfIds() != others->GetNumberOfIds() ||
      !std::equal(ids->begin(), ids->end(), others->begin()))
    {
      return "Cell " + std::to_string(i) +
        " is the first that differs between the rest mesh and the deformed mesh.";
    }
  }
  return rest->GetNumberOfCells() == deformed->GetNumberOfCells()
    ? ""
    : differ("cells", rest->GetNumberOfCells(), deformed->GetNumberOfCells());
}

bool RestMesh::Update(vtkPointSet* mesh, const DeformationOptions& options)
{
  const auto control = MakeControl(mesh, options.Features);
  std::vector<double> choices = ListChoices(control, options);
  if (this->Kept && this->Choices == choices && IsSameMesh(this->Kept, control))
  {
    return true;
  }
  this->Clear();
  ++this->NumberOfBuilds;
  if (!this->Build(control, options))
  {
    return false;
  }
  this->Kept.TakeReference(control->NewInstance());
  this->Kept->DeepCopy(control);
  this->Choices = std::move(choices);
  return true;
}

bool RestMesh::IsSingle() const
{
  return this->Kept && this->Kept->GetPoints()->GetDataType() == VTK_FLOAT;
}

void RestMesh::Clear()
{
  const vtkIdType builds = this->NumberOfBuilds;
  *this = RestMesh();
  this->NumberOfBuilds = builds;
}

bool RestMesh::Build(vtkPointSet* control, const DeformationOptions& options)
{
  this->Control = this->Subdivide(control, 0, this->ControlOperators, options, false);
  if (this->Control)
  {
    this->Fine = this->Subdivide(control, options.Levels, this->Operators, options, true);
  }
  if (!this->Fine)
  {
    return false;
  }
  this->NumberOfPoints = this->Fine->GetNumberOfPoints();
  this->Points = static_cast<const double*>(this->Fine->GetPoints()->GetVoidPointer(0));
  if (this->HasCells())
  {
    this->Tets = SimplexTree(this->Points, 4, GatherCorners(this->Fine, true));
  }
  return true;
}

bool RestMesh::HasCells() const
{
  return this->Fine && this->Fine->GetNumberOfCells() > 0;
}

const SimplexTree& RestMesh::GetOtherCells()
{
  if (!this->HasOtherCells && this->HasCells())
  {
    this->OtherCells = SimplexTree(this->Points, 3, GatherCorners(this->Fine, false));
    this->HasOtherCells = true;
  }
  return this->OtherCells;
}

/// Returns null after an error.
vtkSmartPointer<vtkUnstructuredGrid> RestMesh::Subdivide(vtkPointSet* control, int levels,
  OperatorCache& cache, const DeformationOptions& options, bool isFirst) const
{
  UniformOptions uniform;
  static_cast<RunOptions&>(uniform) = options;
  uniform.OutputPointsPrecision = vtkAlgorithm::DOUBLE_PRECISION;
  uniform.InterpolateIntegers = false;
  uniform.GenerateOriginalIds = levels == 0;
  uniform.Levels = levels;
  uniform.Scheme = options.Scheme;
  uniform.Cache = &cache;
  uniform.Progress = nullptr;
  uniform.Warn = [&](const std::string& message)
  {
    if (isFirst)
    {
      options.Warn("Rest mesh: " + message);
    }
  };
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const bool done = SubdivideUniformly(control, uniform, grid);
  cache.ForgetUnused();
  return done ? grid : nullptr;
}

vtkSmartPointer<vtkDataArray> RestMesh::MoveControlPoints(
  vtkPointSet* rest, vtkPointSet* deformed, const DeformationOptions& options)
{
  const auto control = MakeControl(rest, options.Features);
  AddDeformed(deformed, control);
  const auto moved = this->Subdivide(control, 0, this->ControlOperators, options, false);
  return moved ? moved->GetPointData()->GetArray(DeformedName) : nullptr;
}

const double* RestMesh::MovePoints(vtkDataArray* control)
{
  const auto* values = static_cast<const double*>(control->GetVoidPointer(0));
  const KeptSteps* steps = this->Operators.GetFirstSteps();
  if (!steps)
  {
    return values;
  }
  steps->Apply(values, 3, this->MovedPoints);
  return this->MovedPoints.data();
}

void RestMesh::WarnOfInvertedCells(vtkDataArray* control, const DeformationOptions& options) const
{
  const auto* rest = static_cast<const double*>(this->Control->GetPoints()->GetVoidPointer(0));
  const auto* moved = control ? static_cast<const double*>(control->GetVoidPointer(0)) : nullptr;
  const auto* parents =
    vtkIdTypeArray::SafeDownCast(this->Control->GetCellData()->GetArray(OriginalCellIdsName));
  vtkNew<vtkIdList> ids;
  std::vector<vtkIdType> found;
  for (vtkIdType i = 0; i < this->Control->GetNumberOfCells(); ++i)
  {
    if (this->Control->GetCellType(i) != VTK_TETRA)
    {
      continue;
    }
    this->Control->GetCellPoints(i, ids);
    auto orient = [&](const double* points)
    {
      const double* corners[4];
      for (int k = 0; k < 4; ++k)
      {
        corners[k] = points + 3 * ids->GetId(k);
      }
      return GetOrientationOfTet(corners);
    };
    const int before = orient(rest);
    const bool isWrong = moved ? before != 0 && orient(moved) != before : before <= 0;
    const vtkIdType cell = parents ? parents->GetValue(i) : i;
    if (isWrong && (found.empty() || found.back() != cell)) // pieces of a cell are consecutive
    {
      found.push_back(cell);
    }
  }
  if (!found.empty())
  {
    const std::string which =
      std::to_string(found.size()) + " of its cells, the first is cell " + std::to_string(found[0]);
    options.Warn(moved ? "The deformed mesh turns inside out, or makes flat, " + which +
          ": the deformation folds there. Move the control points back a little."
                       : "The rest mesh has inverted or flat cells (" + which +
          "): points there may be found in another cell. Repair these cells.");
  }
}

std::size_t RestMesh::GetOperatorSize() const
{
  const KeptSteps* steps = this->Operators.GetFirstSteps();
  return steps ? steps->GetMemorySize() : 0;
}

SparseRows<int> RestMesh::Compose(const SparseRows<int>& rows) const
{
  return this->Operators.GetFirstSteps()->ComposeWith(rows);
}

}
