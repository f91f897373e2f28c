// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzFiles.cxx
 * The bytes of a .vtu or .vtp file, through VTK's reader into a filter. The first bytes choose the
 * filter. VTK's readers survive numbers of any kind, but not other XML than a writer makes: files
 * with other elements are left out.
 */
#include "FuzzChecks.h"
#include "FuzzFilter.h"

#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUtilities.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

/// Of LeakSanitizer, where it is linked.
extern "C" void __lsan_disable() __attribute__((weak));
extern "C" void __lsan_enable() __attribute__((weak));

namespace
{

bool IsOneOf(const char* word, const std::vector<std::string>& words)
{
  return word && std::find(words.begin(), words.end(), word) != words.end();
}

bool HasArray(vtkXMLDataElement* element, const char* name)
{
  return element->FindNestedElementWithNameAndAttribute("DataArray", "Name", name) != nullptr;
}

/// VTK's readers count on an array for each element that has one, so that they read the last one
/// into nothing.
bool HasNameTwice(vtkXMLDataElement* element)
{
  std::vector<std::string> names;
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    const char* name = element->GetNestedElement(i)->GetAttribute("Name");
    if (name)
    {
      names.emplace_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  return std::adjacent_find(names.begin(), names.end()) != names.end();
}

/// Whether numbers of things are small, arrays are text of a known type with names of their own,
/// and cells have all that VTK's readers take for granted.
bool IsPlausible(vtkXMLDataElement* element)
{
  if (HasNameTwice(element))
  {
    return false;
  }
  for (int i = 0; i < element->GetNumberOfAttributes(); ++i)
  {
    const std::string name = element->GetAttributeName(i);
    const int number = std::atoi(element->GetAttributeValue(i));
    if (name.compare(0, 8, "NumberOf") == 0 && (number < 0 || number > 1000))
    {
      return false;
    }
  }
  const std::string name = element->GetName();
  if (IsOneOf(name.c_str(), { "Cells", "Verts", "Lines", "Strips", "Polys" }) &&
    !(HasArray(element, "connectivity") && HasArray(element, "offsets") &&
      (name != "Cells" || HasArray(element, "types"))))
  {
    return false;
  }
  if ((name == "DataArray" || name == "Array") &&
    !(IsOneOf(element->GetAttribute("type"),
        { "Float64", "Float32", "Int64", "Int32", "UInt8", "Int8", "String" }) &&
      IsOneOf(element->GetAttribute("format"), { "ascii" }) && element->GetAttribute("Name")))
  {
    return false;
  }
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    if (!IsPlausible(element->GetNestedElement(i)))
    {
      return false;
    }
  }
  return true;
}

/// A file like one of VTK's writers, of this type.
bool IsFile(const std::string& text, const char* type)
{
  if (text.find('\0') != std::string::npos)
  {
    return false;
  }
  const auto root =
    vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(text.c_str()));
  if (!root || std::string(root->GetName()) != "VTKFile" || !root->GetAttribute("type") ||
    std::string(root->GetAttribute("type")) != type)
  {
    return false;
  }
  vtkXMLDataElement* mesh = root->FindNestedElementWithName(type);
  vtkXMLDataElement* piece = mesh ? mesh->FindNestedElementWithName("Piece") : nullptr;
  const bool hasCells = piece &&
    (mesh->GetName() != std::string("UnstructuredGrid") ||
      piece->FindNestedElementWithName("Cells"));
  // Writers write these always, and readers crash without them where a number cannot be read.
  const auto has = [piece](const char* name)
  { return piece->FindNestedElementWithName(name) != nullptr; };
  return hasCells && has("Points") && has("PointData") && has("CellData") && IsPlausible(root);
}

/// VTK's readers lose arrays of a file that they give up (vtkXMLReader::CreateArray): what is
/// allocated while this exists does not count as lost.
struct LossesOfReaders
{
  LossesOfReaders() { __lsan_disable ? __lsan_disable() : void(); }
  ~LossesOfReaders() { __lsan_enable ? __lsan_enable() : void(); }
};

template <typename Reader>
vtkSmartPointer<vtkDataObject> Read(const std::string& text)
{
  const LossesOfReaders losses;
  vtkNew<Reader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(text);
  reader->Update();
  return reader->GetErrorCode() == 0 ? reader->GetOutputDataObject(0) : nullptr;
}

}

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  fuzz::Silence();
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(2);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  constexpr std::size_t head = 64; // for options
  if (size <= head)
  {
    return 0;
  }
  fuzz::Bytes bytes(data, head);
  const std::string text(reinterpret_cast<const char*>(data) + head, size - head);
  vtkSmartPointer<vtkDataObject> input;
  if (IsFile(text, "PolyData"))
  {
    input = Read<vtkXMLPolyDataReader>(text);
  }
  else if (IsFile(text, "UnstructuredGrid"))
  {
    input = Read<vtkXMLUnstructuredGridReader>(text);
  }
  if (!input)
  {
    return 0;
  }
  const subdivide::Filter& what = fuzz::ChooseFilter(bytes);
  const auto filter = fuzz::MakeFilter(what, bytes);
  const auto output = fuzz::Run(filter, input);
  const char* fault = output ? fuzz::FindFault(input, output) : nullptr;
  if (fault)
  {
    fuzz::Report(fault, what.Name);
  }
  return 0;
}
