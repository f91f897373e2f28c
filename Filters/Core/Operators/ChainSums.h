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

/// Where the sums of consecutive points go: to one array.
template <int N, typename Out>
class ToArray
{
public:
  ToArray(Out* first, vtkIdType stride)
    : Values(first)
    , Stride(stride)
  {
  }
  /// Goes on by some points.
  void operator+=(vtkIdType points) { this->Values += points * this->Stride; }
  template <typename In>
  void Copy(const In* values) const
  {
    CopyValues(values, N == 0 ? this->Stride : N, this->Values); // a length that the compiler knows
  }
  /// Stores sums of the components from `first` on. Where one is not finite, instead(c) is stored.
  template <ChainValues Kind, typename In, int W, typename Instead>
  void Store(const Sums<W>& sum, int first, const Instead& instead) const
  {
    Out* const to = this->Values + first;
    if constexpr (Kind == ChainValues::Any)
    {
      StoreSums(sum, to, instead);
    }
    else if constexpr (std::is_same<In, Out>::value && std::is_floating_point<Out>::value)
    {
      for (int c = 0; c < W; ++c)
      {
        to[c] = static_cast<Out>(sum[c]);
      }
    }
    else
    {
      sum.Write(to);
    }
  }

private:
  Out* Values;
  vtkIdType Stride;
};

/// The values of one array, N for each point; 0: their number is known at run time only.
template <int N, typename In, typename Out>
struct OneArray
{
  using Value = In;
  static constexpr int Known = N;
  vtkIdType GetStride() const { return N == 0 ? this->Components : N; }
  void Read(vtkIdType column, Value* to) const
  {
    ToArray<N, Value>(to, this->GetStride()).Copy(this->Values + column * this->GetStride());
  }
  ToArray<N, Out> GetResult(vtkIdType row) const
  {
    return { this->Results + row * this->GetStride(), this->GetStride() };
  }

  const In* Values;
  Out* Results;
  int Components;
};

/// Where the sums of consecutive points go: to an array of vectors and one of scalars.
template <typename T>
class ToVectorsAndScalars
{
public:
  ToVectorsAndScalars(T* vectors, T* scalars)
    : Vectors(vectors)
    , Scalars(scalars)
  {
  }
  void operator+=(vtkIdType points)
  {
    this->Vectors += 3 * points;
    this->Scalars += points;
  }
  void Copy(const T* values) const
  {
    std::copy_n(values, 3, this->Vectors);
    *this->Scalars = values[3];
  }
  template <ChainValues Kind, typename In, typename Instead>
  void Store(const Sums<4>& sum, int, const Instead& instead) const
  {
    if (Kind == ChainValues::Any && !sum.IsFinite())
    {
      T values[4];
      StoreSums(sum, values, instead);
      this->Copy(values);
      return;
    }
    for (int c = 0; c < 4; ++c)
    {
      T& value = c < 3 ? this->Vectors[c] : *this->Scalars;
      value = Kind == ChainValues::Any ? subdivision::Store<T>(sum[c]) : static_cast<T>(sum[c]);
    }
  }

private:
  T* Vectors;
  T* Scalars;
};

/// Vectors, such as points, and scalars side by side: compilers sum two numbers at a time. Both are
/// of one type, to which values are rounded after each step.
template <typename T>
struct VectorsAndScalars
{
  using Value = T;
  static constexpr int Known = 4;
  static constexpr vtkIdType GetStride() { return 4; }
  void Read(vtkIdType column, T* to) const
  {
    const T* vector = this->Vectors + 3 * column;
    const T values[4] = { vector[0], vector[1], vector[2], this->Scalars[column] };
    std::copy_n(values, 4, to);
  }
  ToVectorsAndScalars<T> GetResult(vtkIdType row) const
  {
    return { this->VectorResults + 3 * row, this->ScalarResults + row };
  }

  const T* Vectors;
  const T* Scalars;
  T* VectorResults;
  T* ScalarResults;
};

