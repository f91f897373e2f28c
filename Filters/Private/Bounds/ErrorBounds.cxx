// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/ErrorBounds.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Bounds/Deviations.h"
#include "Private/Bounds/NestedPieces.h"
#include "Private/Bounds/Sectors.h"
#include "Private/Bounds/StepFactors.h"
#include "Private/Bounds/ThirdsReader.h"
#include "Private/Bounds/TightenBounds.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Reading/CellReader.h"
#include "Private/Run/SizeChecks.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace subdivision
{
namespace
{

constexpr int LastStep = NestedPieces::Steps;

/// Whether an array of the points is one of the distances that this file adds.
bool IsDistance(const std::string& name)
{
  const std::string end = SmoothingDistanceName;
  return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

bool IsOfNumbers(vtkDataArray* array)
{
  return array && array->GetName() &&
    (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE);
}

Buffer<double> ReadValues(vtkDataArray* array)
{
  const vtkSmartPointer<vtkDataArray> contiguous = Contiguous(array);
  Buffer<double> values(array->GetNumberOfValues());
  const void* from = contiguous->GetVoidPointer(0);
  array->GetDataType() == VTK_FLOAT
    ? CopyInThreads(static_cast<const float*>(from), values.size(), values.data())
    : CopyInThreads(static_cast<const double*>(from), values.size(), values.data());
  return values;
}

vtkSmartPointer<vtkDoubleArray> MakeResult(const std::string& name, vtkIdType size)
{
  auto result = vtkSmartPointer<vtkDoubleArray>::New();
  result->SetName(name.c_str());
  result->SetNumberOfTuples(size);
  return result;
}

class BoundMaker
{
public:
  BoundMaker(const BoundedRun& run, const RunOptions& options)
    : Given(run)
    , Options(options)
    , Quiet(options)
  {
    this->Quiet.Warn = [](const std::string&) {}; // the run before has told all
    this->Quiet.Fail = [this](const std::string& error)
    {
      this->Options.Fail("GenerateErrorBounds makes a mesh of " +
        std::to_string(this->GetLevel(LastStep) - this->Given.Levels) + " more levels. " + error);
    };
    this->Quiet.GenerateOriginalIds = this->Quiet.GenerateGlobalIds = false;
    this->Quiet.OutputPointsPrecision = vtkAlgorithm::DOUBLE_PRECISION;
  }
  /// Returns false after an error, or a stop.
  bool Add()
  {
    this->Others = this->Options.Others;
    if (this->Others && !this->Given.KnowsParts)
    {
      return this->Refuse("This filter makes error bounds in one process only");
    }
    if (this->Options.HasMaterialFields)
    {
      return this->Refuse("Values that jump at interfaces have no error bounds");
    }
    if (!this->HasMemory())
    {
      return false;
    }
    const auto control = this->Given.Subdivide(0, false, this->Quiet, nullptr);
    const auto limit = control ? this->Given.Subdivide(0, true, this->Quiet, nullptr) : nullptr;
    const int levels = this->GetLevel(LastStep);
    const auto fine =
      limit ? this->Given.Subdivide(levels, false, this->GetAlone(), &this->Factors) : nullptr;
    if (!fine)
    {
      return false;
    }
    if (this->Factors.GetOperations().size() != static_cast<std::size_t>(levels))
    {
      return this->Refuse(Seams); // the mesh is the whole
    }
    const std::unique_ptr<NestedPieces> made = this->MakePieces(fine, control);
    if (!made)
    {
      return false;
    }
    const NestedPieces& pieces = *made;
    const auto reason = static_cast<Reasons>(this->FindLargest(this->FindReason(pieces)));
    if (reason != None)
    {
      return this->Refuse(reason);
    }
    const Sectors::Step last =
      ListFactors(this->Factors, this->GetLevel(LastStep - 1), this->GetLevel(LastStep));
    const Sectors sectors(pieces, last);
    const SteppedPieces stepped{ pieces, sectors, last };
    if (!this->AddBounds(
          stepped, control->GetPoints()->GetData(), this->Given.Output->GetPoints()->GetData(), ""))
    {
      return false;
    }
    this->AddDistances(
      this->Given.Input->GetPoints()->GetData(), limit->GetPoints()->GetData(), "");
    vtkPointData* given = this->Given.Input->GetPointData();
    std::vector<vtkDataArray*> arrays;
    for (int a = 0; a < given->GetNumberOfArrays(); ++a)
    {
      arrays.push_back(given->GetArray(a));
    }
    for (vtkDataArray* array : arrays)
    {
      if (!IsOfNumbers(array) || IsDistance(array->GetName()) || array == given->GetNormals())
      {
        continue;
      }
      const char* name = array->GetName();
      vtkDataArray* of[3] = { this->Given.Output->GetPointData()->GetArray(name),
        control->GetPointData()->GetArray(name), limit->GetPointData()->GetArray(name) };
      if (std::all_of(std::begin(of), std::end(of), IsOfNumbers))
      {
        if (!this->AddBounds(stepped, of[1], of[0], name))
        {
          return false;
        }
        this->AddDistances(array, of[2], name);
      }
    }
    return true;
  }

private:
  /// Why there are no bounds, the last of all partitions' reasons.
  enum Reasons : int
  {
    None,
    NotNested,
    NotThirds,
    ModifiedCentres,
    NegativeWeights,
    Sharp,
    Seams
  };
  Reasons FindReason(const NestedPieces& pieces) const
  {
    if (this->Factors.GetNumberOfSharpSteps() > this->GetLevel(1))
    {
      return Sharp;
    }
    if (this->HasNegativeWeights())
    {
      return NegativeWeights;
    }
    if (this->Given.SubdividePlain && !this->IsPlain())
    {
      return ModifiedCentres;
    }
    const Reasons other = this->Given.HasThirds ? NotThirds : NotNested;
    return pieces.AreOf(this->Given.Output) ? None : other;
  }

  /// Warns that there are no bounds.
  bool Refuse(const std::string& reason) const
  {
    this->Options.Warn(reason + ": GenerateErrorBounds is ignored.");
    return true;
  }
  bool Refuse(Reasons reason) const
  {
    switch (reason)
    {
      case Seams:
        return this->Refuse("Seams of texture coordinates that are joined have no error bounds "
                            "(switch JoinSeams off)");
      case Sharp:
        return this->Refuse(
          "A crease is still sharp for more than one level after the last, so that "
          "there are no error bounds (take more levels, or infinite sharpness)");
      case NegativeWeights:
        return this->Refuse(
          "Rules with negative weights have no error bounds (set FlatnessArray, or "
          "take another scheme)");
      case ModifiedCentres:
        return this->Refuse("The rules of sqrt(3) that follow the number of triangles at borders "
                            "and creases have no error bounds (switch ModifiedBoundary off)");
      case NotThirds:
        return this->Refuse(
          "Cells of sqrt(3) have no error bounds at fixed edges after an odd number "
          "of levels, and where they are no triangles (take an even number)");
      default:
        return this->Refuse("Faces that are no quads, and lines of several pieces, have no error "
                            "bounds on level 0 (take a level)");
    }
  }

  /// Whether the steps to the level after two more have the plain rules.
  bool IsPlain() const
  {
    const auto levels = static_cast<std::size_t>(this->GetLevel(2));
    MatrixFactors plain;
    const auto made =
      this->Given.SubdividePlain(static_cast<int>(levels), this->GetAlone(), &plain);
    if (!made || plain.GetOperations().size() != levels)
    {
      return false;
    }
    Buffer<double> values(this->Given.Input->GetNumberOfPoints());
    ForEach(values.size(), [&](vtkIdType i) { values[i] = std::sin(static_cast<double>(i) + 1.); });
    const Buffer<double> own = ApplyFactors(ListFactors(this->Factors, 0, levels), values, 1);
    const Buffer<double> other = ApplyFactors(ListFactors(plain, 0, levels), values, 1);
    return own.size() == other.size() && std::equal(own.begin(), own.end(), other.begin());
  }

  /// The largest that a partition has.
  double FindLargest(double value) const
  {
    std::vector<double> values{ value };
    if (this->Others)
    {
      this->Others->FindLargest(values);
    }
    return values[0];
  }
  /// For operators, which do not depend on other partitions.
  RunOptions GetAlone() const
  {
    RunOptions alone = this->Quiet;
    alone.Others = nullptr;
    alone.Interpolation = InterpolationOptions();
    return alone;
  }
  /// The level after a step of the pieces. With thirds step 1 does nothing.
  int GetLevel(int step) const
  {
    return this->Given.Levels + (this->Given.HasThirds ? 2 * std::max(step - 1, 0) : step);
  }
  /// Pieces of thirds are few after two steps, and their deviations may be 0 at all of their
  /// points.
  int GetStepOfLimits() const { return this->Given.HasThirds ? LastStep : LastStep - 1; }
  /// Returns null after an error, or a stop.
  std::unique_ptr<NestedPieces> MakePieces(vtkPointSet* fine, vtkPointSet* control) const
  {
    if (this->Given.HasThirds)
    {
      return ReadThirds(
        [&](int steps) -> vtkSmartPointer<vtkPointSet>
        {
          if (steps == 0 || steps == 4)
          {
            return steps == 0 ? this->Given.Output : fine;
          }
          return this->Given.Subdivide(
            this->Given.Levels + steps, false, this->GetAlone(), nullptr);
        });
    }
    std::array<vtkIdType, LastStep + 1> points{};
    for (int step = 0; step <= LastStep; ++step)
    {
      const int last = this->GetLevel(step) - 1;
      points[step] = last < 0
        ? control->GetNumberOfPoints()
        : this->Factors.Get()[this->Factors.GetOperations()[last].End - 1].GetNumberOfRows();
    }
    return std::make_unique<NestedPieces>(
      fine, points, this->Given.IsTetOct ? this->Given.Output : nullptr);
  }

  /// A rough estimate: whether matrices and values of the finest mesh fit beside this mesh.
  bool HasMemory() const
  {
    const CellReader cells(this->Given.Output);
    double counts[4] = { 0., 0., 0., 0. };
    constexpr double placesOfCells[4] = { 1., 10., 81., 165. }; // of a quad, not fewer
    const double cuts =
      this->Given.HasThirds ? PieceLattice::DivisionsInThirds : PieceLattice::Divisions;
    double pieces = 0.;
    double places = 0.;
    std::vector<vtkIdType> scratch;
    for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
    {
      const int type = cells.GetGridType(c, cells.GetCell(c, scratch).Size);
      const int dimension = type == VTK_TETRA ? 3
        : type == VTK_LINE                    ? 1
        : type == VTK_VERTEX                  ? 0
                                              : 2;
      const double children = std::pow(cuts, dimension);
      counts[dimension] += children;
      pieces += children;
      places += placesOfCells[dimension];
    }
    const double points = static_cast<double>(this->Given.Output->GetNumberOfPoints()) + counts[1] +
      counts[2] + counts[3] / 5.;
    int components = 3;
    for (int a = 0; a < this->Given.Output->GetPointData()->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* array = this->Given.Output->GetPointData()->GetArray(a);
      components = array ? std::max(components, array->GetNumberOfComponents()) : components;
    }
    constexpr double bytesOfRow = 16. * 24.; // of steps as they are, and as matrices
    const double bytes = points * (bytesOfRow + 64. * components) + 48. * pieces +
      places * (40. + 24. * (2. * components + 1.));
    const std::string tooLarge = CheckMemory(pieces, points, bytes, this->GetLevel(LastStep));
    if (!tooLarge.empty())
    {
      this->Quiet.Fail(tooLarge);
    }
    return tooLarge.empty();
  }
  bool HasNegativeWeights() const
  {
    const auto& factors = this->Factors.Get();
    return std::any_of(factors.begin(), factors.end(),
      [](const MatrixFactors::Matrix& factor)
      {
        return std::any_of(
          factor.Weights.begin(), factor.Weights.end(), [](double w) { return w < 0.; });
      });
  }

  /// The values after a level, from values after another one.
  Buffer<double> Apply(int from, int to, const Buffer<double>& values, int components) const
  {
    return ApplyFactors(ListFactors(this->Factors, from, to), values, components);
  }
  /// Finds the rows of limits, once. Returns false after an error, or a stop.
  bool FindLimits()
  {
    if (this->AreLimitsFound)
    {
      return true;
    }
    this->AreLimitsFound = true;
    const int levels = this->GetLevel(this->GetStepOfLimits());
    const auto made = this->Given.Subdivide(levels, true, this->GetAlone(), &this->Limits);
    if (this->Limits.GetOperations().size() != static_cast<std::size_t>(levels) + 1)
    {
      this->Limits = MatrixFactors(); // a scheme whose points are on the limit
    }
    return made != nullptr;
  }

  Buffer<double> FindLimitsOf(const Buffer<double>& values, int components) const
  {
    const std::size_t size = this->Limits.GetOperations().size();
    return ApplyFactors(ListFactors(this->Limits, size - 1, size), values, components);
  }
  std::unique_ptr<PartsAsCells> Split(
    const SteppedPieces& from, const std::vector<PartsAsCells::Part>& wanted) const
  {
    if (!this->Given.HasThirds)
    {
      return SplitIntoHalves(from, wanted);
    }
    return SplitIntoThirds(from, wanted,
      [this](vtkPolyData* patch, int levels, MatrixFactors* factors)
      { return this->Given.SubdividePatch(patch, levels, this->GetAlone(), factors); });
  }
  /// `shown`: values of the output that follow from the control points. Returns false after an
  /// error, or a stop.
  bool AddBounds(const SteppedPieces& pieces, vtkDataArray* control, vtkDataArray* shown,
    const std::string& name)
  {
    const int components = control->GetNumberOfComponents();
    const Buffer<double> given = ReadValues(control);
    const std::array<int, LastStep> levels{ { this->GetLevel(1), this->GetLevel(2),
      this->GetLevel(3) } };
    const Buffer<double> next = this->Apply(0, levels[0], given, components);
    // All later values are means of these.
    double largest = 0.;
    for (const double value : InTurn(given))
    {
      largest = std::isfinite(value) ? std::max(largest, std::abs(value)) : largest;
    }
    largest = this->FindLargest(largest);
    const Buffer<double> values = ReadValues(shown);
    const Buffer<double> second = this->Apply(levels[0], levels[1], next, components);
    const Buffer<double> third = this->Apply(levels[1], levels[2], second, components);
    const BoundedValues bounded{ components, values.data(), next, second, third,
      [&](const Buffer<double>& before)
      { return this->Apply(levels[1], levels[2], before, components); },
      64. * std::numeric_limits<double>::epsilon() * largest };
    const vtkIdType cells = pieces.Pieces.GetNumberOfCells();
    std::vector<vtkIdType> all(static_cast<std::size_t>(cells));
    std::iota(all.begin(), all.end(), vtkIdType(0));
    std::vector<CellBound> found = FindBounds(pieces.Pieces, pieces.AllSectors, bounded, all);
    if (std::any_of(found.begin(), found.end(),
          [](const CellBound& bound) { return !bound.OfPieces.empty(); }))
    {
      if (!this->FindLimits())
      {
        return false;
      }
      const bool hasLimits = !this->Limits.GetOperations().empty();
      const bool isDone = TightenBounds(
        pieces, [this](const SteppedPieces& from, const std::vector<PartsAsCells::Part>& wanted)
        { return this->Split(from, wanted); }, bounded,
        hasLimits ? this->FindLimitsOf(this->Given.HasThirds ? third : second, components)
                  : Buffer<double>(),
        found);
      if (!isDone)
      {
        return false;
      }
    }
    const auto bounds = MakeResult(name + ErrorBoundName, cells);
    ForEach(cells, [&](vtkIdType c) { bounds->SetValue(c, found[c].Largest); });
    this->Given.Output->GetCellData()->AddArray(bounds);
    return true;
  }
  /// `given` are values of points of the input, which come first in the output.
  void AddDistances(vtkDataArray* given, vtkDataArray* limit, const std::string& name)
  {
    const int components = given->GetNumberOfComponents();
    const Buffer<double> from = ReadValues(given);
    const Buffer<double> to = ReadValues(limit);
    const auto distances =
      MakeResult(name + SmoothingDistanceName, this->Given.Output->GetNumberOfPoints());
    distances->Fill(-1.); // as ids of points that the input does not have
    ForEach(given->GetNumberOfTuples(),
      [&](vtkIdType i)
      {
        double squares = 0.;
        for (int c = 0; c < components; ++c)
        {
          const double difference = from[components * i + c] - to[components * i + c];
          squares += difference * difference;
        }
        distances->SetValue(i, std::sqrt(squares));
      });
    this->Given.Output->GetPointData()->AddArray(distances);
  }

  const BoundedRun& Given;
  const RunOptions& Options;
  RunOptions Quiet;
  OtherPartitions* Others = nullptr; ///< null: the mesh is the whole
  MatrixFactors Factors;
  MatrixFactors Limits; ///< the last one is the limit after GetStepOfLimits
  bool AreLimitsFound = false;
};

}

bool AddErrorBounds(const BoundedRun& run, const RunOptions& options)
{
  return BoundMaker(run, options).Add();
}

}
