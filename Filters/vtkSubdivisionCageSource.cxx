// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionCageSource.h"

#include "Core/Memory/Loops.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/Ports.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSubdivisionCageSource);

namespace
{

/// Smoothing takes less than this part of a box from a cage of boxes, whatever its shape.
constexpr double HuggedBoxes = 0.45;

/// The fault of bounds after the margin was added; empty if they have a volume. `largest`: the
/// largest coordinate that the output can hold.
std::string FindFault(const double* bounds, double largest)
{
  std::string fault;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = bounds[2 * axis];
    const double high = bounds[2 * axis + 1];
    if (low >= -largest && high <= largest && low < high)
    {
      continue;
    }
    const bool isFlat = std::isfinite(low) && low == high;
    fault = isFlat ? "The box is flat along " : "Bounds along ";
    fault += "xyz"[axis];
    fault += isFlat
      ? ". Raise Margin, or set Bounds with a volume."
      : " are not finite, too large for OutputPointsPrecision, or the first is "
        "larger than the second. Set them in ascending order, or make Margin smaller.";
    break;
  }
  return fault;
}

/// Calls use(i, j, k) for all of a lattice.
template <typename Use>
void ForAll(const int* counts, const Use& use)
{
  subdivision::Turns turns;
  for (int k = 0; k < counts[2]; ++k)
  {
    for (int j = 0; j < counts[1]; ++j)
    {
      for (int i = 0; i < counts[0]; ++i, turns.Next())
      {
        use(i, j, k);
      }
    }
  }
}

/// Numbers the points of the lattice that have cells; -1: it has none. `isKept`: of each box;
/// empty: all are.
std::vector<vtkIdType> NumberPoints(const int* cells, const std::vector<char>& isKept)
{
  const vtkIdType row = cells[0] + 1;
  const vtkIdType layer = row * (cells[1] + 1);
  std::vector<vtkIdType> numbers(static_cast<std::size_t>(layer * (cells[2] + 1)), -1);
  for (std::size_t box = 0; box < isKept.size(); ++box)
  {
    const auto line = static_cast<vtkIdType>(box) / cells[0];
    const vtkIdType first =
      static_cast<vtkIdType>(box) % cells[0] + line % cells[1] * row + line / cells[1] * layer;
    for (int corner = 0; corner < 8 && isKept[box] != 0; ++corner)
    {
      numbers[first + (corner & 1) + (corner >> 1 & 1) * row + (corner >> 2) * layer] = 0;
    }
  }
  vtkIdType used = 0;
  for (vtkIdType& number : subdivision::InTurn(numbers))
  {
    number = isKept.empty() || number == 0 ? used++ : -1;
  }
  return numbers;
}

vtkSmartPointer<vtkPoints> MakePoints(
  const int* cells, const double* bounds, int type, const std::vector<vtkIdType>& numbers)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(type);
  auto number = numbers.begin();
  // The last point of an axis is exactly at its end.
  const auto place = [&](int axis, int i)
  {
    const double t = static_cast<double>(i) / cells[axis];
    return (1. - t) * bounds[2 * axis] + t * bounds[2 * axis + 1];
  };
  const int counts[3] = { cells[0] + 1, cells[1] + 1, cells[2] + 1 };
  ForAll(counts,
    [&](int i, int j, int k)
    {
      if (*number++ >= 0)
      {
        points->InsertNextPoint(place(0, i), place(1, j), place(2, k));
      }
    });
  return points;
}

/// Calls visit(data set) for all data sets with points.
template <typename Visit>
void ForEachDataSet(vtkDataObject* input, const Visit& visit)
{
  const auto look = [&visit](vtkDataObject* object)
  {
    auto* data = vtkDataSet::SafeDownCast(object);
    data && data->GetNumberOfPoints() > 0 ? visit(data) : void();
  };
  if (auto* all = vtkCompositeDataSet::SafeDownCast(input))
  {
    const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(all->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      look(at->GetCurrentDataObject());
    }
  }
  look(input);
}

