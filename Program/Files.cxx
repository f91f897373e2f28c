// SPDX-License-Identifier: BSD-3-Clause
#include "Files.h"
#include "Conversion.h"
#include "Messages.h"
#include "Names.h"
#include "Tables.h"
#include "TextTable.h"
#include "WholeFiles.h"
#include "Writers.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkDataSet.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkSTLReader.h"
#include "vtkTable.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLPImageDataReader.h"
#include "vtkXMLPPolyDataReader.h"
#include "vtkXMLPRectilinearGridReader.h"
#include "vtkXMLPStructuredGridReader.h"
#include "vtkXMLPUnstructuredGridReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLRectilinearGridReader.h"
#include "vtkXMLStructuredGridReader.h"
#include "vtkXMLTableReader.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#ifdef SUBDIVISIONOBJECTS_IOEXODUS
#include "vtkExodusIIReader.h"
#endif
#ifdef SUBDIVISIONOBJECTS_IOINFOVIS
#include "vtkDelimitedTextReader.h"
#endif
#ifdef SUBDIVISIONOBJECTS_IOIMAGE
#include "vtkMetaImageReader.h"
#include "vtkNrrdReader.h"
#endif

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>

namespace subdivide
{
namespace
{

using Algorithm = vtkSmartPointer<vtkAlgorithm>;
using Data = vtkSmartPointer<vtkDataObject>;

/// ".vtu" of "mesh.VTU".
std::string GetEnding(const std::string& name)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(name));
}

// ---------------------------------------------------------------- reading

template <typename Reader>
Algorithm MakeReader(const char* name)
{
  vtkNew<Reader> reader;
  reader->SetFileName(name);
  return reader;
}

Algorithm MakeLegacyReader(const char* name)
{
  vtkNew<vtkGenericDataObjectReader> reader;
  reader->SetFileName(name);
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  return reader;
}

#ifdef SUBDIVISIONOBJECTS_IOEXODUS
Algorithm MakeExodusReader(const char* name)
{
  vtkNew<vtkExodusIIReader> reader;
  reader->SetFileName(name);
  reader->UpdateInformation();
  reader->SetAllArrayStatus(vtkExodusIIReader::NODAL, 1);
  reader->SetAllArrayStatus(vtkExodusIIReader::ELEM_BLOCK, 1);
  return reader;
}
#endif

#ifdef SUBDIVISIONOBJECTS_IOINFOVIS
Algorithm MakeTextReader(const char* name)
{
  CheckTextTable(name);
  vtkNew<vtkDelimitedTextReader> reader;
  reader->SetFileName(name);
  reader->SetHaveHeaders(true);
  reader->DetectNumericColumnsOn();
  reader->TrimWhitespacePriorToNumericConversionOn();
  reader->SetFieldDelimiterCharacters(std::string(1, FindSeparator(name)).c_str());
  return reader;
}
#endif

using Readers = std::map<std::string, Algorithm (*)(const char*)>;

const Readers& GetTableReaders()
{
  static const Readers readers{
#ifdef SUBDIVISIONOBJECTS_IOINFOVIS
    { ".csv", MakeTextReader },
    { ".tsv", MakeTextReader },
#endif
    { ".vtk", MakeLegacyReader },
    { ".vtt", MakeReader<vtkXMLTableReader> },
  };
  return readers;
}

