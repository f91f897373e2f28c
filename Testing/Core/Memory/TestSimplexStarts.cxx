// SPDX-License-Identifier: BSD-3-Clause
// Places of simplices are running sums, whether they are stored or are a product.
#include "Precompiled.h"

#include "Core/Memory/SimplexStarts.h"

namespace
{

using namespace subdivision;

/// A list of simplices by chance, which have `dimensions` dimensions from `first` on.
SimplexList MakeList(vtkIdType size, unsigned int first, unsigned int dimensions)
{
  std::mt19937 random(static_cast<unsigned int>(size));
  SimplexList list;
  for (vtkIdType i = 0; i < size; ++i)
  {
    list.Dimensions.push_back(static_cast<unsigned char>(first + random() % dimensions));
  }
  return list;
}

}

TEST(SimplexStarts, AreRunningSums)
{
  for (const vtkIdType size : { 0, 1, 2, 239, 240, 241, 5000, 100000 })
  {
    for (unsigned int first = 0; first < 4; ++first)
    {
      for (unsigned int dimensions = 1; first + dimensions <= 4; ++dimensions)
      {
        const SimplexList list = MakeList(size, first, dimensions);
        const auto each = [](int dimension) { return vtkIdType(1) << (2 * dimension); };
        const SimplexStarts places(SimplexView(list), each);
        std::array<vtkIdType, 4> counts = {};
        vtkIdType sum = 0;
        for (vtkIdType i = 0; i < size; ++i)
        {
          const int dimension = list.Dimensions[static_cast<std::size_t>(i)];
          ASSERT_EQ(places[i], sum);
          ASSERT_EQ(places.Find(sum), i);
          ++counts[static_cast<std::size_t>(dimension)];
          sum += each(dimension);
          ASSERT_EQ(places.Find(sum - 1), i);
        }
        ASSERT_EQ(places.GetLength(), sum);
        ASSERT_EQ(CountDimensions(list), counts);
      }
    }
  }
}

/// Behind the cells of a view its arrays may go on.
TEST(SimplexStarts, AreOfTheCellsOfAView)
{
  SimplexList list;
  for (int i = 0; i < 100; ++i)
  {
    list.Dimensions.push_back(i % 2 ? 3 : 1);
  }
  SimplexView some(list);
  some.NumberOfSimplices = 90;
  const SimplexStarts places = FindCorners(some);
  EXPECT_EQ(places.GetNumberOfSimplices(), 90);
  for (int i = 0; i <= 90; ++i)
  {
    EXPECT_EQ(places[i], 3 * i - i % 2) << i;
  }
}