/// Boxes of the lattice, of which some are kept.
class Boxes
{
public:
  explicit Boxes(const int* cells)
    : Size{ cells[0], cells[1], cells[2] }
    , IsKept(static_cast<std::size_t>(cells[0]) * cells[1] * cells[2], 0)
  {
  }
  /// Keeps all boxes that bounds touch, which are parts of the lattice.
  void Keep(const double* bounds)
  {
    int ends[6];
    for (int i = 0; i < 6; ++i)
    {
      const int size = this->Size[i / 2];
      ends[i] = static_cast<int>(std::clamp(std::floor(bounds[i] * size), 0., size - 1.));
    }
    for (int k = ends[4]; k <= ends[5]; ++k)
    {
      for (int j = ends[2]; j <= ends[3]; ++j)
      {
        std::fill_n(&this->At(ends[0], j, k), ends[1] - ends[0] + 1, 1);
      }
    }
  }

  /// Keeps boxes that others enclose: there is no way to them through faces of boxes from outside.
  void FillCavities()
  {
    constexpr char outside = 2;
    this->Beyond = outside;
    for (bool hasChanged = true; hasChanged;)
    {
      hasChanged = false;
      ForAll(this->Size,
        [&](int i, int j, int k)
        {
          const char around[6] = { this->At(i - 1, j, k), this->At(i + 1, j, k),
            this->At(i, j - 1, k), this->At(i, j + 1, k), this->At(i, j, k - 1),
            this->At(i, j, k + 1) };
          if (this->At(i, j, k) == 0 && std::count(around, around + 6, outside) > 0)
          {
            this->At(i, j, k) = outside;
            hasChanged = true;
          }
        });
    }
    std::transform(this->IsKept.begin(), this->IsKept.end(), this->IsKept.begin(),
      [](char kept) -> char { return kept == outside ? 0 : 1; });
    this->Beyond = 0;
  }

  /// Keeps more boxes, until the boxes around each point are joined through faces, and so are those
  /// that are not kept. Then the surface is a manifold, at edges too.
  void JoinThroughFaces()
  {
    const int points[3] = { this->Size[0] + 1, this->Size[1] + 1, this->Size[2] + 1 };
    const int two[3] = { 2, 2, 2 };
    for (bool hasChanged = true; hasChanged;)
    {
      hasChanged = false;
      ForAll(points,
        [&](int i, int j, int k)
        {
          std::vector<char*> around;
          ForAll(two, [&](int x, int y, int z)
            { around.push_back(&this->At(i + x - 1, j + y - 1, k + z - 1)); });
          if (!AreJoined(around, 0) || !AreJoined(around, 1))
          {
            std::for_each(around.begin(), around.end(), [](char* box) { *box = 1; });
            this->Beyond = 0;
            hasChanged = true;
          }
        });
    }
  }

  std::vector<char>& GetKept() { return this->IsKept; }

private:
  /// Whether those of 2 x 2 x 2 boxes that have a value are joined through faces: boxes whose
  /// numbers differ in one bit have a common face.
  static bool AreJoined(const std::vector<char*>& around, char value)
  {
    unsigned all = 0;
    for (unsigned b = 0; b < 8; ++b)
    {
      all |= *around[b] == value ? 1U << b : 0U;
    }
    unsigned reached = all & (~all + 1U); // the first
    for (unsigned step = 0; step < 64; ++step)
    {
      const unsigned b = step % 8;
      const unsigned beside = 1U << (b ^ 1U) | 1U << (b ^ 2U) | 1U << (b ^ 4U);
      reached |= (reached >> b & 1U) != 0 ? all & beside : 0U;
    }
    return reached == all;
  }
  char& At(int i, int j, int k)
  {
    const bool isThere =
      i >= 0 && j >= 0 && k >= 0 && i < this->Size[0] && j < this->Size[1] && k < this->Size[2];
    return isThere
      ? this->IsKept[(static_cast<std::size_t>(k) * this->Size[1] + j) * this->Size[0] + i]
      : this->Beyond;
  }

  int Size[3];
  std::vector<char> IsKept;
  char Beyond = 0; ///< of all boxes beyond the lattice
};

