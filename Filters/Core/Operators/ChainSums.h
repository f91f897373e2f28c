// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChainSums.h
 * Sums chains: the same terms in the same order as RingSums.h, step by step. For
 * ApplyChains.cxx alone.
 */
#ifndef SubdivisionObjects_ChainSums_h
#define SubdivisionObjects_ChainSums_h

#include "Core/Operators/ChainOperator.h"
#include "Core/Operators/RingSums.h"

#include <limits>

namespace subdivision
{
namespace
{

/// How the sums of a chain are stored.
enum class ChainValues
{
  Small, ///< floating point numbers whose sums cannot overflow
  Any
};

template <int N, typename Id, typename In, typename Out>
class ChainSums
{
public:
  ChainSums(const ChainRows<Id>& rows, const In* in, Out* out, int components)
    : Chains(rows)
    , Values(in)
    , Results(out)
    , Components(components)
    , Stride(N == 0 ? components : N)
    , OfEdge(std::get<MaskTables<Mask>>(rows.Centres.Masks->Tables).Edges.Get(Rule::Curve, 0, None))
    , OfVertex(
        std::get<MaskTables<Mask>>(rows.Centres.Masks->Tables).Vertices.Get(Rule::Curve, 2, None))
    , Nothing()
  {
    this->Nothing.Clear();
  }

  void Run()
  {
    this->StepStars();
    if (this->Chains.NumberOfRuns == 0)
    {
      for (vtkIdType i = 0; i < this->Chains.Centres.Count; ++i)
      {
        this->WriteCentre(i);
      }
    }
    this->StartRuns();
    for (vtkIdType i = 0; i < this->Chains.NumberOfRuns; ++i)
    {
      this->StepRun(i);
    }
  }

private:
  static constexpr int W = Width<N>;

  /// Makes the values that the centres of stars have after each step.
  void StepStars()
  {
    const RingRows<Id>& centres = this->Chains.Centres;
    const vtkIdType size = centres.Count + this->Chains.Spokes.Count;
    Buffer<In> now(size * this->Stride);
    Buffer<In> next(size * this->Stride);
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->Copy(this->GetValue(this->Chains.Columns[i]), now.data() + i * this->Stride);
    }
    const vtkIdType values = centres.Count * this->Stride;
    this->OfCentres = Buffer<In>(this->Chains.StepsOfStars * values);
    for (int step = 0; step < this->Chains.StepsOfStars; ++step)
    {
      SumBlock<N>(centres, now.data(), next.data(), this->Components);
      SumBlock<N>(this->Chains.Spokes, now.data(), next.data(), this->Components);
      std::copy_n(next.data(), values, this->OfCentres.data() + step * values);
      std::swap(now, next);
    }
  }
  /// The values of a centre after a step, the first of which is step 1.
  const In* GetCentre(vtkIdType star, int step) const
  {
    return this->OfCentres.data() + ((step - 1) * this->Chains.Centres.Count + star) * this->Stride;
  }
  void WriteCentre(vtkIdType star)
  {
    this->Copy(
      this->GetCentre(star, this->Chains.Steps), this->GetResult(this->Chains.Columns[star]));
  }

  /// Makes room for the longest run.
  void StartRuns()
  {
    vtkIdType longest = 0;
    for (vtkIdType i = 0; i < this->Chains.NumberOfRuns; ++i)
    {
      longest = std::max(longest, this->Chains.Runs[i].Count);
    }
    const vtkIdType points = (longest << (this->Chains.Steps - 1)) + 1;
    this->Now = Buffer<In>(points * this->Stride);
    this->Next = Buffer<In>(points * this->Stride);
  }

  void StepRun(vtkIdType i)
  {
    this->ReadRun(this->Chains.Runs[i]);
    bool isSmall = AreSmall(this->Now.data(), (this->Chains.Runs[i].Count + 1) * this->Stride);
    for (int step = 1; step < this->Chains.Steps; ++step)
    {
      isSmall = isSmall && AreSmall(this->GetCentre(2 * i, step), 2 * this->Stride);
    }
    isSmall ? this->StepRun<ChainValues::Small>(i) : this->StepRun<ChainValues::Any>(i);
  }

  template <ChainValues Kind>
  void StepRun(vtkIdType i)
  {
    const EdgeRun& run = this->Chains.Runs[i];
    vtkIdType edges = run.Count;
    for (int step = 1; step < this->Chains.Steps; ++step, edges *= 2)
    {
      const In* from = this->Now.data();
      In* to = this->Next.data();
      this->SumMidpoints<Kind>(from, edges, to + this->Stride, 2);
      this->SumVertices<Kind>(from + this->Stride, 1, edges - 1, to + 2 * this->Stride, 2);
      this->Copy(this->GetCentre(2 * i, step), to);
      this->Copy(this->GetCentre(2 * i + 1, step), to + 2 * edges * this->Stride);
      std::swap(this->Now, this->Next);
    }
    this->StepLast<Kind>(run);
    if (run.HasEnd)
    {
      this->WriteCentre(2 * i + 1);
    }
  }

