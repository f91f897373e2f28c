// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Values/MaterialFields.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Private/ArrayNames.h"
#include "Private/Values/MaterialColours.h"
#include "Private/Values/PointCopies.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace subdivision
{
namespace
{

// ------------------------------------------------------------------------------------------------
// Before the work

/// Whether filters write point arrays of that name themselves: geometry, which has no jumps.
bool IsMade(const std::string& name)
{
  return name == LimitNormalsName || name == LimitTangentNames[0] || name == LimitTangentNames[1];
}

/// Whether a point array becomes a field.
bool IsField(vtkAbstractArray* array, vtkIdType points)
{
  return array && (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE) &&
    array->GetNumberOfComponents() > 0 && array->GetNumberOfTuples() == points &&
    array->GetName() && !IsWeighted(array->GetName()) && !IsMade(array->GetName());
}

/// The mesh that is worked on.
class Control
{
public:
  Control(vtkPointSet* input, vtkDataArray* materials, OtherPartitions* others)
    : Input(input)
    , Places(FindPlaces(FindFirstCopies(input), this->Sources))
    , Mesh(this->JoinCopies())
    , Whole(this->Mesh, materials, others)
  {
  }

  int GetNumberOfColours() const { return this->Whole.NumberOfColours; }
  /// The mesh without fields.
  vtkSmartPointer<vtkPointSet> Get() const { return this->Mesh; }

  /// The material of each point and colour.
  void ListMaterials(InterpolationOptions& options) const
  {
    const int colours = this->GetNumberOfColours();
    options.NumberOfMaterials = std::max(1, this->Whole.NumberOfMaterials);
    options.Materials.assign(
      static_cast<std::size_t>(colours * this->Mesh->GetNumberOfPoints()), 0);
    for (const vtkIdType i : InTurn(this->Whole.GetSize()))
    {
      for (const vtkIdType place : this->Whole.GetPoints(i))
      {
        if (this->Whole.Colours[i] != NoColour && place < this->Mesh->GetNumberOfPoints())
        {
          options.Materials[colours * place + this->Whole.Colours[i]] = this->Whole.Materials[i];
        }
      }
    }
  }

  vtkSmartPointer<vtkPointSet> Make(
    const std::vector<std::string>& cellArrays, const RunOptions& options)
  {
    this->RemoveReserved(options);
    this->AddColours();
    vtkPointData* data = this->Input->GetPointData();
    for (int a = 0; a < data->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = data->GetAbstractArray(a);
      if (IsField(array, this->Input->GetNumberOfPoints()))
      {
        this->AddFields(vtkDataArray::SafeDownCast(array));
      }
    }
    for (const std::string& name : cellArrays)
    {
      this->AddFieldsOfCells(name, options);
    }
    return this->Mesh;
  }

private:
  /// The point of the result that each point of the input is. `sources` gets the points of the
  /// input that they are; empty if all are.
  static std::vector<vtkIdType> FindPlaces(
    const std::vector<vtkIdType>& firsts, std::vector<vtkIdType>& sources)
  {
    std::vector<vtkIdType> places(firsts.size());
    for (const std::size_t i : InTurn(firsts.size()))
    {
      if (firsts[i] == static_cast<vtkIdType>(i))
      {
        places[i] = static_cast<vtkIdType>(sources.size());
        sources.push_back(static_cast<vtkIdType>(i));
      }
      else
      {
        places[i] = places[static_cast<std::size_t>(firsts[i])];
      }
    }
    return places;
  }

  /// The input with one point where it has copies.
  vtkSmartPointer<vtkPointSet> JoinCopies() const
  {
    auto mesh = vtkSmartPointer<vtkPointSet>::Take(this->Input->NewInstance());
    mesh->ShallowCopy(this->Input);
    if (!this->Sources.empty())
    {
      TakePoints(mesh, this->Sources,
        [this](vtkIdType, auto* begin, auto* end)
        {
          for (auto* id = begin; id != end; ++id)
          {
            const bool isKnown = *id >= 0 && *id < this->Input->GetNumberOfPoints();
            *id = isKnown ? static_cast<std::decay_t<decltype(*id)>>(this->Places[*id]) : -1;
          }
        });
    }
    mesh->GetPointData()->RemoveArray(MaterialPointIdsName);
    mesh->GetCellData()->RemoveArray(OwnBlockName);
    return mesh;
  }

  /// Removes arrays with the names of arrays that are added.
  void RemoveReserved(const RunOptions& options)
  {
    for (vtkFieldData* data : { static_cast<vtkFieldData*>(this->Mesh->GetPointData()),
           static_cast<vtkFieldData*>(this->Mesh->GetCellData()) })
    {
      for (int a = data->GetNumberOfArrays() - 1; a >= 0; --a)
      {
        const char* name = data->GetAbstractArray(a)->GetName();
        if (IsWeighted(name) || (name && std::string(name) == ColourName))
        {
          options.Warn("The filter leaves out the array \"" + std::string(name) +
            "\": it uses such names itself. Rename it to keep it.");
          data->RemoveArray(a);
        }
      }
    }
  }

  void AddColours()
  {
    vtkNew<vtkIntArray> colours;
    colours->SetName(ColourName);
    colours->SetNumberOfValues(this->Input->GetNumberOfCells());
    colours->FillValue(NoColour);
    for (vtkIdType i = 0; i < this->Whole.GetSize(); ++i)
    {
      if (this->Whole.Colours[i] != NoColour)
      {
        colours->SetValue(this->Whole.GetCell(i), this->Whole.Colours[i]);
      }
    }
    this->Mesh->GetCellData()->AddArray(colours);
  }

  /// One array of zeros for each colour.
  std::vector<vtkSmartPointer<vtkDataArray>> MakeFields(
    int type, int components, const std::string& name)
  {
    std::vector<vtkSmartPointer<vtkDataArray>> fields;
    for (int colour = 0; colour < this->Whole.NumberOfColours; ++colour)
    {
      fields.push_back(MakeArray(type, components + 1, this->Mesh->GetNumberOfPoints()));
      fields.back()->SetName(MakeFieldName(colour, name).c_str());
      fields.back()->Fill(0.);
      this->Mesh->GetPointData()->AddArray(fields.back());
    }
    return fields;
  }

  /// Calls visit(place, point of the input, colour, cell) for the points of all simplices that have
  /// a colour; not for centres.
  template <typename Visit>
  void ForEachCorner(const Visit& visit) const
  {
    const CellReader cells(this->Input);
    std::vector<vtkIdType> scratch;
    std::vector<vtkIdType> pointAt(this->Places.size()); // of a cell, by place
    vtkIdType last = -1;
    for (vtkIdType i = 0; i < this->Whole.GetSize(); ++i)
    {
      const vtkIdType cell = this->Whole.GetCell(i);
      if (!this->Places.empty() && cell != last)
      {
        const CellIds ids = cells.GetCell(cell, scratch);
        for (vtkIdType k = ids.Size - 1; k >= 0; --k)
        {
          const bool exists = ids.Ids[k] >= 0 && ids.Ids[k] < this->Input->GetNumberOfPoints();
          if (exists)
          {
            pointAt[this->Places[ids.Ids[k]]] = ids.Ids[k];
          }
        }
        last = cell;
      }
      for (const vtkIdType place : this->Whole.GetPoints(i))
      {
        if (this->Whole.Colours[i] != NoColour && place < this->Mesh->GetNumberOfPoints())
        {
          visit(place, this->Places.empty() ? place : pointAt[place], this->Whole.Colours[i], cell);
        }
      }
    }
  }

  /// The values of a point array: from the first cell of a material at a point.
  void AddFields(vtkDataArray* array)
  {
    const int size = array->GetNumberOfComponents();
    const auto fields = this->MakeFields(array->GetDataType(), size, array->GetName());
    this->ForEachCorner(
      [&](vtkIdType place, vtkIdType point, int colour, vtkIdType)
      {
        vtkDataArray* field = fields[static_cast<std::size_t>(colour)];
        if (field->GetComponent(place, size) == 0.)
        {
          for (int k = 0; k < size; ++k)
          {
            field->SetComponent(place, k, array->GetComponent(point, k));
          }
          field->SetComponent(place, size, 1.);
        }
      });
  }

  /// The same for the means of a cell array; also adds the mean of all cells.
  void AddFieldsOfCells(const std::string& name, const RunOptions& options)
  {
    vtkDataArray* array = this->Input->GetCellData()->GetArray(name.c_str());
    if (!array || array->GetNumberOfComponents() < 1 ||
      array->GetNumberOfTuples() != this->Input->GetNumberOfCells() || IsMade(name))
    {
      options.Warn("There is no cell array of numbers, with one for each cell, \"" + name +
        "\" to be made a field. Correct FieldsOfCells.");
      return;
    }
    if (this->Input->GetPointData()->HasArray(name.c_str()))
    {
      options.Warn("The cell array \"" + name +
        "\" does not become a field: there is a point array of that name. Rename one of them.");
      return;
    }
    const int size = array->GetNumberOfComponents();
    auto fields = this->MakeFields(VTK_DOUBLE, size, name);
    fields.push_back(MakeArray(VTK_DOUBLE, size + 1, this->Mesh->GetNumberOfPoints()));
    fields.back()->Fill(0.);
    std::vector<std::pair<vtkIdType, vtkIdType>> seen; // a cell has a point in several pieces
    this->ForEachCorner(
      [&](vtkIdType place, vtkIdType, int, vtkIdType cell) { seen.emplace_back(cell, place); });
    SortDistinct(seen);
    vtkDataArray* colours = this->Mesh->GetCellData()->GetArray(ColourName);
    auto add = [&](vtkDataArray* field, vtkIdType place, vtkIdType cell)
    {
      for (int k = 0; k <= size; ++k)
      {
        const double value = k < size ? array->GetComponent(cell, k) : 1.;
        field->SetComponent(place, k, field->GetComponent(place, k) + value);
      }
    };
    for (const auto& [cell, place] : InTurn(seen))
    {
      add(fields[static_cast<std::size_t>(colours->GetComponent(cell, 0))], place, cell);
      add(fields.back(), place, cell);
    }
    const auto mean = MakeArray(VTK_DOUBLE, size, this->Mesh->GetNumberOfPoints());
    CopyLooks(array, mean);
    for (const auto& field : fields)
    {
      for (const vtkIdType p : InTurn(this->Mesh->GetNumberOfPoints()))
      {
        const double weight = std::max(1., field->GetComponent(p, size));
        for (int k = 0; k <= size; ++k)
        {
          field->SetComponent(p, k, field->GetComponent(p, k) / weight);
          if (k < size)
          {
            mean->SetComponent(p, k, field->GetComponent(p, k));
          }
        }
      }
    }
    this->Mesh->GetPointData()->AddArray(mean);
  }

  vtkPointSet* Input;
  std::vector<vtkIdType> Sources; ///< the point of the input that each point is; empty: the same
  std::vector<vtkIdType> Places;  ///< the opposite
  vtkSmartPointer<vtkPointSet> Mesh;
  ColouredSimplices Whole;
};

// ------------------------------------------------------------------------------------------------
// After the work

int CountBits(ColourMask mask)
{
  int count = 0;
  for (; mask != 0; mask &= mask - 1)
  {
    ++count;
  }
  return count;
}

int FindLowestBit(ColourMask mask)
{
  return mask == 0 ? NoColour : CountBits((mask & (~mask + 1)) - 1);
}

/// Gives the points of an output a copy for each colour beyond the first.
class Tear
{
public:
  explicit Tear(vtkPointSet* output)
    : Output(output)
    , NumberOfPoints(output->GetNumberOfPoints())
  {
    this->FindColours();
    this->Sources.resize(static_cast<std::size_t>(this->NumberOfPoints));
    std::iota(this->Sources.begin(), this->Sources.end(), 0);
    for (const vtkIdType p : InTurn(this->NumberOfPoints))
    {
      ColourMask mask = this->Masks[static_cast<std::size_t>(p)];
      this->ColourOf.push_back(FindLowestBit(mask));
      this->FirstCopies.push_back(static_cast<vtkIdType>(this->Sources.size()));
      const int copies = CountBits(mask) - 1;
      this->Sources.insert(this->Sources.end(), static_cast<std::size_t>(std::max(0, copies)), p);
    }
    for (const vtkIdType p : InTurn(this->NumberOfPoints))
    {
      const ColourMask mask = this->Masks[static_cast<std::size_t>(p)];
      for (ColourMask rest = mask & (mask - 1); mask != 0 && rest != 0; rest &= rest - 1)
      {
        this->ColourOf.push_back(FindLowestBit(rest));
      }
    }
  }

  void Run()
  {
    this->TakeFields();
    if (this->Sources.size() > static_cast<std::size_t>(this->NumberOfPoints))
    {
      TakePoints(this->Output, this->Sources,
        [this](vtkIdType cell, auto* begin, auto* end) { this->Change(cell, begin, end); });
      this->Output->GetPointData()->SetGlobalIds(nullptr); // copies have the same
    }
    for (const auto& field : this->Fields)
    {
      AddInstead(this->Output->GetPointData(), field, this->Output->GetPointData());
    }
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName(MaterialPointIdsName);
    ids->SetNumberOfValues(static_cast<vtkIdType>(this->Sources.size()));
    std::copy(this->Sources.begin(), this->Sources.end(), ids->GetPointer(0));
    // Where other partitions have parts of the output, points are known by their numbers in it.
    vtkDataArray* numbers = this->Output->GetPointData()->GetArray(PointNumbersName);
    for (const vtkIdType p : InTurn(numbers ? ids->GetNumberOfValues() : vtkIdType(0)))
    {
      ids->SetValue(p, ToId(numbers->GetComponent(p, 0)));
    }
    this->Output->GetPointData()->AddArray(ids);
    this->Output->GetCellData()->RemoveArray(ColourName);
    this->Output->GetCellData()->RemoveArray(MergedPartsName);
  }

private:
  /// The colours of cells, and of all cells at each point.
  void FindColours()
  {
    vtkDataArray* colours = this->Output->GetCellData()->GetArray(ColourName);
    for (const vtkIdType c : InTurn(this->Output->GetNumberOfCells()))
    {
      this->CellColours.push_back(
        colours ? static_cast<int>(colours->GetComponent(c, 0)) : NoColour);
    }
    this->Masks = FindColoursAtPoints(this->Output);
  }

  /// Takes the arrays of the colours out of the point data, and makes arrays of them that have a
  /// value for each copy.
  void TakeFields()
  {
    vtkPointData* data = this->Output->GetPointData();
    std::vector<vtkSmartPointer<vtkDataArray>> weighted;
    for (int a = data->GetNumberOfArrays() - 1; a >= 0; --a)
    {
      vtkDataArray* array = data->GetArray(a);
      if (array && IsWeighted(array->GetName()))
      {
        weighted.emplace_back(array);
        data->RemoveArray(a);
      }
    }
    for (int a = 0; a < data->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* array = data->GetArray(a);
      std::vector<vtkDataArray*> fields;
      for (int colour = 0; array && array->GetName() && colour < MaximumNumberOfColours; ++colour)
      {
        const std::string name = MakeFieldName(colour, array->GetName());
        const auto found = std::find_if(weighted.begin(), weighted.end(),
          [&](vtkDataArray* field)
          {
            return name == field->GetName() && array->GetDataType() == field->GetDataType() &&
              array->GetNumberOfComponents() + 1 == field->GetNumberOfComponents();
          });
        if (found == weighted.end())
        {
          break;
        }
        fields.push_back(*found);
      }
      if (!fields.empty())
      {
        array->GetDataType() == VTK_FLOAT ? this->AddField<float>(array, fields)
                                          : this->AddField<double>(array, fields);
      }
    }
  }

  template <typename Value>
  void AddField(vtkDataArray* joint, const std::vector<vtkDataArray*>& fields)
  {
    const int size = joint->GetNumberOfComponents();
    const auto result =
      MakeArray(joint->GetDataType(), size, static_cast<vtkIdType>(this->Sources.size()));
    CopyLooks(joint, result);
    auto read = [](vtkDataArray* array) { return static_cast<Value*>(array->GetVoidPointer(0)); };
    Value* values = read(result);
    ForEach(result->GetNumberOfTuples(),
      [&](vtkIdType i)
      {
        const vtkIdType source = this->Sources[static_cast<std::size_t>(i)];
        const int colour = this->ColourOf[static_cast<std::size_t>(i)];
        const Value* tuple = colour == NoColour
          ? nullptr
          : read(fields[static_cast<std::size_t>(colour)]) + source * (size + 1);
        const bool isKnown = tuple && tuple[size] > 0;
        std::copy_n(isKnown ? tuple : read(joint) + source * size, size, values + i * size);
      });
    this->Fields.push_back(result);
  }

  template <typename Id>
  void Change(vtkIdType cell, Id* begin, Id* end) const
  {
    int colour = this->CellColours[static_cast<std::size_t>(cell)];
    if (colour == NoColour) // a cell on others
    {
      ColourMask common = ~ColourMask(0);
      for (const Id* id = begin; id != end; ++id)
      {
        common &= this->Masks[static_cast<std::size_t>(*id)];
      }
      colour = FindLowestBit(common);
    }
    for (Id* id = begin; colour != NoColour && id != end; ++id)
    {
      const ColourMask mask = this->Masks[static_cast<std::size_t>(*id)];
      const int before = CountBits(mask & ((ColourMask(1) << colour) - 1));
      if (before > 0)
      {
        *id = static_cast<Id>(this->FirstCopies[static_cast<std::size_t>(*id)] + before - 1);
      }
    }
  }

  vtkPointSet* Output;
  vtkIdType NumberOfPoints;
  std::vector<int> CellColours;
  std::vector<ColourMask> Masks;      ///< of the points before
  std::vector<vtkIdType> FirstCopies; ///< of the points before
  std::vector<vtkIdType> Sources;     ///< the point that each point and each copy is
  std::vector<int> ColourOf;          ///< of each point and each copy
  std::vector<vtkSmartPointer<vtkDataArray>> Fields;
};

}

bool RunWithMaterialFields(vtkPointSet* input, vtkPointSet* output, RunOptions& options,
  const MaterialFieldOptions& fields, const std::function<bool(vtkPointSet*, vtkPointSet*)>& work)
{
  const bool hasCopies = input->GetPointData()->HasArray(MaterialPointIdsName);
  const vtkSmartPointer<vtkDataArray> blocks = input->GetCellData()->GetArray(OwnBlockName);
  vtkDataArray* const parts =
    fields.OfMergedParts ? input->GetCellData()->GetArray(MergedPartsName) : nullptr;
  // Where no points were merged there are no values of theirs to keep.
  bool isOn = (fields.OfMergedParts ? parts != nullptr : fields.IsOn) || blocks;
  if (!isOn)
  {
    vtkSmartPointer<vtkPointSet> mesh = input;
    if (hasCopies)
    {
      options.Warn("An earlier filter made copies of points where materials meet. This one does "
                   "not join them, so that the mesh has cracks there: switch PreserveInterfaces "
                   "and InterfaceValues on here too.");
      mesh = vtkSmartPointer<vtkPointSet>::Take(input->NewInstance());
      mesh->ShallowCopy(input);
      mesh->GetPointData()->RemoveArray(MaterialPointIdsName);
    }
    return work(mesh, output);
  }
  vtkSmartPointer<vtkPointSet> mesh;
  {
    Control control(input,
      parts      ? parts
        : blocks ? blocks.Get()
                 : options.Features.Material.Get(),
      options.Others);
    const bool areTooMany = control.GetNumberOfColours() > MaximumNumberOfColours;
    if (areTooMany && !fields.IsOn)
    {
      options.Warn("More than " + std::to_string(MaximumNumberOfColours) +
        " blocks meet in one another with different values: those of the first are taken at each "
        "point that they share. Switch JoinBlocks off, or join some of the blocks.");
    }
    else if (areTooMany)
    {
      options.Fail(std::string(fields.OfMergedParts ? "MergedValues" : "InterfaceValues") +
        ": more than " + std::to_string(MaximumNumberOfColours) + " materials or parts meet, and " +
        std::to_string(control.GetNumberOfColours()) +
        " fields would be needed. Use fewer of them, or values that do not jump.");
      return false;
    }
    isOn = !areTooMany;
    mesh = isOn ? control.Make(fields.CellArrays, options) : control.Get();
    if (isOn)
    {
      control.ListMaterials(options.Interpolation);
    }
  }
  options.HasMaterialFields = isOn;
  const bool isDone = work(mesh, output);
  options.HasMaterialFields = false;
  if (isDone && isOn && output->GetPoints())
  {
    Tear(output).Run();
  }
  return isDone;
}

}
