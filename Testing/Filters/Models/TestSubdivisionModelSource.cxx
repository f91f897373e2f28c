// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionModelSource.cxx
 * Every model is a valid complex with the promised parts and arrays, and what VTK reads from Data/.
 */
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkSubdivisionModelSource.h"

#include "vtkCellType.h"
#include "vtkMath.h"
#include "vtkMultiDimensionalSubdivision.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <cstdlib>

namespace
{

using multi_dimensional_subdivision_tools::Compare;
using multi_dimensional_subdivision_tools::LoadModel;
using multi_dimensional_subdivision_tools::Messages;
using Simplex = std::vector<vtkIdType>; // sorted
using Vector = std::array<double, 3>;

constexpr double Tolerance = 1e-3; // closer than this counts as touching

/// The model as plain numbers, and the geometry that the checks need.
struct Complex
{
  explicit Complex(vtkUnstructuredGrid* grid)
  {
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      this->Points.emplace_back();
      grid->GetPoint(i, this->Points.back().data());
    }
    vtkNew<vtkIdList> ids;
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      grid->GetCellPoints(i, ids);
      this->Cells.emplace_back(ids->begin(), ids->end());
      Simplex sorted = this->Cells.back();
      std::sort(sorted.begin(), sorted.end());
      this->AddFaces(sorted);
    }
  }

  void AddFaces(const Simplex& simplex)
  {
    if (this->Closure[simplex.size()].insert(simplex).second && simplex.size() > 1)
    {
      for (std::size_t i = 0; i < simplex.size(); ++i)
      {
        Simplex face = simplex;
        face.erase(face.begin() + i);
        this->AddFaces(face);
      }
    }
  }

  Vector Edge(vtkIdType a, vtkIdType b) const
  {
    Vector u;
    vtkMath::Subtract(this->Points[b].data(), this->Points[a].data(), u.data());
    return u;
  }

  /// Six times the volume.
  double Volume(const Simplex& t) const
  {
    const Vector u = this->Edge(t[0], t[1]);
    const Vector v = this->Edge(t[0], t[2]);
    const Vector w = this->Edge(t[0], t[3]);
    return vtkMath::Determinant3x3(u.data(), v.data(), w.data());
  }

  /// The smallest distance found from `x` to the simplex, by projection to its plane and its faces.
  double Distance(const Vector& x, const Simplex& s) const;

  std::vector<Vector> Points;
  std::vector<Simplex> Cells;
  std::set<Simplex> Closure[5]; // by number of points
};

/// The nearest point of a simplex lies inside it, or on one of its faces.
double Complex::Distance(const Vector& x, const Simplex& s) const
{
  Vector r;
  vtkMath::Subtract(x.data(), this->Points[s[0]].data(), r.data());
  if (s.size() == 1)
  {
    return vtkMath::Norm(r.data());
  }
  // Least squares: the barycentric coordinates of the projection, by Cramer's rule.
  const int n = static_cast<int>(s.size()) - 1;
  double gram[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  double rhs[3] = { 0, 0, 0 };
  std::vector<Vector> edges;
  for (int i = 0; i < n; ++i)
  {
    edges.push_back(this->Edge(s[0], s[i + 1]));
  }
  for (int i = 0; i < n; ++i)
  {
    rhs[i] = vtkMath::Dot(edges[i].data(), r.data());
    for (int j = 0; j < n; ++j)
    {
      gram[i][j] = vtkMath::Dot(edges[i].data(), edges[j].data());
    }
  }
  double inverse[3][3];
  vtkMath::Invert3x3(gram, inverse);
  double weights[3];
  vtkMath::Multiply3x3(inverse, rhs, weights);
  double sum = 0.0;
  bool inside = true;
  for (int i = 0; i < n; ++i)
  {
    sum += weights[i];
    inside = inside && weights[i] >= 0.0;
    for (int k = 0; k < 3; ++k)
    {
      r[k] -= weights[i] * edges[i][k];
    }
  }
  if (inside && sum <= 1.0)
  {
    return vtkMath::Norm(r.data());
  }
  double distance = VTK_DOUBLE_MAX;
  for (std::size_t i = 0; i < s.size(); ++i)
  {
    Simplex face = s;
    face.erase(face.begin() + i);
    distance = std::min(distance, this->Distance(x, face));
  }
  return distance;
}

bool Disjoint(const Simplex& a, const Simplex& b)
{
  return std::none_of(a.begin(), a.end(),
    [&b](vtkIdType id) { return std::find(b.begin(), b.end(), id) != b.end(); });
}

/// Whether an edge passes through the triangle, its border included.
bool EdgeCrossesTriangle(const Complex& c, const Simplex& edge, const Simplex& t)
{
  const auto side = [&c](vtkIdType i, vtkIdType j, vtkIdType k, vtkIdType l)
  { return c.Volume({ i, j, k, l }); };
  const double p = side(t[0], t[1], t[2], edge[0]);
  const double q = side(t[0], t[1], t[2], edge[1]);
  if (p * q >= 0.0 || std::min(std::abs(p), std::abs(q)) < 1e-9)
  {
    return false; // touching is found by the distance of the end point, or edge against edge
  }
  const double a = side(edge[0], edge[1], t[0], t[1]);
  const double b = side(edge[0], edge[1], t[1], t[2]);
  const double d = side(edge[0], edge[1], t[2], t[0]);
  return (a >= 0.0 && b >= 0.0 && d >= 0.0) || (a <= 0.0 && b <= 0.0 && d <= 0.0);
}

/// Whether two edges without a common end touch in their interiors.
bool EdgesCross(const Complex& c, const Simplex& e, const Simplex& f)
{
  const Vector u = c.Edge(e[0], e[1]);
  const Vector v = c.Edge(f[0], f[1]);
  const Vector w = c.Edge(e[0], f[0]);
  Vector n;
  vtkMath::Cross(u.data(), v.data(), n.data());
  const double nn = vtkMath::Dot(n.data(), n.data());
  if (nn < 1e-12)
  {
    return false; // parallel: an end would lie inside
  }
  const double s = vtkMath::Determinant3x3(w.data(), v.data(), n.data()) / nn;
  const double t = vtkMath::Determinant3x3(w.data(), u.data(), n.data()) / nn;
  const double gap = std::abs(vtkMath::Dot(w.data(), n.data())) / std::sqrt(nn);
  return gap < Tolerance && s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0;
}

}

