// SPDX-License-Identifier: BSD-3-Clause
// Partitions, simulated in one process, number their output as the whole does, and a second filter
// goes on with what the first one made of them.
#include "PartitionTools.h"
#include "Turns.h"

#include "Private/ArrayNames.h"
#include "Private/Surface/SurfaceSubdivision.h"
#include "Private/Uniform/UniformSubdivision.h"

#include "vtkPlane.h"
#include "vtkSurfaceSubdivision.h"

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;
using subdivision::SurfaceOptions;
using subdivision::UniformOptions;

namespace
{

const Partition Partitions[] = { { "halves", 2, 1, false, KnownBy::GlobalIds, 0 },
  { "slabs after an empty part", 3, 2, false, KnownBy::GlobalIds, 1 },
  { "cell by cell", 3, 1, true, KnownBy::GlobalIds, 0 },
  { "cell by cell on many", 8, 1, true, KnownBy::GlobalIds, 2 },
  { "blocks in one process", 1, 4, false, KnownBy::GlobalIds, 0 } };

struct Choice
{
  const char* Name;
  std::function<void(UniformOptions&)> Set;
};

const Choice Choices[] = { { "defaults", [](UniformOptions&) {} },
  { "features",
    [](UniformOptions& o)
    {
      o.Features.DetectFeatures = true;
      o.Features.Embedded = subdivision::EmbeddedRule::SingularInside;
    } },
  { "features and interfaces",
    [](UniformOptions& o)
    {
      o.Features.DetectFeatures = true;
      o.Features.FeatureAngle = 10.;
      o.Features.PreserveInterfaces = true;
    } },
  { "semi-sharp marks",
    [](UniformOptions& o)
    {
      o.Features.DetectFeatures = true;
      o.Features.Marks.Corners = false;
      o.Features.Marks.Creases = true;
      o.Features.Marks.Surfaces = true;
    } },
  { "sharp joints", [](UniformOptions& o)
    { o.Features.Type1 = o.Features.Type2 = o.Features.Type3 = subdivision::JointRule::Sharp; } } };

void SetCommon(subdivision::RunOptions& options)
{
  options.GenerateGlobalIds = true;
  options.Warn = [](const std::string& message)
  {
    EXPECT_EQ(std::string::npos, message.find("any other mesh")) << message;
    EXPECT_EQ(std::string::npos, message.find("global ids")) << message;
  };
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
}

UniformOptions MakeOptions(subdivision::StampScheme scheme, const Choice& choice, int levels)
{
  UniformOptions options;
  options.Scheme = scheme;
  options.Levels = levels;
  SetCommon(options);
  choice.Set(options);
  return options;
}

SurfaceOptions MakeOptions(int scheme, bool findsFeatures, int levels)
{
  SurfaceOptions options;
  options.Scheme = static_cast<subdivision::SurfaceSchemeKind>(scheme);
  options.Levels = levels;
  SetCommon(options);
  options.Features.DetectFeatures = findsFeatures;
  options.Features.FeatureAngle = 50.;
  return options;
}

constexpr const char* MaterialName = "Materials";
constexpr const char* MarksName = "Marks";
constexpr const char* LevelsName = "Levels";

bool Run(vtkPointSet* input, UniformOptions options, vtkPointSet* output)
{
  options.Features.Material = input->GetCellData()->GetArray(MaterialName);
  options.Features.Sharpness = input->GetCellData()->GetArray(LevelsName);
  if (options.Features.Marks.Creases)
  {
    options.Features.Marks.Array = input->GetPointData()->GetArray(MarksName);
    options.Features.Marks.Sharpness = input->GetPointData()->GetArray(LevelsName);
  }
  return SubdivideUniformly(input, options, vtkUnstructuredGrid::SafeDownCast(output));
}

/// Operators are kept, so that the last step is stored.
struct KeepingOptions : UniformOptions
{
};

bool Run(vtkPointSet* input, KeepingOptions options, vtkPointSet* output)
{
  subdivision::KeptEntries cache;
  options.Cache = &cache;
  return Run(input, static_cast<const UniformOptions&>(options), output);
}

bool Run(vtkPointSet* input, const SurfaceOptions& options, vtkPointSet* output)
{
  return SubdivideSurface(
    vtkPolyData::SafeDownCast(input), options, vtkPolyData::SafeDownCast(output));
}

template <typename Options>
constexpr bool IsOfSurfaces = std::is_same<Options, SurfaceOptions>::value;

template <typename Options>
Mesh Subdivide(vtkPointSet* whole, const Options& options)
{
  const Mesh output = subdivision::MakeMesh(IsOfSurfaces<Options>);
  EXPECT_TRUE(Run(whole, options, output));
  subdivision::AddGlobalIds(output);
  return output;
}

/// The outputs of parts, those of one partition after the other.
template <typename Options>
std::vector<Mesh> SubdivideParts(
  const std::vector<Mesh>& parts, const Partition& partition, Options options)
{
  subdivision::DistributionOptions distribution;
  distribution.IsOfSurfaces = IsOfSurfaces<Options>;
  std::vector<Mesh> outputs;
  EXPECT_TRUE(RunOnParts(
    parts, partition, distribution, options, [&options](vtkPointSet* input, vtkPointSet* output)
    { return Run(input, options, output); }, outputs));
  return outputs;
}

/// Marks creases that stay sharp for some levels.
void AddMarks(vtkPointSet* mesh)
{
  vtkNew<vtkIntArray> marks;
  marks->SetName(MarksName);
  vtkNew<vtkDoubleArray> levels;
  levels->SetName(LevelsName);
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    marks->InsertNextValue(p % 4 > 0);
    levels->InsertNextValue(
      p % 5 == 0 ? std::numeric_limits<double>::infinity() : 0.75 * static_cast<double>(p % 5));
  }
  mesh->GetPointData()->AddArray(marks);
  mesh->GetPointData()->AddArray(levels);
}

