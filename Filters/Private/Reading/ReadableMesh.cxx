// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/ReadableMesh.h"

#include "Core/Memory/Buffer.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/NonLinearCells.h"
#include "Private/Reading/PolyhedronFaces.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUniformGridAMR.h"
#include "vtkUniformGridAMRDataIterator.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace subdivision
{
namespace
{

void ShareArrays(vtkDataSet* from, vtkDataSet* to)
{
  to->GetPointData()->ShallowCopy(from->GetPointData());
  to->GetCellData()->ShallowCopy(from->GetCellData());
  to->GetFieldData()->ShallowCopy(from->GetFieldData());
}

// ------------------------------------------------------------------------------------------------
// Structured data

/// The numbers of points of a structured data set along its axes. Returns false for others.
bool GetDimensions(vtkDataSet* data, int* dimensions)
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(dimensions);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    rectilinear->GetDimensions(dimensions);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
  {
    structured->GetDimensions(dimensions);
  }
  else
  {
    return false;
  }
  return true;
}

/// The points of an image or rectilinear grid.
vtkSmartPointer<vtkPoints> MakePoints(vtkDataSet* data)
{
  vtkNew<vtkDoubleArray> values;
  values->SetNumberOfComponents(3);
  values->SetNumberOfTuples(data->GetNumberOfPoints());
  double* x = values->GetPointer(0);
  ForEach(data->GetNumberOfPoints(), [&](vtkIdType i) { data->GetPoint(i, x + 3 * i); });
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(values);
  return points;
}

/// The cells of a structured data set.
vtkSmartPointer<vtkCellArray> MakeBoxes(vtkDataSet* data)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  if (data->GetNumberOfPoints() < std::numeric_limits<int>::max() / 8)
  {
    cells->Use32BitStorage();
  }
  vtkNew<vtkIdList> ids;
  for (const vtkIdType c : InTurn(data->GetNumberOfCells()))
  {
    data->GetCellPoints(c, ids);
    cells->InsertNextCell(ids);
  }
  return cells;
}

/// A mesh whose cells at hidden points are hidden: the mesh itself, if there are no such points.
vtkSmartPointer<vtkPointSet> HideCells(vtkPointSet* mesh)
{
  constexpr unsigned char hidden = vtkDataSetAttributes::HIDDENPOINT;
  vtkUnsignedCharArray* ofPoints = mesh->GetPointGhostArray();
  const vtkIdType points = ofPoints ? ofPoints->GetNumberOfValues() : 0;
  if (!ofPoints || points < mesh->GetNumberOfPoints() ||
    std::none_of(
      ofPoints->GetPointer(0), ofPoints->GetPointer(0) + points,
      [](unsigned char type) { return type & hidden; }))
  {
    return mesh;
  }
  auto grid = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
  grid->ShallowCopy(mesh);
  const CellReader reader(grid);
  vtkNew<vtkUnsignedCharArray> types;
  types->SetName(vtkDataSetAttributes::GhostArrayName());
  types->SetNumberOfValues(grid->GetNumberOfCells());
  types->FillValue(0);
  if (const unsigned char* known = GetGhosts(grid, grid->GetNumberOfCells()))
  {
    std::copy(known, known + grid->GetNumberOfCells(), types->GetPointer(0));
  }
  std::vector<vtkIdType> scratch;
  for (const vtkIdType c : InTurn(grid->GetNumberOfCells()))
  {
    const CellIds cell = reader.GetCell(c, scratch);
    if (std::any_of(cell.Ids, cell.Ids + cell.Size, [&](vtkIdType id)
          { return id >= 0 && id < points && (ofPoints->GetValue(id) & hidden); }))
    {
      types->SetValue(c, types->GetValue(c) | vtkDataSetAttributes::HIDDENCELL);
    }
  }
  grid->GetCellData()->AddArray(types);
  return grid;
}

/// The volume of a box with its corners in the order of VTK_VOXEL or VTK_HEXAHEDRON, times eight:
/// by the edges at each corner.
double MeasureBox(vtkPoints* points, const CellIds& box, bool isVoxel)
{
  double at[8][3];
  for (int corner = 0; corner < 8; ++corner)
  {
    const int stored = isVoxel || corner % 4 < 2 ? corner : corner ^ 1;
    points->GetPoint(box.Ids[stored], at[corner]);
  }
  double volume = 0.;
  for (int corner = 0; corner < 8; ++corner)
  {
    double edges[3][3];
    for (int axis = 0; axis < 3; ++axis)
    {
      vtkMath::Subtract(at[corner | 1 << axis], at[corner & ~(1 << axis)], edges[axis]);
    }
    volume += vtkMath::Determinant3x3(edges);
  }
  return std::isfinite(volume) ? volume : 0.;
}

