// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceLastStep.cxx
 * What is left out of the last levels of a surface, and rings that are found without a walk, change
 * nothing.
 */
#include "SurfaceTools.h"

#include "Core/Surfaces/Scheme/SkippedLevel.h"
#include "Core/Surfaces/Scheme/SurfaceTags.h"
#include "Core/Surfaces/Steps/SurfaceSteps.h"

using namespace surfacetools;

namespace
{

/// Skips levels whatever part of the surface is irregular, or skips none.
struct WithSkippedLevels
{
  explicit WithSkippedLevels(double most = 1.) { MostIrregularVertices = most; }
  ~WithSkippedLevels() { MostIrregularVertices = Default; }
  const double Default = MostIrregularVertices;
};
constexpr double NoLevels = -1.;

class SurfaceLastStep : public testing::TestWithParam<SurfaceSchemeKind>
{
};

std::vector<vtkIdType> GetFaces(const SurfaceSteps<int>& steps, int level)
{
  std::vector<vtkIdType> faces(steps.GetNumberOfCorners(level));
  steps.WriteFaces(level, faces.data());
  std::vector<int> narrow(faces.size());
  steps.WriteFaces(level, narrow.data());
  EXPECT_TRUE(std::equal(faces.begin(), faces.end(), narrow.begin(), narrow.end()));
  return faces;
}

std::vector<int> GetLineEnds(const SurfaceLevel<int>& level)
{
  std::vector<int> ends;
  for (const int line : level.Lines)
  {
    ends.push_back(level.Mesh.EdgeVertices[2 * (line / 2) + line % 2]);
    ends.push_back(level.Mesh.EdgeVertices[2 * (line / 2) + 1 - line % 2]);
  }
  return ends;
}

std::set<vtkIdType> GetParents(const SurfaceSteps<int>& steps, int step, vtkIdType row)
{
  std::vector<vtkIdType> parents;
  steps.GetParents(step, row, parents);
  return { parents.begin(), parents.end() };
}

bool IsLeftOut(const SurfaceLevel<int>& level)
{
  return level.Mesh.Twins.empty() && level.Mesh.NumberOfFaces > 0;
}
int CountLeftOut(const SurfaceSteps<int>& steps)
{
  int count = 0;
  for (int level = 0; level < steps.GetNumberOfSteps(); ++level)
  {
    count += IsLeftOut(steps.GetLevel(level));
  }
  return count;
}

/// Whether the scheme skips the last level but one of this surface.
bool MaySkip(const SurfaceLevel<int>& control, SurfaceSchemeKind kind)
{
  return kind == SurfaceSchemeKind::Loop ||
    (kind == SurfaceSchemeKind::CatmullClark && control.Mesh.Arity == 4);
}
/// How many levels are to be skipped.
int CountSkipped(const SurfaceSteps<int>& steps, SurfaceSchemeKind kind)
{
  const int count = steps.GetNumberOfSteps();
  return count >= 2 && MaySkip(steps.GetLevel(count - 2), kind) ? 1 : 0;
}

template <typename T>
void ExpectEqual(const Buffer<T>& a, const Buffer<T>& b)
{
  EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
}

/// `brief`: steps with what a last step needs, `full`: with whole levels.
void ExpectSameSteps(const SurfaceSteps<int>& brief, const SurfaceSteps<int>& full)
{
  const int count = full.GetNumberOfSteps();
  for (int level = 0; level <= count; ++level)
  {
    EXPECT_EQ(GetFaces(brief, level), GetFaces(full, level)) << level;
  }
  EXPECT_EQ(GetLineEnds(brief.GetLevel(count)), GetLineEnds(full.GetLevel(count)));
  for (int step = 0; step < count; ++step)
  {
    const SparseRows<int> rows = brief.GetStep(step).Store();
    const SparseRows<int> expected = full.GetStep(step).Store();
    ExpectEqual(rows.Offsets, expected.Offsets);
    ExpectEqual(rows.Columns, expected.Columns);
    ExpectEqual(rows.Weights, expected.Weights);
    for (vtkIdType row = 0; row < rows.GetNumberOfRows(); ++row)
    {
      EXPECT_EQ(GetParents(brief, step, row), GetParents(full, step, row));
    }
    ExpectEqual(brief.FindCarriers(step, step + 1), full.FindCarriers(step, step + 1));
    ExpectEqual(brief.FindCarriers(step, count), full.FindCarriers(step, count));
  }
}

/// A torus, of which in most cases some faces are split, in some a vertex is taken out, and in some
/// one face is turned over.
Model MakeTorus(unsigned seed, bool triangles)
{
  constexpr vtkIdType n = 5;
  const auto at = [](vtkIdType i, vtkIdType j) { return (i + n) % n * n + (j + n) % n; };
  std::mt19937 random(seed);
  const auto isDrawn = [&random](double part)
  { return std::uniform_real_distribution<double>(0., 1.)(random) < part; };
  const bool isCut = seed % 3 == 0 && !triangles;
  vtkIdType points = isCut ? n * n - 1 : n * n;
  Model torus;
  if (isCut)
  {
    torus.Faces = { { at(0, -2), at(0, -1), at(0, 0), at(-1, 0), at(-2, 0), at(-2, -1), at(-2, -2),
      at(-1, -2) } };
  }
  for (vtkIdType i = 0; i < n; ++i)
  {
    for (vtkIdType j = 0; j < n; ++j)
    {
      const std::vector<vtkIdType> quad{ at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) };
      if (isCut && i >= n - 2 && j >= n - 2)
      {
        continue;
      }
      if (!triangles && isDrawn(seed % 5 == 4 ? 1. : 0.6))
      {
        torus.Faces.push_back(quad);
      }
      else if (isDrawn(0.5))
      {
        torus.Faces.push_back({ quad[0], quad[1], quad[2] });
        torus.Faces.push_back({ quad[2], quad[3], quad[0] });
      }
      else
      {
        for (std::size_t k = 0; k < 4; ++k)
        {
          torus.Faces.push_back({ quad[k], quad[(k + 1) % 4], points });
        }
        ++points;
      }
    }
  }
  std::shuffle(torus.Faces.begin(), torus.Faces.end(), random);
  for (auto& face : torus.Faces)
  {
    std::rotate(face.begin(), face.begin() + (isDrawn(0.5) ? 2 : 1), face.end());
  }
  if (seed % 4 == 3)
  {
    std::reverse(torus.Faces[0].begin(), torus.Faces[0].end());
  }
  torus.Points = MakeRandomPoints(static_cast<std::size_t>(points), seed);
  return torus;
}