/// Each partition by turns, so that all of them meet each scheme, choice and kind of mesh.
template <typename Test>
void ForCases(const Test& test)
{
  size_t turn = 0;
  for (const Mesh& mesh : MakeMeshes())
  {
    vtkNew<vtkIntArray> materials;
    materials->SetName(MaterialName);
    for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
    {
      materials->InsertNextValue(c / 5 % 3);
    }
    mesh->GetCellData()->AddArray(materials);
    AddMarks(mesh);
    for (const auto scheme :
      { subdivision::StampScheme::BoxSpline, subdivision::StampScheme::TetOct })
    {
      for (const Choice& choice : Choices)
      {
        const Partition& partition = Partitions[turn++ % std::size(Partitions)];
        if (!turns::IsInTurn(turn))
        {
          continue;
        }
        SCOPED_TRACE(std::string(partition.Name) + ", " + choice.Name + ", scheme " +
          std::to_string(static_cast<int>(scheme)) + ", mesh of " +
          std::to_string(mesh->GetNumberOfCells()) + " cells");
        test(mesh, scheme, choice, partition);
        if (testing::Test::HasFailure())
        {
          return;
        }
      }
    }
  }
}

/// The last that goes on; those after it: TestPartitionsAfresh.cxx.
constexpr int LastThatGoesOn = vtkSurfaceSubdivision::CATMULL_CLARK;

/// The same for surfaces, with lines and vertices. test(mesh, scheme, findsFeatures, partition).
template <typename Test>
void ForSurfaces(const Test& test, int last = vtkSurfaceSubdivision::SQRT_THREE)
{
  size_t turn = 0;
  for (const Mesh& mesh : MakeMeshes())
  {
    const Mesh surface = MakeSkin(mesh);
    for (int scheme = vtkSurfaceSubdivision::LOOP; scheme <= last; ++scheme)
    {
      const bool findsFeatures = turn % 2 == 1;
      const Partition& partition = Partitions[turn++ % std::size(Partitions)];
      if (!turns::IsInTurn(turn))
      {
        continue;
      }
      SCOPED_TRACE(std::string(partition.Name) + ", scheme " + std::to_string(scheme) +
        (findsFeatures ? ", features" : "") + ", mesh of " +
        std::to_string(surface->GetNumberOfCells()) + " cells");
      test(surface, scheme, findsFeatures, partition);
      if (testing::Test::HasFailure())
      {
        return;
      }
    }
  }
}

}

