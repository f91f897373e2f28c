// SPDX-License-Identifier: BSD-3-Clause
// Arrays that are moved together get the same bits as each by itself.
#include "Core/Operators/ApplyRows.h"
#include "Core/Operators/BlockOperator.h"
#include "Core/Operators/PackedArrays.h"
#include "Core/Solids/Scheme/ChildRows.h"
#include "CoreZoo.h"

#include "vtkType.h"

#include <cstring>
#include <type_traits>

using namespace subdivision;
using namespace coretest;

namespace
{

std::size_t GetSize(int type)
{
  return type == VTK_DOUBLE || type == VTK_LONG_LONG ? 8 : type == VTK_FLOAT ? 4 : 1;
}

template <typename T>
void Fill(std::vector<unsigned char>& bytes, std::mt19937& random, bool wild)
{
  for (std::size_t i = 0; i < bytes.size() / sizeof(T); ++i)
  {
    double value = std::uniform_real_distribution<double>(0., 200.)(random);
    if (wild && std::is_floating_point<T>::value)
    {
      const unsigned int kind = random() % 40;
      value = kind == 0 ? std::numeric_limits<double>::infinity()
        : kind == 1     ? std::numeric_limits<double>::quiet_NaN()
        : kind == 2     ? static_cast<double>(std::numeric_limits<T>::max())
        : kind == 3     ? -0.
                        : value;
    }
    const T stored = static_cast<T>(value);
    std::memcpy(bytes.data() + i * sizeof(T), &stored, sizeof(T));
  }
}

template <typename T>
int CountDifferencesOf(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  int differences = 0;
  for (std::size_t i = 0; i < a.size(); i += sizeof(T))
  {
    T values[2];
    std::memcpy(values, a.data() + i, sizeof(T));
    std::memcpy(values + 1, b.data() + i, sizeof(T));
    const bool areNone = values[0] != values[0] && values[1] != values[1];
    differences += !areNone && std::memcmp(values, values + 1, sizeof(T)) != 0 ? 1 : 0;
  }
  return differences;
}

/// Types are numbers of VTK: VTK_DOUBLE, VTK_FLOAT, VTK_LONG_LONG or VTK_UNSIGNED_CHAR.
struct StoredValues
{
  int InType;
  int OutType;
  int Components;
  vtkIdType Tuples;
  std::vector<unsigned char> In;
  std::vector<unsigned char> Out;

  /// As ApplyToArrays takes it.
  MovedArray GetArray()
  {
    return { this->In.data(), this->InType, this->Out.data(), this->OutType, this->Components,
      this->Tuples };
  }
  /// Makes room for the values after an operator.
  void Resize(vtkIdType rows);
};

void StoredValues::Resize(vtkIdType rows)
{
  this->Out.resize(static_cast<std::size_t>(rows * this->Components) * GetSize(this->OutType));
}

/// Random values. `wild`: some are not finite, very large, or -0.
StoredValues MakeStoredValues(
  int inType, int outType, int components, vtkIdType tuples, std::mt19937& random, bool wild)
{
  StoredValues values{ inType, outType, components, tuples, {}, {} };
  values.In.resize(static_cast<std::size_t>(tuples * components) * GetSize(inType));
  switch (inType)
  {
    case VTK_DOUBLE:
      Fill<double>(values.In, random, wild);
      break;
    case VTK_FLOAT:
      Fill<float>(values.In, random, wild);
      break;
    case VTK_LONG_LONG:
      Fill<long long>(values.In, random, wild);
      break;
    default:
      Fill<unsigned char>(values.In, random, wild);
  }
  return values;
}

/// The number of values after the operator that differ. Which of two bit patterns says "not a
/// number" is left to the processor.
int CountDifferences(const StoredValues& a, const StoredValues& b)
{
  const auto count = a.OutType == VTK_DOUBLE ? CountDifferencesOf<double>
    : a.OutType == VTK_FLOAT                 ? CountDifferencesOf<float>
                                             : CountDifferencesOf<unsigned char>;
  return count(a.Out, b.Out);
}

/// Applies an operator to many arrays together and one by one.
void Check(const PointOperator& operation, const std::string& name, bool wild)
{
  std::mt19937 random(5);
  const vtkIdType columns = operation.GetNumberOfColumns();
  const vtkIdType rows = operation.GetNumberOfRows();
  ASSERT_GE(rows, 3 * columns) << name << " is no operator whose arrays are packed";
  std::vector<StoredValues> all;
  for (const auto& [in, out, components] :
    std::vector<std::array<int, 3>>{ { VTK_DOUBLE, VTK_FLOAT, 3 }, { VTK_DOUBLE, VTK_DOUBLE, 1 },
      { VTK_UNSIGNED_CHAR, VTK_UNSIGNED_CHAR, 3 }, { VTK_FLOAT, VTK_FLOAT, 2 },
      { VTK_LONG_LONG, VTK_LONG_LONG, 1 }, { VTK_DOUBLE, VTK_DOUBLE, 9 },
      { VTK_FLOAT, VTK_FLOAT, 4 }, { VTK_DOUBLE, VTK_DOUBLE, 3 }, { VTK_FLOAT, VTK_FLOAT, 1 } })
  {
    all.push_back(MakeStoredValues(in, out, components, columns, random, wild));
    all.back().Resize(rows);
  }
  std::vector<MovedArray> arrays;
  std::vector<StoredValues> single = all;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    arrays.push_back(all[i].GetArray());
    ApplyToArrays(operation, { single[i].GetArray() });
  }
  ApplyToArrays(operation, arrays);
  std::vector<std::weak_ptr<const void>> owners;
  for (MovedArray& array : arrays)
  {
    array.Owner = std::make_shared<int>(0);
    owners.emplace_back(array.Owner);
  }
  PackedArrays packed;
  packed.Take(arrays, rows);
  EXPECT_EQ(
    std::count_if(arrays.begin(), arrays.end(), [](const auto& array) { return array.In; }), 5)
    << name << ": long long, nine components, and three without partner";
  const auto kept =
    std::count_if(owners.begin(), owners.end(), [](const auto& owner) { return !owner.expired(); });
  EXPECT_EQ(kept, 5) << name << ": values that were copied are let go";
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    EXPECT_EQ(CountDifferences(all[i], single[i]), 0) << name << ", array " << i;
  }
}