/// A sheet, or faces anywhere on few points, with flags, angles and flatness at random.
class RandomSurface
{
public:
  RandomSurface(unsigned seed, bool triangles)
    : Random(seed)
    , IsSheet(seed % 2 == 0)
    , Surface(MakeSheet(4, 3, triangles, { 1., 0., 0. }, { 0.2, 1., 0. }))
  {
    if (!this->IsSheet)
    {
      this->MakeFaces(triangles ? 3 : 4);
    }
    this->Surface.Points = MakeRandomPoints(this->Surface.Points.size(), seed);
    this->Surface.Lines = { { 0, 1 }, { 3, 9 } };
    const SurfaceLevel<int> level = this->MakeLevel();
    const auto edges = static_cast<std::size_t>(level.Mesh.GetNumberOfEdges());
    const auto points = this->Surface.Points.size();
    this->Features.SharpEdges = this->Draw<unsigned char>(edges, 0.1, 1.);
    this->Features.Corners = this->Draw<unsigned char>(points, 0.1, 1.);
    this->Features.Flatness = this->Draw<double>(points, 0.5, 0.5);
    this->Features.DartEnds = seed % 3 == 0;
    this->Features.Type2 = seed % 4 == 0 ? JointRule::Sharp : JointRule::Blend;
    this->Sharpness = this->Draw<double>(edges, 0.1, this->Pick(0., 4.));
  }