/// Turns the boxes of a left-handed grid, in which more volume is negative than positive.
void TurnLeftHanded(vtkUnstructuredGrid* grid)
{
  const CellReader reader(grid);
  const vtkIdType size = reader.GetNumberOfCells();
  const int type = size > 0 ? reader.GetCellType(0) : VTK_EMPTY_CELL;
  const bool isVoxel = type == VTK_VOXEL;
  double volume = 0.;
  std::vector<vtkIdType> scratch;
  for (const vtkIdType c : InTurn(isVoxel || type == VTK_HEXAHEDRON ? size : vtkIdType(0)))
  {
    const CellIds box = reader.GetCell(c, scratch);
    const bool isBox = box.Size == 8 &&
      std::all_of(box.Ids, box.Ids + 8,
        [grid](vtkIdType id) { return id >= 0 && id < grid->GetNumberOfPoints(); });
    volume += isBox ? MeasureBox(grid->GetPoints(), box, isVoxel) : 0.;
  }
  if (volume >= 0.)
  {
    return;
  }
  vtkNew<vtkCellArray> turned;
  turned->DeepCopy(grid->GetCells()); // an explicit grid shares its cells
  vtkNew<vtkIdList> ids;
  for (const vtkIdType c : InTurn(size))
  {
    turned->GetCellAtId(c, ids);
    for (vtkIdType i = 0; i < 4 && ids->GetNumberOfIds() == 8; ++i)
    {
      const vtkIdType low = ids->GetId(i);
      ids->SetId(i, ids->GetId(i + 4));
      ids->SetId(i + 4, low);
    }
    turned->ReplaceCellAtId(c, ids);
  }
  grid->SetCells(type, turned);
}

/// Null where the input is not structured.
vtkSmartPointer<vtkUnstructuredGrid> ReadStructured(vtkDataSet* data)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  int dimensions[3];
  if (auto* explicitGrid = vtkExplicitStructuredGrid::SafeDownCast(data))
  {
    grid->SetPoints(explicitGrid->GetPoints());
    if (explicitGrid->GetCells())
    {
      grid->SetCells(VTK_HEXAHEDRON, explicitGrid->GetCells());
    }
  }
  else if (GetDimensions(data, dimensions))
  {
    static const int boxes[2][4] = { { VTK_VERTEX, VTK_LINE, VTK_QUAD, VTK_HEXAHEDRON },
      { VTK_VERTEX, VTK_LINE, VTK_PIXEL, VTK_VOXEL } };
    auto* structured = vtkStructuredGrid::SafeDownCast(data);
    const auto axes = std::count_if(dimensions, dimensions + 3, [](int size) { return size > 1; });
    grid->SetPoints(structured ? structured->GetPoints() : MakePoints(data).Get());
    grid->SetCells(boxes[structured ? 0 : 1][axes], MakeBoxes(data));
  }
  else
  {
    return nullptr;
  }
  ShareArrays(data, grid);
  TurnLeftHanded(grid);
  return grid;
}

// ------------------------------------------------------------------------------------------------
// Unstructured grids

/// The non-linear cells of which only the corners remain.
struct Linearised
{
  vtkIdType Cells = 0;
  vtkIdType PlainPoints = 0; ///< that were nodes, and that no cell uses any more
  vtkIdType First = -1;      ///< cell
  int FirstType = 0;
  unsigned int FirstBlock = 0;
};

std::string Describe(const Linearised& done)
{
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(done.FirstType));
  std::string text = done.Cells == 1
    ? "1 cell is not linear (cell "
    : std::to_string(done.Cells) + " cells are not linear (the first is cell ";
  text += std::to_string(done.First) +
    (done.FirstBlock > 0 ? " of block " + std::to_string(done.FirstBlock) : "") + ", type " +
    std::to_string(done.FirstType) + (cell ? std::string(", ") + cell->GetClassName() : "") +
    "): the filter takes a linear cell at the corners of each, and ";
  text += done.PlainPoints == 1
    ? "1 node that no cell uses any more becomes a plain point"
    : std::to_string(done.PlainPoints) + " nodes that no cell uses any more become plain points";
  return text + ". Set QuadraticCells to Pieces to have cells cut along their nodes.";
}

/// Writes the cells of a grid anew.
class CellWriter
{
public:
  CellWriter(vtkUnstructuredGrid* grid, NonLinearRule rule)
    : Grid(grid)
    , Rule(rule)
    , Reader(grid)
    , NonLinear(grid)
    , Ghosts(GetGhosts(grid, grid->GetNumberOfCells()))
  {
  }

