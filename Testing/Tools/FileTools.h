// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileTools.h
 * Files of VTK in tests: written and read again, and those from elsewhere, which may be missing.
 */
#ifndef FileTools_h
#define FileTools_h

#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace file_tools
{

/// Through a file in memory; by default with base64 within the elements, which every reader reads.
inline vtkSmartPointer<vtkUnstructuredGrid> WriteAndRead(
  vtkUnstructuredGrid* grid, int dataMode = vtkXMLWriter::Binary, bool narrow = false)
{
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  writer->SetDataMode(dataMode);
  narrow ? writer->SetHeaderTypeToUInt32() : writer->SetHeaderTypeToUInt64();
  narrow ? writer->SetIdTypeToInt32() : writer->SetIdTypeToInt64();
  writer->WriteToOutputStringOn();
  EXPECT_EQ(writer->Write(), 1);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(writer->GetOutputString());
  reader->Update();
  return reader->GetOutput();
}

/// Whether VTK's reader survives appended data here, which VTK's writers write unless told
/// otherwise. That of ParaView 5.11 does not, raw or base64, with an Expat that has the security
/// update of 2024.
inline bool ReadsAppendedData()
{
  static const bool reads = []
  {
    vtkObject::GlobalWarningDisplayOff();
    vtkNew<vtkPoints> points; // so many that the reader does not meet the end of the file at once
    for (int i = 0; i < 5000; ++i)
    {
      points->InsertNextPoint(std::sin(i), std::cos(3. * i), 0.1 * i);
    }
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(points);
    const bool isRead = WriteAndRead(grid, vtkXMLWriter::Appended)->GetNumberOfPoints() == 5000;
    vtkObject::GlobalWarningDisplayOn();
    return isRead;
  }();
  return reads;
}

/// Where a file from elsewhere is, if it is there.
inline std::string GetSharedFile(const std::string& name)
{
  const char* folder = std::getenv("SUBDIVISIONOBJECTS_SHARED_DATA");
  return std::string(folder ? folder : "../shared/data") + "/" + name;
}

/// Why a test without the file has to be skipped; empty if it need not.
inline std::string WhyNotRead(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    return path + " is missing";
  }
  const std::string text{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  return text.find("<AppendedData") != std::string::npos && !ReadsAppendedData()
    ? path + " has appended data, which the reader of this VTK cannot read with this Expat"
    : "";
}

template <typename Reader>
vtkSmartPointer<vtkPointSet> ReadWith(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// A file .vtp or .vtu.
inline vtkSmartPointer<vtkPointSet> ReadFile(const std::string& path)
{
  return path.substr(path.size() - 3) == "vtp" ? ReadWith<vtkXMLPolyDataReader>(path)
                                               : ReadWith<vtkXMLUnstructuredGridReader>(path);
}

/// A file .vtu.
inline vtkSmartPointer<vtkUnstructuredGrid> ReadGrid(const std::string& path)
{
  return vtkUnstructuredGrid::SafeDownCast(ReadWith<vtkXMLUnstructuredGridReader>(path));
}

}

#endif
