// SPDX-License-Identifier: BSD-3-Clause
#include "FileTools.h"

#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <fstream>
#include <iterator>

namespace file_tools
{

namespace
{

template <typename Reader>
vtkSmartPointer<vtkPointSet> ReadWith(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

}

vtkSmartPointer<vtkUnstructuredGrid> WriteAndRead(
  vtkUnstructuredGrid* grid, int dataMode, bool narrow)
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

bool ReadsAppendedData()
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

std::string WhyNotRead(const std::string& path)
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

vtkSmartPointer<vtkPointSet> ReadFile(const std::string& path)
{
  return path.substr(path.size() - 3) == "vtp" ? ReadWith<vtkXMLPolyDataReader>(path)
                                               : ReadWith<vtkXMLUnstructuredGridReader>(path);
}

vtkSmartPointer<vtkUnstructuredGrid> ReadGrid(const std::string& path)
{
  return vtkUnstructuredGrid::SafeDownCast(ReadWith<vtkXMLUnstructuredGridReader>(path));
}

}
