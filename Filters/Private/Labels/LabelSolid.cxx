// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Labels/LabelSolid.h"

#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Labels/CellMeasures.h"
#include "Private/Labels/LabelImage.h"
#include "Private/Labels/LabelNet.h"
#include "Private/Labels/LabelPieces.h"
#include "Private/Labels/Materials.h"
#include "Private/Labels/VoxelGrid.h"
#include "Private/Run/SizeChecks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace subdivision
{
namespace
{

constexpr double VolumeError = 1e-3; ///< relative, at which rounds end
constexpr double ToldError = 5e-3;   ///< of which a warning tells
constexpr double ThinnestTet = 2e-2; ///< of the volume that it would have in a cube
constexpr int FewestRounds = 3;      ///< even if volumes do not get better
constexpr int MostRounds = 8;
constexpr double TetsOfCube = 6.;

/// The ghost types (vtkGhostType) of voxels that are not there: blanked, refined by finer levels of
/// AMR, or owned by another piece.
constexpr int NotHereCell = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL |
  vtkDataSetAttributes::DUPLICATECELL;
constexpr int NotHerePoint =
  vtkDataSetAttributes::HIDDENPOINT | vtkDataSetAttributes::DUPLICATEPOINT;

/// One execution.
class LabelSolid
{
public:
  LabelSolid(vtkDataSet* image, const LabelSolidOptions& options)
    : Image(image)
    , Options(options)
    , Name(GetLabelName(options))
  {
  }
  bool Run(vtkUnstructuredGrid* output);

private:
  bool Read();
  bool HasHiddenPoint(vtkIdType cell) const;
  bool HasMemory() const;
  void ReadBlocks();
  void WarnOfLostLabels(const LabelNet& net) const;
  void WarnOfPieces() const;
  vtkSmartPointer<vtkUnstructuredGrid> MakeControlMesh(
    const LabelNet& net, const VoxelGrid& placement) const;
  /// Of a solid: volumes of labels, in control voxels; the control cells with a thin tetrahedron.
  struct Measures
  {
    std::vector<double> Volumes;
    std::vector<vtkIdType> Thin;
    vtkIdType NumberOfInverted = 0;
  };
  Measures Measure(vtkUnstructuredGrid* solid, const LabelNet& net, double voxel) const;
  std::vector<double> FindShares(const VoxelGrid& placement) const;
  std::vector<double> SumVolumes(const LabelNet& net, const VoxelGrid& placement) const;
  double GetError(const std::vector<double>& volumes) const;
  void WarnOf(const Measures& found) const;
  vtkUnstructuredGrid* Solve(LabelNet& net, const VoxelGrid& placement, vtkUnstructuredGrid* grid);

  vtkDataSet* Image;
  const LabelSolidOptions& Options;
  std::string Name;
  LabelImage Fine;
  LabelImage Coarse;
  Buffer<vtkIdType> Pieces;   ///< of Fine, where blocks have more voxels than one
  std::vector<double> Wanted; ///< volumes of labels in control voxels; 0 where no cell is left
  std::vector<double> Shares; ///< volumes of control cells, in the mean of all
};

bool LabelSolid::HasMemory() const
{
  // The labels of voxels, their pieces and the ids of corners; corners, cells and their faces.
  constexpr double bytesPerVoxel = 4. + 8. + 8.;
  constexpr double bytesPerCell = 300.;
  const double voxels = static_cast<double>(this->Options.Labels->GetNumberOfTuples());
  const double cells = static_cast<double>(this->Coarse.NumberOfMaterialVoxels);
  const bool hexahedra = this->Options.Hexahedra;
  const double boxes = cells * std::ldexp(1., 3 * this->Options.Levels); // about one point for each
  const double made = boxes * (hexahedra ? 1. : TetsOfCube);
  const std::string tooMany =
    CheckMemory(made, boxes, (hexahedra ? 73. : 41.) * made, this->Options.Levels);
  if (!tooMany.empty())
  {
    this->Options.Fail(tooMany + " Or make NumberOfControlCells smaller.");
    return false;
  }
  const double bytes = bytesPerVoxel * voxels + bytesPerCell * cells;
  KeepEstimate(bytes);
  if (bytes > GetAvailableMemory())
  {
    this->Options.Fail(std::to_string(static_cast<vtkIdType>(voxels)) + " voxels take about " +
      Bytes(bytes) +
      ", which is more than there is. Take a part of the image, or make NumberOfControlCells "
      "smaller.");
    return false;
  }
  return true;
}

/// Whether a point of a cell of the image is hidden.
bool LabelSolid::HasHiddenPoint(vtkIdType cell) const
{
  vtkDataArray* ghosts =
    this->Image->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName());
  if (!ghosts)
  {
    return false;
  }
  const std::array<vtkIdType, 3>& size = this->Fine.Size;
  const vtkIdType at[3] = { cell % size[0], cell / size[0] % size[1], cell / size[0] / size[1] };
  bool isHidden = false;
  for (int corner = 0; corner < 8; ++corner)
  {
    const vtkIdType point = at[0] + (corner & 1) +
      (size[0] + 1) * (at[1] + (corner >> 1 & 1) + (size[1] + 1) * (at[2] + (corner >> 2)));
    isHidden = isHidden ||
      (static_cast<int>(ghosts->GetComponent(point, 0)) & vtkDataSetAttributes::HIDDENPOINT) != 0;
  }
  return isHidden;
}

bool LabelSolid::Read()
{
  const std::array<vtkIdType, 3> points = GetStructuredSize(this->Image);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Fine.Size[axis] = points[axis] - (this->Options.OfPoints ? 0 : 1);
  }
  if (*std::min_element(this->Fine.Size.begin(), this->Fine.Size.end()) < 1)
  {
    this->Options.Fail("The input has no voxels with the labels of its cells: it needs two points "
                       "or more along each axis. Labels of points are read of flat images too.");
    return false;
  }
  const std::string noVolume = VoxelGrid(this->Image, this->Options.OfPoints, 1).FindFault();
  if (!noVolume.empty())
  {
    this->Options.Fail(noVolume);
    return false;
  }
  vtkDataArray* labels = this->Options.Labels;
  vtkDataSetAttributes* data = this->Options.OfPoints
    ? static_cast<vtkDataSetAttributes*>(this->Image->GetPointData())
    : this->Image->GetCellData();
  vtkDataArray* ghosts = data->GetArray(vtkDataSetAttributes::GhostArrayName());
  const int hidden = this->Options.OfPoints ? NotHerePoint : NotHereCell;
  if (!this->HasMemory()) // for the labels
  {
    return false;
  }
  const std::string fault = ReadLabels(
    labels, vtkVariant(static_cast<long long>(this->Options.Background)),
    [&](vtkIdType i)
    {
      return (ghosts && (static_cast<int>(ghosts->GetComponent(i, 0)) & hidden)) ||
        (!this->Options.OfPoints && this->HasHiddenPoint(i));
    },
    this->Fine);
  if (!fault.empty())
  {
    this->Options.Fail(
      (this->Options.OfPoints ? "Point array \"" : "Cell array \"") + this->Name + "\" " + fault);
    return false;
  }
  if (this->Fine.NumberOfMissing > 0)
  {
    this->Options.Warn(std::to_string(this->Fine.NumberOfMissing) +
      " voxels have a label that is not finite, the first is number " +
      std::to_string(this->Fine.FirstMissing) + ": the filter leaves them out like background.");
  }
  this->ReadBlocks();
  return this->HasMemory();
}