TEST(PartitionsIds, AreIndicesOfTheWholeSurface)
{
  ForSurfaces(
    [](vtkPointSet* mesh, int scheme, bool findsFeatures, const Partition& partition)
    {
      for (const int levels : { 0, 1, 3 })
      {
        const SurfaceOptions options = MakeOptions(scheme, findsFeatures, levels);
        ExpectIndices(
          Subdivide(mesh, options), SubdivideParts(Cut(mesh, partition), partition, options));
      }
    });
}

TEST(PartitionsIds, AreIndicesOfTheWhole)
{
  ForCases(
    [](vtkPointSet* mesh, subdivision::StampScheme scheme, const Choice& choice,
      const Partition& partition)
    {
      for (const int levels : { 0, 1, 3 })
      {
        const UniformOptions options = MakeOptions(scheme, choice, levels);
        ExpectIndices(
          Subdivide(mesh, options), SubdivideParts(Cut(mesh, partition), partition, options));
      }
    });
}

TEST(PartitionsIds, AreIndicesOfTheWholeWithKeptOperators)
{
  ForCases(
    [](vtkPointSet* mesh, subdivision::StampScheme scheme, const Choice& choice,
      const Partition& partition)
    {
      const KeepingOptions options{ MakeOptions(scheme, choice, 2) };
      const Mesh whole = Subdivide(mesh, options);
      const std::vector<Mesh> parts = SubdivideParts(Cut(mesh, partition), partition, options);
      ExpectWhole(whole, parts);
      ExpectIndices(whole, parts);
    });
}

TEST(PartitionsIds, OfTheInputAreThoseOfTheParts)
{
  constexpr const char* indexName = "Index";
  ForCases(
    [](vtkPointSet* mesh, subdivision::StampScheme scheme, const Choice& choice,
      const Partition& partition)
    {
      vtkNew<vtkIntArray> indices;
      indices->SetName(indexName);
      for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
      {
        indices->InsertNextValue(static_cast<int>(p));
      }
      mesh->GetPointData()->AddArray(indices);
      UniformOptions options = MakeOptions(scheme, choice, 2);
      options.GenerateOriginalIds = true;
      options.InterpolateIntegers = false;
      const std::vector<Mesh> inputs = Cut(mesh, partition);
      const std::vector<Mesh> outputs = SubdivideParts(inputs, partition, options);
      ASSERT_EQ(inputs.size(), outputs.size());
      for (size_t i = 0; i < inputs.size(); ++i)
      {
        vtkDataArray* ids = outputs[i]->GetPointData()->GetArray(subdivision::OriginalPointIdsName);
        ASSERT_TRUE(ids);
        vtkDataArray* before = inputs[i]->GetPointData()->GetArray(indexName);
        vtkDataArray* after = outputs[i]->GetPointData()->GetArray(indexName);
        vtkIdType old = 0;
        for (vtkIdType p = 0; p < ids->GetNumberOfTuples(); ++p)
        {
          const auto id = static_cast<vtkIdType>(ids->GetComponent(p, 0));
          if (id >= 0)
          {
            ++old;
            ASSERT_EQ(before->GetComponent(id, 0), after->GetComponent(p, 0));
          }
        }
        EXPECT_EQ(old, inputs[i]->GetNumberOfPoints());
      }
    });
}

TEST(PartitionsIds, LetFiltersGoOn)
{
  ForCases(
    [](vtkPointSet* mesh, subdivision::StampScheme scheme, const Choice& choice,
      const Partition& partition)
    {
      const Mesh whole = Subdivide(mesh, MakeOptions(scheme, choice, 3));
      std::vector<Mesh> parts = Cut(mesh, partition);
      for (int step = 0; step < 3; ++step)
      {
        parts = SubdivideParts(parts, partition, MakeOptions(scheme, choice, 1));
      }
      ExpectWhole(whole, parts);
      ExpectIndices(whole, parts);
    });
}

