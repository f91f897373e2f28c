// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestInputContract.cxx
 * Each row of the tables of Documentation/Guide/InputContract.md is what the filter does. Messages,
 * word by word, points and cells of the output stand in InputContract.txt beside this file.
 */
#include "InputContractCases.h"

#include "Private/Reading/ReadableMesh.h"

#include "vtkRedGreenRefinement.h"

#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

using namespace input_contract;

namespace
{

/// What the table says, and what happened.
struct Row
{
  std::string Kind; ///< nothing, warning or error
  std::string Message;
  std::string Points;
  std::string Cells;

  std::string GetText() const
  {
    return this->Kind + " | " + this->Message + " | " + this->Points + " | " + this->Cells;
  }
};

/// Without the place in the code, the class and addresses.
std::string Plain(const std::string& message)
{
  const std::size_t address = message.find("): ");
  std::string text = address == std::string::npos ? message : message.substr(address + 3);
  text = std::regex_replace(text, std::regex("0x[0-9a-f]+"), "address");
  while (!text.empty() && text.back() == '\n')
  {
    text.pop_back();
  }
  return text;
}

vtkIdType CountNotFinite(vtkDataObject* data)
{
  auto* mesh = vtkPointSet::SafeDownCast(data);
  vtkIdType count = 0;
  for (vtkIdType i = 0; mesh && i < mesh->GetNumberOfPoints(); ++i)
  {
    for (const double x : GetPoint(mesh, i))
    {
      count += std::isfinite(x) ? 0 : 1;
    }
  }
  return count;
}

void SetUp(vtkMultiDimensionalSubdivision* filter, const Trial& trial)
{
  filter->SetNumberOfLevels(1);
  filter->SetVolumeSchemeToBoxSpline();
  if (trial.Set)
  {
    trial.Set(filter);
  }
}

/// Splits all cells once, if the trial is of no option.
void SetUp(vtkRedGreenRefinement* filter, const Trial&)
{
  filter->RefineByAttributeErrorOff();
  filter->RefineByEdgeLengthOn();
  filter->SetMaximumEdgeLength(0.001);
  filter->SetMaximumLevel(1);
}

template <typename Tried>
Row Try(const Case& make)
{
  Trial trial;
  make(trial);
  vtkNew<Tried> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  SetUp(filter.Get(), trial);
  if (trial.HasInput && !trial.Other)
  {
    const Grid grid = MakeGrid(trial.Points, trial.Cells);
    trial.Change(grid);
    trial.Other = grid;
  }
  if (trial.HasInput)
  {
    filter->SetInputDataObject(trial.Other);
  }
  filter->Update();
  EXPECT_LE(CountNotFinite(filter->GetOutputDataObject(0)), CountNotFinite(trial.Other));
  Row row;
  const std::vector<std::string>& errors = messages->Errors;
  const std::vector<std::string>& warnings = messages->Warnings;
  row.Kind = !errors.empty() ? "error"
    : warnings.empty()       ? "nothing"
    : warnings.size() == 1   ? "warning"
                             : std::to_string(warnings.size()) + " warnings";
  row.Message = !errors.empty() ? Plain(errors[0]) : warnings.empty() ? "" : Plain(warnings[0]);
  vtkIdType points = 0;
  vtkIdType cells = 0;
  subdivision::ChangeMeshes(filter->GetOutputDataObject(0),
    [&](vtkDataObject* mesh, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      auto* output = vtkUnstructuredGrid::SafeDownCast(mesh);
      points += output ? output->GetNumberOfPoints() : 0;
      cells += output ? output->GetNumberOfCells() : 0;
      return mesh;
    });
  row.Points = std::to_string(points);
  row.Cells = std::to_string(cells);
  return row;
}

std::string Trim(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(" `");
  const std::size_t end = text.find_last_not_of(" `");
  return begin == std::string::npos ? "" : text.substr(begin, end + 1 - begin);
}

std::vector<std::string> SplitColumns(const std::string& line)
{
  std::vector<std::string> columns;
  std::istringstream text(line);
  for (std::string column; std::getline(text, column, '|');)
  {
    columns.push_back(Trim(column));
  }
  return columns;
}

std::ifstream OpenFile(const std::string& path)
{
  const char* data = std::getenv("SUBDIVISIONOBJECTS_DATA");
  return std::ifstream(std::string(data ? data : "") + "/../" + path);
}

/// The rows of all tables of the page, by key. Columns: nothing, keys (of equal inputs), input,
/// message.
std::map<std::string, Row> ReadPage()
{
  std::ifstream page = OpenFile("Documentation/Guide/InputContract.md");
  std::map<std::string, Row> rows;
  std::string line;
  while (std::getline(page, line))
  {
    if (line.compare(0, 3, "| `") != 0)
    {
      continue;
    }
    std::vector<std::string> columns = SplitColumns(line);
    EXPECT_EQ(columns.size(), 4u) << line;
    columns.resize(4);
    std::istringstream keys(columns[1]);
    for (std::string key; std::getline(keys, key, ',');)
    {
      key = Trim(key);
      EXPECT_EQ(rows.count(key), 0u) << key << " is there twice";
      rows[key].Kind = columns[3];
    }
  }
  return rows;
}

/// Adds what InputContract.txt has: points, cells and the message of each key.
void ReadMessages(std::map<std::string, Row>& rows)
{
  std::ifstream file = OpenFile("Testing/Filters/AllFilters/InputContract.txt");
  std::set<std::string> keys;
  std::string line;
  while (std::getline(file, line))
  {
    if (line.compare(0, 1, "#") == 0)
    {
      continue;
    }
    std::vector<std::string> columns = SplitColumns(line);
    EXPECT_TRUE(columns.size() == 3 || columns.size() == 4) << line;
    columns.resize(4);
    EXPECT_TRUE(keys.insert(columns[0]).second) << columns[0] << " is there twice";
    EXPECT_EQ(rows.count(columns[0]), 1u) << columns[0] << " has no row in the page";
    Row& row = rows[columns[0]];
    row.Points = columns[1];
    row.Cells = columns[2];
    row.Message = columns[3];
  }
  EXPECT_EQ(keys.size(), rows.size()) << "rows of the page have no line in InputContract.txt";
}

}

