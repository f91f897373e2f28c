// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/FilterRun.h"

#include "Core/Memory/Loops.h"
#include "Private/Control/MemoryEstimate.h"
#include "Private/Control/ToldWarnings.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkAlgorithm.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

namespace subdivision
{
namespace
{

/// Thrown between loops where the work must stop.
struct WorkStopped
{
};

bool HasDuplicateCells(vtkPointSet* input)
{
  vtkUnsignedCharArray* types = input->GetCellGhostArray();
  return types &&
    std::any_of(types->GetPointer(0), types->GetPointer(0) + types->GetNumberOfTuples(),
      [](unsigned char type) { return type & vtkDataSetAttributes::DUPLICATECELL; });
}

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
  if (traits.Ghosts && HasDuplicateCells(input))
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