class SubdivisionModelSource : public testing::TestWithParam<int>
{
};

INSTANTIATE_TEST_SUITE_P(Models, SubdivisionModelSource,
  testing::Range<int>(0, vtkSubdivisionModelSource::NUMBER_OF_MODELS),
  [](const testing::TestParamInfo<int>& parameter)
  { return std::string(vtkSubdivisionModelSource::GetModelName(parameter.param)); });

TEST_P(SubdivisionModelSource, HasThePromisedParts)
{
  const vtkSmartPointer<vtkUnstructuredGrid> grid = LoadModel(GetParam());
  std::map<int, int> count;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    ++count[grid->GetCellType(i)];
  }
  for (const auto& entry : count)
  {
    EXPECT_TRUE(entry.first == VTK_VERTEX || entry.first == VTK_LINE ||
      entry.first == VTK_TRIANGLE || entry.first == VTK_TETRA)
      << entry.first;
  }
  EXPECT_GE(grid->GetNumberOfCells(), 20);
  EXPECT_LE(grid->GetNumberOfCells(), 600);
  EXPECT_GT(count[VTK_TETRA], 0);
  using Source = vtkSubdivisionModelSource;
  switch (GetParam())
  {
    case Source::MIXED_DIMENSIONS:
    case Source::SHIP:
    case Source::CHARACTER:
      EXPECT_GT(count[VTK_LINE], 0);
      EXPECT_GT(count[VTK_TRIANGLE], 0);
      EXPECT_EQ(count[VTK_VERTEX], 0);
      break;
    case Source::SCREW:
      EXPECT_LT(grid->GetNumberOfPoints(), 20);
      [[fallthrough]];
    case Source::SPRING_AND_VALVE:
      EXPECT_GT(count[VTK_TRIANGLE], 0);
      EXPECT_EQ(count[VTK_LINE], 0);
      break;
    case Source::MECHANICAL_PART:
      EXPECT_GT(count[VTK_TRIANGLE], 0);
      EXPECT_GE(count[VTK_LINE], 16);
      EXPECT_EQ(count[VTK_VERTEX], 4);
      break;
    case Source::CYLINDER:
      EXPECT_EQ(count[VTK_LINE], 16);
      EXPECT_EQ(grid->GetNumberOfCells(), count[VTK_LINE] + count[VTK_TETRA]);
      break;
    default:
      EXPECT_EQ(grid->GetNumberOfCells(), count[VTK_TETRA]);
  }
}

