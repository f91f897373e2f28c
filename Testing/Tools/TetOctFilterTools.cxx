// SPDX-License-Identifier: BSD-3-Clause
#include "TetOctFilterTools.h"

namespace tet_oct_filter_tools
{

Configure TetOct(const Configure& more)
{
  return [more](Filter* filter)
  {
    filter->SetVolumeSchemeToTetOct();
    if (more)
    {
      more(filter);
    }
  };
}

Ids GetOctahedra(vtkUnstructuredGrid* grid)
{
  auto* array = vtkIdTypeArray::SafeDownCast(grid->GetCellData()->GetAbstractArray("OctahedronId"));
  EXPECT_TRUE(array);
  Ids ids;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    ids.push_back(array->GetValue(i));
  }
  return ids;
}

void ExpectChains(vtkUnstructuredGrid* input, const Configure& configure)
{
  auto run = [&](vtkUnstructuredGrid* grid, int levels)
  { return Execute(grid, levels, TetOct(configure)); };
  const Grid zero = run(input, 0);
  const Grid one = run(input, 1);
  const Grid three = run(input, 3);
  ASSERT_GT(three->GetNumberOfCells(), 0);
  EXPECT_EQ(Compare(three, run(zero, 3)), "");
  EXPECT_EQ(Compare(one, run(run(zero, 1), 0)), "");
  EXPECT_EQ(Compare(three, run(run(one, 1), 1)), "");
  EXPECT_EQ(Compare(three, run(run(input, 2), 1)), "");
  EXPECT_EQ(Compare(three, run(run(one, 0), 2)), "");
}

}