void LabelSolid::ReadBlocks()
{
  const vtkIdType wanted = this->Options.WantedCells;
  const vtkIdType longest = *std::max_element(this->Fine.Size.begin(), this->Fine.Size.end());
  int length = FindBlockLength(this->Fine, wanted);
  this->Coarse = Coarsen(this->Fine, length);
  if (length > 1)
  {
    this->Pieces = FindPieces(this->Fine, this->Options.ByCorners);
  }
  // Blocks that connect others may be too many.
  while (length > 1 && this->Options.KeepConnected)
  {
    KeepConnected(this->Fine, this->Pieces, this->Options.ByCorners, this->Coarse);
    if (this->Coarse.NumberOfMaterialVoxels <= wanted || length >= longest)
    {
      return;
    }
    this->Coarse = Coarsen(this->Fine, ++length);
  }
}

void LabelSolid::WarnOfPieces() const
{
  if (this->Coarse.Length == 1)
  {
    return; // voxels have the same pieces
  }
  const std::string changed =
    DescribeChangedLabels(this->Fine, this->Pieces, this->Options.ByCorners, this->Coarse);
  if (!changed.empty())
  {
    this->Options.Warn(
      changed + (this->Options.KeepConnected ? "." : ", or switch KeepConnected on."));
  }
}