/// Six tetrahedra for each box: one for each order in which a path along its edges may go from the
/// first corner to the last. Odd orders are turned to make them positive. `isKept`: of each box;
/// empty: all are.
vtkSmartPointer<vtkCellArray> MakeCells(
  const int* cells, const std::vector<char>& isKept, const std::vector<vtkIdType>& numbers)
{
  static const int orders[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 0, 2, 1 }, { 2, 1, 0 },
    { 1, 0, 2 } };
  const vtkIdType steps[3] = { 1, cells[0] + 1,
    static_cast<vtkIdType>(cells[0] + 1) * (cells[1] + 1) };
  auto tets = vtkSmartPointer<vtkCellArray>::New();
  std::size_t box = 0;
  ForAll(cells,
    [&](int i, int j, int k)
    {
      const bool isMade = isKept.empty() || isKept[box++] != 0;
      for (int order = 0; order < 6 && isMade; ++order)
      {
        vtkIdType tet[4] = { i * steps[0] + j * steps[1] + k * steps[2] };
        for (int corner = 0; corner < 3; ++corner)
        {
          tet[corner + 1] = tet[corner] + steps[orders[order][corner]];
        }
        if (order > 2)
        {
          std::swap(tet[1], tet[2]);
        }
        std::transform(tet, tet + 4, tet, [&](vtkIdType point) { return numbers[point]; });
        tets->InsertNextCell(4, tet);
      }
    });
  return tets;
}

}

vtkSubdivisionCageSource::vtkSubdivisionCageSource()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

vtkSubdivisionCageSource::~vtkSubdivisionCageSource() = default;

void vtkSubdivisionCageSource::SetNumberOfCells(int x, int y, int z)
{
  const int wanted[3] = { x, y, z };
  for (int axis = 0; axis < 3; ++axis)
  {
    const int clamped = std::clamp(wanted[axis], 1, 100);
    if (this->NumberOfCells[axis] != clamped)
    {
      this->NumberOfCells[axis] = clamped;
      this->Modified();
    }
  }
}

vtkCxxSetSmartPointerMacro(vtkSubdivisionCageSource, Controller, vtkMultiProcessController);

vtkMultiProcessController* vtkSubdivisionCageSource::GetController() const
{
  return this->Controller;
}

int vtkSubdivisionCageSource::FillInputPortInformation(int, vtkInformation* info)
{
  return subdivision::TakeTypes(info, { "vtkDataSet", "vtkCompositeDataSet" }, true);
}

int vtkSubdivisionCageSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // All ranks have to come to RequestData, whatever piece they are asked for.
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

/// Each rank reads its own part of the input, whatever it is asked for.
int vtkSubdivisionCageSource::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  if (info)
  {
    vtkMultiProcessController* ranks = this->Controller;
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), ranks ? ranks->GetLocalProcessId() : 0);
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), ranks ? ranks->GetNumberOfProcesses() : 1);
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return 1;
}

bool vtkSubdivisionCageSource::FindBounds(vtkDataObject* input, double* bounds) const
{
  vtkBoundingBox box;
  ForEachDataSet(input, [&box](vtkDataSet* data) { box.AddBounds(data->GetBounds()); });
  // Of an empty box the ends are the largest numbers, the wrong way round.
  double ends[6]; // the lower ones with other signs, so that all are maxima
  for (int axis = 0; axis < 3; ++axis)
  {
    ends[axis] = -box.GetMinPoint()[axis];
    ends[axis + 3] = box.GetMaxPoint()[axis];
  }
  if (this->Controller && this->Controller->GetNumberOfProcesses() > 1)
  {
    const std::vector<double> own(ends, ends + 6);
    this->Controller->AllReduce(own.data(), ends, 6, vtkCommunicator::MAX_OP);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = -ends[axis];
    bounds[2 * axis + 1] = ends[axis + 3];
  }
  return bounds[0] <= bounds[1];
}

std::vector<char> vtkSubdivisionCageSource::FindHugged(
  vtkDataObject* input, const double* bounds, double margin) const
{
  Boxes boxes(this->NumberOfCells);
  ForEachDataSet(input,
    [&](vtkDataSet* data)
    {
      const vtkIdType cells = data->GetNumberOfCells();
      for (const vtkIdType i : subdivision::InTurn(cells + data->GetNumberOfPoints()))
      {
        double around[6];
        i < cells ? data->GetCellBounds(i, around) : void();
        bool isFinite = true;
        for (int c = 0; c < 6; ++c)
        {
          const int axis = c / 2;
          const double x = i < cells ? around[c] : data->GetPoint(i - cells)[axis];
          const double length = bounds[2 * axis + 1] - bounds[2 * axis];
          const double wide = margin / length + HuggedBoxes / this->NumberOfCells[axis];
          around[c] = (x - bounds[2 * axis]) / length + (c % 2 == 0 ? -wide : wide);
          isFinite = isFinite && std::isfinite(around[c]);
        }
        isFinite ? boxes.Keep(around) : void();
      }
    });
  if (this->Controller && this->Controller->GetNumberOfProcesses() > 1)
  {
    const std::vector<char> own = boxes.GetKept();
    this->Controller->AllReduce(own.data(), boxes.GetKept().data(),
      static_cast<vtkIdType>(own.size()), vtkCommunicator::MAX_OP);
  }
  boxes.FillCavities();
  boxes.JoinThroughFaces();
  boxes.FillCavities(); // which the joining may have closed
  return boxes.GetKept();
}

