// SPDX-License-Identifier: BSD-3-Clause
#include "Writers.h"
#include "CheckedFile.h"
#include "Messages.h"
#include "WholeFiles.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkGenericDataObjectWriter.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOBJWriter.h"
#include "vtkObjectFactory.h"
#include "vtkPLYWriter.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLMultiBlockDataWriter.h"
#include "vtkXMLPPolyDataWriter.h"
#include "vtkXMLPUnstructuredGridWriter.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLRectilinearGridWriter.h"
#include "vtkXMLStructuredGridWriter.h"
#include "vtkXMLTableWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#ifdef SUBDIVISIONOBJECTS_IOEXODUS
#include "vtkExodusIIWriter.h"
#endif
#ifdef SUBDIVISIONOBJECTS_IOOPENVDB
#include "vtkOpenVDBWriter.h"
#endif

#include <filesystem>
#include <ostream>

namespace subdivide
{
namespace
{

/// A writer that notices when a file cannot be written to its end.
template <typename Writer>
class Checked : public Writer
{
public:
  static Checked* New() { VTK_STANDARD_NEW_BODY(Checked); }

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    CheckedFile file;
    if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()) || !file.Open(this->GetFileName()))
    {
      return Writer::ProcessRequest(request, inputs, outputs);
    }
    std::ostream stream(&file);
    this->Stream = &stream;
    const vtkTypeBool done = Writer::ProcessRequest(request, inputs, outputs);
    this->Stream = nullptr;
    if (!file.Close())
    {
      TellNotWhole(this->GetFileName(), file.GetReason());
      this->SetErrorCode(vtkErrorCode::OutOfDiskSpaceError);
      return 0;
    }
    if (!done || this->GetErrorCode() != vtkErrorCode::NoError)
    {
      RemovePart(this->GetFileName());
    }
    return done;
  }

protected:
  Checked() = default;
};

// Appended data, which is VTK's default, is more than some versions of ParaView can read.
void Prepare(vtkXMLWriter* writer)
{
  writer->SetDataModeToBinary();
}

// Texts are longer, and have fewer digits than the numbers.
void Prepare(vtkSTLWriter* writer)
{
  writer->SetFileTypeToBinary();
}

void Prepare(vtkGenericDataObjectWriter* writer)
{
  writer->SetFileTypeToBinary();
}

void Prepare(vtkAlgorithm*)
{
}

template <typename Writer>
bool Write(vtkDataObject* data, const char* name)
{
  vtkNew<Writer> writer;
  Prepare(writer.Get());
  writer->SetFileName(name);
  writer->SetInputDataObject(data);
  return writer->Write() != 0 && writer->GetErrorCode() == vtkErrorCode::NoError;
}

/// Makes its pieces with checks, too.
template <typename Writer, typename PieceWriter>
class InPieces : public Checked<Writer>
{
public:
  static InPieces* New() { VTK_STANDARD_NEW_BODY(InPieces); }

protected:
  InPieces() = default;

  vtkXMLUnstructuredDataWriter* CreateUnstructuredPieceWriter() override
  {
    auto* writer = Checked<PieceWriter>::New();
    writer->SetInputConnection(this->GetInputConnection(0, 0));
    return writer;
  }
};

/// Makes its blocks with checks, too.
class BlockWriter : public Checked<vtkXMLMultiBlockDataWriter>
{
public:
  static BlockWriter* New() { VTK_STANDARD_NEW_BODY(BlockWriter); }

protected:
  BlockWriter() = default;

  /// Blocks without anything in them, which readers of Exodus files make, are no failure.
  int WriteComposite(vtkCompositeDataSet* data, vtkXMLDataElement* element, int& index) override
  {
    return vtkXMLMultiBlockDataWriter::WriteComposite(data, element, index) != 0 ||
      this->GetErrorCode() == vtkErrorCode::NoError;
  }

  int WriteNonCompositeData(
    vtkDataObject* data, vtkXMLDataElement* element, int& index, const char* name) override
  {
    if (!this->GetWriter(index))
    {
      return vtkXMLMultiBlockDataWriter::WriteNonCompositeData(data, element, index, name);
    }
    ++index;
    if (element)
    {
      element->SetAttribute("file", name);
    }
    if (!WriteXml(data, (std::string(this->GetFilePath()) + name).c_str()))
    {
      this->SetErrorCode(vtkErrorCode::OutOfDiskSpaceError);
      return 0;
    }
    return 1;
  }
};

