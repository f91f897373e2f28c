// SPDX-License-Identifier: BSD-3-Clause
#include "PartitionTools.h"

#include "Private/Distribution/PointIds.h"

#include "vtkDataSetSurfaceFilter.h"
#include "vtkSubdivisionModelSource.h"

#include <cstring>

namespace partition_tools
{

using namespace multi_dimensional_subdivision_tools;

namespace
{

constexpr const char* CellIdsName = "CellIds";

vtkSmartPointer<vtkIdTypeArray> MakeIds(const char* name, const std::vector<vtkIdType>& values)
{
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(name);
  for (const vtkIdType value : values)
  {
    ids->InsertNextValue(value);
  }
  return ids;
}

std::vector<vtkIdType> FindUnused(vtkPointSet* mesh)
{
  std::vector<char> isUsed(static_cast<size_t>(mesh->GetNumberOfPoints()), 0);
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    mesh->GetCellPoints(c, ids);
    for (const vtkIdType id : *ids)
    {
      isUsed[static_cast<size_t>(id)] = 1;
    }
  }
  std::vector<vtkIdType> unused;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    if (!isUsed[static_cast<size_t>(p)])
    {
      unused.push_back(p);
    }
  }
  return unused;
}

/// Whether tuple i of one array is tuple k of another, of those that are no plain numbers.
bool IsSameTuple(vtkAbstractArray* a, vtkIdType i, vtkAbstractArray* b, vtkIdType k)
{
  const int components = a->GetNumberOfComponents();
  for (int c = 0; c < components; ++c)
  {
    if (a->GetVariantValue(i * components + c) != b->GetVariantValue(k * components + c))
    {
      return false;
    }
  }
  return true;
}

/// Whether an array has ids that count in the part.
bool CountsInPart(const std::string& name)
{
  return name == "OctahedronId" || name == "GreenParent" || name == "vtkOriginalCellIds" ||
    name == "vtkOriginalPointIds" || name == "MaterialPointIds";
}

/// Two arrays of the same name, and their bytes where these can be compared.
struct Pair
{
  Pair(vtkAbstractArray* ours, vtkAbstractArray* theirs)
    : Ours(ours)
    , Theirs(theirs)
  {
    if (vtkDataArray::SafeDownCast(ours) && ours->GetDataType() != VTK_BIT &&
      ours->GetDataType() == theirs->GetDataType() && ours->HasStandardMemoryLayout() &&
      theirs->HasStandardMemoryLayout())
    {
      this->Bytes = static_cast<size_t>(ours->GetNumberOfComponents() * ours->GetDataTypeSize());
      this->OurBytes = static_cast<const char*>(ours->GetVoidPointer(0));
      this->TheirBytes = static_cast<const char*>(theirs->GetVoidPointer(0));
    }
  }
  bool IsSame(vtkIdType i, vtkIdType k) const
  {
    return this->Bytes == 0
      ? IsSameTuple(this->Ours, i, this->Theirs, k)
      : std::memcmp(this->OurBytes + static_cast<size_t>(i) * this->Bytes,
          this->TheirBytes + static_cast<size_t>(k) * this->Bytes, this->Bytes) == 0;
  }

  vtkAbstractArray* Ours;
  vtkAbstractArray* Theirs;
  size_t Bytes = 0;
  const char* OurBytes = nullptr;
  const char* TheirBytes = nullptr;
};

using Pairs = std::vector<Pair>;

std::string ListNames(vtkFieldData* data)
{
  std::string names;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    names += std::string(data->GetArrayName(a)) + " ";
  }
  return names;
}

Pairs PairArrays(vtkFieldData* whole, vtkFieldData* part)
{
  Pairs pairs;
  // Where parts have ids of cells, their children have these too, and points that no step made have
  // ids of points; a whole has none.
  const auto addsIds = [&](const char* name)
  { return part->HasArray(name) && !whole->HasArray(name); };
  const bool hasIds = addsIds(CellIdsName) || addsIds("PointIds");
  EXPECT_EQ(whole->GetNumberOfArrays(), part->GetNumberOfArrays() - (hasIds ? 1 : 0))
    << ListNames(whole) << "| " << ListNames(part);
  for (int a = 0; a < whole->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* ours = whole->GetAbstractArray(a);
    vtkAbstractArray* theirs = part->GetAbstractArray(ours->GetName());
    EXPECT_TRUE(theirs) << ours->GetName();
    if (theirs && !CountsInPart(ours->GetName()))
    {
      EXPECT_EQ(ours->GetDataType(), theirs->GetDataType()) << ours->GetName();
      pairs.emplace_back(ours, theirs);
    }
  }
  return pairs;
}

