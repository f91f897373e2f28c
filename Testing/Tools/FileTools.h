// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileTools.h
 * Files of VTK in tests: written and read again, and those from elsewhere, which may be missing.
 */
#ifndef FileTools_h
#define FileTools_h

#include "Precompiled.h"

#include "vtkPointSet.h"
#include "vtkXMLWriter.h"

#include <cstdlib>

namespace file_tools
{

/// Through a file in memory; by default with base64 within the elements, which every reader reads.
vtkSmartPointer<vtkUnstructuredGrid> WriteAndRead(
  vtkUnstructuredGrid* grid, int dataMode = vtkXMLWriter::Binary, bool narrow = false);

/// Whether VTK's reader survives appended data here, which VTK's writers write unless told
/// otherwise. That of ParaView 5.11 does not, raw or base64, with an Expat that has the security
/// update of 2024.
bool ReadsAppendedData();

/// Where a file from elsewhere is, if it is there.
inline std::string GetSharedFile(const std::string& name)
{
  const char* folder = std::getenv("SUBDIVISIONOBJECTS_SHARED_DATA");
  return std::string(folder ? folder : "../shared/data") + "/" + name;
}

/// Why a test without the file has to be skipped; empty if it need not.
std::string WhyNotRead(const std::string& path);

/// A file .vtp or .vtu.
vtkSmartPointer<vtkPointSet> ReadFile(const std::string& path);

/// A file .vtu.
vtkSmartPointer<vtkUnstructuredGrid> ReadGrid(const std::string& path);

}

#endif