TEST_P(SubdivisionModelSource, IsAValidComplex)
{
  const vtkSmartPointer<vtkUnstructuredGrid> grid = LoadModel(GetParam());
  const Complex complex(grid);
  std::set<Simplex> cells;
  std::map<Simplex, int> tetsOfFace;
  for (const Simplex& cell : complex.Cells)
  {
    Simplex sorted = cell;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_TRUE(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
    EXPECT_TRUE(cells.insert(sorted).second) << "equal cells";
    if (cell.size() == 4)
    {
      double squares = 0.0;
      for (int i = 0; i < 4; ++i)
      {
        for (int j = 0; j < i; ++j)
        {
          const Vector e = complex.Edge(cell[i], cell[j]);
          squares += vtkMath::Dot(e.data(), e.data()) / 6.0;
        }
        Simplex face = sorted;
        face.erase(face.begin() + i);
        ++tetsOfFace[face];
      }
      // 1 for a regular tetrahedron: positive, and no sliver
      EXPECT_GT(complex.Volume(cell) * std::sqrt(2.0) / std::pow(squares, 1.5), 0.15);
    }
  }
  for (const auto& entry : tetsOfFace)
  {
    EXPECT_LE(entry.second, 2);
  }
  EXPECT_EQ(static_cast<vtkIdType>(complex.Closure[1].size()), grid->GetNumberOfPoints())
    << "unused points";
}

/// Two triangles that continue each other run along their edge in opposite directions: else a
/// smooth surface has normals of both sides.
TEST_P(SubdivisionModelSource, SurfacesAreOriented)
{
  const vtkSmartPointer<vtkUnstructuredGrid> grid = LoadModel(GetParam());
  const Complex complex(grid);
  std::map<Simplex, std::vector<bool>> runsUp; // of each triangle at an edge
  std::set<Simplex> excluded;                  // edges of solids, and singular lines
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    const Simplex& cell = complex.Cells[i];
    const bool isSingular = grid->GetCellData()->GetArray("Singular")->GetTuple1(i) != 0.0;
    for (std::size_t j = 0; j < cell.size() && cell.size() > 1; ++j)
    {
      for (std::size_t k = 0; k < j; ++k)
      {
        const Simplex edge = { std::min(cell[j], cell[k]), std::max(cell[j], cell[k]) };
        if (cell.size() == 4 || (cell.size() == 2 && isSingular))
        {
          excluded.insert(edge);
        }
        else if (cell.size() == 3)
        {
          runsUp[edge].push_back((cell[k] < cell[j]) == (j == k + 1));
        }
      }
    }
  }
  for (const auto& [edge, triangles] : runsUp)
  {
    if (triangles.size() == 2 && excluded.count(edge) == 0)
    {
      EXPECT_NE(triangles[0], triangles[1]) << testing::PrintToString(edge);
    }
  }
}

TEST_P(SubdivisionModelSource, CellsMeetOnlyInCommonFaces)
{
  const Complex complex(LoadModel(GetParam()));
  for (int size = 1; size <= 4; ++size) // equal points, T-junctions, points inside cells
  {
    for (const Simplex& simplex : complex.Closure[size])
    {
      for (std::size_t i = 0; i < complex.Points.size(); ++i)
      {
        const vtkIdType id = static_cast<vtkIdType>(i);
        if (Disjoint({ id }, simplex))
        {
          ASSERT_GT(complex.Distance(complex.Points[i], simplex), Tolerance)
            << "point " << i << " touches " << testing::PrintToString(simplex);
        }
      }
    }
  }
  for (const Simplex& edge : complex.Closure[2])
  {
    for (int size = 2; size <= 3; ++size)
    {
      for (const Simplex& other : complex.Closure[size])
      {
        if (Disjoint(edge, other))
        {
          ASSERT_FALSE(size == 2 ? EdgesCross(complex, edge, other)
                                 : EdgeCrossesTriangle(complex, edge, other))
            << testing::PrintToString(edge) << " crosses " << testing::PrintToString(other);
        }
      }
    }
  }
}

TEST_P(SubdivisionModelSource, CarriesItsArrays)
{
  const vtkSmartPointer<vtkUnstructuredGrid> grid = LoadModel(GetParam());
  auto* tension = vtkDoubleArray::SafeDownCast(grid->GetPointData()->GetScalars());
  ASSERT_NE(tension, nullptr);
  EXPECT_STREQ(tension->GetName(), "Tension");
  EXPECT_EQ(tension->GetNumberOfComponents(), 1);
  EXPECT_EQ(tension->GetNumberOfTuples(), grid->GetNumberOfPoints());
  EXPECT_GT(tension->GetRange()[1] - tension->GetRange()[0], 0.5);
  EXPECT_EQ(grid->GetPointData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(grid->GetCellData()->GetNumberOfArrays(), 2);
  for (const char* name : { "MaterialId", "Singular" })
  {
    auto* array = vtkIntArray::SafeDownCast(grid->GetCellData()->GetArray(name));
    ASSERT_NE(array, nullptr) << name;
    EXPECT_EQ(array->GetNumberOfComponents(), 1);
    EXPECT_EQ(array->GetNumberOfTuples(), grid->GetNumberOfCells());
  }
  vtkDataArray* material = grid->GetCellData()->GetArray("MaterialId");
  EXPECT_EQ(material->GetRange()[0], 0.0);
  EXPECT_GE(material->GetRange()[1], 1.0);
  vtkDataArray* singular = grid->GetCellData()->GetArray("Singular");
  const bool flagged = GetParam() == vtkSubdivisionModelSource::MECHANICAL_PART ||
    GetParam() == vtkSubdivisionModelSource::CYLINDER;
  EXPECT_EQ(singular->GetRange()[0], 0.0);
  EXPECT_EQ(singular->GetRange()[1], flagged ? 1.0 : 0.0);
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    EXPECT_FALSE(grid->GetCellType(i) == VTK_TETRA && singular->GetTuple1(i) != 0.0);
  }
}

