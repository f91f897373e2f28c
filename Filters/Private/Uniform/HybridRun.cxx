// SPDX-License-Identifier: BSD-3-Clause
// Uniform subdivision in which every cell keeps its type, smooth or linear (Mathematics 15).
#include "Core/Memory/FreedPages.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/Hybrid/HybridLimits.h"
#include "Core/Solids/Hybrid/HybridSkin.h"
#include "Core/Solids/Hybrid/HybridTangents.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/CellArrays.h"
#include "Private/Arrays/PointArrays.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Partitions/SharedNumbers.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Uniform/Classification.h"
#include "Private/Uniform/HybridColours.h"
#include "Private/Uniform/HybridFacts.h"
#include "Private/Uniform/HybridKept.h"
#include "Private/Uniform/HybridNumbers.h"
#include "Private/Uniform/HybridOutput.h"
#include "Private/Uniform/HybridPlaceRun.h"
#include "Private/Uniform/HybridSizes.h"
#include "Private/Uniform/HybridStamp.h"
#include "Private/Uniform/OperatorCache.h"
#include "Private/Uniform/UniformCells.h"
#include "Private/Values/SharedInterpolation.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

namespace subdivision
{
namespace
{

template <typename Id>
class HybridRun
{
public:
  HybridRun(vtkPointSet* input, const UniformOptions& options, HybridCells& cells,
    HybridStamp& stamp, vtkUnstructuredGrid* output)
    : Input(input)
    , Options(options)
    , Output(output)
    , Rules(options.Scheme == StampScheme::Linear ? HybridRules::Linear : HybridRules::Smooth)
    , Given(cells)
    , Sources(std::move(cells.Sources))
    , Centres(std::move(cells.Centres))
    , CentreSources(std::move(cells.CentreSources))
    , Others(options.GenerateGlobalIds ? options.Others : nullptr)
    , Stamp(std::move(stamp))
  {
    this->Last.Cells = ListCells<Id>(cells);
  }

  /// Returns false after an error, or if Progress asks to stop.
  bool Run()
  {
    this->Centres.Simplices.NumberOfPoints = this->Last.Cells.NumberOfPoints;
    if (this->Options.Factors)
    {
      AppendCentres(this->Centres, *this->Options.Factors);
    }
    const bool goesOn = this->Options.Levels > 0 && this->Stamp.MadeLevels > 0 &&
      RestoreHybridLevel(this->Stamp, this->Last.Cells, this->Input, this->Options, this->Level);
    if (!goesOn)
    {
      this->Stamp = HybridStamp();
      this->Stamp.NumberOfControlPoints = this->Last.Cells.NumberOfPoints;
      this->Stamp.GlobalIds =
        ReadIdsOf(this->Input->GetPointData(), this->Input->GetNumberOfPoints());
    }
    std::vector<std::string> replaced;
    if (this->Options.GenerateClassification)
    {
      replaced = { RuleName, TypeName };
    }
    this->Points = StartPointArrays(this->Options, this->Input, this->Centres,
      this->Stamp.GlobalIds, goesOn, this->Options.Warn, replaced);
    if (this->Others)
    {
      this->Places = PlaceCells(this->Input, *this->Others);
      this->Numbers.Points = NumberPoints(this->Input->GetNumberOfPoints(), *this->Others);
      this->Numbers.Points.Add(
        MakeKeysOfPieces(this->CentreSources, this->Places, *this->Others), *this->Others);
    }
    KeepColours(this->Input, this->Last.Cells, this->Sources, *this->Points);
    const bool needsLevel = this->Options.Levels > 0 || MakesLastLevel(this->Options) ||
      this->Options.Interpolation.IsOn();
    if (needsLevel)
    {
      if (!this->Start(goesOn))
      {
        return false;
      }
      if (this->Options.Places)
      {
        return FindPlacesKeepingTypes(
          this->GetLevel(0), this->Sources, this->Input, this->Options, *this->Points);
      }
      if (!this->Step())
      {
        return false;
      }
    }
    this->Write();
    this->Keep();
    return true;
  }

private:
  /// The levels that are kept, or the current one.
  const HybridLevel<Id>& GetLevel(int step) const
  {
    return this->Found ? this->Found->Levels[static_cast<std::size_t>(step)] : this->Level;
  }