std::string FindDifference(const Pairs& pairs, vtkIdType i, vtkIdType k)
{
  for (const Pair& pair : pairs)
  {
    if (!pair.IsSame(i, k))
    {
      return pair.Ours->GetName() ? pair.Ours->GetName() : "coordinates";
    }
  }
  return std::string();
}

/// The cells of a mesh by their number, in their order.
std::vector<std::vector<vtkIdType>> SortCells(vtkPointSet* mesh, vtkIdType numbers)
{
  std::vector<std::vector<vtkIdType>> cells(static_cast<size_t>(numbers));
  vtkDataArray* array = mesh->GetCellData()->GetArray(CellName);
  for (vtkIdType c = 0; array && c < mesh->GetNumberOfCells(); ++c)
  {
    cells[static_cast<size_t>(array->GetTuple1(c))].push_back(c);
  }
  return cells;
}

}

void NumberCells(vtkPointSet* mesh)
{
  vtkNew<vtkIntArray> numbers;
  numbers->SetName(CellName);
  numbers->SetNumberOfValues(mesh->GetNumberOfCells());
  std::iota(numbers->GetPointer(0), numbers->GetPointer(0) + numbers->GetNumberOfValues(), 0);
  mesh->GetCellData()->AddArray(numbers);
}

std::vector<Mesh> MakeMeshes()
{
  std::vector<Mesh> meshes;
  for (int model = 0; model < vtkSubdivisionModelSource::NUMBER_OF_MODELS; ++model)
  {
    vtkNew<vtkSubdivisionModelSource> source;
    source->SetModel(model);
    source->Update();
    meshes.push_back(DeepCopy(source->GetOutput()));
  }
  meshes.push_back(MakeMixedBox(3));
  for (const Mesh& mesh : meshes)
  {
    AddArrays(vtkUnstructuredGrid::SafeDownCast(mesh));
    NumberCells(mesh);
  }
  return meshes;
}

/// Adds what criteria read: a wanted level that is high in few cells, and a field with a front.
void AddFields(vtkPointSet* mesh)
{
  vtkNew<vtkIntArray> wanted;
  wanted->SetName(WantedName);
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    wanted->InsertNextValue(c % 23 == 5 ? 3 : (c % 7 == 1 ? 1 : 0));
  }
  mesh->GetCellData()->AddArray(wanted);
  vtkNew<vtkDoubleArray> field;
  field->SetName(FieldName);
  double box[6];
  mesh->GetBounds(box);
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    const double* x = mesh->GetPoint(p);
    const double along = (x[0] - box[0]) / (box[1] - box[0]) + 0.2 * x[1];
    field->InsertNextValue(std::tanh(20. * (along - 0.5)));
  }
  mesh->GetPointData()->AddArray(field);
}

Mesh MakeSkin(vtkPointSet* mesh)
{
  vtkNew<vtkDataSetSurfaceFilter> filter;
  filter->SetInputData(mesh);
  filter->Update();
  const auto skin = Mesh::Take(vtkPolyData::New());
  skin->DeepCopy(filter->GetOutput());
  NumberCells(skin);
  return skin;
}

std::vector<Mesh> Cut(vtkPointSet* whole, const std::vector<int>& partOf, int parts, KnownBy known)
{
  std::vector<Mesh> cut;
  for (int part = 0; part < parts; ++part)
  {
    std::vector<vtkIdType> cells;
    for (size_t c = 0; c < partOf.size(); ++c)
    {
      if (partOf[c] == part)
      {
        cells.push_back(static_cast<vtkIdType>(c));
      }
    }
    const auto mesh = Mesh::Take(whole->NewInstance());
    const std::vector<vtkIdType> points = subdivision::TakeCells(
      whole, cells, part == 0 ? FindUnused(whole) : std::vector<vtkIdType>(), mesh);
    if (known == KnownBy::GlobalIds)
    {
      mesh->GetPointData()->SetGlobalIds(MakeIds("PointIds", points));
      mesh->GetCellData()->SetGlobalIds(MakeIds(CellIdsName, cells));
    }
    cut.push_back(mesh);
  }
  return cut;
}

std::vector<int> CutByChance(vtkPointSet* whole, int parts, unsigned seed)
{
  std::mt19937 chance(seed);
  std::vector<int> partOf(static_cast<size_t>(whole->GetNumberOfCells()));
  for (int& part : partOf)
  {
    part = static_cast<int>(chance() % static_cast<unsigned>(parts));
  }
  return partOf;
}