BlockOperator<int> MakeWeights(vtkIdType columns)
{
  return BlockOperator<int>(columns, 5 * columns + 7,
    [columns](vtkIdType begin, vtkIdType end, RowBlock<int>& rows)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        std::mt19937 random(static_cast<unsigned int>(row));
        const int entries = row % 7 == 0 ? 1 : static_cast<int>(random() % 12);
        for (int i = 0; i < entries; ++i)
        {
          rows.Add(random() % columns, row % 7 == 0 ? 1. : 0.01 * (random() % 50));
        }
        rows.EndRow();
      }
    });
}

/// The same rows, the last one first.
class Backward : public PointOperator
{
public:
  explicit Backward(const BlockOperator<int>& operation)
    : Rows(operation.Store())
  {
    const vtkIdType rows = operation.GetNumberOfRows();
    for (vtkIdType i = 0; i < rows; ++i)
    {
      this->Numbers.push_back(static_cast<int>(rows - 1 - i));
    }
  }
  vtkIdType GetNumberOfColumns() const override { return this->Rows.NumberOfColumns; }
  vtkIdType GetNumberOfRows() const override
  {
    return static_cast<vtkIdType>(this->Numbers.size());
  }
  void ForEachBlock(const User& use) const override
  {
    const vtkIdType size = this->GetNumberOfRows();
    for (const vtkIdType half : { vtkIdType(0), size / 2 })
    {
      WeightedRows<int> rows = this->Rows.GetRows(half, half == 0 ? size / 2 : size);
      rows.Numbers = this->Numbers.data() + half;
      use(rows);
    }
  }

private:
  SparseRows<int> Rows;
  std::vector<int> Numbers;
};

/// Values that stay side by side between two operators get the bits of those that go to their
/// arrays.
void CheckStaying(const PointOperator& first, const PointOperator& second, bool wild)
{
  std::mt19937 random(7);
  PackedArrays packed;
  std::vector<StoredValues> all;
  for (const auto& [type, components] :
    std::vector<std::array<int, 2>>{ { VTK_FLOAT, 3 }, { VTK_DOUBLE, 3 }, { VTK_DOUBLE, 1 },
      { VTK_LONG_LONG, 1 }, { VTK_UNSIGNED_CHAR, 1 }, { VTK_DOUBLE, 5 } })
  {
    all.push_back(
      MakeStoredValues(type, type, components, first.GetNumberOfColumns(), random, wild));
  }
  std::vector<StoredValues> single = all;
  for (const PointOperator* operation : { &first, &second })
  {
    const vtkIdType rows = operation->GetNumberOfRows();
    const bool isFirst = operation == &first;
    std::vector<MovedArray> arrays;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      for (StoredValues* values : { &all[i], &single[i] })
      {
        values->In = isFirst ? values->In : values->Out;
        values->Tuples = operation->GetNumberOfColumns();
        values->Resize(rows);
      }
      ApplyToArrays(*operation, { single[i].GetArray() });
      arrays.push_back(all[i].GetArray());
      arrays.back().In = packed.Has(i) ? nullptr : arrays.back().In;
    }
    packed.Take(arrays, rows);
    packed.Start(arrays, rows, isFirst);
    ApplyToArrays(*operation, packed, arrays);
    EXPECT_EQ(packed.IsEmpty(), !isFirst);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      ASSERT_EQ(packed.Has(i), isFirst && i != 3 && i != 5) << i;
      EXPECT_TRUE(packed.Has(i) || CountDifferences(all[i], single[i]) == 0) << "array " << i;
    }
  }
}

}

TEST(PackedArrays, StayBetweenOperators)
{
  const BlockOperator<int> weights = MakeWeights(100);
  const BlockOperator<int> more = MakeWeights(weights.GetNumberOfRows());
  for (const bool wild : { false, true })
  {
    CheckStaying(weights, more, wild);
    CheckStaying(Backward(weights), more, wild);
    CheckStaying(weights, Backward(more), wild);
  }
}

TEST(PackedArrays, HaveTheSameBitsInRowsOfRings)
{
  for (const Mesh& mesh : GetZoo())
  {
    const auto level = RefineOnce(Build<int>(mesh.Cells));
    const ChildRows<BoxSplineSplit<int>> rows(level.Level);
    if (rows.GetNumberOfColumns() > 0 && rows.GetNumberOfRows() >= 3 * rows.GetNumberOfColumns())
    {
      Check(rows, mesh.Name, false);
      Check(rows, mesh.Name + ", wild values", true);
    }
  }
}

TEST(PackedArrays, HaveTheSameBitsInRowsWithWeights)
{
  const BlockOperator<int> operation = MakeWeights(300);
  Check(operation, "weights", false);
  Check(operation, "weights, wild values", true);
}
