// SPDX-License-Identifier: BSD-3-Clause
// Partitions, simulated in one process, solve together for the control values that the whole mesh
// has.
#include "PartitionTools.h"

#include "Private/Distribution/KeptParts.h"
#include "Private/Run/KeptEntries.h"
#include "Private/Surface/SurfaceSubdivision.h"
#include "Private/Uniform/UniformSubdivision.h"

#include "vtkSurfaceSubdivision.h"

#include <iterator>
#include <mutex>

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;
using subdivision::StampScheme;
using subdivision::SurfaceOptions;
using subdivision::UniformOptions;

namespace
{

const Partition Partitions[] = { { "halves", 2, 1, false },
  { "three slabs, one rank without cells", 3, 2, false, KnownBy::GlobalIds, 1 },
  { "cell by cell", 3, 1, true }, { "by coordinates", 3, 1, true, KnownBy::Coordinates } };

constexpr const char* SharpnessName = "LineSharpness";

std::vector<Mesh> MakeMeshesWithSharpness()
{
  const std::vector<Mesh> meshes = MakeMeshes();
  for (const Mesh& mesh : meshes)
  {
    vtkNew<vtkDoubleArray> sharpness;
    sharpness->SetName(SharpnessName);
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      sharpness->InsertNextValue(mesh->GetCellType(cell) == VTK_LINE ? 2.75 : 0.);
    }
    mesh->GetCellData()->AddArray(sharpness);
    vtkNew<vtkDoubleArray> chosen;
    chosen->SetName("Chosen");
    vtkNew<vtkDoubleArray> normals;
    normals->SetName("Wanted");
    normals->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      chosen->InsertNextValue(i % 7 == 0 ? 1. : i % 7 == 1 ? 0.5 : 0.);
      const auto x = static_cast<double>(i % 11 == 0 ? i : 0);
      normals->InsertNextTuple3(std::sin(x), x > 0. ? 1. : 0., std::sin(2. * x));
    }
    mesh->GetPointData()->AddArray(chosen);
    mesh->GetPointData()->AddArray(normals);
  }
  return meshes;
}

void InterpolateAll(subdivision::RunOptions& options)
{
  options.Warn = [](const std::string&) {};
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  options.Interpolation.Points = true;
  options.Interpolation.Arrays = true;
}

struct Choice
{
  const char* Name;
  std::function<void(vtkPointSet*, subdivision::RunOptions&)> Set; ///< for the mesh, or a part
};

const Choice Choices[] = { { "defaults", [](vtkPointSet*, subdivision::RunOptions&) {} },
  { "some points, and normals of surfaces",
    [](vtkPointSet* mesh, subdivision::RunOptions& o)
    {
      o.Interpolation.Chosen = mesh->GetPointData()->GetArray("Chosen");
      const bool isSurface = vtkPolyData::SafeDownCast(mesh) != nullptr;
      o.Interpolation.Normals = isSurface ? mesh->GetPointData()->GetArray("Wanted") : nullptr;
    } },
  { "creases and sharpness",
    [](vtkPointSet* mesh, subdivision::RunOptions& o)
    {
      o.Features.DetectFeatures = true;
      o.Features.Embedded = subdivision::EmbeddedRule::SingularInside;
      o.Features.Sharpness = mesh->GetCellData()->GetArray(SharpnessName);
    } },
  { "materials, half of one array", [](vtkPointSet* mesh, subdivision::RunOptions& o)
    {
      o.Features.Material = mesh->GetCellData()->GetArray("byte");
      o.Features.PreserveInterfaces = o.Features.Material != nullptr;
      o.Interpolation.Names = { "double" };
      o.Interpolation.Weight = 0.5;
    } } };

bool Subdivide(vtkPointSet* input, vtkPointSet* output, const Choice& choice, UniformOptions own)
{
  choice.Set(input, own);
  return SubdivideUniformly(input, own, vtkUnstructuredGrid::SafeDownCast(output));
}

bool Subdivide(vtkPointSet* input, vtkPointSet* output, const Choice& choice, SurfaceOptions own)
{
  choice.Set(input, own);
  return SubdivideSurface(vtkPolyData::SafeDownCast(input), own, vtkPolyData::SafeDownCast(output));
}

