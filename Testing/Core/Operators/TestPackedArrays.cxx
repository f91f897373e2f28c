// SPDX-License-Identifier: BSD-3-Clause
// Arrays that are moved together get the same bits as each by itself.
#include "Core/Operators/BlockOperator.h"
#include "Core/Operators/PackedArrays.h"
#include "Core/Solids/Scheme/ChildRows.h"
#include "CoreTools.h"
#include "CoreZoo.h"
#include "StoredValues.h"

#include "vtkType.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <random>

using namespace subdivision;
using namespace coretest;

namespace
{

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
  const PackedArrays packed(operation, arrays);
  EXPECT_EQ(arrays.size(), 5u) << name << ": long long, nine components, and three without partner";
  const auto kept =
    std::count_if(owners.begin(), owners.end(), [](const auto& owner) { return !owner.expired(); });
  EXPECT_EQ(kept, 5) << name << ": values that were copied are let go";
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    EXPECT_EQ(CountDifferences(all[i], single[i]), 0) << name << ", array " << i;
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