  /// Whether there is a cell that has to be changed.
  bool IsNeeded() const
  {
    const unsigned char* types = this->Reader.GetTypes();
    return std::any_of(types, types + this->Reader.GetNumberOfCells(),
      [this](int type)
      {
        return type == VTK_POLYHEDRON ||
          (type > VTK_HEXAGONAL_PRISM && this->Rule == NonLinearRule::Corners && IsNonLinear(type));
      });
  }

  vtkSmartPointer<vtkUnstructuredGrid> Write(Linearised& done, unsigned int block)
  {
    const vtkIdType cells = this->Reader.GetNumberOfCells();
    this->Types->SetNumberOfValues(cells);
    this->Ends->InsertNextValue(0);
    this->Uses.assign(static_cast<size_t>(this->Grid->GetNumberOfPoints()), Use::None);
    vtkNew<vtkIdList> stream;
    std::vector<vtkIdType> scratch;
    for (const vtkIdType c : InTurn(cells))
    {
      const int type = this->Reader.GetCellType(c);
      CornerCell kept;
      kept.Type = type;
      if (type == VTK_POLYHEDRON)
      {
        kept.Type = FaceLoops;
        ReadFaceStream(this->Grid, c, stream);
        this->AddLoops(stream);
      }
      else
      {
        const CellIds cell = this->Reader.GetCell(c, scratch);
        kept.Size = cell.Size;
        if (this->TakesCorners(type, c, cell.Size))
        {
          kept = GetCornerCell(type, cell.Size);
          this->Count(type, c, block, done);
        }
        this->AddIds(cell, kept.Size, this->Ghosts && this->IsHidden(c));
      }
      this->Types->SetValue(c, static_cast<unsigned char>(kept.Type));
      this->Ends->InsertNextValue(this->Ids->GetNumberOfValues());
    }
    done.PlainPoints += std::count(this->Uses.begin(), this->Uses.end(), Use::Dropped);
    return this->MakeGrid();
  }

private:
  enum class Use : unsigned char
  {
    None,
    Dropped,
    Taken
  };

  bool IsHidden(vtkIdType cell) const { return this->Ghosts && IsHiddenCell(this->Ghosts[cell]); }
  /// Cells with a wrong number of points are left as they are, and CheckCells tells of them.
  bool TakesCorners(int type, vtkIdType cell, vtkIdType size)
  {
    return this->Rule == NonLinearRule::Corners && IsNonLinear(type) &&
      this->NonLinear.Find(type, cell, size);
  }
  void Count(int type, vtkIdType cell, unsigned int block, Linearised& done) const
  {
    if (this->IsHidden(cell))
    {
      return;
    }
    if (done.Cells++ == 0)
    {
      done.First = cell;
      done.FirstType = type;
      done.FirstBlock = block;
    }
  }
  void AddId(vtkIdType id, bool isHidden)
  {
    this->Ids->InsertNextValue(id);
    if (!isHidden && id >= 0 && id < static_cast<vtkIdType>(this->Uses.size()))
    {
      this->Uses[id] = Use::Taken;
    }
  }
  void AddIds(const CellIds& cell, vtkIdType kept, bool isHidden)
  {
    for (vtkIdType i = 0; i < kept; ++i)
    {
      this->AddId(cell.Ids[i], isHidden);
    }
    for (vtkIdType i = kept; i < cell.Size && !isHidden; ++i)
    {
      const vtkIdType id = cell.Ids[i];
      const bool exists = id >= 0 && id < static_cast<vtkIdType>(this->Uses.size());
      if (exists && this->Uses[id] == Use::None)
      {
        this->Uses[id] = Use::Dropped;
      }
    }
  }
  /// `stream`: the number of faces, then the number of points and the points of each.
  void AddLoops(vtkIdList* stream)
  {
    for (vtkIdType i = 1; i < stream->GetNumberOfIds();)
    {
      const vtkIdType begin = i + 1;
      const vtkIdType end = std::min(begin + stream->GetId(i), stream->GetNumberOfIds());
      for (i = begin; i < end; ++i)
      {
        this->AddId(stream->GetId(i), false);
      }
      if (begin < end)
      {
        this->AddId(stream->GetId(begin), false);
      }
    }
  }
  vtkSmartPointer<vtkUnstructuredGrid> MakeGrid() const
  {
    auto made = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkNew<vtkCellArray> cells;
    cells->SetData(this->Ends.Get(), this->Ids.Get());
    made->SetPoints(this->Grid->GetPoints());
    made->SetCells(this->Types.Get(), cells);
    ShareArrays(this->Grid, made);
    return made;
  }

  vtkUnstructuredGrid* Grid;
  const NonLinearRule Rule;
  const CellReader Reader;
  NonLinearCells NonLinear;
  const unsigned char* Ghosts;
  std::vector<Use> Uses; ///< of each point
  vtkNew<vtkUnsignedCharArray> Types;
  vtkNew<vtkIdTypeArray> Ends;
  vtkNew<vtkIdTypeArray> Ids;
};

}