int vtkSubdivisionCageSource::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  double bounds[6];
  std::copy(this->Bounds, this->Bounds + 6, bounds);
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  if (input && !this->FindBounds(input, bounds))
  {
    subdivision::Fail(this,
      "The input has no points, so there is nothing to put a cage around. Disconnect it "
      "to have a cage in its Bounds.");
    return 1; // 0 would make the pipeline tell a second error
  }
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    longest = std::max(longest, bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  const double margin = this->Margin / 100. * (longest > 0 ? longest : 1.);
  for (int axis = 0; axis < 3; ++axis)
  {
    // The limit of the cage is up to 5/24 of a cell inside of it. With a quarter of a new cell on
    // each side n cells are as long as the box and half a cell.
    const double length = bounds[2 * axis + 1] - bounds[2 * axis] + 2. * margin;
    const double boxes = input ? (this->Hug ? HuggedBoxes : 0.25) : 0.;
    const double shrinking = boxes * length / (this->NumberOfCells[axis] - 2. * boxes);
    bounds[2 * axis] -= margin + shrinking;
    bounds[2 * axis + 1] += margin + shrinking;
  }
  const int type = this->OutputPointsPrecision == SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE;
  const std::string fault = FindFault(bounds,
    type == VTK_FLOAT ? std::numeric_limits<float>::max() : std::numeric_limits<double>::max());
  if (!fault.empty())
  {
    subdivision::Fail(this, fault);
    return 1;
  }
  auto* output = vtkUnstructuredGrid::GetData(outputVector);
  subdivision::FilterTraits traits;
  traits.Memory = "so many boxes. Make NumberOfCells smaller.";
  subdivision::RunOptions options;
  bool failed = false;
  subdivision::ConnectToFilter(this, options, failed);
  std::vector<char> hugged; // by all ranks together
  const auto hug = [&]
  {
    hugged = this->FindHugged(input, bounds, margin);
    return true;
  };
  const bool hasRanks = this->Controller && this->Controller->GetNumberOfProcesses() > 1;
  const bool isHugged = !this->Hug || !input ||
    (hasRanks ? hug() : subdivision::DoWork(traits, options, hug)); // other ranks wait for this one
  if (isHugged && !hugged.empty() && std::count(hugged.begin(), hugged.end(), 1) == 0)
  {
    options.Fail(
      "No point or cell of the input has finite coordinates alone, so there is nothing to "
      "put a cage around. Repair them, or switch Hug off.");
    return 1;
  }
  vtkInformation* info = outputVector->GetInformationObject(0);
  if (info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1; // the first piece is the whole cage
  }
  const auto make = [&]
  {
    const std::vector<vtkIdType> numbers = NumberPoints(this->NumberOfCells, hugged);
    output->SetPoints(MakePoints(this->NumberOfCells, bounds, type, numbers));
    if (options.Progress(0.2))
    {
      return false;
    }
    output->SetCells(VTK_TETRA, MakeCells(this->NumberOfCells, hugged, numbers));
    return true;
  };
  if (!isHugged || !subdivision::DoWork(traits, options, make))
  {
    output->Initialize();
  }
  return failed ? 0 : 1;
}

void vtkSubdivisionCageSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const int* n = this->NumberOfCells;
  const double* b = this->Bounds;
  os << indent << "NumberOfCells: " << n[0] << " " << n[1] << " " << n[2] << "\n";
  os << indent << "Bounds: " << b[0] << " " << b[1] << " " << b[2] << " " << b[3] << " " << b[4]
     << " " << b[5] << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
  os << indent << "Hug: " << this->Hug << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
}
