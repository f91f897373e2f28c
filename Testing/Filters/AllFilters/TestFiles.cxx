// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestFiles.cxx
 * What VTK's own reader does with appended data, because users meet it in ParaView 5.11.
 */
#include "FileTools.h"

#include "vtkVersionMacros.h"

using namespace file_tools;

TEST(Files, AppendedDataAreReadOrKnownToBeBroken)
{
  if (ReadsAppendedData())
  {
    return;
  }
  if (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 3)
  {
    GTEST_SKIP() << "known broken here: the reader of this VTK does not read appended data with "
                    "this Expat; Guide/ParaView.md says what to do";
  }
  FAIL()
    << "VTK reads appended data from 9.3 on; many tests of files are skipped where it does not";
}