  /// The last step of a run: each point to its row.
  template <ChainValues Kind>
  void StepLast(const EdgeRun& run)
  {
    const In* from = this->Now.data();
    const int last = this->Chains.Steps - 1;
    this->SumMidpoints<Kind>(from, run.Count << last, this->GetResult(this->GetRow(run, last)), 1);
    for (int step = 0; step < last; ++step) // the new points of earlier steps
    {
      const vtkIdType apart = vtkIdType(1) << (last - step);
      this->SumVertices<Kind>(from + apart / 2 * this->Stride, apart, run.Count << step,
        this->GetResult(this->GetRow(run, step)), 1);
    }
    for (vtkIdType i = 1; i < run.Count; ++i) // the vertices
    {
      this->SumVertices<Kind>(from + (i << last) * this->Stride, 1, 1,
        this->GetResult(this->Chains.Ends[2 * (run.FirstEdge + i)]), 1);
    }
  }

  /// The first row of the points of a run that a step makes.
  vtkIdType GetRow(const EdgeRun& run, int step) const
  {
    const vtkIdType before = (vtkIdType(1) << step) - 1;
    return this->Chains.NumberOfVertices + before * this->Chains.NumberOfEdges +
      (run.FirstEdge << step);
  }

  void ReadRun(const EdgeRun& run)
  {
    const Id* ends = this->Chains.Ends + 2 * run.FirstEdge;
    this->Copy(this->GetValue(ends[0]), this->Now.data());
    for (vtkIdType i = 0; i < run.Count; ++i)
    {
      this->Copy(this->GetValue(ends[2 * i + 1]), this->Now.data() + (i + 1) * this->Stride);
    }
  }

  /// Whether values are so small that no sum overflows.
  static bool AreSmall(const In* values, vtkIdType size)
  {
    if constexpr (std::is_floating_point<In>::value)
    {
      constexpr In most = std::numeric_limits<In>::max() / 16;
      bool large = false;
      for (vtkIdType i = 0; i < size; ++i)
      {
        large |= !(std::abs(values[i]) <= most); // true for what is not a number
      }
      return !large;
    }
    else
    {
      return true;
    }
  }

  /// The midpoints of consecutive edges, to each `apart`-th place.
  template <ChainValues Kind, typename To>
  void SumMidpoints(const In* from, vtkIdType edges, To* to, vtkIdType apart) const
  {
    const vtkIdType stride = this->Stride;
    const Mask mask = this->OfEdge;
    Sums<W> sum;
    for (vtkIdType i = 0; i < edges; ++i)
    {
      ForGroups<N>(stride,
        [&](int first)
        {
          sum.Set(from + first);
          sum.Add(from + stride + first);
          sum.Scale(mask.Own);
          sum.Add(mask.Ring, this->Nothing);
          this->StoreSum<Kind>(sum, to + first,
            [&](int c)
            {
              return SumTermByTerm(MakeParted(mask, 0), from + first + c, from + stride + first + c,
                static_cast<const Id*>(nullptr), from, stride);
            });
        });
      from += stride;
      to += apart * stride;
    }
  }

  /// Points between two others, of each `apart`-th place, to each `apartTo`-th place.
  template <ChainValues Kind, typename To>
  void SumVertices(
    const In* from, vtkIdType apart, vtkIdType points, To* to, vtkIdType apartTo) const
  {
    static constexpr Id ring[2] = { 0, 2 }; // seen from the point before
    const vtkIdType stride = this->Stride;
    const Mask mask = this->OfVertex;
    Sums<W> sum;
    Sums<W> section;
    for (vtkIdType i = 0; i < points; ++i)
    {
      if (mask.Ring == 0.) // 0 times infinity is not 0
      {
        this->Copy(from, to);
      }
      else
      {
        ForGroups<N>(stride,
          [&](int first)
          {
            section.Clear();
            section.Add(from - stride + first);
            section.Add(from + stride + first);
            sum.Set(from + first);
            sum.Scale(mask.Own);
            sum.Add(mask.Ring, section);
            this->StoreSum<Kind>(sum, to + first,
              [&](int c)
              {
                return SumTermByTerm(MakeParted(mask, 2), from + first + c,
                  static_cast<const In*>(nullptr), ring, from - stride + first + c, stride);
              });
          });
      }
      from += apart * stride;
      to += apartTo * stride;
    }
  }

  template <ChainValues Kind, typename To, typename Instead>
  static void StoreSum(const Sums<W>& sum, To* to, const Instead& instead)
  {
    if constexpr (Kind == ChainValues::Any)
    {
      StoreSums(sum, to, instead);
    }
    else if constexpr (std::is_same<In, To>::value && std::is_floating_point<To>::value)
    {
      for (int c = 0; c < W; ++c)
      {
        to[c] = static_cast<To>(sum[c]);
      }
    }
    else
    {
      sum.Write(to);
    }
  }

  template <typename To>
  void Copy(const In* from, To* to) const
  {
    CopyValues(from, N == 0 ? this->Stride : N, to); // a length that the compiler knows
  }
  const In* GetValue(vtkIdType column) const { return this->Values + column * this->Stride; }
  Out* GetResult(vtkIdType row) const { return this->Results + row * this->Stride; }

  const ChainRows<Id>& Chains;
  const In* Values;
  Out* Results;
  const int Components;
  const vtkIdType Stride;
  Mask None = {};
  const Mask OfEdge;
  const Mask OfVertex;
  Sums<W> Nothing;
  Buffer<In> OfCentres;
  Buffer<In> Now;
  Buffer<In> Next;
};

template <int N, typename Id, typename In, typename Out>
void SumChains(const ChainRows<Id>& rows, const In* in, Out* out, int components)
{
  ChainSums<N, Id, In, Out>(rows, in, out, components).Run();
}

}

}

#endif