  SurfaceSteps<int> MakeSteps(
    SurfaceSchemeKind kind, int count, LastLevel last, bool semiSharp) const
  {
    const std::shared_ptr<const SurfaceScheme<int>> scheme =
      MakeSurfaceScheme<int>(kind, this->IsSheet);
    const auto classify = [this, &scheme](const SurfaceFeatures& features)
    {
      return ClassifySurface(
        this->MakeLevel().Mesh, *scheme, features, this->Surface.Points.data()->data());
    };
    SurfaceLevel<int> level = this->MakeLevel();
    level.Tags = classify(this->Features);
    SurfaceSteps<int> steps(std::move(level), scheme, count, last, nullptr);
    if (semiSharp && scheme->HalvesEdges())
    {
      steps.SetSharpness(this->Sharpness,
        [&](const std::vector<bool>& edges)
        {
          SurfaceFeatures more = this->Features;
          std::transform(edges.begin(), edges.end(), more.SharpEdges.begin(),
            more.SharpEdges.begin(), [](bool sharp, unsigned char flag) { return sharp || flag; });
          return classify(more);
        });
    }
    return steps;
  }

private:
  SurfaceLevel<int> MakeLevel() const
  {
    return surfacetools::MakeLevel(
      this->Surface.Points.size(), this->Surface.Faces, this->Surface.Lines);
  }
  double Pick(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }
  template <typename T>
  std::vector<T> Draw(std::size_t size, double part, double value)
  {
    std::vector<T> values(size, T(0));
    std::generate(values.begin(), values.end(),
      [&] { return this->Pick(0., 1.) < part ? static_cast<T>(value) : T(0); });
    return values;
  }
  void MakeFaces(std::size_t corners)
  {
    this->Surface.Faces.clear();
    for (int i = 0; i < 14; ++i)
    {
      std::set<vtkIdType> ids;
      while (ids.size() < corners)
      {
        ids.insert(static_cast<vtkIdType>(this->Pick(0., 18.)));
      }
      this->Surface.Faces.emplace_back(ids.begin(), ids.end());
      std::shuffle(
        this->Surface.Faces.back().begin(), this->Surface.Faces.back().end(), this->Random);
    }
  }

  std::mt19937 Random;
  bool IsSheet;
  Model Surface;
  SurfaceFeatures Features;
  EdgeSharpness Sharpness;
};

void ExpectSameLimits(const SurfaceSteps<int>& a, const SurfaceSteps<int>& b, LimitKind kind)
{
  const SparseRows<int> rows = a.GetLimit(kind).Store();
  const SparseRows<int> others = b.GetLimit(kind).Store();
  const auto areEqual = [](const auto& one, const auto& other)
  { return std::equal(one.begin(), one.end(), other.begin(), other.end()); };
  EXPECT_TRUE(areEqual(rows.Offsets, others.Offsets));
  EXPECT_TRUE(areEqual(rows.Columns, others.Columns));
  EXPECT_TRUE(areEqual(rows.Weights, others.Weights));
}

/// Arrays that are gathered.
vtkSmartPointer<vtkPolyData> AddArrays(const vtkSmartPointer<vtkPolyData>& input)
{
  vtkNew<vtkIntArray> marks;
  marks->SetName("marks");
  vtkNew<vtkIntArray> ofCells;
  ofCells->SetName("cells");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    marks->InsertNextValue(7 * i % 11);
  }
  for (int i = 0; i < input->GetNumberOfCells(); ++i)
  {
    ofCells->InsertNextValue(i);
  }
  input->GetPointData()->AddArray(marks);
  input->GetCellData()->AddArray(ofCells);
  return input;
}

void ExpectSameOutputs(const vtkSmartPointer<vtkPolyData>& input, int scheme)
{
  vtkSmartPointer<vtkPolyData> whole;
  {
    const WithSkippedLevels making(NoLevels);
    whole = RunFilter(input, scheme, 4);
  }
  const WithSkippedLevels skipping;
  ExpectSameBits(whole, RunFilter(input, scheme, 4));
  ExpectSameBits(whole, RunFilter(RunFilter(input, scheme, 1), scheme, 3));
  ExpectSameBits(whole, RunFilter(RunFilter(input, scheme, 2), scheme, 2));
  ExpectSameBits(whole, RunFilter(RunFilter(input, scheme, 3), scheme, 1));
}

}

