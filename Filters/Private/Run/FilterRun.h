// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FilterRun.h
 * The part of RequestData that is alike in all filters: it connects the work of one filter on one
 * input to VTK.
 */
#ifndef SubdivisionObjects_FilterRun_h
#define SubdivisionObjects_FilterRun_h

#include "Private/Run/RunOptions.h"

#include "vtkSubdivisionObjectsModule.h"

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkInformationVector;
class vtkObject;
class vtkPointSet;

namespace subdivision
{

/// Puts the words of an interface in the places of names of C++ ("MergePoints", "array index 5") in
/// the messages of a class; null: these stay.
extern VTKSUBDIVISIONOBJECTS_EXPORT std::string (*Translate)(
  const std::string& className, const std::string& text);

/// A warning or an error of a filter.
void Warn(vtkObject* filter, const std::string& text);
void Fail(vtkObject* filter, const std::string& text);

/// The differences of filters that run alike.
struct FilterTraits
{
  /// The error message where the input or the output is missing, or is of another type.
  const char* WrongInput;
  /// A text on the result of duplicate cells of the input; null or empty: the filter does not warn
  /// of them.
  const char* Ghosts = nullptr;
  /// A text on data for which there may be too little memory, and on remedies.
  std::string Memory;
  /// Whether the output after an error is the input; else it is empty. An input without points is
  /// worked on only in the first case. After a stop it is empty.
  bool FallsBackToInput = false;
};

/// Does the work of one filter: reads the arrays of the input, and writes the output. Returns
/// whether it finished. It may be called with other data sets than the pipeline's.
using FilterWork = std::function<bool(vtkPointSet*, vtkPointSet*)>;

/// Sets the functions of `options` for messages and for the progress of this part of the work; Fail
/// sets `failed`.
void ConnectToFilter(vtkAlgorithm* filter, RunOptions& options, bool& failed);

/// A warning where a mesh has duplicate cells, but fewer than `wanted` layers of them around the
/// others, one less where there are no solids and `rulesAreLocal`; else empty.
std::string DescribeThinLayers(vtkPointSet* mesh, int wanted, bool rulesAreLocal);

/// Calls `work`; too little memory is an error. Between loops the work reports that it goes on, and
/// ends where it must stop. Returns whether it finished.
bool DoWork(const FilterTraits& traits, RunOptions& options, const std::function<bool()>& work);

/// Sets the functions of `options` for messages and progress, and calls `work`. Returns the result
/// for RequestData. An error or too little memory lead to the output that `traits` says, a user who
/// stops the filter to an empty one.
int RunFilter(vtkAlgorithm* filter, vtkPointSet* input, vtkPointSet* output,
  const FilterTraits& traits, RunOptions& options, const FilterWork& work);

/// The same with the data sets that the pipeline has, for a filter of other types.
template <typename Input, typename Output, typename Work>
int RunFilter(vtkAlgorithm* filter, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, const FilterTraits& traits, RunOptions& options,
  const Work& work)
{
  return RunFilter(filter, Input::GetData(inputVector[0]), Output::GetData(outputVector), traits,
    options, [&work](vtkPointSet* input, vtkPointSet* output)
    { return work(static_cast<Input*>(input), static_cast<Output*>(output)); });
}

/// Copies the options that all filters have under the same names.
template <typename Filter>
void ReadSharedOptions(Filter* filter, RunOptions& options)
{
  options.InterpolateIntegers = filter->GetInterpolateIntegers();
  options.GenerateOriginalIds = filter->GetGenerateOriginalIds();
  options.GenerateGlobalIds = filter->GetGenerateGlobalIds();
  options.OutputPointsPrecision = filter->GetOutputPointsPrecision();
  options.MaximumNumberOfCells = filter->GetMaximumNumberOfCells();
}

}

#endif
