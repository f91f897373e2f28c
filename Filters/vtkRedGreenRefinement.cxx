// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRedGreenRefinement.h"

#include "Private/Curved/CurvedCells.h"
#include "Private/Distribution/PartitionsOfRank.h"
#include "Private/RedGreen/RedGreenRefinement.h"
#include "Private/Run/FilterRun.h"

#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <string>

vtkStandardNewMacro(vtkRedGreenRefinement);

vtkRedGreenRefinement::vtkRedGreenRefinement() = default;
vtkRedGreenRefinement::~vtkRedGreenRefinement() = default;

int vtkRedGreenRefinement::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::RedGreenOptions options;
  options.LimitPlacement = this->Placement == LIMIT;
  options.Scheme = subdivision::GetVolumeScheme(this->VolumeScheme);
  options.GenerateLimitNormals = this->GenerateLimitNormals && options.LimitPlacement;
  if (this->GenerateLimitNormals && !options.LimitPlacement)
  {
    subdivision::Warn(this,
      "GenerateLimitNormals makes no normals with Placement = Linear: set Placement to Limit.");
  }
  options.IsCurved = this->OutputCells != LINEAR_CELLS;
  options.Kind = this->OutputCells == QUADRATIC_CELLS ? subdivision::CurvedKind::Quadratic
                                                      : subdivision::CurvedKind::Lagrange;
  options.CellOrder = this->OutputCells == QUADRATIC_CELLS ? 2 : this->CellOrder;
  if (options.IsCurved && options.GenerateLimitNormals &&
    !subdivision::AreNodesOnLevels(options.CellOrder))
  {
    options.GenerateLimitNormals = false;
    subdivision::Warn(this,
      "Nodes of CellOrder 3, 5 and 6 have no normals: GenerateLimitNormals is ignored. Set "
      "CellOrder "
      "to 1, 2 or 4.");
  }
  return this->RunRounds(inputVector, outputVector, options, options.Criteria,
    [this, &options](vtkPointSet* input, vtkPointSet* output)
    {
      options.Torn = this->Torn;
      return subdivision::RefineRedGreen(input, options, vtkUnstructuredGrid::SafeDownCast(output));
    });
}

vtkSmartPointer<vtkDataObject> vtkRedGreenRefinement::Finish(vtkDataObject* made)
{
  if (this->OutputCells == LINEAR_CELLS)
  {
    return made;
  }
  subdivision::PartitionsOfRank ofRank(this->SharesRanks() ? this->Controller.Get() : nullptr);
  subdivision::ExchangeOfAll ranks(ofRank);
  subdivision::CurvedOptions options;
  options.Kind = this->OutputCells == QUADRATIC_CELLS ? subdivision::CurvedKind::Quadratic
                                                      : subdivision::CurvedKind::Lagrange;
  options.Order = this->OutputCells == QUADRATIC_CELLS ? 2 : this->CellOrder;
  options.AreMade = true;
  options.Ranks = &ranks;
  options.Warn = [this](const std::string& text) { subdivision::Warn(this, text); };
  options.Fail = [this](const std::string& text) { subdivision::Fail(this, text); };
  return subdivision::MakeCurvedCells(made, options);
}

void vtkRedGreenRefinement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Placement: " << this->Placement << "\n";
  os << indent << "VolumeScheme: " << this->VolumeScheme << "\n";
  os << indent << "GenerateLimitNormals: " << this->GenerateLimitNormals << "\n";
  os << indent << "OutputCells: " << this->OutputCells << "\n";
  os << indent << "CellOrder: " << this->CellOrder << "\n";
}
