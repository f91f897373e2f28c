// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RowBlock.h
 * A few rows of an operator, which are used as soon as they are made. They stay in the processor's
 * cache, so that an operator whose rows are cheap to make need not be stored.
 */
#ifndef SubdivisionObjects_RowBlock_h
#define SubdivisionObjects_RowBlock_h

#include "Core/Operators/ApplyRows.h"

#include <algorithm>
#include <array>
#include <vector>

namespace subdivision
{

template <typename Id>
class RowBlock
{
public:
  /// Adds an entry to the row that is being made.
  void Add(vtkIdType column, double weight)
  {
    if (this->Size == this->Columns.size())
    {
      this->Columns.resize(2 * this->Size + 64);
      this->Weights.resize(this->Columns.size());
    }
    this->Columns[this->Size] = static_cast<Id>(column);
    this->Weights[this->Size] = weight;
    ++this->Size;
  }
  /// Adds up to `most` whole rows that have the same weights, which must live as long as the block;
  /// such rows are made and summed in less time. fill(i, columns) writes the columns of row i of
  /// these, or returns false: then there are only i. Returns how many there are.
  template <std::size_t N, typename Fill>
  vtkIdType AddRun(const std::array<double, N>& weights, vtkIdType most, const Fill& fill)
  {
    return this->AddGroups<1>(weights, most, fill);
  }
  /// Adds the rows of the corners of up to `most` quads (QuadRows): fill(i, columns) writes the
  /// four corners of quad i, or returns false. Returns how many rows there are.
  template <typename Fill>
  vtkIdType AddQuads(const std::array<double, 4>& weights, vtkIdType most, const Fill& fill)
  {
    return this->AddGroups<4, true>(weights, most, fill);
  }
  /// The same for groups of OfEach rows: fill(i, columns) writes the columns of all rows of group
  /// i. Returns how many rows there are.
  template <int OfEach, bool OfQuads = false, std::size_t N, typename Fill>
  vtkIdType AddGroups(const std::array<double, N>& weights, vtkIdType most, const Fill& fill)
  {
    const std::size_t needed = this->Size + OfEach * N * static_cast<std::size_t>(most);
    if (needed > this->Columns.size())
    {
      this->Columns.resize(std::max(needed, 2 * this->Size));
      this->Weights.resize(this->Columns.size());
    }
    Id* columns = this->Columns.data() + this->Size;
    vtkIdType groups = 0;
    for (; groups < most && fill(groups, columns); ++groups)
    {
      columns += OfEach * N;
    }
    const vtkIdType count = OfEach * groups;
    const std::size_t row = this->GetNumberOfRows();
    this->Offsets.resize(row + static_cast<std::size_t>(count) + 1);
    Id* end = this->Offsets.data() + row + 1;
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->Size += N;
      end[i] = static_cast<Id>(this->Size);
    }
    if (!this->Runs.empty() && this->Runs.back().Weights == weights.data() &&
      this->Runs.back().OfQuads == OfQuads && this->Runs.back().End == row)
    {
      this->Runs.back().End += static_cast<std::size_t>(count);
    }
    else if (count > 0)
    {
      this->Runs.push_back({ row, row + static_cast<std::size_t>(count), static_cast<int>(N),
        weights.data(), OfQuads });
    }
    return count;
  }
  /// Adds `count` whole rows that copy consecutive columns from `column` on.
  void AddCopies(vtkIdType column, vtkIdType count)
  {
    const std::size_t run = this->Runs.size();
    this->AddRun(One, count,
      [column](vtkIdType i, Id* columns)
      {
        *columns = static_cast<Id>(column + i);
        return true;
      });
    if (run < this->Runs.size())
    {
      this->Runs.back().Weights = nullptr;
    }
  }
  /// Not for rows of AddRun and AddCopies.
  void SetWeight(std::size_t entry, double weight) { this->Weights[entry] = weight; }
  void EndRow() { this->Offsets.push_back(static_cast<Id>(this->Size)); }
  void Clear()
  {
    this->Size = 0;
    this->Written = 0;
    this->Offsets.resize(1);
    this->Runs.clear();
  }