void CopyTree(vtkCompositeDataSet* from, vtkCompositeDataSet* to)
{
  to->CopyStructure(from);
  to->GetFieldData()->ShallowCopy(from->GetFieldData());
  auto* tree = vtkDataObjectTree::SafeDownCast(from);
  if (!tree)
  {
    return;
  }
  const auto at = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  at->VisitOnlyLeavesOff();
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    auto* inner = vtkCompositeDataSet::SafeDownCast(at->GetCurrentDataObject());
    if (vtkDataObject* made = inner ? to->GetDataSet(at) : nullptr)
    {
      made->GetFieldData()->ShallowCopy(inner->GetFieldData());
    }
  }
}

vtkSmartPointer<vtkDataObject> MakeTree(vtkDataObject* input)
{
  auto* amr = vtkUniformGridAMR::SafeDownCast(input);
  if (!amr)
  {
    return input;
  }
  const auto tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  tree->GetFieldData()->ShallowCopy(amr->GetFieldData());
  const auto all = vtkSmartPointer<vtkCompositeDataIterator>::Take(amr->NewIterator());
  auto* at = vtkUniformGridAMRDataIterator::SafeDownCast(all);
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    const unsigned int level = at->GetCurrentLevel();
    auto* grids = vtkMultiBlockDataSet::SafeDownCast(tree->GetBlock(level));
    if (!grids)
    {
      tree->SetBlock(level, vtkSmartPointer<vtkMultiBlockDataSet>::New());
      tree->GetMetaData(level)->Set(
        vtkCompositeDataSet::NAME(), ("Level " + std::to_string(level)).c_str());
      grids = vtkMultiBlockDataSet::SafeDownCast(tree->GetBlock(level));
    }
    grids->SetBlock(at->GetCurrentIndex(), at->GetCurrentDataObject());
  }
  return tree;
}

vtkSmartPointer<vtkDataObject> ChangeMeshes(vtkDataObject* input,
  const std::function<vtkSmartPointer<vtkDataObject>(vtkDataObject*, unsigned int)>& change)
{
  auto* from = vtkCompositeDataSet::SafeDownCast(input);
  if (!from)
  {
    return input ? change(input, 0) : nullptr;
  }
  auto to = vtkSmartPointer<vtkCompositeDataSet>::Take(from->NewInstance());
  CopyTree(from, to);
  bool isSame = true;
  const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(from->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    const auto changed = change(at->GetCurrentDataObject(), at->GetCurrentFlatIndex());
    isSame = isSame && changed == at->GetCurrentDataObject();
    to->SetDataSet(at, changed);
  }
  if (isSame)
  {
    return input;
  }
  return to;
}

vtkSmartPointer<vtkDataObject> MakeReadable(
  vtkDataObject* input, NonLinearRule rule, std::vector<std::string>& warnings)
{
  Linearised done;
  auto readable = ChangeMeshes(input,
    [&](vtkDataObject* mesh, unsigned int block) -> vtkSmartPointer<vtkDataObject>
    {
      auto* data = vtkDataSet::SafeDownCast(mesh);
      const auto structured = data ? ReadStructured(data) : nullptr;
      auto* points = structured ? structured : vtkPointSet::SafeDownCast(mesh);
      if (!points)
      {
        return mesh;
      }
      const auto shown = HideCells(points);
      auto* grid = vtkUnstructuredGrid::SafeDownCast(shown);
      if (grid && !structured)
      {
        CellWriter writer(grid, rule);
        if (writer.IsNeeded())
        {
          return writer.Write(done, block);
        }
      }
      return shown;
    });
  if (done.Cells > 0)
  {
    warnings.push_back(Describe(done));
  }
  return readable;
}

vtkSmartPointer<vtkDataObject> MakeMovable(vtkDataObject* input)
{
  return ChangeMeshes(input,
    [](vtkDataObject* mesh, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      int dimensions[3];
      auto* data = vtkDataSet::SafeDownCast(mesh);
      if (vtkStructuredGrid::SafeDownCast(data) || !GetDimensions(data, dimensions))
      {
        return mesh;
      }
      auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
      grid->SetDimensions(dimensions);
      grid->SetPoints(MakePoints(data));
      ShareArrays(data, grid);
      return grid;
    });
}

std::vector<vtkUnstructuredGrid*> ListGrids(vtkDataObject* data)
{
  std::vector<vtkUnstructuredGrid*> grids;
  if (auto* const grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    grids.push_back(grid);
  }
  if (auto* const blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      if (auto* grid = vtkUnstructuredGrid::SafeDownCast(at->GetCurrentDataObject()))
      {
        grids.push_back(grid);
      }
    }
  }
  return grids;
}

}