void LabelSolid::WarnOfLostLabels(const LabelNet& net) const
{
  std::vector<bool> isThere(this->Fine.Labels.size() + 1, false);
  for (const int label : net.GetCellLabels())
  {
    isThere[label] = true;
  }
  const auto lost = std::count(isThere.begin() + 1, isThere.end(), false);
  if (lost > 0)
  {
    const auto first = std::find(isThere.begin() + 1, isThere.end(), false) - isThere.begin() - 1;
    this->Options.Warn(std::to_string(lost) + " of " + std::to_string(this->Fine.Labels.size()) +
      " labels have the most voxels in no block of " + std::to_string(this->Coarse.Length) +
      "^3 voxels and are not in the output; the first is " + this->Fine.Labels[first].ToString() +
      ". Make NumberOfControlCells larger.");
  }
}

vtkSmartPointer<vtkUnstructuredGrid> LabelSolid::MakeControlMesh(
  const LabelNet& net, const VoxelGrid& placement) const
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(net.GetNumberOfPoints());
  grid->SetPoints(points);
  const bool isMirrored = placement.GetVoxelVolume() < 0.;
  vtkNew<vtkCellArray> cells;
  for (LabelNet::Cell cell : InTurn(net.GetCells()))
  {
    if (isMirrored)
    {
      std::rotate(cell.begin(), cell.begin() + 4, cell.end());
    }
    cells->InsertNextCell(8, cell.data());
  }
  grid->SetCells(VTK_HEXAHEDRON, cells);
  vtkFieldData* fields = grid->GetFieldData();
  fields->PassData(this->Image->GetFieldData());
  vtkCellData* data = grid->GetCellData();
  CopyVoxelArrays(this->Fine, this->Coarse,
    this->Options.OfPoints ? static_cast<vtkDataSetAttributes*>(this->Image->GetPointData())
                           : this->Image->GetCellData(),
    this->Options.Labels, data, this->Options.Warn);
  if (this->Options.Materials)
  {
    AddMaterials(this->Options.Materials, this->Name, this->Fine.Labels, net.GetCellLabels(), data,
      fields, this->Options.Warn);
  }
  std::vector<vtkIdType> sources;
  for (const int label : InTurn(net.GetCellLabels()))
  {
    sources.push_back(this->Fine.FirstVoxels[label - 1]);
  }
  const auto labels =
    Gather(this->Options.Labels, { sources.data(), sources.data() + sources.size() });
  labels->SetName(this->Name.c_str());
  data->SetScalars(vtkDataArray::SafeDownCast(labels));
  return grid;
}

