// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/MeshMessage.h"

#include "Private/Arrays/Arrays.h"
#include "Private/Distribution/StampedParts.h"
#include "Private/Values/PointCopies.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cstring>
#include <string>

namespace subdivision
{
namespace
{

class Writer
{
public:
  explicit Writer(std::vector<char>& bytes)
    : Bytes(bytes)
  {
  }
  void Put(const void* data, std::size_t size)
  {
    const char* first = static_cast<const char*>(data);
    this->Bytes.insert(this->Bytes.end(), first, first + size);
  }
  void Put(vtkIdType value) { this->Put(&value, sizeof(value)); }
  void Put(const std::string& text)
  {
    this->Put(static_cast<vtkIdType>(text.size()));
    this->Put(text.data(), text.size());
  }
  void Put(const std::vector<vtkIdType>& values)
  {
    this->Put(static_cast<vtkIdType>(values.size()));
    this->Put(values.data(), values.size() * sizeof(vtkIdType));
  }

private:
  std::vector<char>& Bytes;
};

class Reader
{
public:
  explicit Reader(const std::vector<char>& bytes)
    : Next(bytes.data())
    , End(bytes.data() + bytes.size())
  {
  }
  bool IsAtEnd() const { return this->Next == this->End; }
  void Get(void* data, std::size_t size)
  {
    if (size > 0)
    {
      std::memcpy(data, this->Next, size);
      this->Next += size;
    }
  }
  vtkIdType GetId()
  {
    vtkIdType value = 0;
    this->Get(&value, sizeof(value));
    return value;
  }
  std::string GetString()
  {
    std::string text(static_cast<std::size_t>(this->GetId()), '\0');
    this->Get(&text[0], text.size());
    return text;
  }
  std::vector<vtkIdType> GetIds()
  {
    std::vector<vtkIdType> values(static_cast<std::size_t>(this->GetId()));
    this->Get(values.data(), values.size() * sizeof(vtkIdType));
    return values;
  }

private:
  const char* Next;
  const char* End;
};

// ------------------------------------------------------------------------------------------------
// Arrays

bool CanBeSent(vtkAbstractArray* array)
{
  return vtkDataArray::SafeDownCast(array) || vtkStringArray::SafeDownCast(array);
}

void PutArray(vtkAbstractArray* array, Writer& writer)
{
  writer.Put(std::string(array->GetName() ? array->GetName() : ""));
  writer.Put(static_cast<vtkIdType>(array->GetDataType()));
  writer.Put(static_cast<vtkIdType>(array->GetNumberOfComponents()));
  writer.Put(array->GetNumberOfTuples());
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i)
    {
      writer.Put(std::string(strings->GetValue(i)));
    }
    return;
  }
  auto* data = vtkDataArray::SafeDownCast(array);
  if (data->GetDataType() == VTK_BIT)
  {
    for (vtkIdType i = 0; i < data->GetNumberOfValues(); ++i)
    {
      const char bit = data->GetVariantValue(i).ToInt() != 0 ? 1 : 0;
      writer.Put(&bit, 1);
    }
    return;
  }
  const auto plain = Contiguous(data);
  writer.Put(plain->GetVoidPointer(0),
    static_cast<std::size_t>(plain->GetNumberOfValues()) * plain->GetDataTypeSize());
}

vtkSmartPointer<vtkAbstractArray> GetArray(Reader& reader)
{
  const std::string name = reader.GetString();
  const int type = static_cast<int>(reader.GetId());
  const int components = static_cast<int>(reader.GetId());
  const vtkIdType tuples = reader.GetId();
  auto array = vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(type));
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  if (!name.empty())
  {
    array->SetName(name.c_str());
  }
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    for (vtkIdType i = 0; i < tuples * components; ++i)
    {
      strings->SetValue(i, reader.GetString());
    }
    return array;
  }
  if (type == VTK_BIT)
  {
    for (vtkIdType i = 0; i < tuples * components; ++i)
    {
      char bit = 0;
      reader.Get(&bit, 1);
      array->SetVariantValue(i, bit);
    }
    return array;
  }
  reader.Get(array->GetVoidPointer(0),
    static_cast<std::size_t>(tuples * components) * array->GetDataTypeSize());
  return array;
}

template <typename IsWanted>
void PutArrays(vtkFieldData* data, const IsWanted& isWanted, Writer& writer)
{
  std::vector<vtkAbstractArray*> arrays;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    if (isWanted(data->GetAbstractArray(a)))
    {
      arrays.push_back(data->GetAbstractArray(a));
    }
  }
  writer.Put(static_cast<vtkIdType>(arrays.size()));
  for (vtkAbstractArray* array : arrays)
  {
    PutArray(array, writer);
  }
}