/// What a filter makes of the parts of a mesh, which meet in rounds.
template <typename Options>
bool SubdivideParts(const std::vector<Mesh>& cut, const Partition& partition, const Choice& choice,
  Options options, std::vector<Mesh>& outputs, int layers = 2)
{
  subdivision::DistributionOptions distribution;
  distribution.IsOfSurfaces = std::is_same<Options, SurfaceOptions>::value;
  distribution.Layers = layers;
  return RunOnParts(
    cut, partition, distribution, options, [&](vtkPointSet* input, vtkPointSet* output)
    { return Subdivide(input, output, choice, options); }, outputs);
}

/// Cuts the mesh in one of these ways, each time in the next one.
template <typename Options>
void ExpectPartsAreWhole(
  vtkPointSet* mesh, const Choice& choice, const Options& options, int layers = 2)
{
  static std::size_t next = 0;
  const Partition& partition = Partitions[next++ % std::size(Partitions)];
  SCOPED_TRACE(std::string(partition.Name) + ", " + choice.Name + ", scheme " +
    std::to_string(static_cast<int>(options.Scheme)) + ", mesh of " +
    std::to_string(mesh->GetNumberOfCells()) + " cells");
  const std::vector<Mesh> cut = Cut(mesh, partition);
  const Mesh whole = subdivision::MakeMesh(std::is_same<Options, SurfaceOptions>::value);
  const Mesh input = partition.Known == KnownBy::Coordinates ? Renumber(cut) : Mesh(mesh);
  ASSERT_TRUE(Subdivide(input, whole, choice, options));
  std::vector<Mesh> outputs;
  EXPECT_TRUE(SubdivideParts(cut, partition, choice, options, outputs, layers));
  ExpectWhole(whole, outputs);
}

}

TEST(PartitionsInterpolation, GiveTheWholeUniformly)
{
  for (const Mesh& mesh : MakeMeshesWithSharpness())
  {
    for (const StampScheme scheme : { StampScheme::BoxSpline, StampScheme::TetOct })
    {
      for (const Choice& choice : Choices)
      {
        UniformOptions options;
        InterpolateAll(options);
        options.Scheme = scheme;
        options.ProjectToLimit = &choice == &Choices[0];
        ExpectPartsAreWhole(mesh, choice, options, scheme == StampScheme::TetOct ? 3 : 2);
        if (HasFailure())
        {
          return;
        }
      }
    }
  }
}

TEST(PartitionsInterpolation, GiveTheWholeOfSurfaces)
{
  const std::vector<Mesh> meshes = MakeMeshesWithSharpness();
  for (std::size_t m = 0; m < meshes.size(); m += 3)
  {
    const Mesh surface = MakeSkin(meshes[m]);
    for (int scheme = vtkSubdivisionAlgorithm::LINEAR; scheme <= vtkSurfaceSubdivision::SQRT_THREE;
      ++scheme)
    {
      for (const Choice& choice : Choices)
      {
        SurfaceOptions options;
        InterpolateAll(options);
        options.Scheme = static_cast<subdivision::SurfaceSchemeKind>(scheme);
        options.Levels = 2;
        ExpectPartsAreWhole(surface, choice, options);
        if (HasFailure())
        {
          return;
        }
      }
    }
  }
}

// Points far from the border depend on those of other parts.
TEST(PartitionsInterpolation, OfALargeMeshAreNotTheWhole)
{
  const Mesh box = MakeMixedBox(9);
  AddArrays(vtkUnstructuredGrid::SafeDownCast(box));
  NumberCells(box);
  for (const StampScheme scheme : { StampScheme::BoxSpline, StampScheme::TetOct })
  {
    UniformOptions options;
    InterpolateAll(options);
    options.Scheme = scheme;
    ExpectPartsAreWhole(box, Choices[0], options, scheme == StampScheme::TetOct ? 3 : 2);
  }
}

// Where the iteration is too slow, the first part solves for all with the matrix of the whole.
TEST(PartitionsInterpolation, SolveDirectlyTogether)
{
  const Mesh sheet = MakeSkin(MakeMixedBox(5));
  int warnings = 0;
  for (const auto scheme :
    { subdivision::SurfaceSchemeKind::FourEight, subdivision::SurfaceSchemeKind::CatmullClark })
  {
    for (std::size_t cut = 0; cut < std::size(Partitions); ++cut)
    {
      SurfaceOptions options;
      InterpolateAll(options);
      options.Warn = [&](const std::string& text)
      { warnings += text.find("does not pass") != std::string::npos ? 1 : 0; };
      options.Scheme = scheme;
      ExpectPartsAreWhole(sheet, Choices[0], options);
    }
  }
  EXPECT_EQ(warnings, 0);
}