TEST(PartitionsIds, LetFiltersOfSurfacesGoOn)
{
  ForSurfaces(
    [](vtkPointSet* mesh, int scheme, bool findsFeatures, const Partition& partition)
    {
      const Mesh whole = Subdivide(mesh, MakeOptions(scheme, findsFeatures, 3));
      std::vector<Mesh> parts = Cut(mesh, partition);
      for (int step = 0; step < 3; ++step)
      {
        // Only the first filter looks for features.
        parts =
          SubdivideParts(parts, partition, MakeOptions(scheme, findsFeatures && step == 0, 1));
      }
      ExpectWhole(whole, parts);
      ExpectIndices(whole, parts);
    },
    LastThatGoesOn);
}

TEST(PartitionsIds, PartsAgreeThatMarksStartAfresh)
{
  ForSurfaces(
    [](vtkPointSet* mesh, int scheme, bool, const Partition& partition)
    {
      // At one end: many parts have no mark.
      const double* bounds = mesh->GetBounds();
      vtkNew<vtkPlane> plane;
      plane->SetNormal(-1., 0., 0.);
      plane->SetOrigin(bounds[1] - 0.01 * (bounds[1] - bounds[0]), 0., 0.);
      SurfaceOptions marking = MakeOptions(scheme, false, 1);
      marking.Features.Marks.Function = plane;
      const SurfaceOptions first = MakeOptions(scheme, false, 1);
      const Mesh whole = Subdivide(Subdivide(mesh, first), marking);
      const std::vector<Mesh> parts =
        SubdivideParts(SubdivideParts(Cut(mesh, partition), partition, first), partition, marking);
      ExpectWhole(whole, parts);
      ExpectIndices(whole, parts);
    },
    LastThatGoesOn);
}

namespace
{

/// Eight cubes in a row, of six tetrahedra each: halves of it do not know their far ends.
Mesh MakeBar()
{
  constexpr vtkIdType length = 8;
  constexpr int orders[6][3] = { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 }, { 2, 0, 1 },
    { 2, 1, 0 } };
  constexpr vtkIdType strides[3] = { 4, 2, 1 };
  const auto bar = Grid::New();
  vtkNew<vtkPoints> points;
  for (vtkIdType p = 0; p < 4 * (length + 1); ++p)
  {
    points->InsertNextPoint(
      static_cast<double>(p / 4), static_cast<double>(p / 2 % 2), static_cast<double>(p % 2));
  }
  bar->SetPoints(points);
  bar->Allocate();
  for (vtkIdType tet = 0; tet < 6 * length; ++tet)
  {
    vtkIdType corners[4] = { tet / 6 * 4 };
    for (int k = 0; k < 3; ++k)
    {
      corners[k + 1] = corners[k] + strides[orders[tet % 6][k]];
    }
    bar->InsertNextCell(VTK_TETRA, 4, corners);
  }
  NumberCells(bar);
  return bar.Get();
}

}

TEST(PartitionsIds, FeaturesAtTheEndOfLayersAreNone)
{
  // Where its layers end, a part sees sharp edges that the whole does not have. Without a step they
  // are known by points that the whole has.
  const Mesh bar = MakeBar();
  const Choice choice = { "features", [](UniformOptions& o) { o.Features.DetectFeatures = true; } };
  const auto makeOptions = [&](int levels)
  { return MakeOptions(subdivision::StampScheme::BoxSpline, choice, levels); };
  std::vector<Mesh> parts = Cut(bar, Partitions[0]);
  for (const int levels : { 0, 1 })
  {
    parts = SubdivideParts(parts, Partitions[0], makeOptions(levels));
  }
  ExpectWhole(Subdivide(bar, makeOptions(1)), parts);
}