  /// Finds or builds the first level. Returns false after an error.
  bool Start(bool isRestored)
  {
    const bool keeps = this->Options.Cache && !isRestored && !this->Others &&
      this->Options.Levels > 0 && !MakesLastLevel(this->Options);
    this->Found = keeps ? this->FindKept() : nullptr;
    if (!this->Found && !isRestored)
    {
      this->Made = keeps ? std::make_unique<KeptHybrid<Id>>() : nullptr;
      this->Build();
    }
    if (!this->Options.Places && !this->PlanLast())
    {
      return false;
    }
    if (this->Rules == HybridRules::Smooth)
    {
      if (!isRestored)
      {
        TellOpenPoints(this->GetLevel(0).Complex, this->Sources, this->Options.Features,
          this->Points->GetCoordinates(), this->Options.Warn);
      }
      this->DescribeControl(this->GetLevel(0).Complex);
      this->StartFrames();
      this->Interpolate();
    }
    return true;
  }

  /// Decides whether the last level is made. Returns false after an error.
  bool PlanLast()
  {
    const bool isForPicture = this->Options.NormalsWhereSmooth;
    this->Options.GenerateLimitNormals = this->Options.GenerateLimitNormals &&
      (!isForPicture || (this->HasRules() && LooksSmooth(this->GetLevel(0), this->Options.Levels)));
    std::string error = this->PlanFrames();
    if (isForPicture &&
      (!error.empty() || (this->Plan.MakesLast && !MakesLastLevel(this->Options))))
    {
      this->Options.GenerateLimitNormals = false; // they are dear, or there is no memory for them
      error = this->PlanFrames();
    }
    this->Made = this->Plan.MakesLast ? nullptr : std::move(this->Made);
    error.empty() ? void() : this->Options.Fail(error);
    return error.empty();
  }

  /// Returns a text if there is no memory for normals and tangents.
  std::string PlanFrames()
  {
    this->Plan = PlanHybrid(this->GetLevel(0), this->Options);
    double corners = 0.;
    return this->Options.HasFrames()
      ? CheckHybridSize(this->Input, this->Given, this->Options, this->Plan, corners)
      : std::string();
  }

  void Build()
  {
    this->Level.Complex = BuildCellComplex(std::move(this->Last.Cells));
    HybridChoices choices;
    if (this->Rules == HybridRules::Smooth)
    {
      ReadHybridChoices(this->Level.Complex, this->Sources, this->Input, this->Options.Features,
        this->Points->GetCoordinates(), 0, {}, this->Options.Warn, choices);
      DecideStrata(this->Level, choices);
      this->Stamp.Derived = choices.Derived;
    }
    if (this->Made)
    {
      this->Made->Choices = std::move(choices);
      this->Made->ControlSources = this->Sources;
      this->Made->Colours = ReadColours(this->Input, this->Sources, *this->Points);
    }
  }

  /// Makes all steps, and takes what is wanted of the last level. Returns false if Progress asks to
  /// stop.
  bool Step()
  {
    const int levels = this->Options.Levels;
    for (int step = 1; step <= levels; ++step)
    {
      if (this->Options.Progress && this->Options.Progress(step / (levels + 1.)))
      {
        return false;
      }
      this->Advance(this->GetLevel(step - 1), step);
      if (step == levels && !this->Plan.MakesLast)
      {
        this->EndStep(this->GetLevel(step - 1).Complex);
      }
      else
      {
        this->GiveToChildren(this->GetLevel(step - 1).Complex.Cells);
        this->Refine();
        KeepColours(this->Input, this->GetLevel(step).Complex.Cells, this->Sources, *this->Points);
      }
    }
    this->FindLimits();
    return true;
  }

  void Refine()
  {
    if (!this->Found)
    {
      HybridLevel<Id> next = RefineHybrid(this->Level, this->Rules);
      if (this->Made)
      {
        this->Made->Levels.push_back(std::move(this->Level));
      }
      this->Level = std::move(next);
    }
  }

  /// The data that the children of the last level need while they are no level.
  void EndStep(const CellComplex<Id>& complex)
  {
    if (this->Points->HasWeights())
    {
      KeepColours(this->Input, SplitCells(complex),
        GiveTo(FindFirstChildren(complex.Cells), this->Sources), *this->Points);
    }
  }

