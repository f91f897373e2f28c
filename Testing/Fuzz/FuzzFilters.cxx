// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzFilters.cxx
 * A small data set with any cells and arrays, through a filter with any options, and its output
 * through another one. Nothing crashes, outputs are whole, no array is lost, finite input gives
 * finite output, and a second run, with other threads and with what the filter keeps, or in two
 * filters in a row, gives the same bits.
 */
#include "FuzzChecks.h"
#include "FuzzFilter.h"
#include "FuzzMesh.h"

#include "vtkDataObject.h"
#include "vtkSMPTools.h"

#include <string>

namespace
{

/// Equal bytes as the first time.
bool IsSameAgain(const subdivide::Filter& what, fuzz::Bytes bytes, vtkAlgorithm* first,
  vtkDataObject* input, vtkDataObject* output)
{
  vtkSMPTools::Initialize(1);
  const auto fresh = fuzz::MakeFilter(what, bytes);
  const bool isSame = fuzz::AreEqual(output, fuzz::Run(fresh, input));
  vtkSMPTools::Initialize(2);
  const auto copy = vtkSmartPointer<vtkDataObject>::Take(output->NewInstance());
  copy->DeepCopy(output);
  first->Modified(); // kept operators are used
  return isSame && fuzz::AreEqual(copy, fuzz::Run(first, input));
}

/// The output, after it was looked at.
vtkSmartPointer<vtkDataObject> Try(vtkDataObject* input, fuzz::Bytes& bytes)
{
  const subdivide::Filter& what = fuzz::ChooseFilter(bytes);
  const fuzz::Bytes options = bytes;
  const auto filter = fuzz::MakeFilter(what, bytes);
  auto output = fuzz::Run(filter, input);
  if (!output)
  {
    return nullptr;
  }
  if (const char* fault = fuzz::FindFault(input, output, filter))
  {
    fuzz::Report(fault, what.Name);
  }
  const std::string lost = !fuzz::CarriesArrays(what)
    ? std::string()
    : fuzz::FindLostArray(input, output, fuzz::CarriesCellArrays(what));
  if (!lost.empty())
  {
    fuzz::Report(("the output has lost the array " + lost).c_str(), what.Name);
  }
  if (bytes.Chance(8) && !fuzz::IsChainWhole(what, input, bytes))
  {
    fuzz::Report("two filters in a row give another output than one", what.Name);
  }
  if (bytes.Chance(4) && !IsSameAgain(what, options, filter, input, output))
  {
    fuzz::Report("the second run gives another output", what.Name);
  }
  return output;
}

}

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  fuzz::Silence();
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(2);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Bytes bytes(data, size);
  const auto input = fuzz::MakeData(bytes);
  const auto output = Try(input, bytes);
  if (output && bytes.Choose(2) == 0)
  {
    Try(output, bytes);
  }
  return 0;
}
