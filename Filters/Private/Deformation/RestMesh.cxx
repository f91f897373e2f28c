// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Deformation/RestMesh.h"

#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/PointArrays.h"
#include "Private/Places/PlaceOutput.h"
#include "Private/Reading/CellReader.h"
#include "Private/Reading/CellsToSimplices.h"
#include "Private/Reading/SolidOrientation.h"
#include "Private/Surface/SurfaceInput.h"
#include "Private/Surface/SurfaceSubdivision.h"
#include "Private/Uniform/OperatorCache.h"
#include "Private/Uniform/UniformSubdivision.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <limits>

namespace subdivision
{
namespace
{

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
// The mesh that is subdivided

/// The mesh, only with arrays on which the operators depend.
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
  if (vtkDataArray* degrees = mesh->GetCellData()->GetHigherOrderDegrees())
  {
    cells->SetHigherOrderDegrees(degrees);
  }
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
    if (BelongsToStamp(name) && fields->GetArray(i))
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
  choices.push_back(options.KeepsCellTypes ? 1. : 0.);
  choices.push_back(static_cast<double>(options.SurfaceScheme));
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

/// The corners of all tetrahedra, or of all other cells as triangles with repeated corners.
Buffer<int> GatherCorners(const UniformCells& made, bool tets)
{
  const vtkIdType cells = made.Cells->GetNumberOfCells();
  const unsigned char* types = made.Types->GetPointer(0);
  auto isWanted = [&](vtkIdType i) { return (types[i] == VTK_TETRA) == tets; };
  Buffer<vtkIdType> places(cells + 1);
  ForEach(cells, [&](vtkIdType i) { places[i] = isWanted(i) ? 1 : 0; });
  CountsToOffsets(places);
  const vtkIdType corners = tets ? 4 : 3;
  Buffer<int> ids(corners * places[cells]);
  auto values = [](vtkDataArray* array)
  { return static_cast<const vtkIdType*>(array->GetVoidPointer(0)); }; // Use32BitIds is off here
  const vtkIdType* connectivity = values(made.Cells->GetConnectivityArray());
  const vtkIdType* offsets = values(made.Cells->GetOffsetsArray());
  ForEach(cells,
    [&](vtkIdType i)
    {
      const vtkIdType begin = offsets[i];
      const vtkIdType size = offsets[i + 1] - begin;
      for (vtkIdType k = 0; k < corners && isWanted(i); ++k)
      {
        ids[corners * places[i] + k] =
          static_cast<int>(connectivity[begin + std::min(k, size - 1)]);
      }
    });
  return ids;
}

bool CopiesAll(const MatrixFactors::Matrix& factor)
{
  bool copies = factor.GetNumberOfRows() == factor.GetNumberOfColumns() &&
    factor.Columns.size() == factor.GetNumberOfRows();
  for (vtkIdType i = 0; copies && i < factor.Columns.size(); ++i)
  {
    copies = factor.Offsets[i] == i && factor.Columns[i] == i && factor.Weights[i] == 1.;
  }
  return copies;
}

/// The factors but those that only copy, which there are where no cell needs a centre.
std::vector<SparseRows<int>> Narrow(const MatrixFactors& factors)
{
  std::vector<SparseRows<int>> rows;
  for (const MatrixFactors::Matrix& factor : factors.Get())
  {
    if (CopiesAll(factor))
    {
      continue;
    }
    SparseRows<int> narrow;
    narrow.NumberOfColumns = factor.NumberOfColumns;
    const auto copy = [](const Buffer<long long>& from, Buffer<int>& to)
    {
      to = Buffer<int>(from.size());
      ForEach(from.size(), [&](vtkIdType i) { to[i] = static_cast<int>(from[i]); });
    };
    copy(factor.Offsets, narrow.Offsets);
    copy(factor.Columns, narrow.Columns);
    narrow.Weights = Buffer<double>(factor.Weights.size());
    CopyInThreads(factor.Weights.data(), factor.Weights.size(), narrow.Weights.data());
    rows.push_back(std::move(narrow));
  }
  return rows;
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
  const CellReader cells(rest);
  const CellReader otherCells(deformed);
  std::vector<vtkIdType> scratch;
  std::vector<vtkIdType> otherScratch;
  const vtkIdType both = std::min(cells.GetNumberOfCells(), otherCells.GetNumberOfCells());
  for (vtkIdType i = 0; i < both; ++i)
  {
    const CellIds ids = cells.GetCell(i, scratch);
    const CellIds others = otherCells.GetCell(i, otherScratch);
    if (cells.GetGridType(i, ids.Size) != otherCells.GetGridType(i, others.Size) ||
      !std::equal(ids.Ids, ids.Ids + ids.Size, others.Ids, others.Ids + others.Size))
    {
      return "Cell " + std::to_string(i) +
        " is the first that differs between the rest mesh and the deformed mesh.";
    }
  }
  return cells.GetNumberOfCells() == otherCells.GetNumberOfCells()
    ? ""
    : differ("cells", cells.GetNumberOfCells(), otherCells.GetNumberOfCells());
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
  auto kept = vtkSmartPointer<vtkPointSet>::Take(control->NewInstance());
  kept->DeepCopy(control);
  if (!this->Build(kept, options))
  {
    return false;
  }
  this->Kept = kept;
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
  RunOptions run = options;
  run.OutputPointsPrecision = vtkAlgorithm::DOUBLE_PRECISION;
  run.InterpolateIntegers = false;
  run.GenerateOriginalIds = false;
  run.Progress = nullptr;
  run.Warn = [&](const std::string& message) { options.Warn("Rest mesh: " + message); };
  const bool isBuilt = options.SurfaceScheme != SurfaceSchemeKind::Loop
    ? this->BuildSurface(control, run, options)
    : options.KeepsCellTypes ? this->BuildHybrid(control, run, options)
                             : this->BuildUniform(control, run, options);
  if (isBuilt)
  {
    this->ControlPoints = this->MoveControlPoints(control);
  }
  return isBuilt;
}

/// Subdivides any mesh as the main filter does.
bool RestMesh::BuildUniform(
  vtkPointSet* control, const RunOptions& run, const DeformationOptions& options)
{
  UniformOptions uniform;
  static_cast<RunOptions&>(uniform) = run;
  uniform.Levels = options.Levels;
  uniform.Scheme = options.Scheme;
  UniformOperators operators;
  if (!FindUniformOperators(control, uniform, operators))
  {
    return false;
  }
  this->Control = std::move(operators.Control);
  this->Steps = std::move(operators.Steps);
  this->Points = operators.Points;
  const vtkIdType cells = operators.Cells.Cells ? operators.Cells.Cells->GetNumberOfCells() : 0;
  this->TooLarge = std::max(cells, this->GetNumberOfPoints()) > std::numeric_limits<int>::max();
  if (cells > 0 && !this->TooLarge)
  {
    this->TetCorners = GatherCorners(operators.Cells, true);
    this->OtherCorners = GatherCorners(operators.Cells, false);
    this->Tets = SimplexTree(this->GetPoints(), 4, this->TetCorners);
  }
  return true;
}

/// Subdivides any mesh without cuts. The cells of the last level hold points as tetrahedra that fit
/// together.
bool RestMesh::BuildHybrid(
  vtkPointSet* control, const RunOptions& run, const DeformationOptions& options)
{
  UniformOptions uniform;
  static_cast<RunOptions&>(uniform) = run;
  MatrixFactors factors;
  uniform.Levels = options.Levels;
  uniform.KeepCellTypes = true;
  uniform.Factors = &factors;
  vtkNew<vtkUnstructuredGrid> made;
  if (!SubdivideUniformly(control, uniform, made))
  {
    return false;
  }
  const std::vector<vtkIdType> ids =
    ReadIdsOf(control->GetPointData(), control->GetNumberOfPoints());
  this->Control = CellsToSimplices(control, ids.empty() ? nullptr : ids.data());
  const SimplicesOfCells cells = CellsToSimplices(made, nullptr);
  AppendCentres(cells, factors);
  this->Points = StartValues(made->GetPoints()->GetData(), VTK_DOUBLE, cells);
  const auto isLarge = [](vtkIdType size) { return size > std::numeric_limits<int>::max(); };
  this->TooLarge = isLarge(cells.Simplices.GetNumberOfSimplices());
  for (const MatrixFactors::Matrix& factor : factors.Get())
  {
    this->TooLarge = this->TooLarge || isLarge(factor.Columns.size());
  }
  if (!this->TooLarge)
  {
    std::vector<SparseRows<int>> rows = Narrow(factors);
    this->Steps = rows.empty() ? nullptr : std::make_unique<StoredSequence>(std::move(rows));
    this->TakeCells(cells);
  }
  return true;
}

void RestMesh::TakeCells(const SimplicesOfCells& cells)
{
  vtkIdType counts[2] = { 0, 0 };
  for (const unsigned char dimension : InTurn(cells.Simplices.Dimensions))
  {
    ++counts[dimension == 3 ? 1 : 0];
  }
  this->OtherCorners = Buffer<int>(3 * counts[0]);
  this->TetCorners = Buffer<int>(4 * counts[1]);
  int* to[2] = { this->OtherCorners.data(), this->TetCorners.data() };
  const vtkIdType* corners = cells.Simplices.Connectivity.data();
  for (const unsigned char dimension : InTurn(cells.Simplices.Dimensions))
  {
    int*& place = to[dimension == 3 ? 1 : 0];
    for (int i = 0; i < (dimension == 3 ? 4 : 3); ++i)
    {
      *place++ = static_cast<int>(corners[std::min<int>(i, dimension)]);
    }
    corners += dimension + 1;
  }
  this->Tets = SimplexTree(this->GetPoints(), 4, this->TetCorners);
}

/// Subdivides a mesh without solids by a surface scheme. `places`: null, or what is wanted instead.
bool RestMesh::BuildSurface(vtkPointSet* control, const RunOptions& run,
  const DeformationOptions& options, const PlaceRequest* places)
{
  vtkSmartPointer<vtkPolyData> mesh = vtkPolyData::SafeDownCast(control);
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(control))
  {
    const vtkIdType solid = FindFirstSolid(grid);
    if (solid >= 0)
    {
      options.Fail("Cell " + std::to_string(solid) +
        " of the rest mesh is a solid, and CatmullClark (SurfaceScheme) is for meshes of polygons "
        "alone. Set SurfaceScheme to Loop, or extract the surface of the mesh. The output is the "
        "input.");
      return false;
    }
    std::vector<std::string> warnings;
    mesh = MakeSurface(grid, false, false, warnings);
    Tell(warnings, run);
  }
  SurfaceOptions surface;
  static_cast<RunOptions&>(surface) = run;
  surface.Scheme = options.SurfaceScheme;
  surface.Levels = options.Levels;
  surface.Places = places;
  FeatureOptions& features = surface.Features;
  for (auto* array : { &features.Singular, &features.Material, &features.Part, &features.Rules,
         &features.Sharpness }) // from cells of `mesh`
  {
    *array = *array ? mesh->GetCellData()->GetArray((*array)->GetName()) : nullptr;
  }
  if (places)
  {
    surface.ProjectToLimit = true;
    return SubdivideSurface(mesh, surface, places->Output);
  }
  SurfaceOperators operators;
  if (!FindSurfaceOperators(mesh, surface, operators))
  {
    return false;
  }
  this->Control.Simplices.NumberOfPoints = mesh->GetNumberOfPoints();
  this->Steps = std::move(operators.Steps);
  this->Points = operators.Points;
  this->TooLarge = std::max(operators.Triangles.size() / 3, this->GetNumberOfPoints()) >
    std::numeric_limits<int>::max();
  if (!this->TooLarge)
  {
    this->OtherCorners = Buffer<int>(operators.Triangles.size());
    ForEach(this->OtherCorners.size(),
      [&](vtkIdType i) { this->OtherCorners[i] = static_cast<int>(operators.Triangles[i]); });
  }
  return true;
}

bool RestMesh::FindPlaces(const PlaceRequest& request, const DeformationOptions& options)
{
  UniformOptions uniform;
  static_cast<RunOptions&>(uniform) = options;
  uniform.GenerateOriginalIds = uniform.GenerateGlobalIds = false;
  uniform.OutputPointsPrecision = vtkAlgorithm::DOUBLE_PRECISION;
  uniform.Warn = [](const std::string&) {}; // Build has told of the mesh
  if (options.SurfaceScheme != SurfaceSchemeKind::Loop)
  {
    return this->BuildSurface(this->Kept, uniform, options, &request);
  }
  uniform.Levels = 0;
  uniform.ProjectToLimit = true;
  uniform.Places = &request;
  uniform.KeepCellTypes = options.KeepsCellTypes;
  uniform.Scheme = options.Scheme;
  return SubdivideUniformly(this->Kept, uniform, nullptr);
}

vtkIdType RestMesh::GetNumberOfPoints() const
{
  return this->Points->GetNumberOfTuples();
}

const double* RestMesh::GetPoints() const
{
  return static_cast<const double*>(this->Points->GetVoidPointer(0));
}

const SimplexTree& RestMesh::GetOthers()
{
  if (this->Others.GetNumberOfSimplices() == 0 && !this->OtherCorners.empty())
  {
    this->Others = SimplexTree(this->GetPoints(), 3, this->OtherCorners);
  }
  return this->Others;
}

vtkSmartPointer<vtkDataArray> RestMesh::MoveControlPoints(vtkPointSet* deformed) const
{
  return StartValues(deformed->GetPoints()->GetData(), VTK_DOUBLE, this->Control);
}

const double* RestMesh::MovePoints(vtkDataArray* control)
{
  const auto* values = static_cast<const double*>(control->GetVoidPointer(0));
  if (!this->Steps)
  {
    return values;
  }
  this->Steps->Apply(values, 3, this->MovedPoints);
  return this->MovedPoints.data();
}

void RestMesh::WarnOfInvertedCells(vtkDataArray* control, const DeformationOptions& options) const
{
  const bool moved = control != nullptr;
  const SimplexList& simplices = this->Control.Simplices;
  const auto& parents = this->Control.ParentCells;
  const auto orient = [&simplices](vtkDataArray* points)
  {
    constexpr double tie = 1e-14;
    std::vector<signed char> signs(static_cast<std::size_t>(simplices.GetNumberOfSimplices()), 1);
    for (const vtkIdType tet :
      FindInvertedTets(simplices, { static_cast<const double*>(points->GetVoidPointer(0)), tie }))
    {
      signs[tet / 2] = tet % 2 == 0 ? -1 : 0;
    }
    return signs;
  };
  const std::vector<signed char> before = orient(this->ControlPoints);
  const std::vector<signed char> after = moved ? orient(control) : before;
  std::vector<vtkIdType> found;
  for (const vtkIdType i : InTurn(simplices.GetNumberOfSimplices()))
  {
    const bool isWrong = moved ? before[i] != 0 && after[i] != before[i] : before[i] <= 0;
    const vtkIdType cell = parents.empty() ? i : parents[i];
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
  return this->Steps ? this->Steps->GetMemorySize() : 0;
}

SparseRows<int> RestMesh::Compose(const SparseRows<int>& rows) const
{
  return this->Steps->ComposeWith(rows);
}

}
