// SPDX-License-Identifier: BSD-3-Clause
// The data that a uniform subdivision keeps for the next execution, and its use.
#include "Private/Uniform/UniformRun.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"

#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// A copy that is made in parts, between which the run may report and be stopped.
template <typename T>
std::vector<T> CopyInTurn(const std::vector<T>& values)
{
  constexpr std::size_t most = std::size_t(1) << 20;
  std::vector<T> copy;
  copy.reserve(values.size());
  while (copy.size() < values.size())
  {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(copy.size());
    copy.insert(copy.end(), begin,
      begin + static_cast<std::ptrdiff_t>(std::min(most, values.size() - copy.size())));
    BetweenLoops::Act();
  }
  return copy;
}

}

void AppendCentres(const SimplicesOfCells& cells, MatrixFactors& factors)
{
  const vtkIdType centres = cells.GetNumberOfCentres();
  const vtkIdType points = cells.Simplices.NumberOfPoints - centres;
  const auto members = static_cast<vtkIdType>(cells.CentreMembers.size());
  MatrixFactors::Matrix factor;
  factor.NumberOfColumns = points;
  factor.Offsets = Buffer<long long>(points + centres + 1);
  factor.Columns = Buffer<long long>(points + members);
  factor.Weights = Buffer<double>(points + members, 1.);
  ForEach(points, [&](vtkIdType i) { factor.Offsets[i] = factor.Columns[i] = i; });
  for (const vtkIdType c : InTurn(centres))
  {
    const vtkIdType begin = cells.CentreOffsets[c];
    const vtkIdType size = cells.CentreOffsets[c + 1] - begin;
    factor.Offsets[points + c] = points + begin;
    for (vtkIdType m = begin; m < begin + size; ++m)
    {
      factor.Columns[points + m] = cells.CentreMembers[m];
      factor.Weights[points + m] = 1. / static_cast<double>(size);
    }
  }
  factor.Offsets[points + centres] = points + members;
  factors.Append(std::move(factor));
}

TopologyKey UniformRun::MakeKey() const
{
  TopologyKey key;
  const SimplexList& simplices = this->Mesh.Cells.Simplices;
  key.Simplices.NumberOfPoints = simplices.NumberOfPoints;
  key.Simplices.Dimensions = CopyInTurn(simplices.Dimensions);
  key.Simplices.Connectivity = CopyInTurn(simplices.Connectivity);
  key.Scheme = this->Options.Scheme;
  key.MadeLevels = this->Mesh.MadeLevels;
  key.NumberOfControlPoints = this->Mesh.GetControl().NumberOfPoints;
  key.Levels = this->Options.Levels;
  key.Use32BitIds = this->Options.Use32BitIds;
  key.Wanted = this->Wanted;
  key.Choices = EncodeChoices(this->Options.Features, this->Mesh.Values);
  BetweenLoops::Act();
  key.Choices.push_back(this->Mesh.IsStamped);
  key.Choices.push_back(this->Options.ProjectToLimit);
  key.Choices.push_back(this->Options.GenerateLimitNormals);
  key.Choices.push_back(this->Options.NormalsWhereSmooth);
  key.Choices.push_back(this->Options.GenerateTangents);
  key.Choices.push_back(this->Interpolates());
  key.Choices.push_back(this->Points->HasWeights());
  key.Derived = this->Mesh.Derived;
  return key;
}

/// The kept operator, if the same edges exceed the feature angle as when it was built.
KeptOperator* UniformRun::FindKept(const TopologyKey& key)
{
  KeptOperator* found = this->Options.Cache->FindUnused<KeptOperator>(
    [&](const KeptOperator& kept)
    {
      if (!(kept.Key == key))
      {
        return false;
      }
      const Coordinates points =
        kept.Candidates.empty() ? Coordinates(nullptr) : this->Points->GetCoordinates();
      for (std::size_t i = 0; i < kept.Candidates.size(); ++i)
      {
        if (IsFeature(kept.Candidates[i], points, this->Options.Features.FeatureAngle) !=
          kept.Features[i])
        {
          return false;
        }
      }
      return kept.HasCells();
    });
  if (found)
  {
    found->Used = true;
  }
  return found;
}

