// SPDX-License-Identifier: BSD-3-Clause
#include "Tables.h"
#include "CheckedFile.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace subdivide
{
namespace
{

/// As few digits as give the same number again.
std::string ToText(double number)
{
  std::string text;
  for (int digits = 15; digits <= std::numeric_limits<double>::max_digits10; ++digits)
  {
    std::ostringstream stream;
    stream << std::setprecision(digits) << number;
    text = stream.str();
    if (!std::isfinite(number) || std::stod(text) == number)
    {
      break;
    }
  }
  return text;
}

/// The values of a tuple between separators, by `write`.
template <typename Write>
std::string Join(
  vtkDataArray* values, vtkIdType tuple, const std::string& between, const Write& write)
{
  std::string text;
  for (int c = 0; c < values->GetNumberOfComponents(); ++c)
  {
    text += (c > 0 ? between : "") + write(values->GetComponent(tuple, c));
  }
  return text;
}

std::string Quote(const std::string& text)
{
  std::ostringstream quoted;
  quoted << '"';
  for (const char letter : text)
  {
    if (letter == '"' || letter == '\\')
    {
      quoted << '\\' << letter;
    }
    else if (static_cast<unsigned char>(letter) < 0x20)
    {
      quoted << "\\u" << std::hex << std::setw(4) << std::setfill('0') << int(letter);
    }
    else
    {
      quoted << letter;
    }
  }
  quoted << '"';
  return quoted.str();
}

/// One title of a .csv file: components by name or number.
std::string GetTitles(vtkDataArray* column)
{
  std::string titles;
  for (int c = 0; c < column->GetNumberOfComponents(); ++c)
  {
    std::string title = column->GetName();
    if (column->GetNumberOfComponents() > 1)
    {
      const char* component = column->GetComponentName(c);
      title += ":" + (component ? std::string(component) : std::to_string(c));
    }
    std::string doubled = "\"";
    for (const char letter : title)
    {
      doubled += letter == '"' ? "\"\"" : std::string(1, letter);
    }
    titles += (c > 0 ? "," : "") + doubled + "\"";
  }
  return titles;
}

/// The values of a tuple as one of JSON.
std::string ToJson(vtkDataArray* values, vtkIdType tuple)
{
  const std::string text = Join(values, tuple, ", ",
    [](double number) { return std::isfinite(number) ? ToText(number) : std::string("null"); });
  return values->GetNumberOfComponents() == 1 ? text : "[" + text + "]";
}

std::vector<vtkDataArray*> GetColumns(vtkTable* table)
{
  std::vector<vtkDataArray*> columns;
  for (vtkIdType c = 0; c < table->GetNumberOfColumns(); ++c)
  {
    if (auto* column = vtkDataArray::SafeDownCast(table->GetColumn(c)))
    {
      columns.push_back(column);
    }
  }
  return columns;
}

/// Not by vtkDelimitedTextWriter, which writes six digits of each number.
void PutCsv(vtkTable* table, std::ostream& out)
{
  const auto columns = GetColumns(table);
  const auto putLine = [&](const auto& get)
  {
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      out << (c > 0 ? "," : "") << get(columns[c]);
    }
    out << "\n";
  };
  putLine([](vtkDataArray* column) { return GetTitles(column); });
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    putLine([row](vtkDataArray* column) { return Join(column, row, ",", ToText); });
  }
}

void PutJson(vtkTable* table, std::ostream& out)
{
  const auto columns = GetColumns(table);
  out << "{\n";
  vtkFieldData* const field = table->GetFieldData();
  for (int i = 0; i < field->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const values = field->GetArray(i);
    if (values && values->GetName() && values->GetNumberOfTuples() == 1)
    {
      out << "  " << Quote(values->GetName()) << ": " << ToJson(values, 0) << ",\n";
    }
  }
  out << "  \"rows\": [";
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    out << (row > 0 ? ",\n    {" : "\n    {");
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      out << (c > 0 ? ",\n     " : "") << Quote(columns[c]->GetName()) << ": "
          << ToJson(columns[c], row);
    }
    out << "}";
  }
  out << "\n  ]\n}\n";
}

template <typename Put>
bool WriteText(vtkDataObject* data, const char* name, const Put& put)
{
  CheckedFile file;
  if (!file.Open(name))
  {
    return false;
  }
  std::ostream out(&file);
  put(vtkTable::SafeDownCast(data), out);
  if (!file.Close())
  {
    TellNotWhole(name, file.GetReason());
    return false;
  }
  return true;
}

}

void PrintTable(vtkTable* table, std::ostream& out)
{
  const std::string remainder = "Remainder";
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    out << (row > 0 ? "\n" : "");
    for (vtkDataArray* column : GetColumns(table))
    {
      const std::string name = column->GetName();
      const std::size_t begin = name.size() - std::min(name.size(), remainder.size());
      if (name.substr(begin) == remainder && table->GetColumnByName(name.substr(0, begin).c_str()))
      {
        continue;
      }
      out << std::left << std::setw(16) << name << " " << Join(column, row, " ", ToText);
      auto* const error =
        vtkDataArray::SafeDownCast(table->GetColumnByName((name + remainder).c_str()));
      const auto shorten = [](double number)
      {
        std::ostringstream text;
        text << std::setprecision(2) << number;
        return text.str();
      };
      out << (error ? "  +- " + Join(error, row, " ", shorten) : std::string()) << "\n";
    }
  }
}

bool WriteCsv(vtkDataObject* table, const char* name)
{
  return WriteText(table, name, PutCsv);
}

bool WriteJson(vtkDataObject* table, const char* name)
{
  return WriteText(table, name, PutJson);
}

}
