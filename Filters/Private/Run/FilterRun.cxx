// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Run/FilterRun.h"

#include "Core/Memory/Loops.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Run/SizeChecks.h"
#include "Private/Run/ToldWarnings.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkAlgorithm.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace subdivision
{
namespace
{

/// Thrown between loops where the work must stop.
struct WorkStopped
{
};

bool HasSolids(vtkPointSet* input)
{
  const CellReader cells(input);
  bool hasSolids = false;
  for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
  {
    hasSolids = hasSolids || GetDimensionOfType(cells.GetCellType(c)) == 3;
  }
  return hasSolids;
}

/// How many layers of duplicate cells a mesh with such cells has around the others, `most` at most,
/// which is also the result where there are no others.
int CountLayers(vtkPointSet* input, int most)
{
  const CellReader cells(input);
  const vtkIdType size = cells.GetNumberOfCells();
  const unsigned char* types = GetGhosts(input, size);
  const auto isDuplicate = [types](vtkIdType c)
  { return (types[c] & vtkDataSetAttributes::DUPLICATECELL) != 0; };
  std::vector<char> isIn(static_cast<std::size_t>(size), 0);
  for (const std::size_t c : InTurn(isIn.size()))
  {
    isIn[c] = isDuplicate(static_cast<vtkIdType>(c)) ? 0 : 1;
  }
  if (std::find(isIn.begin(), isIn.end(), 1) == isIn.end())
  {
    return most;
  }
  std::vector<char> isAt(static_cast<std::size_t>(input->GetNumberOfPoints()), 0);
  std::vector<vtkIdType> scratch;
  int layers = 0;
  for (bool isFound = true; layers < most && isFound; layers += isFound ? 1 : 0)
  {
    isFound = false;
    for (const bool marks : { true, false })
    {
      for (const vtkIdType c : InTurn(size))
      {
        const CellIds cell = cells.GetCell(c, scratch);
        for (vtkIdType i = 0; i < cell.Size && isIn[c] == (marks ? 1 : 0); ++i)
        {
          const bool exists = cell.Ids[i] >= 0 && cell.Ids[i] < input->GetNumberOfPoints();
          if (exists && marks)
          {
            isAt[cell.Ids[i]] = 1;
          }
          else if (exists && isAt[cell.Ids[i]])
          {
            isIn[c] = 1;
            isFound = true;
          }
        }
      }
    }
  }
  return layers;
}

}

std::string DescribeThinLayers(vtkPointSet* mesh, int wanted, bool rulesAreLocal)
{
  if (!HasDuplicates(mesh))
  {
    return {};
  }
  const int needed = wanted - (rulesAreLocal && !HasSolids(mesh) ? 1 : 0);
  const int layers = CountLayers(mesh, needed);
  return layers == needed
    ? std::string()
    : "The input has " + std::to_string(layers) + " of " + std::to_string(needed) +
      " layers of duplicate (ghost) cells that this filter needs around the others: results at the "
      "border of the partition are not those of the whole mesh. Ask for more (Ghost Cells).";
}

std::string (*Translate)(const std::string& className, const std::string& text) = nullptr;

void Warn(vtkObject* filter, const std::string& text)
{
  vtkWarningWithObjectMacro(
    filter, << (Translate ? Translate(filter->GetClassName(), text) : text));
}

void Fail(vtkObject* filter, const std::string& text)
{
  vtkErrorWithObjectMacro(filter, << (Translate ? Translate(filter->GetClassName(), text) : text));
}

void ConnectToFilter(vtkAlgorithm* filter, RunOptions& options, bool& failed)
{
  options.Warn = [filter, told = options.Told](const std::string& message)
  {
    if (!told || told->IsNew(message))
    {
      subdivision::Warn(filter, message);
    }
  };
  options.Fail = [filter, &failed](const std::string& message)
  {
    subdivision::Fail(filter, message);
    failed = true;
  };
  options.Progress =
    [filter, part = options.Part, last = std::make_shared<double>(options.Part.Begin)](double done)
  {
    *last = std::max(*last, part.At(done));
    filter->UpdateProgress(*last);
    return IsAborted(filter);
  };
}

bool DoWork(const FilterTraits& traits, RunOptions& options, const std::function<bool()>& work)
{
  const BetweenLoops goesOn(
    [&options]
    {
      if (options.Progress && options.Progress(-1.))
      {
        throw WorkStopped();
      }
    });
  ForgetEstimate();
  try
  {
    return work();
  }
  catch (const WorkStopped&)
  {
    return false;
  }
  catch (const std::bad_alloc&)
  {
    options.Fail("There is not enough memory for " + traits.Memory + " " + TellEstimate());
  }
  catch (const std::length_error& tooLong)
  {
    options.Fail("The mesh is too large: " + std::string(tooLong.what()) +
      ". Use fewer levels, or a part of it.");
  }
  return false;
}

int RunFilter(vtkAlgorithm* filter, vtkPointSet* input, vtkPointSet* output,
  const FilterTraits& traits, RunOptions& options, const FilterWork& work)
{
  bool failed = false;
  ConnectToFilter(filter, options, failed);
  if (!input || !output)
  {
    options.Fail(traits.WrongInput);
    return 0;
  }
  if (!input->GetPoints() && !traits.FallsBackToInput)
  {
    return 1; // without points the output is empty
  }
  if (traits.Ghosts && *traits.Ghosts && HasDuplicates(input))
  {
    options.Warn(std::string("The input has duplicate (ghost) cells. ") + traits.Ghosts);
  }
  const bool done = DoWork(traits, options, [&] { return work(input, output); });
  if (!done && failed && traits.FallsBackToInput)
  {
    output->ShallowCopy(input);
    return 1;
  }
  if (!done)
  {
    output->Initialize();
  }
  return failed ? 0 : 1;
}

}