  /// Takes points and arrays to the next level.
  void Advance(const HybridLevel<Id>& level, int step)
  {
    const HybridRows<Id> rows(level, this->Rules);
    if (this->Others)
    {
      NumberNewPoints(
        level.Complex, this->Sources, this->Places, *this->Others, this->Numbers.Points);
    }
    if (this->Options.Factors)
    {
      this->Options.Factors->Append(rows);
      if (!level.Sharpness.Stages.empty())
      {
        this->Options.Factors->SetNumberOfSharpSteps(step);
      }
    }
    this->Points->Advance(rows,
      [&](vtkIdType row)
      {
        return rows.FindOrigin(
          row, [this](vtkIdType a, vtkIdType b) { return this->Points->IsEarlier(a, b); });
      });
  }

  /// The kept data of this mesh; null: there are none.
  KeptHybrid<Id>* FindKept()
  {
    const std::vector<int> colours = ReadColours(this->Input, this->Sources, *this->Points);
    std::vector<std::string> warnings;
    UniformOptions needed = this->Options; // normals for a picture alone never need the last level
    needed.GenerateLimitNormals = needed.GenerateLimitNormals && !needed.NormalsWhereSmooth;
    auto* found = this->Options.Cache->template FindUnused<KeptHybrid<Id>>(
      [&](const KeptHybrid<Id>& kept)
      {
        if (kept.Rules != this->Rules ||
          static_cast<int>(kept.Levels.size()) != this->Options.Levels ||
          kept.Use32BitIds != this->Options.Use32BitIds || kept.Colours != colours ||
          kept.ControlSources != this->Sources || !kept.HasCells(this->Last.Cells))
        {
          return false;
        }
        HybridChoices choices;
        warnings.clear();
        if (this->Rules == HybridRules::Smooth)
        {
          ReadHybridChoices(
            kept.Levels.front().Complex, this->Sources, this->Input, this->Options.Features,
            this->Points->GetCoordinates(), 0, {},
            [&warnings](const std::string& warning) { warnings.push_back(warning); }, choices);
        }
        this->Stamp.Derived = choices.Derived;
        return (this->Rules == HybridRules::Linear || choices == kept.Choices) &&
          !PlanHybrid(kept.Levels.front(), needed).MakesLast;
      });
    if (found)
    {
      found->Used = true;
      Tell(warnings, this->Options);
    }
    return found;
  }

  void Keep()
  {
    if (this->Made)
    {
      this->Made->Rules = this->Rules;
      this->Made->Use32BitIds = this->Options.Use32BitIds;
      this->Made->TakeOutput(std::move(this->Written));
      ++this->Options.Cache->NumberOfBuilds;
      this->Options.Cache->Add(std::move(this->Made));
    }
  }

  /// Gives the sources of cells, and the facts about their control cells, to their children.
  void GiveToChildren(const CellList<Id>& cells)
  {
    const Buffer<Id> first = FindFirstChildren(cells);
    this->Sources = GiveTo(first, this->Sources);
    this->Dimensions = GiveTo(first, this->Dimensions);
    this->Signs = GiveTo(first, this->Signs);
    this->Controls = GiveTo(first, this->Controls);
  }

  void DescribeControl(const CellComplex<Id>& complex)
  {
    this->Signs = FindOrientations(complex.Cells, this->Points->GetCoordinates());
    if (this->Options.GenerateClassification)
    {
      this->Dimensions = FindMaximalDimensions(complex);
    }
  }

  void Interpolate()
  {
    if (this->Options.Interpolation.IsOn())
    {
      InterpolationLimits limits = GetInterpolationLimits(this->GetLevel(0).Complex.Cells);
      ConnectToOthers(this->Input, this->Centres, this->Options, limits);
      this->Points->Interpolate(MakeLimitOperator(this->GetLevel(0)).Store(),
        this->Options.Interpolation, limits, this->Options.Warn);
    }
  }

  /// Decides on the control mesh to which side normals point.
  void StartFrames()
  {
    if (!this->Options.HasFrames())
    {
      return;
    }
    this->Controls.resize(this->Signs.size());
    std::iota(this->Controls.begin(), this->Controls.end(), vtkIdType(0));
    for (const vtkIdType c : InTurn(this->Controls))
    {
      const signed char sign = this->Signs[static_cast<std::size_t>(c)];
      if (sign < 1 && this->GetLevel(0).Complex.Cells.GetTable(c).Dimension == 3)
      {
        this->Inverted.push_back(2 * c + (sign == 0 ? 1 : 0));
      }
    }
    this->Turned = FindPolygonSides(this->GetLevel(0)).ListTurned();
  }