TEST_P(SurfaceLastStep, IsTheSameAsOfWholeLevels)
{
  const WithSkippedLevels skipping;
  const bool triangles = MakeSurfaceScheme<int>(GetParam(), true)->NeedsTriangles();
  for (const auto& entry : MakeZoo(triangles))
  {
    for (int count = 1; count <= 4; ++count)
    {
      SCOPED_TRACE(entry.first + ", " + std::to_string(count) + " steps");
      Walk first(entry.second, GetParam());
      Walk second(entry.second, GetParam());
      const SurfaceSteps<int> brief(
        std::move(first.Level), first.Scheme, count, LastLevel::ForCells, nullptr);
      const SurfaceSteps<int> full(
        std::move(second.Level), second.Scheme, count, LastLevel::Whole, nullptr);
      EXPECT_EQ(CountLeftOut(brief), CountSkipped(brief, GetParam()));
      ExpectSameSteps(brief, full);
    }
  }
}

TEST_P(SurfaceLastStep, IsTheSameAsOfWholeLevelsOnRandomSurfaces)
{
  const WithSkippedLevels skipping;
  const bool triangles = MakeSurfaceScheme<int>(GetParam(), true)->NeedsTriangles();
  int skipped = 0;
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    const RandomSurface surface(seed, triangles);
    const int count = seed % 10 == 9 ? 4 : 2 + static_cast<int>(seed) % 2;
    for (const bool semiSharp : { false, true })
    {
      SCOPED_TRACE(std::to_string(seed) + (semiSharp ? ", semi-sharp" : ""));
      const SurfaceSteps<int> brief =
        surface.MakeSteps(GetParam(), count, LastLevel::ForCells, semiSharp);
      const SurfaceSteps<int> full =
        surface.MakeSteps(GetParam(), count, LastLevel::Whole, semiSharp);
      skipped += IsLeftOut(brief.GetLevel(count - 1));
      ExpectSameSteps(brief, full);
    }
  }
  EXPECT_EQ(skipped > 40,
    GetParam() == SurfaceSchemeKind::Loop || GetParam() == SurfaceSchemeKind::CatmullClark);
}

TEST_P(SurfaceLastStep, IsTheSameAsOfWholeLevelsOnClosedSurfaces)
{
  const WithSkippedLevels skipping;
  const bool triangles = MakeSurfaceScheme<int>(GetParam(), true)->NeedsTriangles();
  int skipped = 0;
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    const int count = 2 + static_cast<int>(seed / 4) % 2;
    SCOPED_TRACE(std::to_string(seed) + ", " + std::to_string(count) + " steps");
    Walk first(MakeTorus(seed, triangles), GetParam());
    Walk second(MakeTorus(seed, triangles), GetParam());
    const SurfaceSteps<int> brief(
      std::move(first.Level), first.Scheme, count, LastLevel::ForCells, nullptr);
    const SurfaceSteps<int> full(
      std::move(second.Level), second.Scheme, count, LastLevel::Whole, nullptr);
    EXPECT_EQ(CountLeftOut(brief), CountSkipped(brief, GetParam()));
    skipped += CountLeftOut(brief) > 0;
    ExpectSameSteps(brief, full);
  }
  EXPECT_EQ(skipped >= 20,
    GetParam() == SurfaceSchemeKind::Loop || GetParam() == SurfaceSchemeKind::CatmullClark);
}