const Readers& GetReaders()
{
  static const Readers readers{
#ifdef SUBDIVISIONOBJECTS_IOEXODUS
    { ".e", MakeExodusReader },
    { ".ex2", MakeExodusReader },
    { ".exo", MakeExodusReader },
#endif
#ifdef SUBDIVISIONOBJECTS_IOIMAGE
    { ".mha", MakeReader<vtkMetaImageReader> },
    { ".mhd", MakeReader<vtkMetaImageReader> },
    { ".nrrd", MakeReader<vtkNrrdReader> },
#endif
    { ".obj", MakeReader<vtkOBJReader> },
    { ".ply", MakeReader<vtkPLYReader> },
    { ".pvti", MakeReader<vtkXMLPImageDataReader> },
    { ".pvtp", MakeReader<vtkXMLPPolyDataReader> },
    { ".pvtr", MakeReader<vtkXMLPRectilinearGridReader> },
    { ".pvts", MakeReader<vtkXMLPStructuredGridReader> },
    { ".pvtu", MakeReader<vtkXMLPUnstructuredGridReader> },
    { ".stl", MakeReader<vtkSTLReader> },
    { ".vti", MakeReader<vtkXMLImageDataReader> },
    { ".vtk", MakeLegacyReader },
    { ".vtm", MakeReader<vtkXMLMultiBlockDataReader> },
    { ".vtp", MakeReader<vtkXMLPolyDataReader> },
    { ".vtr", MakeReader<vtkXMLRectilinearGridReader> },
    { ".vts", MakeReader<vtkXMLStructuredGridReader> },
    { ".vtu", MakeReader<vtkXMLUnstructuredGridReader> },
  };
  return readers;
}

// ---------------------------------------------------------------- writing

/// What a format holds, and who writes it.
struct Format
{
  Data (*Convert)(vtkDataObject*);
  bool (*Write)(vtkDataObject*, const char*);
  const char* Class; ///< without another one nothing can be written; null: any
};

const std::map<std::string, Format>& GetWriters()
{
  static const std::map<std::string, Format> writers{
#ifdef SUBDIVISIONOBJECTS_IOEXODUS
    { ".e", { AsGridOfNumbers, WriteExodus, nullptr } },
    { ".ex2", { AsGridOfNumbers, WriteExodus, nullptr } },
    { ".exo", { AsGridOfNumbers, WriteExodus, nullptr } },
#endif
    { ".obj", { AsSurface, WriteObj, nullptr } },
    { ".ply", { AsTriangles, WritePly, nullptr } },
    { ".pvtp", { AsSurface, WritePieces, nullptr } },
    { ".pvtu", { AsGrid, WritePieces, nullptr } },
    { ".stl", { AsTriangles, WriteStl, nullptr } },
#ifdef SUBDIVISIONOBJECTS_IOOPENVDB
    { ".vdb", { AsItIs, WriteVdb, "vtkImageData" } },
#endif
    { ".vti", { AsItIs, WriteXml, "vtkImageData" } },
    { ".vtk", { AsItIs, WriteLegacy, nullptr } },
    { ".vtm", { AsBlocks, WriteBlocks, nullptr } },
    { ".vtp", { AsSurface, WriteXml, nullptr } },
    { ".vtr", { AsItIs, WriteXml, "vtkRectilinearGrid" } },
    { ".vts", { AsItIs, WriteXml, "vtkStructuredGrid" } },
    { ".vtu", { AsGrid, WriteXml, nullptr } },
  };
  return writers;
}

const std::map<std::string, Format>& GetTableWriters()
{
  static const std::map<std::string, Format> writers{
    { ".csv", { AsItIs, WriteCsv, "vtkTable" } },
    { ".json", { AsItIs, WriteJson, "vtkTable" } },
    { ".vtk", { AsItIs, WriteLegacy, "vtkTable" } },
    { ".vtt", { AsItIs, WriteXml, "vtkTable" } },
  };
  return writers;
}

template <typename Map>
std::string List(const Map& map)
{
  std::string text;
  for (const auto& one : map)
  {
    text += (text.empty() ? "" : " ") + one.first;
  }
  return text;
}

Data Read(const Readers& readers, const std::string& name)
{
  if (!vtksys::SystemTools::FileExists(name, true))
  {
    throw Failure("there is no file \"" + name + "\"");
  }
  const std::string ending = GetEnding(name);
  if ((ending == ".ply" && !IsWholePly(name)) || (ending == ".stl" && !IsWholeStl(name)))
  {
    throw Failure("cannot read \"" + name + "\": it is damaged, or ends too early");
  }
  const int before = GetNumberOfErrors();
  const Algorithm reader = readers.at(ending)(name.c_str());
  reader->Update();
  Data data = reader->GetOutputDataObject(0);
  if (!data || GetNumberOfErrors() > before)
  {
    throw Failure("cannot read \"" + name + "\"");
  }
  return data;
}

