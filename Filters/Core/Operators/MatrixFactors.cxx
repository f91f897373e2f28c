// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/MatrixFactors.h"

#include <algorithm>
#include <stdexcept>

namespace subdivision
{
namespace
{

/// A weight, and the sum of values that it belongs to.
template <typename Id>
struct Term
{
  double Weight;
  const Id* First;
  vtkIdType Size;
};

/// use(term) for each term of a row of rules and rings, in the order in which ApplyRows.cxx adds
/// them.
template <typename Id, typename Use>
void ForTerms(const RingRows<Id>& rows, vtkIdType i, const Use& use)
{
  const Row<Id> ring = rows.GetRing(i);
  if (rows.OfCentres)
  {
    use(Term<Id>{ 1. / RingRows<Id>::CentreSize, ring.begin(), ring.size() });
    return;
  }
  const Id vertex = rows.OfEdges ? Id(0) : static_cast<Id>(rows.GetColumn(i));
  if (!rows.OfEdges && rows.HasCounts(i))
  {
    const Id* counts = rows.Counts + rows.Offsets[i];
    double all = 0.;
    for (vtkIdType k = 0; k < ring.size(); ++k)
    {
      all += static_cast<double>(counts[k]) / 3.;
    }
    use(Term<Id>{ rows.Masks->CountedOwn, &vertex, 1 });
    for (vtkIdType k = 0; k < ring.size(); ++k)
    {
      use(Term<Id>{
        rows.Masks->CountedOther * static_cast<double>(counts[k]) / all, ring.begin() + k, 1 });
    }
    return;
  }
  const PartedMask mask = GetMask(*rows.Masks, rows.OfEdges, rows.Strata[i].GetRule(), ring.size());
  use(rows.OfEdges ? Term<Id>{ mask.Own, rows.Ends + 2 * i, 2 } : Term<Id>{ mask.Own, &vertex, 1 });
  const Id* first = ring.begin();
  for (int part = 0; part < mask.Parts; ++part)
  {
    use(Term<Id>{ mask.Weights[part], first, mask.Sizes[part] });
    first += mask.Sizes[part];
  }
}

/// Makes the factors of an operator. The blocks are read twice: to count, and to write.
class FactorMaker
{
public:
  explicit FactorMaker(const PointOperator& operation)
    : Operation(operation)
    , NumberOfColumns(operation.GetNumberOfColumns())
    , Entries(operation.GetNumberOfRows() + 1, 0)
    , Sums(operation.GetNumberOfRows() + 1, 0)
    , IsWeighted(operation.GetNumberOfRows(), 0)
  {
  }

  void Make(std::vector<MatrixFactors::Matrix>& factors)
  {
    this->Operation.ForEachBlock([this](const RowsView& view)
      { std::visit([this](const auto& rows) { this->Count(rows); }, view); });
    CountsToOffsets(this->Entries);
    CountsToOffsets(this->Sums);
    const vtkIdType sums = this->Sums[this->Sums.size() - 1];
    Start(this->Rows, this->NumberOfColumns + sums, this->Entries);
    if (sums > 0)
    {
      this->StartFirst(sums);
    }
    this->Operation.ForEachBlock([this](const RowsView& view)
      { std::visit([this](const auto& rows) { this->Write(rows); }, view); });
    if (sums > 0)
    {
      factors.push_back(std::move(this->First));
    }
    factors.push_back(std::move(this->Rows));
  }

private:
  using Matrix = MatrixFactors::Matrix;

  static void Start(Matrix& matrix, vtkIdType columns, const Buffer<long long>& offsets)
  {
    matrix.NumberOfColumns = columns;
    matrix.Offsets = Buffer<long long>(offsets.size());
    CopyInThreads(offsets.data(), offsets.size(), matrix.Offsets.data());
    matrix.Columns = Buffer<long long>(offsets[offsets.size() - 1]);
    matrix.Weights = Buffer<double>(offsets[offsets.size() - 1]);
  }
  static void Set(Matrix& matrix, vtkIdType entry, vtkIdType column, double weight)
  {
    matrix.Columns[entry] = column;
    matrix.Weights[entry] = weight;
  }

  /// Starts the first factor, with the rows that copy.
  void StartFirst(vtkIdType sums)
  {
    const vtkIdType copies = this->NumberOfColumns;
    Buffer<long long> offsets(copies + sums + 1);
    ForEach(copies, [&](vtkIdType i) { offsets[i] = 1; });
    this->Operation.ForEachBlock(
      [&](const RowsView& view)
      {
        std::visit(
          [&](const auto& rows) { this->CountMembers(rows, offsets.data() + copies); }, view);
      });
    CountsToOffsets(offsets);
    Start(this->First, copies, offsets);
    ForEach(copies, [this](vtkIdType i) { Set(this->First, i, i, 1.); });
  }

  // ----------------------------------------------------------------------------------------------
  // Rows of rules and rings. Explicit rows replace some of them.

  template <typename Id>
  static bool IsSum(const Term<Id>& term)
  {
    return term.Size > 1;
  }
  template <typename Id>
  static bool Counts(const Term<Id>& term)
  {
    return term.Weight != 0. && term.Size > 0;
  }

