// SPDX-License-Identifier: BSD-3-Clause
#include "Private/RedGreen/RedGreenWriter.h"

#include "Core/Memory/Ids.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/CellArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <string>

namespace subdivision
{
namespace
{

/// Warns if an input that no filter of this kind made has arrays with the names of the output's.
void WarnOfReplaced(vtkPointSet* input, const RedGreenMesh& mesh, const RunOptions& run)
{
  if (mesh.IsContinued)
  {
    return;
  }
  for (const char* name : { LevelName, KindName, GreenParentName })
  {
    if (input->GetCellData()->HasArray(name))
    {
      run.Warn(std::string("The input's cell array \"") + name +
        "\" is replaced: the filter writes an array of this name. Rename it to keep it.");
    }
  }
}

}

template <typename Id>
void WriteRedGreenCells(const RedGreenOutput<Id>& plan, vtkPointSet* input,
  const RedGreenMesh& mesh, const RunOptions& run, bool pointsMove,
  std::vector<vtkIdType>* simplices, vtkUnstructuredGrid* output)
{
  const CellCounts counts = plan.GetCounts();
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkUnsignedCharArray> levels;
  vtkNew<vtkUnsignedCharArray> kinds;
  vtkNew<vtkIdTypeArray> parents;
  Allocate(offsets, 1, counts.Cells + 1);
  Allocate(connectivity, 1, counts.Entries);
  Allocate(types, 1, counts.Cells);
  Allocate(levels, 1, counts.Cells);
  Allocate(kinds, 1, counts.Cells);
  Allocate(parents, 1, counts.Cells);
  levels->SetName(LevelName);
  kinds->SetName(KindName);
  parents->SetName(GreenParentName);
  vtkNew<vtkIdTypeArray> sources;
  Allocate(sources, 1, counts.Cells);
  RedGreenStorage<vtkIdType> storage;
  storage.Cells = { connectivity->GetPointer(0), offsets->GetPointer(0), types->GetPointer(0) };
  storage.Levels = levels->GetPointer(0);
  storage.Kinds = kinds->GetPointer(0);
  storage.GreenParents = parents->GetPointer(0);
  storage.InputCells = sources->GetPointer(0);
  plan.Write(storage);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  output->SetCells(types, cells);
  if (simplices)
  {
    simplices->assign(sources->GetPointer(0), sources->GetPointer(0) + counts.Cells);
  }
  if (!mesh.Control.Cells.ParentCells.empty())
  {
    vtkIdType* ids = sources->GetPointer(0);
    ForEach(counts.Cells, [&](vtkIdType i) { ids[i] = mesh.GetInputCell(ids[i]); });
  }
  CellArrayOptions options;
  options.PointsMove = pointsMove;
  options.OriginalIds = true;
  options.CarryOriginalIds = mesh.CarriesOriginals() &&
    HasIds(input->GetCellData(), OriginalCellIdsName, input->GetNumberOfCells());
  options.Replaced = { LevelName, KindName, GreenParentName };
  options.Warn = run.Warn;
  WarnOfReplaced(input, mesh, run);
  CopyCellArrays(input, sources, options, output);
  for (vtkDataArray* own : { static_cast<vtkDataArray*>(levels), static_cast<vtkDataArray*>(kinds),
         static_cast<vtkDataArray*>(parents) })
  {
    AddInstead(input->GetCellData(), own, output->GetCellData());
  }
}

SUBDIVISION_COMPILE_FUNCTION(WriteRedGreenCells);

}