TEST(PartitionsIds, SemiSharpEdgesCountBeyondTheCut)
{
  // The sharpness of a vertex is the mean of that of its edges, and some are those of other parts.
  const Mesh bar = MakeBar();
  AddMarks(bar);
  for (const auto scheme :
    { subdivision::StampScheme::BoxSpline, subdivision::StampScheme::TetOct })
  {
    const UniformOptions options = MakeOptions(scheme, Choices[3], 2);
    ExpectWhole(
      Subdivide(bar, options), SubdivideParts(Cut(bar, Partitions[0]), Partitions[0], options));
  }
}

TEST(PartitionsIds, SemiSharpTrianglesCountBeyondTheCut)
{
  // The same for faces of the bar's cells, which partitions have in different orders.
  const Mesh mesh = MakeBar();
  auto* bar = vtkUnstructuredGrid::SafeDownCast(mesh);
  vtkNew<vtkDoubleArray> levels;
  levels->SetName(LevelsName);
  const vtkIdType solids = bar->GetNumberOfCells();
  levels->SetNumberOfValues(solids);
  levels->Fill(0.);
  for (vtkIdType c = 0; c < solids; c += 2)
  {
    vtkNew<vtkIdList> ids;
    bar->GetCellPoints(c, ids);
    bar->InsertNextCell(VTK_TRIANGLE, 3, ids->GetPointer(c / 2 % 2));
    levels->InsertNextValue(0.7 + 0.1 * static_cast<double>(c % 17));
  }
  bar->GetCellData()->AddArray(levels);
  NumberCells(bar);
  for (const auto scheme :
    { subdivision::StampScheme::BoxSpline, subdivision::StampScheme::TetOct })
  {
    const UniformOptions options = MakeOptions(scheme, Choices[0], 2);
    ExpectWhole(
      Subdivide(bar, options), SubdivideParts(Cut(bar, Partitions[0]), Partitions[0], options));
    const UniformOptions one = MakeOptions(scheme, Choices[0], 1);
    const std::vector<Mesh> parts = SubdivideParts(Cut(bar, Partitions[0]), Partitions[0], one);
    ExpectWhole(Subdivide(bar, options), SubdivideParts(parts, Partitions[0], one));
  }
}

TEST(PartitionsIds, LastStepIsOfOwnCells)
{
  const Mesh bar = MakeBar();
  for (const auto scheme :
    { subdivision::StampScheme::BoxSpline, subdivision::StampScheme::TetOct })
  {
    UniformOptions options = MakeOptions(scheme, Choices[0], 3);
    subdivision::DistributionOptions distribution;
    std::atomic<vtkIdType> made{ 0 };
    std::vector<Mesh> parts;
    ASSERT_TRUE(RunOnParts(
      Cut(bar, Partitions[0]), Partitions[0], distribution, options,
      [&](vtkPointSet* input, vtkPointSet* output)
      {
        const bool done = ::Run(input, options, output);
        made += output->GetNumberOfPoints();
        return done;
      },
      parts));
    vtkIdType taken = 0;
    for (const Mesh& part : parts)
    {
      taken += part->GetNumberOfPoints();
    }
    EXPECT_EQ(taken, made);
  }
}

TEST(PartitionsIds, HiddenCellsHaveNoOutput)
{
  const Mesh bar = MakeBar();
  vtkNew<vtkUnsignedCharArray> types;
  types->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType c = 0; c < bar->GetNumberOfCells(); ++c)
  {
    const bool isHidden = 2 * c >= bar->GetNumberOfCells();
    types->InsertNextValue(isHidden ? vtkDataSetAttributes::HIDDENCELL : 0);
  }
  bar->GetCellData()->AddArray(types);
  for (const auto scheme :
    { subdivision::StampScheme::BoxSpline, subdivision::StampScheme::TetOct })
  {
    const UniformOptions options = MakeOptions(scheme, Choices[0], 2);
    const std::vector<Mesh> parts = SubdivideParts(Cut(bar, Partitions[0]), Partitions[0], options);
    ExpectWhole(Subdivide(bar, options), parts);
    EXPECT_EQ(0, parts[1]->GetNumberOfCells());
  }
}