/// `Arrays`: OneArray, or what has the same members.
template <typename Id, typename Arrays>
class ChainSums
{
public:
  ChainSums(const ChainRows<Id>& rows, const Arrays& arrays)
    : Chains(rows)
    , Values(arrays)
    , Stride(arrays.GetStride())
    , OfEdge(std::get<MaskTables<Mask>>(rows.Centres.Masks->Tables).Edges.Get(Rule::Curve, 0, None))
    , OfVertex(
        std::get<MaskTables<Mask>>(rows.Centres.Masks->Tables).Vertices.Get(Rule::Curve, 2, None))
  {
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
  using In = typename Arrays::Value;
  static constexpr int N = Arrays::Known;
  static constexpr int W = Width<N>;
  using ToBuffer = ToArray<N, In>;

  /// Makes the values that the centres of stars have after each step.
  void StepStars()
  {
    const RingRows<Id>& centres = this->Chains.Centres;
    const vtkIdType size = centres.Count + this->Chains.Spokes.Count;
    Buffer<In> now(size * this->Stride);
    Buffer<In> next(size * this->Stride);
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->Values.Read(this->Chains.Columns[i], now.data() + i * this->Stride);
    }
    const auto components = static_cast<int>(this->Stride);
    const vtkIdType values = centres.Count * this->Stride;
    this->OfCentres = Buffer<In>(this->Chains.StepsOfStars * values);
    for (int step = 0; step < this->Chains.StepsOfStars; ++step)
    {
      SumBlock<N>(centres, now.data(), next.data(), components);
      SumBlock<N>(this->Chains.Spokes, now.data(), next.data(), components);
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
    this->Values.GetResult(this->Chains.Columns[star])
      .Copy(this->GetCentre(star, this->Chains.Steps));
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
      const auto to = [this](vtkIdType point)
      { return ToBuffer(this->Next.data() + point * this->Stride, this->Stride); };
      this->SumMidpoints<Kind>(from, edges, to(1), 2);
      this->SumVertices<Kind>(from + this->Stride, 1, edges - 1, to(2), 2);
      to(0).Copy(this->GetCentre(2 * i, step));
      to(2 * edges).Copy(this->GetCentre(2 * i + 1, step));
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
    this->SumMidpoints<Kind>(
      from, run.Count << last, this->Values.GetResult(this->GetRow(run, last)), 1);
    for (int step = 0; step < last; ++step) // the new points of earlier steps
    {
      const vtkIdType apart = vtkIdType(1) << (last - step);
      this->SumVertices<Kind>(from + apart / 2 * this->Stride, apart, run.Count << step,
        this->Values.GetResult(this->GetRow(run, step)), 1);
    }
    const Id* starts = this->Chains.Ends + 2 * run.FirstEdge;
    for (vtkIdType i = 1, next = 1; i < run.Count; i = next) // the vertices, as far as rows follow
    {
      do
      {
        ++next;
      } while (next < run.Count && starts[2 * next] == starts[2 * next - 2] + 1);
      this->SumVertices<Kind>(from + (i << last) * this->Stride, vtkIdType(1) << last, next - i,
        this->Values.GetResult(starts[2 * i]), 1);
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
    this->Values.Read(ends[0], this->Now.data());
    for (vtkIdType i = 0; i < run.Count; ++i)
    {
      this->Values.Read(ends[2 * i + 1], this->Now.data() + (i + 1) * this->Stride);
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
  void SumMidpoints(const In* from, vtkIdType edges, To to, vtkIdType apart) const
  {
    const vtkIdType stride = this->Stride;
    const Mask mask = this->OfEdge;
    double noRing[W]; // what a ring without members adds
    std::fill_n(noRing, W, mask.Ring * 0.);
    Sums<W> sum;
    for (vtkIdType i = 0; i < edges; ++i)
    {
      ForGroups<N>(stride,
        [&](int first)
        {
          sum.Set(from + first);
          sum.Add(from + stride + first);
          sum.Scale(mask.Own);
          sum.Add(noRing);
          to.template Store<Kind, In>(sum, first,
            [&](int c)
            {
              return SumTermByTerm(MakeParted(mask, 0), from + first + c, from + stride + first + c,
                static_cast<const Id*>(nullptr), from, stride);
            });
        });
      from += stride;
      to += apart;
    }
  }

  /// Points between two others, of each `apart`-th place, to each `apartTo`-th place.
  template <ChainValues Kind, typename To>
  void SumVertices(
    const In* from, vtkIdType apart, vtkIdType points, To to, vtkIdType apartTo) const
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
        to.Copy(from);
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
            to.template Store<Kind, In>(sum, first,
              [&](int c)
              {
                return SumTermByTerm(MakeParted(mask, 2), from + first + c,
                  static_cast<const In*>(nullptr), ring, from - stride + first + c, stride);
              });
          });
      }
      from += apart * stride;
      to += apartTo;
    }
  }

  const ChainRows<Id>& Chains;
  const Arrays Values;
  const vtkIdType Stride;
  Mask None = {};
  const Mask OfEdge;
  const Mask OfVertex;
  Buffer<In> OfCentres;
  Buffer<In> Now;
  Buffer<In> Next;
};

/// Sums chains of a ChainOperator.
template <typename Arrays>
void SumChains(const ChainOperator::ChainsView& view, const Arrays& arrays)
{
  std::visit(
    [&](const auto& chains)
    {
      using Id = std::decay_t<decltype(*chains.Ends)>;
      ChainSums<Id, Arrays>(chains, arrays).Run();
    },
    view);
}

}

}

#endif