void UniformRun::UseKept(KeptOperator& kept)
{
  this->Cells = kept.Cells;
  this->Parents = kept.Parents;
  if (this->ReusesPoints)
  {
    this->Points->ReusePoints(kept.PointsOut);
    this->Points->ReuseLimitNormals(kept.NormalsOut);
  }
  else
  {
    kept.PointsOut = nullptr; // until they belong to PointsIn: memory may not suffice
    kept.NormalsOut = nullptr;
    kept.IsUpright = false;
    kept.PointsIn->DeepCopy(this->Points->GetPoints());
    kept.PointsWeight = this->GetPointsWeight();
  }
  if (kept.Steps)
  {
    this->Interpolate(kept.Steps->GetControlLimit());
    kept.Steps->Apply(*this->Points, this->Mesh.Inverted, this->Turned);
  }
  this->FinishPoints(false);
  kept.HandOut(this->Cells, this->Output);
  if (this->Options.Levels > 0)
  {
    this->AddClassification(kept.Steps->GetLastVertices(), kept.Steps->GetLastEdges());
  }
  else
  {
    this->AddClassification(kept.ControlStrata, Buffer<Stratum>());
  }
  this->Derived = kept.Derived;
  this->Control.ManifoldDimensions = Buffer<unsigned char>(kept.ManifoldDimensions.size());
  std::copy(kept.ManifoldDimensions.begin(), kept.ManifoldDimensions.end(),
    this->Control.ManifoldDimensions.begin());
}

/// Hands out the operators of this run as matrices.
void UniformRun::FindFactors() const
{
  MatrixFactors* factors = this->Options.Factors;
  if (!factors)
  {
    return;
  }
  AppendCentres(this->Mesh.Cells, *factors);
  for (int step = 0; step < this->Options.Levels; ++step)
  {
    if (IsSharpAfter(this->Control.Sharpness, step)) // not known if operators were kept
    {
      factors->SetNumberOfSharpSteps(step + 1);
    }
  }
  const KeptOperator& made = this->Found ? *this->Found : *this->ToKeep;
  if (made.Steps)
  {
    made.Steps->ForEachOperator(
      [factors](const PointOperator& operation) { factors->Append(operation); });
  }
}

/// Stores the operators and cells of this run for the next execution.
void UniformRun::Keep()
{
  if (!this->ToKeep || !this->Options.Cache)
  {
    return;
  }
  this->ToKeep->HasNormals = this->Options.GenerateLimitNormals;
  this->ToKeep->HandOut(this->Cells, this->Output);
  this->ToKeep->Parents = std::move(this->Parents);
  this->ToKeep->Derived = std::move(this->Derived);
  this->ToKeep->ControlDerived = std::move(this->Control.Derived.Tuples);
  this->ToKeep->Candidates = std::move(this->Control.Candidates);
  this->ToKeep->Features = std::move(this->Control.Features);
  this->ToKeep->ManifoldDimensions = std::move(this->Control.ManifoldDimensions);
  this->ToKeep->Sides = std::move(this->Sides);
  this->ToKeep->Warnings = std::move(this->BuildWarnings);
  ++this->Options.Cache->NumberOfBuilds;
  this->Options.Cache->Add(std::move(this->ToKeep));
}

bool UniformRun::FindOperators(UniformOperators& operators)
{
  this->ToKeep = std::make_unique<KeptOperator>();
  if (!this->Plan() || !this->Execute())
  {
    return false;
  }
  this->CheckOrientation();
  operators.Control = std::move(this->Mesh.Cells);
  operators.Steps = std::move(this->ToKeep->Steps);
  operators.Cells = std::move(this->Cells);
  operators.Points = this->Output->GetPoints()->GetData();
  return true;
}

}