void GetArrays(Reader& reader, vtkFieldData* data)
{
  for (vtkIdType left = reader.GetId(); left > 0; --left)
  {
    data->AddArray(GetArray(reader));
  }
}

// ------------------------------------------------------------------------------------------------
// Cells

void PutCells(vtkPointSet* mesh, Writer& writer)
{
  ForEachCellArray(mesh,
    [&writer](vtkCellArray* cells, vtkIdType)
    {
      PutArray(cells->GetOffsetsArray(), writer);
      PutArray(cells->GetConnectivityArray(), writer);
    });
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh))
  {
    PutArray(GetCellTypes(grid), writer);
  }
}

void GetCells(Reader& reader, vtkPointSet* mesh)
{
  const bool isPolyData = vtkPolyData::SafeDownCast(mesh) != nullptr;
  std::vector<vtkSmartPointer<vtkCellArray>> lists;
  for (int kind = 0; kind < (isPolyData ? 4 : 1); ++kind)
  {
    const auto offsets = GetArray(reader);
    const auto ids = GetArray(reader);
    lists.push_back(vtkSmartPointer<vtkCellArray>::New());
    lists.back()->SetData(vtkDataArray::SafeDownCast(offsets), vtkDataArray::SafeDownCast(ids));
  }
  const auto types = isPolyData ? nullptr : GetArray(reader);
  SetCellArrays(mesh, vtkUnsignedCharArray::SafeDownCast(types), lists);
}

std::vector<vtkIdType> Select(
  const std::vector<vtkIdType>& values, const std::vector<vtkIdType>& indices)
{
  std::vector<vtkIdType> selected;
  selected.reserve(indices.size());
  for (const vtkIdType i : indices)
  {
    selected.push_back(values[i]);
  }
  return selected;
}

vtkSmartPointer<vtkPoints> GetPoints(Reader& reader)
{
  const auto coordinates = GetArray(reader);
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(coordinates->GetDataType());
  points->SetData(vtkDataArray::SafeDownCast(coordinates));
  return points;
}

void PutValues(vtkPointSet* mesh, Writer& writer)
{
  PutArray(mesh->GetPoints()->GetData(), writer);
  PutArrays(mesh->GetPointData(), CanBeSent, writer);
  PutArrays(mesh->GetCellData(), CanBeSent, writer);
}

void GetValues(Reader& reader, vtkPointSet* mesh)
{
  mesh->SetPoints(GetPoints(reader));
  GetArrays(reader, mesh->GetPointData());
  GetArrays(reader, mesh->GetCellData());
}

}

std::vector<vtkIdType> PackCells(
  const MeshPart& part, const std::vector<vtkIdType>& cells, std::vector<char>& message)
{
  auto mesh = vtkSmartPointer<vtkPointSet>::Take(part.Mesh->NewInstance());
  std::vector<vtkIdType> points = TakeCells(part.Mesh, cells, {}, mesh);
  Writer writer(message);
  writer.Put(static_cast<vtkIdType>(vtkPolyData::SafeDownCast(mesh) ? 1 : 0));
  PutCells(mesh, writer);
  PutValues(mesh, writer);
  AddFieldArrays(part.Mesh->GetFieldData(), IsStampedList, mesh->GetFieldData());
  PutArrays(mesh->GetFieldData(), CanBeSent, writer);
  writer.Put(static_cast<vtkIdType>(part.Index));
  writer.Put(Select(part.Points, points));
  writer.Put(Select(part.Cells, cells));
  return points;
}

void UnpackCells(const std::vector<char>& message, std::vector<MeshPart>& parts)
{
  for (Reader reader(message); !reader.IsAtEnd();)
  {
    MeshPart part;
    part.Mesh = MakeMesh(reader.GetId() == 1);
    GetCells(reader, part.Mesh);
    GetValues(reader, part.Mesh);
    GetArrays(reader, part.Mesh->GetFieldData());
    part.Index = static_cast<int>(reader.GetId());
    part.Points = reader.GetIds();
    part.Cells = reader.GetIds();
    parts.push_back(std::move(part));
  }
}

void PackValues(const MeshPart& part, const std::vector<vtkIdType>& points,
  const std::vector<vtkIdType>& cells, std::vector<char>& message)
{
  auto mesh = vtkSmartPointer<vtkPointSet>::Take(part.Mesh->NewInstance());
  TakeValues(part.Mesh, points, cells, mesh);
  Writer writer(message);
  PutValues(mesh, writer);
}

void UnpackValues(const std::vector<char>& message, const std::vector<MeshPart*>& parts)
{
  Reader reader(message);
  for (MeshPart* part : parts)
  {
    GetValues(reader, part->Mesh);
  }
}

}