// Operators are used again where values change, also values that only another part has.
TEST(PartitionsInterpolation, KeepOperators)
{
  const Mesh mesh = MakeMixedBox(9);
  AddArrays(vtkUnstructuredGrid::SafeDownCast(mesh));
  NumberCells(mesh);
  const Partition& partition = Partitions[0];
  std::vector<subdivision::KeptEntries> caches(static_cast<std::size_t>(partition.Parts));
  subdivision::KeptParts kept;
  const auto check = [&](const char* what)
  {
    SCOPED_TRACE(what);
    UniformOptions options;
    InterpolateAll(options);
    const Mesh whole = subdivision::MakeMesh(false);
    ASSERT_TRUE(Subdivide(mesh, whole, Choices[0], options));
    subdivision::DistributionOptions distribution;
    distribution.Kept = &kept;
    std::vector<Mesh> outputs;
    EXPECT_TRUE(RunOnParts(
      Cut(mesh, partition), partition, distribution, options,
      [&](vtkPointSet* input, vtkPointSet* output)
      {
        UniformOptions own = options;
        own.Cache = &caches[options.Others->GetPartition()];
        return Subdivide(input, output, Choices[0], own);
      },
      outputs));
    ExpectWhole(whole, outputs);
    for (subdivision::KeptEntries& cache : caches)
    {
      cache.ForgetUnused();
      EXPECT_EQ(1, cache.NumberOfBuilds);
    }
  };
  check("first");
  mesh->GetPointData()->GetArray("float")->SetComponent(5, 0, 7.);
  check("another value at one point");
  const Point at = GetPoint(mesh, 5);
  mesh->GetPoints()->SetPoint(5, at[0], at[1], at[2] + 0.01);
  check("one point moved");
  caches[1].Clear();
  caches[1].NumberOfBuilds = 0;
  check("one part builds anew");
}

// All say the same of values beyond the range, and of what they do not find.
TEST(PartitionsInterpolation, WarnTogether)
{
  const Mesh mesh = MakeMixedBox(9);
  AddArrays(vtkUnstructuredGrid::SafeDownCast(mesh));
  NumberCells(mesh);
  for (const Partition& partition : Partitions)
  {
    SCOPED_TRACE(partition.Name);
    std::mutex mutex;
    std::set<std::string> warnings;
    UniformOptions options;
    InterpolateAll(options);
    options.Interpolation.Names = { "double", "nothing" };
    options.Warn = [&](const std::string& message)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      warnings.insert(message);
    };
    std::vector<Mesh> outputs;
    const std::vector<Mesh> cut = Cut(mesh, partition);
    EXPECT_TRUE(SubdivideParts(cut, partition, Choices[0], options, outputs));
    const auto count = [&](const std::string& text)
    {
      return std::count_if(warnings.begin(), warnings.end(),
        [&](const std::string& warning) { return warning.find(text) != std::string::npos; });
    };
    EXPECT_EQ(1, count("exceed the range that the input has: values of double (by up to "));
    EXPECT_EQ(1, count("array \"nothing\""));
    std::set<std::string> ofParts;
    ofParts.swap(warnings);
    const Mesh whole = subdivision::MakeMesh(false);
    const Mesh input = partition.Known == KnownBy::Coordinates ? Renumber(cut) : mesh;
    ASSERT_TRUE(Subdivide(input, whole, Choices[0], options));
    const auto most = [](const std::set<std::string>& texts)
    {
      for (const std::string& text : texts)
      {
        const std::size_t at = text.find("(by up to");
        if (at != std::string::npos)
        {
          return text.substr(at);
        }
      }
      return std::string();
    };
    EXPECT_EQ(most(warnings), most(ofParts));
  }
}

// One part goes on from an earlier filter, or stops: the others do not wait for it.
TEST(PartitionsInterpolation, FailTogether)
{
  const Mesh mesh = MakeMixedBox(3);
  AddArrays(vtkUnstructuredGrid::SafeDownCast(mesh));
  NumberCells(mesh);
  for (const bool atOnce : { true, false })
  {
    UniformOptions options;
    InterpolateAll(options);
    subdivision::DistributionOptions distribution;
    std::vector<Mesh> outputs;
    EXPECT_FALSE(RunOnParts(
      Cut(mesh, Partitions[2]), Partitions[2], distribution, options,
      [&](vtkPointSet* input, vtkPointSet* output)
      {
        UniformOptions own = options;
        if (options.Others->GetPartition() == 1)
        {
          if (atOnce)
          {
            return false;
          }
          own.Progress = [](double) { return true; };
        }
        return Subdivide(input, output, Choices[0], own);
      },
      outputs));
  }
}
