// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/Ranks.h"

#include "Private/Distribution/JoinedArrays.h"
#include "Private/Run/SizeChecks.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <numeric>
#include <set>
#include <sstream>
#include <tuple>

namespace subdivision
{
namespace
{

std::vector<char> ToBytes(const std::string& text)
{
  return std::vector<char>(text.begin(), text.end());
}

std::string ToText(const std::vector<char>& bytes)
{
  return std::string(bytes.begin(), bytes.end());
}

vtkIdType CountCells(const std::vector<MeshPart>& parts)
{
  return std::accumulate(parts.begin(), parts.end(), vtkIdType(0),
    [](vtkIdType sum, const MeshPart& part) { return sum + part.Mesh->GetNumberOfCells(); });
}

/// Association, value type, number of components, name.
using Description = std::tuple<int, int, int, std::string>;

std::set<Description> DescribeArrays(const std::vector<MeshPart>& parts)
{
  std::set<Description> found;
  for (const MeshPart& part : parts)
  {
    for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
    {
      vtkDataSetAttributes* data = part.Mesh->GetAttributes(association);
      for (int a = 0; a < data->GetNumberOfArrays(); ++a)
      {
        vtkAbstractArray* array = data->GetAbstractArray(a);
        if (array->GetName() && HasValues(array, part.Mesh->GetNumberOfElements(association)) &&
          std::string(array->GetName()) != vtkDataSetAttributes::GhostArrayName())
        {
          found.emplace(
            association, array->GetDataType(), array->GetNumberOfComponents(), array->GetName());
        }
      }
    }
  }
  return found;
}

std::string Write(const std::set<Description>& arrays)
{
  std::ostringstream text;
  for (const auto& [association, type, components, name] : arrays)
  {
    text << association << ' ' << type << ' ' << components << ' ' << name << '\0';
  }
  return text.str();
}

void Read(const std::string& text, std::set<Description>& arrays)
{
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line, '\0');)
  {
    std::istringstream words(line);
    int numbers[3] = {};
    words >> numbers[0] >> numbers[1] >> numbers[2];
    words.get();
    std::string name;
    std::getline(words, name, '\0');
    arrays.emplace(numbers[0], numbers[1], numbers[2], name);
  }
}

void AddArray(const Description& array, vtkPointSet* mesh)
{
  const auto& [association, type, components, name] = array;
  auto added = vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(type));
  added->SetName(name.c_str());
  added->SetNumberOfComponents(components);
  mesh->GetAttributes(association)->AddArray(added);
}

/// A part without points that is of the same class as another.
MeshPart MakeEmptyPart(const MeshPart& other)
{
  MeshPart part;
  part.Mesh = vtkSmartPointer<vtkPointSet>::Take(other.Mesh->NewInstance());
  vtkNew<vtkPoints> points;
  points->SetDataType(other.Mesh->GetPoints()->GetDataType());
  part.Mesh->SetPoints(points);
  return part;
}

}

// ------------------------------------------------------------------------------------------------

RankMessages::RankMessages(RunOptions& options)
  : Warn(options.Warn)
  , Fail(options.Fail)
{
  options.Warn = [this](const std::string& message) { this->Warnings.push_back(message); };
  options.Fail = [this](const std::string& message)
  {
    this->Error = this->Failed ? this->Error : message;
    this->Failed = true;
  };
}