std::vector<int> CutInSlabs(vtkPointSet* whole, int parts)
{
  std::vector<std::pair<double, vtkIdType>> order;
  for (vtkIdType c = 0; c < whole->GetNumberOfCells(); ++c)
  {
    double box[6];
    whole->GetCellBounds(c, box);
    order.emplace_back(box[0] + box[1], c);
  }
  std::sort(order.begin(), order.end());
  std::vector<int> partOf(order.size());
  for (size_t i = 0; i < order.size(); ++i)
  {
    partOf[order[i].second] = static_cast<int>(i * static_cast<size_t>(parts) / order.size());
  }
  return partOf;
}

std::vector<Mesh> Cut(vtkPointSet* whole, const Partition& partition)
{
  const int count = partition.Parts * partition.Blocks;
  return Cut(whole, partition.ByChance ? CutByChance(whole, count, 17) : CutInSlabs(whole, count),
    count, partition.Known);
}

bool RunOnParts(const std::vector<Mesh>& cut, const Partition& partition,
  const subdivision::DistributionOptions& distribution, subdivision::RunOptions& options,
  const subdivision::FilterWork& work, std::vector<Mesh>& outputs)
{
  const int parts = partition.Parts + partition.Empty;
  std::vector<std::vector<subdivision::Block>> blocks(static_cast<size_t>(parts));
  outputs.clear();
  for (size_t i = 0; i < cut.size(); ++i)
  {
    outputs.push_back(subdivision::MakeMesh(distribution.IsOfSurfaces));
    const size_t part = i / static_cast<size_t>(partition.Blocks);
    blocks[static_cast<size_t>(partition.Empty) + part].push_back({ cut[i], outputs.back(), 0 });
  }
  subdivision::PartitionsOfRank partitions(nullptr, parts);
  return RunPartitions(
    blocks, partitions, distribution, subdivision::FilterTraits(), options, work);
}

Mesh Renumber(const std::vector<Mesh>& cut)
{
  std::vector<subdivision::MeshPart> parts;
  for (const Mesh& mesh : cut)
  {
    parts.push_back({ mesh, 0, {}, {} });
  }
  subdivision::PartitionsOfRank alone;
  subdivision::ExchangeOfAll exchange(alone);
  IdentifyPoints(parts, exchange, [](const std::string& message) { ADD_FAILURE() << message; });
  const Mesh whole = Join(parts).Mesh;
  whole->GetCellData()->RemoveArray(subdivision::BlockName);
  return whole;
}

namespace
{

/// The corners of a cell.
std::vector<Point> GetCorners(vtkPointSet* mesh, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  std::vector<Point> corners;
  for (const vtkIdType id : *ids)
  {
    corners.push_back(GetPoint(mesh, id));
  }
  return corners;
}

using Corners = std::set<std::vector<Point>>;

/// The cells of `whole` around those in `own`.
Corners FindLayer(vtkPointSet* whole, const Corners& own)
{
  std::set<Point> points;
  for (const auto& corners : own)
  {
    points.insert(corners.begin(), corners.end());
  }
  Corners layer;
  for (vtkIdType c = 0; c < whole->GetNumberOfCells(); ++c)
  {
    const std::vector<Point> corners = GetCorners(whole, c);
    if (own.count(corners) == 0 &&
      std::any_of(
        corners.begin(), corners.end(), [&](const Point& p) { return points.count(p) > 0; }))
    {
      layer.insert(corners);
    }
  }
  return layer;
}

}

void ExpectGhosts(vtkPointSet* whole, vtkPointSet* part)
{
  vtkUnsignedCharArray* types = part->GetCellGhostArray();
  ASSERT_TRUE(types);
  Corners own;
  Corners ghosts;
  for (vtkIdType c = 0; c < part->GetNumberOfCells(); ++c)
  {
    (types->GetValue(c) ? ghosts : own).insert(GetCorners(part, c));
  }
  for (const auto& corners : own) // some cells are there twice
  {
    ghosts.erase(corners);
  }
  EXPECT_TRUE(ghosts == FindLayer(whole, own));
  EXPECT_FALSE(own.empty());
}