template <typename Map>
void Check(const Map& map, const std::string& name, const char* what)
{
  if (map.count(GetEnding(name)) == 0)
  {
    throw UsageError("cannot " + std::string(what) + " \"" + name +
      "\": its name has to end with one of " + List(map));
  }
}

}

void CheckReadable(const std::string& name)
{
  Check(GetReaders(), name, "read");
}

void CheckReadableTable(const std::string& name)
{
  Check(GetTableReaders(), name, "read");
}

void CheckWritable(const std::string& name, bool isTable)
{
  if (GetEnding(name) == ".vdb" && !isTable && GetWriters().count(".vdb") == 0)
  {
    throw UsageError("cannot write \"" + name +
      "\": this VTK was built without its module IOOpenVDB; .vti files hold images, too");
  }
  Check(isTable ? GetTableWriters() : GetWriters(), name, isTable ? "write the table" : "write");
}

void CheckPlace(const std::string& name)
{
  const std::string path = vtksys::SystemTools::GetFilenamePath(name);
  const std::string folder = path.empty() ? "." : path;
  if (!vtksys::SystemTools::FileIsDirectory(folder))
  {
    throw Failure("cannot write \"" + name + "\": there is no folder \"" + folder + "\"");
  }
  if (vtksys::SystemTools::FileIsDirectory(name))
  {
    throw Failure("cannot write \"" + name + "\": it is a folder");
  }
  const bool isNew = !vtksys::SystemTools::PathExists(name);
  errno = 0;
  const bool opens = static_cast<bool>(vtksys::ofstream(name.c_str(), std::ios::app));
  const std::string reason = errno != 0 ? std::strerror(errno) : "it cannot be opened";
  if (isNew)
  {
    vtksys::SystemTools::RemoveFile(name);
  }
  if (!opens)
  {
    throw Failure("cannot write \"" + name + "\": " + reason);
  }
}

std::string ListReadable()
{
  return List(GetReaders());
}

std::string ListReadableTables()
{
  return List(GetTableReaders());
}

std::string ListWritable()
{
  return List(GetWriters());
}

std::string ListWritableTables()
{
  return List(GetTableWriters());
}

vtkSmartPointer<vtkDataObject> ReadFile(const std::string& name)
{
  Data data = Read(GetReaders(), name);
  auto* points = vtkDataSet::SafeDownCast(data);
  if (points && points->GetNumberOfPoints() == 0)
  {
    throw Failure("\"" + name + "\" has no points");
  }
  if (vtkTable::SafeDownCast(data))
  {
    throw Failure("\"" + name + "\" is a table, and no mesh");
  }
  return data;
}

vtkSmartPointer<vtkDataObject> ReadTable(const std::string& name)
{
  Data data = Read(GetTableReaders(), name);
  auto* table = vtkTable::SafeDownCast(data);
  if (!table)
  {
    throw Failure("\"" + name + "\" is no table");
  }
  if (table->GetNumberOfRows() == 0)
  {
    throw Failure("the table \"" + name + "\" has no rows");
  }
  for (vtkIdType c = 0; c < table->GetNumberOfColumns(); ++c)
  {
    vtkAbstractArray* column = table->GetColumn(c);
    column->SetName(GetTitle(column->GetName() ? column->GetName() : "").c_str());
  }
  return data;
}

void WriteFile(vtkDataObject* data, const std::string& name)
{
  const int before = GetNumberOfErrors();
  const Format& format =
    (vtkTable::SafeDownCast(data) ? GetTableWriters() : GetWriters()).at(GetEnding(name));
  if (format.Class && !data->IsA(format.Class))
  {
    throw Failure("the output is a " + std::string(data->GetClassName()) + ", which " +
      GetEnding(name) + " files cannot hold; .vtu and .vtk can");
  }
  const Data converted = format.Convert(data);
  auto* set = vtkDataSet::SafeDownCast(converted);
  if (set && set->GetNumberOfCells() == 0 && converted != data)
  {
    throw Failure("the output has no cells that " + GetEnding(name) + " files can hold");
  }
  if (!format.Write(converted, name.c_str()) || GetNumberOfErrors() > before)
  {
    throw Failure("cannot write \"" + name + "\"");
  }
}

}