#ifdef SUBDIVISIONOBJECTS_IOEXODUS
/// Whether a file can still become larger: if not, its last bytes may be missing.
bool CanGrow(const char* name)
{
  const auto path = std::filesystem::u8path(name);
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  std::ofstream file(path, std::ios::binary | std::ios::app);
  file << '\0' << std::flush;
  const bool grows = static_cast<bool>(file);
  file.close();
  std::filesystem::resize_file(path, size, error);
  return grows && !error;
}
#endif

/// Some writers do not notice when something is missing.
bool IsWhole(bool hasAll, const char* name)
{
  if (!hasAll)
  {
    TellNotWhole(name, "is the disk full?");
    RemovePart(name);
  }
  return hasAll;
}

}

bool WriteXml(vtkDataObject* data, const char* name)
{
  switch (data->GetDataObjectType())
  {
    case VTK_POLY_DATA:
      return Write<Checked<vtkXMLPolyDataWriter>>(data, name);
    case VTK_UNSTRUCTURED_GRID:
      return Write<Checked<vtkXMLUnstructuredGridWriter>>(data, name);
    case VTK_RECTILINEAR_GRID:
      return Write<Checked<vtkXMLRectilinearGridWriter>>(data, name);
    case VTK_STRUCTURED_GRID:
      return Write<Checked<vtkXMLStructuredGridWriter>>(data, name);
    case VTK_TABLE:
      return Write<Checked<vtkXMLTableWriter>>(data, name);
    default:
      return Write<Checked<vtkXMLImageDataWriter>>(data, name);
  }
}

bool WritePieces(vtkDataObject* data, const char* name)
{
  return vtkPolyData::SafeDownCast(data)
    ? Write<InPieces<vtkXMLPPolyDataWriter, vtkXMLPolyDataWriter>>(data, name)
    : Write<InPieces<vtkXMLPUnstructuredGridWriter, vtkXMLUnstructuredGridWriter>>(data, name);
}

bool WriteBlocks(vtkDataObject* data, const char* name)
{
  return Write<BlockWriter>(data, name);
}

bool WriteObj(vtkDataObject* data, const char* name)
{
  auto* surface = vtkPolyData::SafeDownCast(data);
  if (surface->GetNumberOfVerts() > 0)
  {
    Tell("warning",
      "the file holds surfaces and curves: " + std::to_string(surface->GetNumberOfVerts()) +
        " vertices are left out; .vtp and .vtu files keep them");
  }
  return Write<vtkOBJWriter>(data, name) && IsWhole(HasAllOfObj(name, surface), name);
}

bool WritePly(vtkDataObject* data, const char* name)
{
  // The writer lets all names end with small letters.
  const std::string given = name;
  const bool isSmall = given.compare(given.size() - 4, 4, ".ply") == 0;
  const std::string written = isSmall ? given : given + ".ply";
  if (!Write<vtkPLYWriter>(data, written.c_str()) || !IsWhole(IsWholePly(written), written.c_str()))
  {
    return false;
  }
  std::error_code error;
  if (!isSmall)
  {
    std::filesystem::rename(
      std::filesystem::u8path(written), std::filesystem::u8path(given), error);
  }
  return !error;
}

bool WriteStl(vtkDataObject* data, const char* name)
{
  return Write<vtkSTLWriter>(data, name);
}

bool WriteLegacy(vtkDataObject* data, const char* name)
{
  return Write<vtkGenericDataObjectWriter>(data, name);
}

#ifdef SUBDIVISIONOBJECTS_IOEXODUS
bool WriteExodus(vtkDataObject* data, const char* name)
{
  return Write<vtkExodusIIWriter>(data, name) && IsWhole(CanGrow(name), name);
}
#endif

#ifdef SUBDIVISIONOBJECTS_IOOPENVDB
bool WriteVdb(vtkDataObject* data, const char* name)
{
  return Write<vtkOpenVDBWriter>(data, name) && IsWhole(std::filesystem::exists(name), name);
}
#endif

}