/// Limits of a last level of which only counts are made.
TEST_P(SurfaceLastStep, LimitsAreThoseOfWholeLevels)
{
  const WithSkippedLevels skipping;
  const bool triangles = MakeSurfaceScheme<int>(GetParam(), true)->NeedsTriangles();
  int skipped = 0;
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    const RandomSurface surface(seed, triangles);
    const int count = 1 + static_cast<int>(seed) % 3;
    for (const bool semiSharp : { false, true })
    {
      SCOPED_TRACE(std::to_string(seed) + (semiSharp ? ", semi-sharp" : ""));
      const auto make = [&](LastLevel last)
      { return surface.MakeSteps(GetParam(), count, last, semiSharp); };
      const SurfaceSteps<int> whole = make(LastLevel::Whole);
      const SurfaceSteps<int> positions = make(LastLevel::ForPositions);
      const SurfaceSteps<int> tangents = make(LastLevel::ForTangents);
      skipped += tangents.GetLevelOfLimits() != nullptr;
      ExpectSameLimits(whole, positions, LimitKind::Position);
      for (const LimitKind kind : { LimitKind::Position, LimitKind::Tangent1, LimitKind::Tangent2 })
      {
        ExpectSameLimits(whole, tangents, kind);
      }
    }
  }
  EXPECT_EQ(skipped > 10,
    GetParam() == SurfaceSchemeKind::Loop || GetParam() == SurfaceSchemeKind::CatmullClark);
}

TEST_P(SurfaceLastStep, FramesAreThoseOfWholeLevels)
{
  const bool triangles = MakeSurfaceScheme<int>(GetParam(), true)->NeedsTriangles();
  for (const auto& entry : MakeZoo(triangles))
  {
    for (int count = 1; count <= 3; ++count)
    {
      SCOPED_TRACE(entry.first + ", " + std::to_string(count) + " steps");
      const auto run = [&](double most)
      {
        const WithSkippedLevels skipping(most);
        return RunFilter(MakeInput(entry.second), static_cast<int>(GetParam()), count, true,
          [](vtkSurfaceSubdivision* filter)
          {
            filter->SetGenerateLimitNormals(true);
            filter->SetGenerateTangents(true);
          });
      };
      ExpectSameBits(run(NoLevels), run(1.));
    }
  }
}

/// What a level knows of the step that made it saves walks, and changes nothing.
TEST_P(SurfaceLastStep, IsTheSameAsWithoutTheLevelBefore)
{
  const bool triangles = MakeSurfaceScheme<int>(GetParam(), true)->NeedsTriangles();
  for (const auto& entry : MakeZoo(triangles))
  {
    Walk known(entry.second, GetParam());
    Walk unknown(entry.second, GetParam());
    for (int step = 0; step < 4; ++step)
    {
      SCOPED_TRACE(entry.first + ", step " + std::to_string(step));
      unknown.Level.VerticesBefore = -1;
      unknown.Scheme->Prepare(unknown.Level);
      ExpectEqual(known.Level.Places, unknown.Level.Places);
      const RowBlock<int> rows = known.GetRows();
      const RowBlock<int> expected = unknown.GetRows();
      ASSERT_EQ(rows.GetNumberOfRows(), expected.GetNumberOfRows());
      ASSERT_EQ(rows.GetNumberOfEntries(), expected.GetNumberOfEntries());
      const std::size_t size = rows.GetNumberOfEntries();
      EXPECT_TRUE(std::equal(rows.GetColumns(), rows.GetColumns() + size, expected.GetColumns()));
      EXPECT_TRUE(std::equal(rows.GetWeights(), rows.GetWeights() + size, expected.GetWeights()));
      known.Step();
      unknown.Step();
      ExpectEqual(known.Level.Mesh.Vertices, unknown.Level.Mesh.Vertices);
      ExpectEqual(known.Level.Mesh.Twins, unknown.Level.Mesh.Twins);
    }
  }
}

/// Also arrays that are gathered, and after other levels by another filter.
TEST(SurfaceSkippedLevel, OutputsAreThoseOfWholeLevels)
{
  for (const int scheme : { vtkSurfaceSubdivision::LOOP, vtkSurfaceSubdivision::CATMULL_CLARK })
  {
    ExpectSameOutputs(AddArrays(MakeInput(MakeSheet(5, 4,
                        scheme != vtkSurfaceSubdivision::CATMULL_CLARK, { 1, 0, 0 }, { 0, 1, 1 }))),
      scheme);
  }
}

