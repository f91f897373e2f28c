// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzFilter.h
 * A filter with options that the bytes of a fuzzer choose from the table of the program, so that a
 * new filter or option is tried without an edit here.
 */
#ifndef SubdivisionObjects_FuzzFilter_h
#define SubdivisionObjects_FuzzFilter_h

#include "Bytes.h"

#include "Options.h"

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

class vtkDataObject;

namespace fuzz
{

/// A filter with a main input; sources have none, and nothing that can be wrong.
const subdivide::Filter& ChooseFilter(Bytes& bytes);

/// A new filter. Equal bytes give equal options and further inputs.
vtkSmartPointer<vtkAlgorithm> MakeFilter(const subdivide::Filter& what, Bytes& bytes);

/// The output, which is none where the input has the wrong type.
vtkSmartPointer<vtkDataObject> Run(vtkAlgorithm* filter, vtkDataObject* input);

/// Whether the output has the arrays of the input's points. Not that of filters whose output is no
/// part of the input, or made of an image of labels.
bool CarriesArrays(const subdivide::Filter& what);

/// Whether it has those of the input's cells as well, because its cells come from them.
bool CarriesCellArrays(const subdivide::Filter& what);

/// Whether filters of one level in a row give what one filter of all levels gives, bit for bit,
/// with the default of all options but the scheme. True for what no such filter takes. Coordinates
/// and values of single precision are rounded between such filters, and so no part of the promise.
bool IsChainWhole(const subdivide::Filter& what, vtkDataObject* input, Bytes& bytes);

/// Ends the process, which is how a fuzzer learns of a fault.
[[noreturn]] void Report(const char* fault, const char* filter);

/// Errors and warnings are made, and go nowhere.
void Silence();

}

#endif