  /// Takes what is wanted of the last level.
  void FindLimits()
  {
    if (this->Options.HasFrames() && this->HasRules())
    {
      this->ApplyFrames();
    }
    if (this->Options.ProjectToLimit && this->HasRules())
    {
      const BlockOperator<Id> limit = MakeLimitOperator(this->Level);
      if (this->Options.Factors)
      {
        this->Options.Factors->Append(limit);
      }
      this->Points->Project(limit);
    }
  }

  void ApplyFrames()
  {
    KeptHybrid<Id>* const kept = this->Found ? this->Found : this->Made.get();
    LimitOperators<Id> own;
    LimitOperators<Id>& limit = kept ? kept->Limit : own;
    const int levels = this->Options.Levels;
    if (this->Plan.MakesLast)
    {
      limit.Frames.Tangents = BuildHybridTangents(this->Level, this->Controls, levels);
    }
    else if (limit.Frames.Tangents.Sectors.Offsets.empty())
    {
      limit.Frames = BuildHybridSkinTangents(this->GetLevel(levels - 1), this->Controls, levels);
    }
    limit.HasNormals = this->Options.GenerateLimitNormals;
    limit.HasTangents = this->Options.GenerateTangents;
    limit.Apply(*this->Points, this->Inverted, this->Turned);
  }

  // Output.
  void Write()
  {
    this->WriteCells();
    const HybridOutput<Id>& written = this->GetWritten();
    this->Output->SetCells(written.Types, written.Cells);
    this->Points->Finish(this->Output);
    this->WriteCellData(written);
    TellOvershoot(*this->Points, this->Options, this->Output, this->Options.ProjectToLimit);
    FinishArrays(this->Input, this->Options, this->Output);
    const bool goesOn = this->HasRules() && this->Options.Levels > 0 &&
      !this->Options.ProjectToLimit && !this->Options.Interpolation.IsOn();
    WriteHybridStamp(
      this->Stamp, goesOn ? this->Options.Levels : 0, goesOn && this->Options.Others, this->Output);
    if (this->Others)
    {
      this->Numbers.Cells =
        NumberCells(this->Places, GiveTo(written.First, this->Sources), *this->Others);
      this->Numbers.Write(this->Output);
    }
  }

  const HybridOutput<Id>& GetWritten() const
  {
    return this->Found && this->Found->Output.Cells ? this->Found->Output : this->Written;
  }

  void WriteCells()
  {
    bool splits = this->Options.Levels > 0;
    if (splits && this->Plan.MakesLast)
    {
      splits = false;
      this->Last.Cells = std::move(this->Level.Complex.Cells);
    }
    else if (this->Found || this->Made)
    {
      if (this->Made)
      {
        this->Made->Levels.push_back(std::move(this->Level));
      }
      const KeptHybrid<Id>& kept = this->Found ? *this->Found : *this->Made;
      if (kept.Output.Cells)
      {
        const CellComplex<Id>& last = kept.Levels.back().Complex;
        this->AreInverted = FindInverted(SplitCells(last),
          GiveTo(FindFirstChildren(last.Cells), this->Signs), this->Points->GetCoordinates());
        return;
      }
      this->Last = kept.CopyLast();
    }
    else if (splits)
    {
      this->Level.Complex.ForgetIncidences();
      this->Level.Strata = HybridStrata<Id>();
      ReturnFreedPages();
      this->Last = std::move(this->Level.Complex);
    }
    else if (this->Level.Complex.Cells.GetNumberOfCells() > 0)
    {
      this->Last.Cells = std::move(this->Level.Complex.Cells);
    }
    this->Written = WriteHybridCells<Id>(std::move(this->Last), splits, this->Options.Use32BitIds,
      this->Signs, [this] { return this->Points->GetCoordinates(); });
    this->AreInverted = std::move(this->Written.AreInverted);
  }

