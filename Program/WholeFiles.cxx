// SPDX-License-Identifier: BSD-3-Clause
#include "WholeFiles.h"

#include "vtkPolyData.h"

#include "vtksys/FStream.hxx"

#include <algorithm>
#include <cstdint>
#include <map>
#include <sstream>
#include <vector>

namespace subdivide
{
namespace
{

struct Property
{
  std::string Name;
  std::streamoff Size = 0;      ///< in bytes
  std::streamoff CountSize = 0; ///< of a list: of its length; else 0
  bool IsKnown = false;         ///< the types of its numbers
};

struct Element
{
  std::string Name;
  std::int64_t Count = 0;
  std::vector<Property> Properties;
};

struct Header
{
  std::string Format;
  std::vector<Element> Elements;
};

std::streamoff GetSize(const std::string& type)
{
  static const std::map<std::string, std::streamoff> sizes{ { "char", 1 }, { "uchar", 1 },
    { "int8", 1 }, { "uint8", 1 }, { "short", 2 }, { "ushort", 2 }, { "int16", 2 }, { "uint16", 2 },
    { "int", 4 }, { "uint", 4 }, { "int32", 4 }, { "uint32", 4 }, { "float", 4 }, { "float32", 4 },
    { "double", 8 }, { "float64", 8 } };
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

Header ReadHeader(std::istream& file)
{
  Header header;
  std::string line;
  while (std::getline(file, line))
  {
    std::istringstream words(line);
    std::string word;
    std::string type;
    words >> word >> type;
    if (word == "end_header")
    {
      break;
    }
    if (word == "format")
    {
      header.Format = type;
    }
    else if (word == "element")
    {
      header.Elements.emplace_back();
      header.Elements.back().Name = type;
      words >> header.Elements.back().Count;
    }
    else if (word == "property" && !header.Elements.empty())
    {
      std::string counts;
      Property property;
      if (type == "list")
      {
        words >> counts >> type;
        property.CountSize = GetSize(counts);
      }
      property.Size = GetSize(type);
      words >> property.Name;
      property.IsKnown = property.Size > 0 && (counts.empty() || property.CountSize > 0);
      header.Elements.back().Properties.push_back(property);
    }
  }
  return header;
}

/// Whether VTK's reader, which crashes at others, can read a file with this header.
bool IsReadable(const Header& header)
{
  int found = 0;
  for (const Element& element : header.Elements)
  {
    for (const Property& property : element.Properties)
    {
      const bool isList = property.CountSize > 0;
      const bool isCoordinate = !isList && element.Name == "vertex" &&
        (property.Name == "x" || property.Name == "y" || property.Name == "z");
      const bool isCorners = isList && element.Name == "face" &&
        (property.Name == "vertex_indices" || property.Name == "vertex_index");
      found += isCoordinate || isCorners ? 1 : 0;
      if (!property.IsKnown)
      {
        return false;
      }
    }
  }
  return found == 4;
}

/// The length of a list; 0 at the end of the file.
std::int64_t ReadCount(std::istream& file, std::streamoff size, bool bigEndian)
{
  unsigned char bytes[8] = {};
  file.read(reinterpret_cast<char*>(bytes), size);
  std::reverse(bytes, bytes + (bigEndian ? 0 : size));
  std::int64_t count = 0;
  for (std::streamoff i = 0; i < size; ++i)
  {
    count = 256 * count + bytes[i];
  }
  return file ? count : 0;
}

/// Passes over the values. Returns whether they are all there.
bool PassOver(std::istream& file, const Header& header, std::streamoff end)
{
  for (const Element& element : header.Elements)
  {
    const bool hasLists = std::any_of(element.Properties.begin(), element.Properties.end(),
      [](const Property& property) { return property.CountSize > 0; });
    std::streamoff size = 0;
    for (const Property& property : element.Properties)
    {
      size += property.Size;
    }
    if (!hasLists && element.Count > end / std::max<std::streamoff>(size, 1))
    {
      return false;
    }
    if (!hasLists)
    {
      file.seekg(size * element.Count, std::ios::cur);
    }
    for (std::int64_t i = 0; hasLists && i < element.Count && file; ++i)
    {
      for (const Property& property : element.Properties)
      {
        const bool bigEndian = header.Format == "binary_big_endian";
        const std::int64_t count =
          property.CountSize > 0 ? ReadCount(file, property.CountSize, bigEndian) : 1;
        file.ignore(count * property.Size);
        if (file.gcount() != count * property.Size)
        {
          return false;
        }
      }
    }
  }
  return file && file.tellg() <= end;
}

/// Whether there are as many lines, that are not empty, as elements.
bool HasLines(std::istream& file, const Header& header)
{
  std::int64_t missing = 0;
  for (const Element& element : header.Elements)
  {
    missing += element.Count;
  }
  for (std::string line; missing > 0 && std::getline(file, line);)
  {
    missing -= line.find_first_not_of(" \t\r") == std::string::npos ? 0 : 1;
  }
  return missing <= 0;
}

}

bool IsWholePly(const std::string& name)
{
  vtksys::ifstream file(name.c_str(), std::ios::binary);
  const Header header = ReadHeader(file);
  if (!IsReadable(header))
  {
    return false;
  }
  if (header.Format == "ascii")
  {
    return HasLines(file, header);
  }
  const std::streamoff begin = file.tellg();
  file.seekg(0, std::ios::end);
  const std::streamoff end = file.tellg();
  file.seekg(begin);
  return PassOver(file, header, end);
}

bool IsWholeStl(const std::string& name)
{
  vtksys::ifstream file(name.c_str(), std::ios::binary);
  std::string begin(84, '\0');
  file.read(&begin[0], 84);
  const std::size_t first = std::min(begin.find_first_not_of(" \t\r\n"), begin.size());
  file.clear();
  file.seekg(0, std::ios::end);
  const std::streamoff size = file.tellg();
  if (begin.compare(first, 5, "solid") != 0)
  {
    std::streamoff count = 0;
    for (int i = 3; i >= 0; --i)
    {
      count = 256 * count + static_cast<unsigned char>(begin[80 + i]);
    }
    return size >= 84 + 50 * count;
  }
  constexpr std::streamoff most = 1000; // a name may follow
  file.seekg(std::max<std::streamoff>(size - most, 0));
  std::ostringstream rest;
  rest << file.rdbuf();
  return rest.str().find("endsolid") != std::string::npos;
}

bool HasAllOfObj(const std::string& name, vtkPolyData* surface)
{
  vtksys::ifstream file(name.c_str());
  vtkIdType points = 0;
  vtkIdType cells = 0;
  bool ends = false;
  for (std::string line; std::getline(file, line); ends = !file.eof())
  {
    points += line.compare(0, 2, "v ") == 0 ? 1 : 0;
    cells += line.compare(0, 2, "f ") == 0 || line.compare(0, 2, "l ") == 0 ? 1 : 0;
  }
  return ends && points == surface->GetNumberOfPoints() &&
    cells >= surface->GetNumberOfPolys() + surface->GetNumberOfLines();
}

}