  template <typename Id>
  void Count(const RingRows<Id>& rows)
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      const vtkIdType row = rows.FirstRow + i;
      this->Entries[row] = this->Sums[row] = 0;
      ForTerms(rows, i,
        [&](const Term<Id>& term)
        {
          this->Entries[row] += Counts(term) ? 1 : 0;
          this->Sums[row] += Counts(term) && IsSum(term) ? 1 : 0;
        });
    }
  }
  template <typename Id>
  void CountMembers(const RingRows<Id>& rows, long long* sizes)
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      const vtkIdType row = rows.FirstRow + i;
      vtkIdType sum = this->Sums[row];
      ForTerms(rows, i,
        [&](const Term<Id>& term)
        {
          if (!this->IsWeighted[row] && Counts(term) && IsSum(term))
          {
            sizes[sum++] = term.Size;
          }
        });
    }
  }
  template <typename Rows>
  void CountMembers(const Rows&, long long*)
  {
  }
  template <typename Id>
  void Write(const RingRows<Id>& rows)
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      const vtkIdType row = rows.FirstRow + i;
      if (!this->IsWeighted[row])
      {
        vtkIdType entry = this->Entries[row];
        vtkIdType sum = this->NumberOfColumns + this->Sums[row];
        ForTerms(rows, i,
          [&](const Term<Id>& term)
          {
            if (Counts(term))
            {
              Set(this->Rows, entry++, IsSum(term) ? sum : *term.First, term.Weight);
              sum += IsSum(term) ? this->WriteSum(term, sum) : 0;
            }
          });
      }
    }
  }
  /// Returns 1, the number of sums.
  template <typename Id>
  vtkIdType WriteSum(const Term<Id>& term, vtkIdType row)
  {
    for (vtkIdType k = 0; k < term.Size; ++k)
    {
      Set(this->First, this->First.Offsets[row] + k, term.First[k], 1.);
    }
    return 1;
  }

  // ----------------------------------------------------------------------------------------------
  // Rows with weights

  void Count(const CopiedRows& rows)
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      this->Entries[rows.FirstRow + i] = 1;
    }
  }
  void Write(const CopiedRows& rows)
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      Set(this->Rows, this->Entries[rows.FirstRow + i], rows.FirstColumn + i, 1.);
    }
  }
  void Count(const RowsOfFour& rows)
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      const auto& weights = rows.Rows[i].Weights;
      this->Entries[rows.FirstRow + i] =
        std::count_if(weights, weights + 4, [](double w) { return w != 0.; });
    }
  }
  void Write(const RowsOfFour& rows)
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      vtkIdType entry = this->Entries[rows.FirstRow + i];
      for (int k = 0; k < 4; ++k)
      {
        if (rows.Rows[i].Weights[k] != 0.)
        {
          Set(this->Rows, entry++, rows.Rows[i].Columns[k], rows.Rows[i].Weights[k]);
        }
      }
    }
  }
  template <typename Id>
  static vtkIdType GetRow(const WeightedRows<Id>& rows, vtkIdType i)
  {
    return rows.Numbers ? static_cast<vtkIdType>(rows.Numbers[i]) : rows.FirstRow + i;
  }
  template <typename Id>
  void Count(const WeightedRows<Id>& rows)
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      const vtkIdType row = GetRow(rows, i);
      this->Entries[row] = rows.Offsets[i + 1] - rows.Offsets[i];
      this->Sums[row] = 0;
      this->IsWeighted[row] = 1;
    }
  }
  template <typename Id>
  void Write(const WeightedRows<Id>& rows)
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      vtkIdType entry = this->Entries[GetRow(rows, i)];
      for (vtkIdType k = rows.Offsets[i]; k < rows.Offsets[i + 1]; ++k)
      {
        Set(this->Rows, entry++, rows.FirstColumn + rows.Columns[k], rows.Weights[k]);
      }
    }
  }

  template <typename Id>
  void Count(const EqualRows<Id>& rows)
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      this->Entries[rows.FirstRow + i] = rows.Size;
    }
  }
  template <typename Id>
  void Write(const EqualRows<Id>& rows)
  {
    const Id* column = rows.Columns;
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      vtkIdType entry = this->Entries[rows.FirstRow + i];
      for (int k = 0; k < rows.Size; ++k)
      {
        Set(this->Rows, entry++, *column++, rows.Weights[k]);
      }
    }
  }

  template <typename Id>
  void Count(const QuadRows<Id>& rows)
  {
    std::fill_n(this->Entries.data() + rows.FirstRow, rows.Count, 4);
  }
  template <typename Id>
  void Write(const QuadRows<Id>& rows)
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      for (int k = 0; k < 4; ++k)
      {
        Set(
          this->Rows, this->Entries[rows.FirstRow + i] + k, rows.GetColumn(i, k), rows.Weights[k]);
      }
    }
  }

  const PointOperator& Operation;
  const vtkIdType NumberOfColumns;
  Buffer<long long> Entries;        ///< of each row; counts, then offsets
  Buffer<long long> Sums;           ///< the same of the sums that each row has
  Buffer<unsigned char> IsWeighted; ///< whether a row of weights replaces the row of a ring
  Matrix First;
  Matrix Rows;
};

MatrixFactors::Matrix MakeIdentity(vtkIdType size)
{
  MatrixFactors::Matrix identity;
  identity.NumberOfColumns = size;
  identity.Offsets = Buffer<long long>(size + 1);
  identity.Columns = Buffer<long long>(size);
  identity.Weights = Buffer<double>(size, 1.);
  ForEach(size, [&](vtkIdType i) { identity.Offsets[i] = identity.Columns[i] = i; });
  identity.Offsets[size] = size;
  return identity;
}

}

void MatrixFactors::Append(const PointOperator& operation)
{
  if (operation.GetNumberBetween() > 0)
  {
    throw std::invalid_argument("an operator with values between has no factors");
  }
  const std::size_t begin = this->Factors.size();
  FactorMaker(operation).Make(this->Factors);
  this->Operations.push_back({ begin, this->Factors.size() });
}

MatrixFactors::Matrix MatrixFactors::Multiply() const
{
  Matrix product = MakeIdentity(this->GetNumberOfColumns());
  for (const Matrix& factor : this->Factors)
  {
    product = subdivision::Multiply(factor, product);
  }
  return product;
}

}