LabelSolid::Measures LabelSolid::Measure(
  vtkUnstructuredGrid* solid, const LabelNet& net, double voxel) const
{
  Measures found;
  found.Volumes.assign(this->Wanted.size(), 0.);
  const double allowed = ThinnestTet / TetsOfCube / std::ldexp(1., 3 * this->Options.Levels);
  auto* origins =
    vtkIdTypeArray::SafeDownCast(solid->GetCellData()->GetArray("vtkOriginalCellIds"));
  for (const vtkIdType i : InTurn(solid->GetNumberOfCells()))
  {
    vtkIdType size;
    const vtkIdType* corners;
    solid->GetCellPoints(i, size, corners);
    const CellMeasures measures = MeasureCell(solid, corners, size);
    const double least = measures.Least / voxel;
    const vtkIdType cell = origins ? origins->GetValue(i) : i;
    found.Volumes[net.GetCellLabels()[cell]] += measures.Volume / voxel;
    found.NumberOfInverted += least > 0. && measures.Volume > 0. ? 0 : 1; // also if it is no number
    if (least < allowed * this->Shares[cell] && (found.Thin.empty() || found.Thin.back() != cell))
    {
      found.Thin.push_back(cell);
    }
  }
  return found;
}

/// The largest relative error of volumes.
double LabelSolid::GetError(const std::vector<double>& volumes) const
{
  double largest = 0.;
  for (std::size_t m = 1; m < volumes.size(); ++m)
  {
    const double error = this->Wanted[m] > 0. ? volumes[m] / this->Wanted[m] - 1. : 0.;
    largest = std::max(largest, std::abs(error));
  }
  return largest;
}

void LabelSolid::WarnOf(const Measures& found) const
{
  if (found.NumberOfInverted > 0)
  {
    this->Options.Warn(std::to_string(found.NumberOfInverted) +
      " cells are inverted or flat. Make MaximumDisplacement smaller.");
  }
  int count = 0;
  std::string first;
  for (std::size_t m = 1; m < found.Volumes.size(); ++m)
  {
    const double volume = this->Wanted[m] > 0. ? found.Volumes[m] / this->Wanted[m] : 1.;
    if (std::abs(volume - 1.) > ToldError && ++count == 1)
    {
      first = "label " + this->Fine.Labels[m - 1].ToString() + " has " +
        std::to_string(100. * volume) + " % of the volume of its voxels";
    }
  }
  if (count > 0)
  {
    this->Options.Warn(std::to_string(count) + " of " + std::to_string(this->Fine.Labels.size()) +
      " labels do not keep their volumes to 0.5 %; " + first +
      ". Parts that are thinner than a control voxel would have to move farther than "
      "MaximumDisplacement. Make NumberOfControlCells larger, if it is not 0.");
  }
}

/// Looks for points whose limits have the volumes of the voxels, and no thin tetrahedra.
vtkUnstructuredGrid* LabelSolid::Solve(
  LabelNet& net, const VoxelGrid& placement, vtkUnstructuredGrid* grid)
{
  const double voxel = std::abs(placement.GetVoxelVolume());
  // Corners are moved among voxels that all count alike; rounds correct the rest.
  std::vector<double> target(this->Wanted.size(), 0.);
  const double part = 1. / std::pow(static_cast<double>(this->Coarse.Length), 3);
  for (const int label : InTurn(this->Fine.Voxels))
  {
    target[label] += this->Wanted[label] > 0. ? part : 0.;
  }
  vtkNew<vtkCellArray> edges;
  for (const auto& edge : InTurn(net.GetBorderEdges()))
  {
    edges->InsertNextCell(2, edge.data());
  }
  vtkNew<vtkPolyData> creases;
  creases->SetPoints(grid->GetPoints());
  creases->SetLines(edges);
  double before = VTK_DOUBLE_MAX;
  for (int round = 1;; ++round)
  {
    const auto corners = net.HoldVolumes(target);
    for (const vtkIdType i : InTurn(net.GetNumberOfPoints()))
    {
      double point[3];
      placement.Place(corners[i], point);
      grid->GetPoints()->SetPoint(i, point);
    }
    grid->GetPoints()->Modified();
    vtkUnstructuredGrid* solid = this->Options.Subdivide(grid, creases);
    if (!solid)
    {
      return nullptr;
    }
    const Measures found = this->Measure(solid, net, voxel);
    const double error = this->GetError(found.Volumes);
    const bool isHeld = error < VolumeError || (round > FewestRounds && error > .9 * before);
    if ((isHeld && found.Thin.empty()) || round == MostRounds)
    {
      this->WarnOf(found);
      return this->Options.Curve ? this->Options.Curve(grid, creases) : solid;
    }
    before = error;
    net.Stiffen(found.Thin);
    for (std::size_t m = 1; m < target.size(); ++m)
    {
      target[m] *=
        found.Volumes[m] > 0. ? std::clamp(this->Wanted[m] / found.Volumes[m], .5, 2.) : 1.;
    }
  }
}

