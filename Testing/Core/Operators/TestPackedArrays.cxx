// SPDX-License-Identifier: BSD-3-Clause
// Arrays that are moved together get the same bits as each by itself.
#include "Core/Operators/BlockOperator.h"
#include "Core/Operators/PackedArrays.h"
#include "Core/Solids/Scheme/ChildRows.h"
#include "CoreTools.h"
#include "CoreZoo.h"

#include "vtkType.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <random>

using namespace subdivision;
using namespace coretest;

namespace
{

/// Values of a type before and after an operator.
struct Values
{
  int InType;
  int OutType;
  int Components;
  std::vector<unsigned char> In;
  std::vector<unsigned char> Out;
};

int GetSize(int type)
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

Values Make(
  int inType, int outType, int components, vtkIdType columns, std::mt19937& random, bool wild)
{
  Values values{ inType, outType, components, {}, {} };
  values.In.resize(static_cast<std::size_t>(columns) * components * GetSize(inType));
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

/// The number of values that differ. Which of two bit patterns says "not a number" is left to the
/// processor.
template <typename T>
int CountDifferences(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
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

/// Applies an operator to many arrays together and one by one.
void Check(const PointOperator& operation, const std::string& name, bool wild)
{
  std::mt19937 random(5);
  const vtkIdType columns = operation.GetNumberOfColumns();
  const vtkIdType rows = operation.GetNumberOfRows();
  ASSERT_GE(rows, 3 * columns) << name << " is no operator whose arrays are packed";
  std::vector<Values> all;
  for (const auto& [in, out, components] :
    std::vector<std::array<int, 3>>{ { VTK_DOUBLE, VTK_FLOAT, 3 }, { VTK_DOUBLE, VTK_DOUBLE, 1 },
      { VTK_UNSIGNED_CHAR, VTK_UNSIGNED_CHAR, 3 }, { VTK_FLOAT, VTK_FLOAT, 2 },
      { VTK_LONG_LONG, VTK_LONG_LONG, 1 }, { VTK_DOUBLE, VTK_DOUBLE, 9 },
      { VTK_FLOAT, VTK_FLOAT, 4 }, { VTK_DOUBLE, VTK_DOUBLE, 3 }, { VTK_FLOAT, VTK_FLOAT, 1 } })
  {
    all.push_back(Make(in, out, components, columns, random, wild));
    all.back().Out.resize(static_cast<std::size_t>(rows) * components * GetSize(out));
  }
  std::vector<MovedArray> arrays;
  std::vector<Values> single = all;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    Values& values = all[i];
    arrays.push_back({ values.In.data(), values.InType, values.Out.data(), values.OutType,
      values.Components, columns });
    ApplyToArrays(operation,
      { { single[i].In.data(), values.InType, single[i].Out.data(), values.OutType,
        values.Components, columns } });
  }
  ApplyToArrays(operation, arrays);
  std::vector<std::weak_ptr<const void>> owners;
  for (MovedArray& array : arrays)
  {
    array.Owner = std::make_shared<int>(0);
    owners.emplace_back(array.Owner);
  }
  const PackedArrays packed(operation, arrays);
  EXPECT_EQ(arrays.size(), 5u) << name << ": long long, nine components, and three without partner";
  const auto kept =
    std::count_if(owners.begin(), owners.end(), [](const auto& owner) { return !owner.expired(); });
  EXPECT_EQ(kept, 5) << name << ": values that were copied are let go";
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const auto count = all[i].OutType == VTK_DOUBLE ? CountDifferences<double>
      : all[i].OutType == VTK_FLOAT                 ? CountDifferences<float>
                                                    : CountDifferences<unsigned char>;
    EXPECT_EQ(count(all[i].Out, single[i].Out), 0) << name << ", array " << i;
  }
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
  constexpr vtkIdType columns = 300;
  const BlockOperator<int> operation(columns, 5 * columns + 7,
    [](vtkIdType begin, vtkIdType end, RowBlock<int>& rows)
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
  Check(operation, "weights", false);
  Check(operation, "weights, wild values", true);
}