  std::size_t GetNumberOfRows() const { return this->Offsets.size() - 1; }
  std::size_t GetNumberOfEntries() const { return this->Size; }
  std::size_t GetBegin(std::size_t row) const
  {
    return static_cast<std::size_t>(this->Offsets[row]);
  }
  std::size_t GetEnd(std::size_t row) const
  {
    return static_cast<std::size_t>(this->Offsets[row + 1]);
  }
  const Id* GetColumns() const
  {
    this->WriteAll();
    return this->Columns.data();
  }
  const double* GetWeights() const
  {
    this->WriteAll();
    return this->Weights.data();
  }

  /// The rows as rows of an operator, from row `first` on.
  WeightedRows<Id> GetRows(vtkIdType first) const
  {
    this->WriteAll();
    return this->GetRows(first, 0, this->GetNumberOfRows());
  }
  /// use(rows): the same in parts, of which many have equal rows.
  template <typename Use>
  void ForRuns(vtkIdType first, const Use& use) const
  {
    std::size_t done = 0;
    for (const Run& run : this->Runs)
    {
      if (run.End - run.Begin < WorthACall)
      {
        this->Write(run, this->Written);
        continue;
      }
      if (done < run.Begin)
      {
        use(this->GetRows(first, done, run.Begin));
      }
      const vtkIdType row = first + static_cast<vtkIdType>(run.Begin);
      const vtkIdType count = static_cast<vtkIdType>(run.End - run.Begin);
      const Id* columns = this->Columns.data() + this->GetBegin(run.Begin);
      run.OfQuads     ? use(QuadRows<Id>{ row, count, columns, run.Weights })
        : run.Weights ? use(EqualRows<Id>{ row, count, run.Size, columns, run.Weights })
                      : use(CopiedRows{ row, count, static_cast<vtkIdType>(*columns) });
      done = run.End;
    }
    if (done < this->GetNumberOfRows())
    {
      use(this->GetRows(first, done, this->GetNumberOfRows()));
    }
  }
  /// out = S in for these rows, with `components` interleaved values per column.
  void Apply(const double* in, double* out, int components) const
  {
    SumRows(this->GetRows(0), in, out, components);
  }

private:
  /// The least number of equal rows that are passed by themselves.
  static constexpr std::size_t WorthACall = 8;

  WeightedRows<Id> GetRows(vtkIdType first, std::size_t begin, std::size_t end) const
  {
    return { first + static_cast<vtkIdType>(begin), static_cast<vtkIdType>(end - begin),
      this->Offsets.data() + begin, this->Columns.data(), this->Weights.data() };
  }

  static constexpr std::array<double, 1> One{ 1. };

  /// Rows that were added with the same weights; without weights they copy consecutive columns.
  struct Run
  {
    std::size_t Begin;
    std::size_t End;
    int Size;
    const double* Weights;
    bool OfQuads; ///< of each four rows only the first has its columns before Write
  };
  /// Writes the weights, and columns of quads, of the rows of a run from `begin` on.
  void Write(const Run& run, std::size_t begin) const
  {
    for (std::size_t row = std::max(begin, run.Begin); row < run.End; ++row)
    {
      std::copy_n(run.Weights ? run.Weights : One.data(), run.Size,
        this->Weights.begin() + this->GetBegin(row));
      const std::size_t turn = run.OfQuads ? (row - run.Begin) % 4 : 0;
      if (turn > 0)
      {
        const auto quad = this->Columns.begin() + this->GetBegin(row - turn);
        std::rotate_copy(quad, quad + turn, quad + 4, quad + 4 * turn);
      }
    }
  }
  void WriteAll() const
  {
    if (this->Written < this->GetNumberOfRows())
    {
      for (const Run& run : this->Runs)
      {
        this->Write(run, this->Written);
      }
      this->Written = this->GetNumberOfRows();
    }
  }

  std::vector<Run> Runs;
  /// Columns and weights of long runs: Write makes them when somebody asks. Sums do not need them.
  mutable std::vector<Id> Columns;
  mutable std::vector<double> Weights;
  mutable std::size_t Written = 0; ///< how many rows have all of them
  std::vector<Id> Offsets{ Id(0) };
  std::size_t Size = 0;
};

}

#endif
