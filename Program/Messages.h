// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Messages.h
 * What the program writes to standard error: errors and warnings of VTK, and a bar of progress.
 */
#ifndef SubdivisionObjects_Messages_h
#define SubdivisionObjects_Messages_h

#include <string>

class vtkAlgorithm;

namespace subdivide
{

/// From now on messages of VTK are lines "subdivide: error: ..." on standard error.
void CatchMessages(bool quiet);

/// How many errors there were so far.
int GetNumberOfErrors();

/// "subdivide: KIND: text", but no warning if the program is to be quiet.
void Tell(const std::string& kind, const std::string& text);

/// While one exists no warning is told.
class WithoutWarnings
{
public:
  WithoutWarnings();
  ~WithoutWarnings();
  WithoutWarnings(const WithoutWarnings&) = delete;
  WithoutWarnings& operator=(const WithoutWarnings&) = delete;

private:
  bool WasQuiet;
};

/// Shows the progress of an algorithm on a terminal; elsewhere it does nothing.
void ShowProgress(vtkAlgorithm* algorithm, const std::string& name);

/// Takes the bar away.
void EndProgress();

}

#endif
