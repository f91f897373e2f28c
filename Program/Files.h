// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Files.h
 * Reads and writes files of the formats that VTK knows, by the ends of their names.
 */
#ifndef SubdivisionObjects_Files_h
#define SubdivisionObjects_Files_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <stdexcept>
#include <string>

namespace subdivide
{

/// Something went wrong that is no fault of the command line. The program ends with code 1.
struct Failure : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Throw UsageError where no reader or writer belongs to the end of the name.
void CheckReadable(const std::string& name);
void CheckReadableTable(const std::string& name);
void CheckWritable(const std::string& name, bool isTable = false);

/// Throws Failure where no file of this name can be written: the folder does not exist, for
/// instance.
void CheckPlace(const std::string& name);

/// What is in the file. Throws Failure.
vtkSmartPointer<vtkDataObject> ReadFile(const std::string& name);

/// The same for a table. Numbers of .csv files are detected; their separators are commas, or
/// semicolons if the first line has no comma.
vtkSmartPointer<vtkDataObject> ReadTable(const std::string& name);

/// Writes what the format can hold: for .ply, .stl, .obj and .vtp the surface of solids. Throws
/// Failure, also if not everything could be stored.
void WriteFile(vtkDataObject* data, const std::string& name);

/// The ends of names that can be read and written, for the help; of tables others.
std::string ListReadable();
std::string ListReadableTables();
std::string ListWritable();
std::string ListWritableTables();

}

#endif