void ExpectWhole(vtkPointSet* whole, const std::vector<Mesh>& parts)
{
  vtkDataArray* numbers = whole->GetCellData()->GetArray(CellName);
  ASSERT_TRUE(numbers);
  const auto size = static_cast<vtkIdType>(numbers->GetRange(0)[1]) + 1;
  const std::vector<std::vector<vtkIdType>> cells = SortCells(whole, size);
  std::vector<char> isFound(static_cast<size_t>(whole->GetNumberOfPoints()), 0);
  std::vector<char> isTaken(static_cast<size_t>(size), 0);
  vtkNew<vtkIdList> ours;
  vtkNew<vtkIdList> theirs;
  vtkIdType numberOfCells = 0;
  for (size_t p = 0; p < parts.size(); ++p)
  {
    SCOPED_TRACE("part " + std::to_string(p));
    vtkPointSet* part = parts[p];
    if (part->GetNumberOfPoints() == 0)
    {
      continue;
    }
    numberOfCells += part->GetNumberOfCells();
    Pairs pointArrays = PairArrays(whole->GetPointData(), part->GetPointData());
    pointArrays.emplace_back(whole->GetPoints()->GetData(), part->GetPoints()->GetData());
    const Pairs cellArrays = PairArrays(whole->GetCellData(), part->GetCellData());
    std::vector<vtkIdType> pointOf(static_cast<size_t>(part->GetNumberOfPoints()), -1);
    std::vector<char> isThere(static_cast<size_t>(whole->GetNumberOfPoints()), 0);
    const std::vector<std::vector<vtkIdType>> own = SortCells(part, size);
    for (size_t n = 0; n < own.size(); ++n)
    {
      if (own[n].empty())
      {
        continue;
      }
      ASSERT_FALSE(isTaken[n]) << "cell " << n << " is in several parts";
      isTaken[n] = 1;
      ASSERT_EQ(cells[n].size(), own[n].size()) << "of cell " << n;
      for (size_t i = 0; i < own[n].size(); ++i)
      {
        whole->GetCellPoints(cells[n][i], ours);
        part->GetCellPoints(own[n][i], theirs);
        ASSERT_EQ(whole->GetCellType(cells[n][i]), part->GetCellType(own[n][i]));
        ASSERT_EQ(ours->GetNumberOfIds(), theirs->GetNumberOfIds());
        ASSERT_EQ(std::string(), FindDifference(cellArrays, cells[n][i], own[n][i]))
          << "cell " << cells[n][i];
        for (vtkIdType k = 0; k < ours->GetNumberOfIds(); ++k)
        {
          vtkIdType& point = pointOf[theirs->GetId(k)];
          if (point < 0)
          {
            point = ours->GetId(k);
            isFound[point] = 1;
            ASSERT_FALSE(isThere[point]) << "point " << point << " is there twice";
            isThere[point] = 1;
            ASSERT_EQ(std::string(), FindDifference(pointArrays, point, theirs->GetId(k)))
              << "point " << point;
          }
          ASSERT_EQ(point, ours->GetId(k));
        }
      }
    }
  }
  EXPECT_EQ(whole->GetNumberOfCells(), numberOfCells);
  for (const vtkIdType point : FindUnused(whole))
  {
    isFound[point] = 1;
  }
  EXPECT_EQ(0, std::count(isFound.begin(), isFound.end(), 0));
}

namespace
{

/// The corners of a cell, by their global ids if there are any.
std::vector<vtkIdType> GetCornerIds(vtkPointSet* mesh, vtkIdType cell)
{
  vtkDataArray* numbers = mesh->GetPointData()->GetGlobalIds();
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  std::vector<vtkIdType> corners;
  for (const vtkIdType id : *ids)
  {
    corners.push_back(numbers ? static_cast<vtkIdType>(numbers->GetTuple1(id)) : id);
  }
  return corners;
}

}

void ExpectIndices(vtkPointSet* whole, const std::vector<Mesh>& parts)
{
  std::vector<int> isThere(static_cast<size_t>(whole->GetNumberOfCells()), 0);
  for (const Mesh& part : parts)
  {
    vtkDataArray* points = part->GetPointData()->GetGlobalIds();
    vtkDataArray* cells = part->GetCellData()->GetGlobalIds();
    ASSERT_TRUE(points && cells);
    for (vtkIdType p = 0; p < part->GetNumberOfPoints(); ++p)
    {
      const auto number = static_cast<vtkIdType>(points->GetTuple1(p));
      ASSERT_TRUE(number >= 0 && number < whole->GetNumberOfPoints());
      ASSERT_EQ(GetPoint(whole, number), GetPoint(part, p)) << "point " << p;
    }
    for (vtkIdType c = 0; c < part->GetNumberOfCells(); ++c)
    {
      const auto number = static_cast<vtkIdType>(cells->GetTuple1(c));
      ASSERT_TRUE(number >= 0 && number < whole->GetNumberOfCells());
      ++isThere[static_cast<size_t>(number)];
      ASSERT_EQ(whole->GetCellType(number), part->GetCellType(c));
      ASSERT_EQ(GetCornerIds(whole, number), GetCornerIds(part, c)) << "cell " << c;
    }
  }
  EXPECT_EQ(std::vector<int>(isThere.size(), 1), isThere);
}

}