/// The volumes of the voxels of each label; 0 where no cell is left.
std::vector<double> LabelSolid::SumVolumes(const LabelNet& net, const VoxelGrid& placement) const
{
  std::vector<double> volumes(this->Fine.Labels.size() + 1, 0.);
  std::vector<bool> isThere(volumes.size(), false);
  for (const int label : net.GetCellLabels())
  {
    isThere[label] = true;
  }
  for (const vtkIdType voxel : InTurn(this->Fine.Voxels.size()))
  {
    const int label = this->Fine.Voxels[voxel];
    volumes[label] += label > 0 && isThere[label]
      ? placement.GetShare(this->Fine.GetPlace(voxel), { 1, 1, 1 })
      : 0.;
  }
  return volumes;
}

/// The volumes of control cells before they are smoothed.
std::vector<double> LabelSolid::FindShares(const VoxelGrid& placement) const
{
  std::vector<double> shares;
  for (const vtkIdType block : InTurn(this->Coarse.Voxels.size()))
  {
    if (this->Coarse.Voxels[block] > 0)
    {
      shares.push_back(
        placement.GetShare(this->Coarse.GetFirst(block), this->Coarse.GetExtent(block)));
    }
  }
  return shares;
}

bool LabelSolid::Run(vtkUnstructuredGrid* output)
{
  if (!this->Read())
  {
    return false;
  }
  if (this->Fine.NumberOfMaterialVoxels == 0)
  {
    this->Options.Warn("All voxels have the label of the background, " +
      std::to_string(this->Options.Background) +
      ", or are hidden: the output is empty. Set BackgroundLabel to another number.");
    return true;
  }
  LabelNet net(this->Coarse, this->Options.LargestMove, this->Options.FlatBorder);
  this->WarnOfLostLabels(net);
  this->WarnOfPieces();
  if (net.GetCells().empty())
  {
    return true;
  }
  VoxelGrid placement(this->Image, this->Options.OfPoints, this->Coarse.Length);
  placement.FindFault(); // Read found none
  this->Wanted = this->SumVolumes(net, placement);
  this->Shares = this->FindShares(placement);
  if (this->Options.Progress(LabelsAreRead))
  {
    return false;
  }
  net.Smooth(this->Options.SmoothingSteps);
  const auto grid = this->MakeControlMesh(net, placement);
  vtkUnstructuredGrid* solid = this->Solve(net, placement, grid);
  if (!solid)
  {
    return false;
  }
  output->ShallowCopy(solid);
  output->GetCellData()->RemoveArray("vtkOriginalCellIds");
  output->GetPointData()->RemoveArray("vtkOriginalPointIds");
  output->GetCellData()->SetActiveScalars(this->Name.c_str());
  return true;
}

}

std::string GetLabelName(const LabelSolidOptions& options)
{
  const char* name = options.Labels->GetName();
  const bool isHere = name && *name &&
    name != std::string(vtkDataSetAttributes::GhostArrayName()) &&
    name != std::string(OriginalCellIdsName);
  return isHere ? name : "Label";
}

bool MakeLabelSolid(
  vtkDataSet* image, const LabelSolidOptions& options, vtkUnstructuredGrid* output)
{
  return LabelSolid(image, options).Run(output);
}

}