  void WriteCellData(const HybridOutput<Id>& written)
  {
    CellArrayOptions cells;
    cells.Levels = this->Options.Levels;
    cells.PointsMove = this->Options.MovesPoints();
    cells.OriginalIds = this->Options.GenerateOriginalIds;
    cells.CarryOriginalIds = this->Stamp.MadeLevels > 0 &&
      HasIds(this->Input->GetCellData(), OriginalCellIdsName, this->Input->GetNumberOfCells());
    cells.Replaced = { OctahedraName };
    if (this->Options.GenerateClassification)
    {
      cells.Replaced.insert(cells.Replaced.end(), { DimensionName, InvertedName });
    }
    cells.Warn = this->Options.Warn;
    if (cells.OriginalIds || this->Input->GetCellData()->GetNumberOfArrays() > 0)
    {
      const std::vector<vtkIdType> given = GiveTo(written.First, this->Sources);
      vtkNew<vtkIdTypeArray> sources;
      sources->SetName(OriginalCellIdsName);
      Allocate(sources, 1, this->Output->GetNumberOfCells());
      CopyInThreads(given.data(), static_cast<vtkIdType>(given.size()), sources->GetPointer(0));
      CopyCellArrays(this->Input, sources, cells, this->Output);
    }
    this->Output->GetCellData()->AddArray(written.Octahedra);
    this->Classify(written);
  }

  /// Adds the arrays of GenerateClassification, and warns of solids that are inside out.
  void Classify(const HybridOutput<Id>& written)
  {
    const vtkIdType size = this->Output->GetNumberOfCells();
    InvertedCells found;
    for (const vtkIdType c : InTurn(this->AreInverted.size()))
    {
      if (this->AreInverted[c])
      {
        found.First = found.Count++ == 0 ? c : found.First;
      }
    }
    TellInverted(found, size, this->Options);
    if (this->Options.GenerateClassification && this->HasRules())
    {
      AddRules([this](vtkIdType i) { return this->Level.Strata.Vertices[i].Result; }, this->Input,
        this->Output);
      AddToCells(DimensionName, GiveTo(written.First, this->Dimensions), this->Input, this->Output);
      std::vector<unsigned char> marks(static_cast<std::size_t>(size), 0);
      std::copy(this->AreInverted.begin(), this->AreInverted.end(), marks.begin());
      AddToCells(InvertedName, marks, this->Input, this->Output);
    }
  }
  bool HasRules() const { return this->Rules == HybridRules::Smooth; }

  vtkPointSet* Input;
  UniformOptions Options;
  vtkUnstructuredGrid* Output;
  const HybridRules Rules;
  const HybridCells& Given;
  std::vector<vtkIdType> Sources; ///< the cell of the input of each cell of the current level
  CellComplex<Id> Last;  ///< the level before the output; at first, and without steps, only cells
  HybridLevel<Id> Level; ///< the current one
  HybridPlan Plan;
  // Of the control cell in which each cell lies; empty where nobody asks:
  std::vector<unsigned char> Dimensions; ///< of the maximal cell
  std::vector<signed char> Signs;        ///< of volumes
  std::vector<vtkIdType> Controls;       ///< its number
  Buffer<unsigned char> AreInverted;     ///< cells of the output; empty without signs
  // For normals, as in ComputeLimitNormals, with numbers of control cells:
  std::vector<vtkIdType> Inverted;
  Buffer<unsigned char> Turned;
  SimplicesOfCells Centres;             ///< points that cells of the input need beside its points
  std::vector<vtkIdType> CentreSources; ///< the cell of the input of each
  std::unique_ptr<PointArrays> Points;
  OtherPartitions* Others; ///< null: nobody asks for numbers
  std::vector<vtkIdType> Places;
  WholeNumbers Numbers;
  HybridStamp Stamp; ///< of the input, then of the output
  HybridOutput<Id> Written;
  KeptHybrid<Id>* Found = nullptr;      ///< an earlier execution kept it, and it fits
  std::unique_ptr<KeptHybrid<Id>> Made; ///< for the next execution; null: nothing is kept
};

}

bool RefineKeepingTypes(
  vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output)
{
  const std::vector<vtkIdType> ids = ReadIdsOf(input->GetPointData(), input->GetNumberOfPoints());
  HybridCells cells = ReadHybridCells(input, ids.empty() ? nullptr : ids.data());
  HybridStamp stamp;
  if (options.Scheme != StampScheme::Linear)
  {
    stamp = ReadHybridStamp(input, cells, options.Features);
  }
  Tell(cells.Warnings, options);
  double corners = 0.;
  const HybridPlan plan{ MakesLastLevel(options), 0. };
  const std::string error = CheckHybridSize(input, cells, options, plan, corners);
  if (!error.empty())
  {
    options.Fail(error);
    return false;
  }
  // No table of the last level is larger than its corners.
  return corners < static_cast<double>(LargestSmallId)
    ? HybridRun<int>(input, options, cells, stamp, output).Run()
    : HybridRun<long long>(input, options, cells, stamp, output).Run();
}

}