bool RankMessages::Tell(Exchange& ranks, RunEnd end)
{
  const bool one = ranks.GetNumberOfPartitions() == 1;
  const auto worst =
    static_cast<RunEnd>(ranks.Max(static_cast<vtkIdType>(this->Failed ? RunEnd::Failed : end)));
  if (worst == RunEnd::NotDone)
  {
    this->Error = "The filter ended without an output, and nothing said why: blocks or ranks did "
                  "not take the same steps. This is a defect of the filter; please report it. "
                  "Spread the cells in another way, use one rank, or switch JoinBlocks off.";
    this->Failed = true;
  }
  std::string all;
  for (const std::string& warning : this->Warnings)
  {
    all += "w" + warning + '\0';
  }
  all += this->Failed ? "e" + this->Error + '\0' : "";
  Exchange::Messages messages{ { 0, ToBytes(all) } };
  ranks.Send(messages);
  std::set<std::string> told;
  bool hasError = false;
  for (const auto& [from, bytes] : messages)
  {
    std::istringstream lines(ToText(bytes));
    for (std::string line; std::getline(lines, line, '\0');)
    {
      const bool isError = line[0] == 'e';
      if (!told.insert(line).second || (isError && hasError))
      {
        continue;
      }
      const std::string text = (one ? "" : "Rank " + std::to_string(from) + ": ") + line.substr(1);
      (isError ? this->Fail : this->Warn)(text);
      hasError = hasError || isError;
    }
  }
  return worst == RunEnd::NotDone || worst == RunEnd::Failed;
}

int CountRanksOfMachine(Exchange& ranks)
{
  if (ranks.GetNumberOfPartitions() == 1)
  {
    return 1;
  }
  vtksys::SystemInformation system;
  const char* name = system.GetHostname();
  const auto own = static_cast<vtkIdType>(std::hash<std::string>()(name ? name : "") >> 1);
  const std::vector<vtkIdType> all = ranks.Gather(own);
  return std::max(1, static_cast<int>(std::count(all.begin(), all.end(), own)));
}

std::string CheckMemoryForJoining(const std::vector<MeshPart>& parts)
{
  double bytes = 0.;
  for (const MeshPart& part : parts)
  {
    bytes += 4. * 1024. * static_cast<double>(part.Mesh->GetActualMemorySize());
  }
  if (bytes <= GetAvailableMemory())
  {
    return std::string();
  }
  return "There is not enough memory to join blocks or partitions, which takes about " +
    Bytes(bytes) +
    ". Use a part of the input, more ranks on other machines, or switch JoinBlocks off.";
}

std::string CheckLoad(const std::vector<MeshPart>& parts, Exchange& exchange)
{
  const std::vector<vtkIdType> all = exchange.Gather(CountCells(parts));
  const auto most = std::max_element(all.begin(), all.end());
  const double mean = static_cast<double>(std::accumulate(all.begin(), all.end(), vtkIdType(0))) /
    static_cast<double>(all.size());
  if (static_cast<double>(*most) <= 3. * mean)
  {
    return std::string();
  }
  return "The cells are spread unevenly: rank " + std::to_string(most - all.begin()) + " has " +
    std::to_string(*most) + " of " +
    std::to_string(std::accumulate(all.begin(), all.end(), vtkIdType(0))) +
    ", more than three times the mean, and the others wait for it. Put "
    "vtkRedistributeDataSetFilter before this filter.";
}

int FindPointType(const std::vector<MeshPart>& parts, Exchange& exchange)
{
  vtkIdType type = 0;
  for (const MeshPart& part : parts)
  {
    type = std::max<vtkIdType>(type, part.Mesh->GetPoints()->GetDataType() == VTK_FLOAT ? 1 : 2);
  }
  return exchange.Max(type) == 2 ? VTK_DOUBLE : VTK_FLOAT;
}

void ShareArrays(std::vector<MeshPart>& parts, Exchange& exchange)
{
  const std::set<Description> own = DescribeArrays(parts);
  std::set<Description> all;
  std::vector<char> text = ToBytes(Write(own));
  exchange.BringTo(0, text);
  Read(ToText(text), all);
  text = ToBytes(Write(all));
  exchange.TakeFrom(0, text);
  all.clear();
  Read(ToText(text), all);
  if (parts.empty())
  {
    return;
  }
  MeshPart added = MakeEmptyPart(parts[0]);
  for (const Description& array : all)
  {
    if (own.count(array) == 0)
    {
      AddArray(array, added.Mesh);
    }
  }
  parts.push_back(std::move(added));
}

}
