// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MessageWords.h
 * How filters tell errors and warnings, in the words of the interface that runs them.
 */
#ifndef SubdivisionObjects_MessageWords_h
#define SubdivisionObjects_MessageWords_h

#include "vtkSubdivisionObjectsModule.h"

#include "vtkSubdivisionObjectsModule.h"

#include <map>
#include <string>

class vtkObject;

namespace subdivision
{

/// Words of messages, such as "MergePoints" or "array index 5", and what an interface says instead.
using MessageWords = std::map<std::string, std::string>;

/// An interface calls it when it starts, for each class of filters. Without it messages have the
/// names of C++.
VTKSUBDIVISIONOBJECTS_EXPORT void AddMessageWords(
  const std::string& className, const MessageWords& words);

/// The text with other words; where several fit, the longest is meant.
std::string Replace(const MessageWords& words, const std::string& text);

void TellWarning(vtkObject* filter, const std::string& text);
void TellError(vtkObject* filter, const std::string& text);

}

#endif
