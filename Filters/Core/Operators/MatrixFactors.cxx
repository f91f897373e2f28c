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

/// The number of the row of a block.
template <typename Rows>
vtkIdType GetRow(const Rows& rows, vtkIdType i)
{
  return rows.FirstRow + i;
}
template <typename Id>
vtkIdType GetRow(const WeightedRows<Id>& rows, vtkIdType i)
{
  return rows.Numbers ? static_cast<vtkIdType>(rows.Numbers[i]) : rows.FirstRow + i;
}

/// Whether rows may replace rows of rings that were passed before.
template <typename Rows>
constexpr bool ReplacesRows(const Rows&)
{
  return false;
}
template <typename Id>
constexpr bool ReplacesRows(const WeightedRows<Id>&)
{
  return true;
}

/// use(term) for each term of a row, in the order in which ApplyRows.cxx adds them.
template <typename Use>
void ForTerms(const CopiedRows& rows, vtkIdType i, const Use& use)
{
  const vtkIdType column = rows.FirstColumn + i;
  use(Term<vtkIdType>{ 1., &column, 1 });
}
template <typename Id, typename Use>
void ForTerms(const WeightedRows<Id>& rows, vtkIdType i, const Use& use)
{
  for (vtkIdType k = rows.Offsets[i]; k < rows.Offsets[i + 1]; ++k)
  {
    const vtkIdType column = rows.FirstColumn + rows.Columns[k];
    use(Term<vtkIdType>{ rows.Weights[k], &column, 1 });
  }
}
template <typename Id, typename Use>
void ForTerms(const EqualRows<Id>& rows, vtkIdType i, const Use& use)
{
  for (int k = 0; k < rows.Size; ++k)
  {
    use(Term<Id>{ rows.Weights[k], rows.Columns + rows.Size * i + k, 1 });
  }
}
template <typename Use>
void ForTerms(const RowsOfFour& rows, vtkIdType i, const Use& use)
{
  for (int k = 0; k < 4; ++k)
  {
    use(Term<int>{ rows.Rows[i].Weights[k], rows.Rows[i].Columns + k, 1 });
  }
}
template <typename Id, typename Use>
void ForTerms(const QuadRows<Id>& rows, vtkIdType i, const Use& use)
{
  for (int k = 0; k < 4; ++k)
  {
    const Id column = rows.GetColumn(i, k);
    use(Term<Id>{ rows.Weights[k], &column, 1 });
  }
}
template <typename Id, typename Use>
void ForTerms(const RingRows<Id>& rows, vtkIdType i, const Use& use)
{
  const auto useIfAny = [&use](const Term<Id>& term)
  {
    if (term.Weight != 0. && term.Size > 0)
    {
      use(term);
    }
  };
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
    useIfAny(Term<Id>{ rows.Masks->CountedOwn, &vertex, 1 });
    for (vtkIdType k = 0; k < ring.size(); ++k)
    {
      useIfAny(Term<Id>{
        rows.Masks->CountedOther * static_cast<double>(counts[k]) / all, ring.begin() + k, 1 });
    }
    return;
  }
  const PartedMask mask = GetMask(*rows.Masks, rows.OfEdges, rows.Strata[i].GetRule(), ring.size());
  useIfAny(
    rows.OfEdges ? Term<Id>{ mask.Own, rows.Ends + 2 * i, 2 } : Term<Id>{ mask.Own, &vertex, 1 });
  const Id* first = ring.begin();
  for (int part = 0; part < mask.Parts; ++part)
  {
    useIfAny(Term<Id>{ mask.Weights[part], first, mask.Sizes[part] });
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
    , IsReplaced(operation.GetNumberOfRows(), 0)
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

  template <typename Rows>
  void Count(const Rows& rows)
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      const vtkIdType row = GetRow(rows, i);
      this->Entries[row] = this->Sums[row] = 0;
      this->IsReplaced[row] = ReplacesRows(rows) ? 1 : this->IsReplaced[row];
      ForTerms(rows, i,
        [&](const auto& term)
        {
          ++this->Entries[row];
          this->Sums[row] += term.Size > 1 ? 1 : 0;
        });
    }
  }
  /// act(row, forTerms) for the rows that no others replace.
  template <typename Rows, typename Act>
  void ForKept(const Rows& rows, const Act& act)
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      const vtkIdType row = GetRow(rows, i);
      if (ReplacesRows(rows) || !this->IsReplaced[row])
      {
        act(row, [&](const auto& use) { ForTerms(rows, i, use); });
      }
    }
  }
  template <typename Rows>
  void CountMembers(const Rows& rows, long long* sizes)
  {
    this->ForKept(rows,
      [&](vtkIdType row, const auto& forTerms)
      {
        vtkIdType sum = this->Sums[row];
        forTerms(
          [&](const auto& term)
          {
            if (term.Size > 1)
            {
              sizes[sum++] = term.Size;
            }
          });
      });
  }
  template <typename Rows>
  void Write(const Rows& rows)
  {
    this->ForKept(rows,
      [&](vtkIdType row, const auto& forTerms)
      {
        vtkIdType entry = this->Entries[row];
        vtkIdType sum = this->NumberOfColumns + this->Sums[row];
        forTerms(
          [&](const auto& term)
          {
            Set(this->Rows, entry++, term.Size > 1 ? sum : *term.First, term.Weight);
            for (vtkIdType k = 0; term.Size > 1 && k < term.Size; ++k)
            {
              Set(this->First, this->First.Offsets[sum] + k, term.First[k], 1.);
            }
            sum += term.Size > 1 ? 1 : 0;
          });
      });
  }

  const PointOperator& Operation;
  const vtkIdType NumberOfColumns;
  Buffer<long long> Entries;        ///< of each row; counts, then offsets
  Buffer<long long> Sums;           ///< the same of the sums that each row has
  Buffer<unsigned char> IsReplaced; ///< whether a row of weights replaces the row of a ring
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