/// Where nothing is kept for the next update, and no cell shows data, levels go before the last
/// step. Sharpness, seams and limits read more of them than steps do.
TEST_P(SurfaceLastStep, LevelsThatAreForgottenChangeNothing)
{
  const int scheme = static_cast<int>(GetParam());
  const bool triangles = MakeSurfaceScheme<int>(GetParam(), true)->NeedsTriangles();
  auto models = MakeZoo(triangles);
  models["torus of mixed faces"] = MakeTorus(1, triangles);
  for (const auto& entry : models)
  {
    const auto input = MakeInput(entry.second);
    for (const bool limit : { false, true })
    {
      SCOPED_TRACE(entry.first + (limit ? ", on the limit" : ""));
      const auto run = [&](vtkPolyData* mesh, int levels, bool cache)
      {
        return RunFilter(mesh, scheme, levels, limit && levels > 1,
          [cache](vtkSurfaceSubdivision* filter) { filter->SetCacheOperator(cache); });
      };
      ExpectSameBits(run(input, 3, true), run(input, 3, false));
      ExpectSameBits(run(input, 4, true), run(input, 4, false));
      ExpectSameBits(run(run(input, 1, true), 3, true), run(run(input, 1, false), 3, false));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, SurfaceLastStep,
  testing::Values(SurfaceSchemeKind::Loop, SurfaceSchemeKind::ModifiedButterfly,
    SurfaceSchemeKind::CatmullClark, SurfaceSchemeKind::DooSabin, SurfaceSchemeKind::Midedge,
    SurfaceSchemeKind::FourEight, SurfaceSchemeKind::SqrtThree, SurfaceSchemeKind::Linear));

/// Three faces of an input may be numbered around a vertex as those that a step makes.
TEST(SurfaceSqrtThree, AnInputVertexHasAllOfItsRing)
{
  Model fan;
  fan.Points = MakeRandomPoints(10, 1);
  for (const vtkIdType first : { 0, 3, 6, 1, 2, 4, 5, 7, 8 })
  {
    fan.Faces.push_back({ first, (first + 1) % 9, 9 });
  }
  const Walk walk(fan, SurfaceSchemeKind::SqrtThree);
  const RowBlock<int> rows = walk.GetRows();
  EXPECT_EQ(rows.GetEnd(9) - rows.GetBegin(9), 10);
}

/// In odd steps, and in even ones where no edge is fixed, the row of a smooth vertex is its ring in
/// the order of its fan.
TEST(SurfaceSqrtThree, RowsHaveTheRingInTheOrderOfTheFan)
{
  int centres = 0;
  for (const auto& entry : MakeZoo(true))
  {
    SCOPED_TRACE(entry.first);
    Walk walk(entry.second, SurfaceSchemeKind::SqrtThree);
    for (int step = 0; step < 4; ++step, walk.Step())
    {
      const PolygonMesh<int>& mesh = walk.Level.Mesh;
      if (!walk.Level.Places.empty())
      {
        continue;
      }
      const RowBlock<int> rows = walk.GetRows();
      for (int v = 0; v < mesh.NumberOfVertices; ++v)
      {
        if (walk.Level.Tags.Vertices[v] != VertexTag::Smooth)
        {
          continue;
        }
        std::vector<int> ring{ v };
        VisitCycle(mesh, mesh.VertexCorners[v], [&](const FanStep<int>& at)
          { ring.push_back(mesh.GetOtherEnd(mesh.Edges[at.GetHalfEdgeIn(mesh)], v)); });
        const std::vector<int> columns(
          rows.GetColumns() + rows.GetBegin(v), rows.GetColumns() + rows.GetEnd(v));
        ASSERT_EQ(columns, ring) << "vertex " << v << ", step " << step;
        centres += step > 0 && ring.size() == 7;
        for (std::size_t k = rows.GetBegin(v) + 1; k < rows.GetEnd(v); ++k)
        {
          ASSERT_EQ(rows.GetWeights()[k], rows.GetWeights()[rows.GetBegin(v) + 1]);
        }
      }
    }
  }
  EXPECT_GT(centres, 100);
}
