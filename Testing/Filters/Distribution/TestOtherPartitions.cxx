// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestOtherPartitions.cxx
 * What partitions agree upon by the functions of Exchange.
 */
#include "Precompiled.h"

#include "Private/Partitions/OtherPartitions.h"

using namespace subdivision;

namespace
{

/// The second of three partitions; the others are lists of values, null without a mesh.
class SecondOfThree : public OtherPartitions
{
public:
  SecondOfThree(const std::vector<double>* first, const std::vector<double>* third)
    : Others{ { 0, first }, { 2, third } }
  {
  }
  int GetPartition() const override { return 1; }
  int GetNumberOfPartitions() const override { return 3; }
  const std::vector<vtkIdType>& GetPointIds() const override { return this->None; }
  const std::vector<vtkIdType>& GetCellIds() const override { return this->None; }
  bool IsOwn(vtkIdType) const override { return true; }
  const std::vector<int>& GetNeighbours(vtkIdType) const override { return this->Nobody; }

  bool Send(Messages& messages) override
  {
    ++this->NumberOfSends;
    const bool isToUs = this->NumberOfSends % 2 == (this->Others[0] ? 0 : 1);
    Messages answer;
    if (messages.count(1))
    {
      answer[1] = messages.at(1);
    }
    for (const auto& [partition, values] : this->Others)
    {
      if (isToUs && values)
      {
        answer[partition] = Pack(*values);
      }
    }
    messages = answer;
    return true;
  }
  std::vector<vtkIdType> Gather(vtkIdType own) override
  {
    const auto count = [](const std::vector<double>* values)
    { return values ? static_cast<vtkIdType>(values->size()) : -1; };
    return { count(this->Others[0]), own, count(this->Others[2]) };
  }

  int NumberOfSends = 0;

private:
  static std::vector<char> Pack(const std::vector<double>& values)
  {
    std::vector<char> message(values.size() * sizeof(double));
    std::memcpy(message.data(), values.data(), message.size());
    return message;
  }

  std::map<int, const std::vector<double>*> Others;
  std::vector<vtkIdType> None;
  std::vector<int> Nobody;
};

}

TEST(Exchange, LargestOfThoseWithAMesh)
{
  const std::vector<double> third = { -1., 7. };
  SecondOfThree others(nullptr, &third);
  std::vector<double> values = { 2., 3. };
  others.FindLargest(values);
  EXPECT_EQ(values, (std::vector<double>{ 2., 7. }));

  const std::vector<double> largest = { 5., 6. };
  SecondOfThree led(&largest, &third);
  led.FindLargest(values);
  EXPECT_EQ(values, largest);
}

// Whoever brings another number of values would be waited for: all partitions stop, before they
// send.
TEST(Exchange, ListsOfDifferentLengthEndTheWork)
{
  const std::vector<double> longer = { 1., 2., 3. };
  const std::vector<double> same = { 1., 2. };
  using Pair = std::pair<const std::vector<double>*, const std::vector<double>*>;
  for (const auto& [first, third] :
    { Pair(&longer, nullptr), Pair(nullptr, &longer), Pair(&same, &longer) })
  {
    SecondOfThree others(first, third);
    std::vector<double> values = { 2., 3. };
    EXPECT_THROW(others.FindLargest(values), PartitionStopped);
    EXPECT_EQ(others.NumberOfSends, 0);
  }
}