TEST_P(SubdivisionModelSource, IsDeterministic)
{
  EXPECT_EQ(Compare(LoadModel(GetParam()), LoadModel(GetParam())), "");
}

TEST_P(SubdivisionModelSource, EqualsItsFileInData)
{
  const char* folder = std::getenv("SUBDIVISIONOBJECTS_DATA");
  if (folder == nullptr)
  {
    GTEST_SKIP() << "SUBDIVISIONOBJECTS_DATA is not set";
  }
  const std::string path =
    std::string(folder) + "/" + vtkSubdivisionModelSource::GetModelName(GetParam()) + ".vtu";
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  ASSERT_EQ(reader->CanReadFile(path.c_str()), 1) << path;
  reader->SetFileName(path.c_str());
  reader->Update();
  ASSERT_NE(reader->GetOutput()->GetPointData()->GetScalars(), nullptr);
  EXPECT_EQ(Compare(LoadModel(GetParam()), reader->GetOutput(), false), "");
}

/// Such numbers are exact in the text of the files.
TEST_P(SubdivisionModelSource, NumbersHaveFourDecimals)
{
  const vtkSmartPointer<vtkUnstructuredGrid> grid = LoadModel(GetParam());
  for (vtkDataArray* array : { grid->GetPoints()->GetData(), grid->GetPointData()->GetScalars() })
  {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      {
        const double value = array->GetComponent(i, k);
        EXPECT_EQ(value, std::round(value * 1e4) / 1e4) << "point " << i;
        EXPECT_FALSE(value == 0. && std::signbit(value)) << "point " << i;
      }
    }
  }
}

TEST_P(SubdivisionModelSource, IsSubdividedWithoutAWarning)
{
  for (const int scheme :
    { vtkMultiDimensionalSubdivision::BOX_SPLINE, vtkMultiDimensionalSubdivision::TET_OCT })
  {
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetInputData(LoadModel(GetParam()));
    filter->SetVolumeScheme(scheme);
    filter->SetNumberOfLevels(3);
    filter->Update();
    EXPECT_EQ(messages->Warnings.size() + messages->Errors.size() + messages->Inversions.size(), 0u)
      << scheme;
  }
}

TEST(SubdivisionModelSourceOptions, ModelsHaveNamesAndNumbers)
{
  vtkNew<vtkSubdivisionModelSource> source;
  EXPECT_STREQ(source->GetModelAsString(), "MixedDimensions");
  EXPECT_EQ(source->GetNumberOfInputPorts(), 0);
  source->SetModelToScrew();
  EXPECT_EQ(source->GetModel(), 1);
  source->SetModelToSpringAndValve();
  EXPECT_EQ(source->GetModel(), 2);
  source->SetModelToShip();
  EXPECT_EQ(source->GetModel(), 3);
  source->SetModelToMechanicalPart();
  EXPECT_EQ(source->GetModel(), 4);
  source->SetModelToCharacter();
  EXPECT_EQ(source->GetModel(), 5);
  source->SetModelToMaterialBlock();
  EXPECT_EQ(source->GetModel(), 6);
  source->SetModelToCylinder();
  EXPECT_EQ(source->GetModel(), 7);
  source->SetModelToMixedDimensions();
  EXPECT_EQ(source->GetModel(), 0);
  source->SetModel(99);
  EXPECT_STREQ(source->GetModelAsString(), "Cylinder");
  source->SetModel(-1);
  EXPECT_EQ(source->GetModel(), 0);
  EXPECT_EQ(vtkSubdivisionModelSource::GetModelName(-1), nullptr);
  EXPECT_EQ(vtkSubdivisionModelSource::GetModelName(8), nullptr);
}

TEST(SubdivisionModelSourceOptions, PrecisionOfPoints)
{
  vtkNew<vtkSubdivisionModelSource> source;
  EXPECT_EQ(source->GetOutputPointsPrecision(), vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
  source->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetPoints()->GetDataType(), VTK_FLOAT);
  source->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
}