TEST(InputContract, EachRowIsWhatHappens)
{
  std::map<std::string, Row> rows = ReadPage();
  ReadMessages(rows);
  ASSERT_FALSE(rows.empty()) << "no table in Documentation/Guide/InputContract.md";
  for (const auto& row : rows)
  {
    const auto found = GetCases().find(row.first);
    if (found == GetCases().end())
    {
      ADD_FAILURE() << row.first << " is a row, but this test makes no such input";
      continue;
    }
    Row made = Try<Filter>(found->second);
    const std::string& message = row.second.Message;
    const std::size_t size = message.size();
    if (size > 3 && message.substr(size - 3) == "..." &&
      made.Message.compare(0, size - 3, message, 0, size - 3) == 0)
    {
      made.Message = message; // whose end is that of VTK, and differs between versions
    }
    EXPECT_EQ(made.GetText(), row.second.GetText()) << row.first;
  }
}

TEST(InputContract, EachInputHasARow)
{
  const std::map<std::string, Row> rows = ReadPage();
  for (const auto& one : GetCases())
  {
    EXPECT_EQ(rows.count(one.first), 1u)
      << "| `" << one.first << "` | | " << Try<Filter>(one.second).Kind << " |";
  }
}

TEST(InputContract, RedGreenRefinementSaysTheSame)
{
  // What it says of copies of other ranks' cells is its own. It takes values of edges only.
  const std::vector<std::string> others = { "duplicate-ghost", "value-missing", "value-masked" };
  int same = 0;
  for (const auto& one : GetCases())
  {
    Trial trial;
    one.second(trial);
    if (trial.Set || std::count(others.begin(), others.end(), one.first)) // options of the other
    {
      continue;
    }
    const Row found = Try<vtkRedGreenRefinement>(one.second);
    Row expected = Try<Filter>(one.second);
    expected.Message = std::regex_replace(
      expected.Message, std::regex("vtkMultiDimensionalSubdivision"), "vtkRedGreenRefinement");
    EXPECT_EQ(found.Kind, expected.Kind) << one.first;
    EXPECT_EQ(found.Message, expected.Message) << one.first;
    ++same;
  }
  EXPECT_GT(same, 30);
}
