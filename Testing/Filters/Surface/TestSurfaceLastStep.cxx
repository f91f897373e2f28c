// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceLastStep.cxx
 * What is left out of the last two levels of a surface, and rings that are found without a walk,
 * change nothing.
 */
#include "SurfaceTools.h"

#include "Core/Surfaces/Scheme/SkippedLevel.h"
#include "Core/Surfaces/Scheme/SurfaceTags.h"
#include "Core/Surfaces/Steps/SurfaceSteps.h"

using namespace surfacetools;

namespace
{

/// Skips levels whatever part of the surface is irregular.
struct WithSkippedLevels
{
  WithSkippedLevels() { MostIrregularVertices = 1.; }
  ~WithSkippedLevels() { MostIrregularVertices = Default; }
  const double Default = MostIrregularVertices;
};

class SurfaceLastStep : public testing::TestWithParam<SurfaceSchemeKind>
{
};

std::vector<vtkIdType> GetFaces(const SurfaceSteps<int>& steps)
{
  const int last = steps.GetNumberOfSteps();
  std::vector<vtkIdType> faces(steps.GetNumberOfCorners(last));
  steps.WriteFaces(last, faces.data());
  std::vector<int> narrow(faces.size());
  steps.WriteFaces(last, narrow.data());
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

bool Skips(const SurfaceSteps<int>& steps, SurfaceSchemeKind kind)
{
  const int count = steps.GetNumberOfSteps();
  return count > 1 &&
    (kind == SurfaceSchemeKind::Loop || kind == SurfaceSchemeKind::ModifiedButterfly ||
      (kind == SurfaceSchemeKind::CatmullClark && steps.GetLevel(count - 2).Mesh.Arity == 4));
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
  EXPECT_EQ(GetFaces(brief), GetFaces(full));
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
    const auto faces = MakeCarriers<int>(full.GetLevel(step).Mesh.NumberOfFaces);
    Buffer<Carrier<int>> carriers[2];
    brief.GetScheme().CarryFaces(brief.GetLevel(step), faces, true, carriers[0]);
    full.GetScheme().CarryFaces(full.GetLevel(step), faces, true, carriers[1]);
    ExpectEqual(carriers[0], carriers[1]);
  }
}

bool IsLeftOut(const SurfaceLevel<int>& level)
{
  return level.Mesh.Twins.empty() && level.Mesh.NumberOfFaces > 0;
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

  SurfaceSteps<int> MakeSteps(SurfaceSchemeKind kind, int count, bool whole, bool semiSharp) const
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
    SurfaceSteps<int> steps(std::move(level), scheme, count, whole, nullptr);
    if (semiSharp && scheme->HalvesEdges() && scheme->UsesTags())
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
      const SurfaceSteps<int> brief(std::move(first.Level), first.Scheme, count, false, nullptr);
      const SurfaceSteps<int> full(std::move(second.Level), second.Scheme, count, true, nullptr);
      EXPECT_EQ(IsLeftOut(brief.GetLevel(count - 1)), Skips(brief, GetParam()));
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
    const int count = 2 + static_cast<int>(seed) % 2;
    for (const bool semiSharp : { false, true })
    {
      SCOPED_TRACE(std::to_string(seed) + (semiSharp ? ", semi-sharp" : ""));
      const SurfaceSteps<int> brief = surface.MakeSteps(GetParam(), count, false, semiSharp);
      const SurfaceSteps<int> full = surface.MakeSteps(GetParam(), count, true, semiSharp);
      skipped += IsLeftOut(brief.GetLevel(count - 1));
      ExpectSameSteps(brief, full);
    }
  }
  EXPECT_EQ(skipped > 40,
    GetParam() == SurfaceSchemeKind::Loop || GetParam() == SurfaceSchemeKind::ModifiedButterfly ||
      GetParam() == SurfaceSchemeKind::CatmullClark);
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
      unknown.Level.FirstMade = -1;
      unknown.Level.FanSizes = {};
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
  for (const int scheme : { vtkSurfaceSubdivision::LOOP, vtkSurfaceSubdivision::MODIFIED_BUTTERFLY,
         vtkSurfaceSubdivision::CATMULL_CLARK })
  {
    const auto input = MakeInput(
      MakeSheet(5, 4, scheme != vtkSurfaceSubdivision::CATMULL_CLARK, { 1, 0, 0 }, { 0, 1, 1 }));
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
    const auto whole = RunFilter(input, scheme, 4);
    const WithSkippedLevels skipping;
    ExpectSameBits(whole, RunFilter(input, scheme, 4));
    ExpectSameBits(whole, RunFilter(RunFilter(input, scheme, 1), scheme, 3));
    ExpectSameBits(whole, RunFilter(RunFilter(input, scheme, 3), scheme, 1));
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
