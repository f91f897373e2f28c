// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionDeformationMemory.cxx
 * Memory of an output that the next one takes, and that of outputs which others still have.
 */
#include "SubdivisionDeformationTools.h"

#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/ReturnedMemory.h"

#include "vtkCallbackCommand.h"

using namespace deformation_tools;
using subdivision::ReturnedMemory;

namespace
{

constexpr vtkIdType Size = ReturnedMemory::LeastBytes / 4; // tuples of doubles

/// An array whose values tell the memory from any other.
vtkSmartPointer<vtkDataArray> MakeMarked(ReturnedMemory& memory)
{
  auto array = memory.MakeArray(VTK_DOUBLE, 1, Size);
  array->Fill(42.);
  return array;
}

bool IsMarked(vtkDataArray* array)
{
  const auto* values = static_cast<const double*>(array->GetVoidPointer(0));
  return std::all_of(
    values, values + array->GetNumberOfValues(), [](double value) { return value == 42.; });
}

/// Whether the next array has the memory of one that was marked; the mark is gone then. Memory that
/// the C library may give out again is overwritten first.
bool ComesBack(ReturnedMemory& memory)
{
  std::vector<vtkSmartPointer<vtkDataArray>> others(16);
  for (auto& other : others)
  {
    other = subdivision::MakeArray(VTK_DOUBLE, 1, Size);
    other->Fill(7.);
  }
  const auto array = memory.MakeArray(VTK_DOUBLE, 1, Size);
  EXPECT_EQ(array->GetNumberOfTuples(), Size);
  const bool isMarked = IsMarked(array);
  array->Fill(7.);
  return isMarked;
}

/// A cloud whose points are worth it, and a pose of a cage.
struct Scene
{
  const Grid Cage = MakeKuhnBox(2, 0.2, 3);
  const Grid Cloud = MakeCloud(60000, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1);

  Grid Pose(double shift) const
  {
    return Moved(this->Cage,
      [shift](const Point& x) { return Point{ x[0] + shift * x[1], x[1], x[2] - shift }; });
  }
};

vtkDataArray* GetPoints(vtkPointSet* set)
{
  return set->GetPoints()->GetData();
}

}

TEST(SubdivisionDeformationMemory, ComesBackWhenItIsAwaited)
{
  ReturnedMemory memory;
  auto array = MakeMarked(memory);
  EXPECT_FALSE(ComesBack(memory)); // nothing is freed
  memory.Await();
  array = nullptr;
  EXPECT_FALSE(IsMarked(memory.MakeArray(VTK_DOUBLE, 1, 2 * Size))); // it is too small
  EXPECT_TRUE(ComesBack(memory));
  EXPECT_FALSE(ComesBack(memory)); // once
  // Nor that of an array which was made later.
  array = MakeMarked(memory);
  array = nullptr;
  EXPECT_FALSE(ComesBack(memory));
}

TEST(SubdivisionDeformationMemory, IsGivenBackWhenThatEnds)
{
  ReturnedMemory memory;
  auto array = MakeMarked(memory);
  auto later = MakeMarked(memory);
  memory.Await();
  array = nullptr;
  memory.Release();
  EXPECT_FALSE(ComesBack(memory));
  later = nullptr;
  EXPECT_FALSE(ComesBack(memory));
  // An array outlives who made it.
  auto owner = std::make_unique<ReturnedMemory>();
  array = MakeMarked(*owner);
  owner->Await();
  owner = nullptr;
  EXPECT_TRUE(IsMarked(array));
}

TEST(SubdivisionDeformationMemory, StaysWithWhoHasIt)
{
  ReturnedMemory memory;
  ReturnedMemory other;
  auto array = MakeMarked(memory);
  vtkNew<vtkDoubleArray> copy;
  copy->ShallowCopy(array); // of the same memory
  ASSERT_EQ(copy->GetVoidPointer(0), array->GetVoidPointer(0));
  memory.Await();
  other.Await();
  array = nullptr;
  EXPECT_FALSE(ComesBack(memory));
  EXPECT_TRUE(IsMarked(copy));
  copy->Resize(2 * Size); // moves it
  EXPECT_FALSE(ComesBack(other));
  EXPECT_TRUE(ComesBack(memory));
}

TEST(SubdivisionDeformationMemory, TheNextOutputTakesIt)
{
  const Scene scene;
  Deformer filter;
  filter.Run(scene.Cloud, scene.Cage, scene.Pose(0.1));
  const void* first = GetPoints(filter->GetOutput())->GetVoidPointer(0);
  // Others ask for as much memory meanwhile, and would get it.
  std::vector<vtkSmartPointer<vtkDataArray>> others;
  vtkNew<vtkCallbackCommand> ask;
  ask->SetClientData(&others);
  ask->SetCallback(
    [](vtkObject*, unsigned long, void* list, void*)
    {
      static_cast<std::vector<vtkSmartPointer<vtkDataArray>>*>(list)->push_back(
        subdivision::MakeArray(VTK_DOUBLE, 3, 60000));
    });
  filter->AddObserver(vtkCommand::ProgressEvent, ask);
  filter.Run(scene.Cloud, scene.Cage, scene.Pose(0.2));
  EXPECT_GT(others.size(), 0U);
  EXPECT_EQ(GetPoints(filter->GetOutput())->GetVoidPointer(0), first);
}

TEST(SubdivisionDeformationMemory, OutputsThatOthersHaveDoNotChange)
{
  const Scene scene;
  Deformer filter;
  std::vector<vtkSmartPointer<vtkObject>> held;
  std::vector<vtkDataArray*> found; // in what is held
  std::vector<vtkSmartPointer<vtkDataArray>> wanted;
  for (int time = 0; time < 8; ++time)
  {
    const Grid pose = scene.Pose(0.1 * (time + 1));
    Deformer fresh;
    wanted.push_back(vtkSmartPointer<vtkDoubleArray>::New());
    wanted.back()->DeepCopy(GetPoints(fresh.Run(scene.Cloud, scene.Cage, pose)));
    const auto copy = filter.Run(scene.Cloud, scene.Cage, pose);
    auto shared = vtkSmartPointer<vtkDoubleArray>::New();
    shared->ShallowCopy(GetPoints(copy)); // has the memory, not the array
    vtkObject* const kinds[] = { copy, copy->GetPoints(), GetPoints(copy), shared };
    held.emplace_back(kinds[time % 4]);
    found.push_back(time % 4 == 3 ? shared : GetPoints(copy));
    for (std::size_t before = 0; before < found.size(); ++before)
    {
      EXPECT_TRUE(subdivision::HoldsSameValues(found[before], wanted[before])) << time << before;
    }
  }
}
