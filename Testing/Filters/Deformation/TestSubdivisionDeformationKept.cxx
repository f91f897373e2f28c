// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionDeformationKept.cxx
 * What a deformation keeps: rows of both kinds, checksums of points, and for how long.
 */
#include "SubdivisionDeformationTools.h"

#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/Fingerprint.h"
#include "Private/Deformation/EmbeddedPoints.h"

#include "vtkBitArray.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkSubdivisionModelSource.h"
#include "vtkTrivialProducer.h"

using namespace deformation_tools;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Points in a mesh that is subdivided by a scheme, as the filter keeps them.
struct Embedding
{
  Embedding(const Grid& cage, int scheme, const Grid& cloud)
    : Cage(cage)
    , Cloud(cloud)
  {
    this->Options.Scheme =
      scheme == 1 ? subdivision::StampScheme::TetOct : subdivision::StampScheme::BoxSpline;
    this->Options.Warn =
      this->Options.Fail = [](const std::string& text) { ADD_FAILURE() << text; };
    EXPECT_TRUE(this->Rest.Update(cage, this->Options));
    this->Points = subdivision::EmbedPoints(
      cloud->GetPoints()->GetData(), subdivision::OutsideRule::Leave, this->Rest);
  }
  /// The largest error against a map, by the rows of the points or by the composed ones.
  double GetError(const Map& map, bool byComposed)
  {
    const auto control = this->Rest.MoveControlPoints(Moved(this->Cage, map));
    const double* moved = byComposed ? nullptr : this->Rest.MovePoints(control);
    const Grid result = DeepCopy(this->Cloud);
    result->GetPoints()->SetData(subdivision::MoveEmbeddedPoints(
      *this->Points, static_cast<const double*>(control->GetVoidPointer(0)), moved, VTK_DOUBLE));
    return GetLargestError(result, this->Cloud, map);
  }

  Grid Cage;
  Grid Cloud;
  subdivision::DeformationOptions Options;
  subdivision::RestMesh Rest;
  std::unique_ptr<subdivision::EmbeddedPoints> Points;
};

constexpr vtkIdType BlockOfPrint = subdivision::FingerprintHashes::Block; // words

subdivision::Fingerprint Print(const std::vector<float>& values)
{
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return subdivision::ComputeFingerprint(array);
}

}

TEST(SubdivisionDeformationKept, BothKindsOfRowsAreAffine)
{
  // Few points have composed rows, many do not; both ways lead to the same place.
  for (int scheme : { 0, 1 })
  {
    const Grid cage = MakeKuhnBox(2, 0.2, 3);
    const auto cloud = [](int size)
    { return MakeCloud(size, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1); };
    Embedding few(cage, scheme, cloud(50));
    ASSERT_EQ(few.Points->Composed.GetNumberOfRows(), 50);
    EXPECT_LT(few.Points->Composed.GetMemorySize(), few.Rest.GetOperatorSize());
    EXPECT_LT(few.GetError(Affine, true), 1e-12);
    EXPECT_LT(few.GetError(Affine, false), 1e-12);
    Embedding many(cage, scheme, cloud(20000));
    ASSERT_EQ(many.Points->Composed.GetNumberOfRows(), 0);
    EXPECT_EQ(many.Points->Rows.GetMemorySize(), 28U * 20000U); // three weights and a number
    EXPECT_LT(many.GetError(Affine, false), 1e-12);
  }
}

TEST(SubdivisionDeformationKept, MovedPointsAreWrittenOver)
{
  // Three poses in turns, into memory that is kept.
  Embedding embedding(
    MakeKuhnBox(2, 0.2, 3), 0, MakeCloud(100, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1));
  for (int time = 0; time < 3; ++time)
  {
    auto map = [time](const Point& x)
    { return Point{ x[0] + time * x[1], x[1] - time, x[2] * (1 + time) }; };
    EXPECT_LT(embedding.GetError(map, false), 1e-12);
  }
}

TEST(SubdivisionDeformationKept, OneOtherValueShowsInTheChecksum)
{
  std::vector<float> values(
    2 * BlockOfPrint + 2 * 5000 + 1); // a block, a part of one, and half a word
  std::mt19937 random(1);
  for (float& value : values)
  {
    value = static_cast<float>(random()) / 4294967296.F;
  }
  const auto print = Print(values);
  EXPECT_EQ(Print(values), print);
  for (std::size_t i = 0; i < values.size(); i += i < 300 || i + 300 > values.size() ? 1 : 977)
  {
    const float before = values[i];
    values[i] = std::nextafter(before, 2.F);
    ASSERT_NE(Print(values), print) << i;
    values[i] = before;
  }
  // Values that change places, at distances of words that meet in one sum.
  for (std::size_t distance : { std::size_t(1), std::size_t(2), std::size_t(16), std::size_t(32),
         static_cast<std::size_t>(2 * BlockOfPrint) })
  {
    for (std::size_t i = 0; i < 64; ++i)
    {
      std::swap(values[i], values[i + distance]);
      ASSERT_NE(Print(values), print) << i << " " << distance;
      std::swap(values[i], values[i + distance]);
    }
  }
  values.pop_back();
  EXPECT_NE(Print(values), print);
  // Equal bytes of another type are other points.
  vtkNew<vtkDoubleArray> zeros;
  zeros->SetNumberOfValues(30);
  zeros->Fill(0.);
  EXPECT_NE(Print(std::vector<float>(60, 0.F)), subdivision::ComputeFingerprint(zeros));
  // Bits have no bytes of their own: none are read, rather than too many.
  vtkNew<vtkBitArray> bits;
  bits->SetNumberOfValues(1000);
  bits->Fill(1.);
  EXPECT_EQ(subdivision::ComputeFingerprint(bits).size(), 3U);
}

TEST(SubdivisionDeformationKept, WorkBesideTheChecksumIsDoneOnceForEachPoint)
{
  const auto check = [](vtkDataArray* points, vtkIdType size)
  {
    points->SetNumberOfComponents(3);
    points->SetNumberOfTuples(size);
    for (vtkIdType i = 0; i < 3 * size; ++i)
    {
      points->SetComponent(i / 3, static_cast<int>(i % 3), 0.1 * static_cast<double>(i));
    }
    std::vector<int> counts(size, 0);
    const auto print = subdivision::ComputeFingerprint(points,
      [&](vtkIdType begin, vtkIdType end)
      {
        ASSERT_LE(end, size);
        for (vtkIdType i = begin; i < end; ++i)
        {
          ++counts[i];
        }
      });
    EXPECT_EQ(print, subdivision::ComputeFingerprint(points)) << size;
    EXPECT_EQ(std::count(counts.begin(), counts.end(), 1), size) << size;
    EXPECT_TRUE(subdivision::BeginsAs(points, print)) << size;
    points->SetComponent(0, 0, 1.);
    EXPECT_FALSE(subdivision::BeginsAs(points, print)) << size;
  };
  for (const vtkIdType size : { 1, 2, 3, 15, 16, 17, 33, 1000 })
  {
    for (const vtkIdType more : { vtkIdType(0), BlockOfPrint / 3, 2 * BlockOfPrint / 3 })
    {
      check(vtkNew<vtkFloatArray>(), size + more);
      check(vtkNew<vtkDoubleArray>(), size + more);
    }
  }
}

TEST(SubdivisionDeformationKept, APointThatChangesInPlaceIsSeenWhereverItIs)
{
  // Known points are moved before it is known whether they are the same; first and last ones differ
  // in when that shows.
  const Grid cage = MakeKuhnBox(2, 0.2, 3);
  const Grid cloud = MakeCloud(60000, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1);
  cloud->GetPoints()->SetPoint(7, 40., 1., 2.); // outside
  Deformer filter;
  const auto expectFresh = [&](double shift, vtkIdType builds)
  {
    const Grid deformed = Moved(cage,
      [shift](const Point& x) { return Point{ x[0] + shift * x[1] * x[1], x[1] - shift, x[2] }; });
    Deformer fresh;
    const auto expected = fresh.Run(cloud, cage, deformed);
    const auto moved = filter.Run(cloud, cage, deformed);
    EXPECT_TRUE(subdivision::HoldsSameValues(
      moved->GetPoints()->GetData(), expected->GetPoints()->GetData()));
    EXPECT_EQ(filter->GetNumberOfLocationBuilds(), builds);
    EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 1);
  };
  expectFresh(0.1, 1);
  expectFresh(0.2, 1);
  vtkIdType builds = 1;
  for (const vtkIdType i : { 59999, 0, 21839, 21840, 40000 })
  {
    cloud->GetPoints()->SetPoint(i, 0.9, 1., 1.1);
    ++builds;
    expectFresh(0.1 * static_cast<double>(builds), builds);
    expectFresh(0.3, builds);
  }
}

TEST(SubdivisionDeformationKept, WhatAnUpdateDidNotUseIsForgotten)
{
  const Grid cage = MakeKuhnBox(2);
  const Grid clouds[2] = { MakeCloud(30, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1),
    MakeCloud(30, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 2) };
  Deformer filter;
  vtkIdType lookups = 0;
  for (int i : { 0, 1, 0 })
  {
    filter.Run(clouds[i], cage, cage);
    EXPECT_EQ(filter->GetNumberOfLocationBuilds(), ++lookups);
  }
  EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
}

TEST(SubdivisionDeformationKept, ControlPointsThatAreNotFiniteAtRest)
{
  // Point 0 of the mesh, with its cells, cannot be used: all else can, and nothing else is lost.
  const Grid cage = MakeKuhnBox(3);
  cage->GetPoints()->SetPoint(0, NaN, NaN, NaN);
  for (int scheme : { 0, 1 })
  {
    for (int rule : { 0, 1 })
    {
      // Few and many: both kinds of rows. Two are outside.
      for (int size : { 30, 20000 })
      {
        const Grid cloud = MakeCloud(size, { 1.4, 1.4, 1.4 }, { 1.9, 1.9, 1.9 }, 1);
        cloud->GetPoints()->SetPoint(1, 40., 1., 2.);
        cloud->GetPoints()->SetPoint(2, 0.1, 0.1, 0.1);
        Deformer filter;
        filter->SetVolumeScheme(scheme);
        filter->SetOutsidePoints(rule);
        const auto moved = filter.Run(cloud, cage, Moved(cage, Affine));
        EXPECT_TRUE(filter.GetErrors().empty());
        EXPECT_FALSE(filter.GetWarnings().empty());
        EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 2);
        for (vtkIdType i = 0; i < size; ++i)
        {
          const bool isOutside = i == 1 || i == 2;
          const Point x = GetPoint(cloud, i);
          const Point wanted = isOutside ? x : Affine(x);
          for (int c = 0; c < 3; ++c)
          {
            const double found = GetPoint(moved, i)[c];
            ASSERT_TRUE(std::isfinite(found)) << i;
            ASSERT_TRUE((isOutside && rule == 1) || std::abs(found - wanted[c]) < 1e-12) << i;
          }
        }
      }
    }
  }
}

TEST(SubdivisionDeformationKept, SinglePrecisionPointsOnTheBoundaryAreInside)
{
  // Points of a face of a sharp box, whose coordinates are not numbers in single precision.
  const Grid cage = MakeKuhnBox(2);
  for (vtkIdType i = 0; i < cage->GetNumberOfPoints(); ++i)
  {
    const Point x = GetPoint(cage, i);
    cage->GetPoints()->SetPoint(i, x[0] / 3. + 0.7, x[1] / 3., x[2] / 3.);
  }
  std::vector<Point> points;
  for (int i = 0; i < 40; ++i)
  {
    points.push_back({ 0.7, 0.016 * i + 0.01, 0.3 });
    points.push_back({ 0.016 * i + 0.71, 2. / 3., 0.1 });
  }
  Deformer filter;
  filter->DetectFeaturesOn();
  for (int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const Grid cloud = MakeGrid(points, {}, type);
    const auto moved = filter.Run(cloud, cage, Moved(cage, Affine));
    EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 0) << type;
    EXPECT_LT(GetLargestError(moved, cloud, Affine), type == VTK_FLOAT ? 1e-6 : 1e-12);
  }
}

TEST(SubdivisionDeformationKept, ControlMeshesAreAskedForWhole)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkNew<vtkSubdivisionDeformation> filter;
  const Grid meshes[3] = { MakeCloud(30, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1), MakeKuhnBox(2),
    MakeKuhnBox(2) };
  std::vector<vtkSmartPointer<vtkTrivialProducer>> producers;
  for (int port = 0; port < 3; ++port)
  {
    producers.push_back(vtkSmartPointer<vtkTrivialProducer>::New());
    producers.back()->SetOutput(meshes[port]);
    filter->SetInputConnection(port, producers.back()->GetOutputPort());
  }
  filter->UpdatePiece(1, 2, 0);
  for (int port = 0; port < 3; ++port)
  {
    vtkInformation* request = filter->GetInputInformation(port, 0);
    EXPECT_EQ(request->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()), port == 0 ? 2 : 1) << port;
    EXPECT_EQ(request->Get(Pipeline::UPDATE_PIECE_NUMBER()), port == 0 ? 1 : 0) << port;
  }
}

TEST(SubdivisionDeformationKept, IntegerVectorsPass)
{
  const Grid cage = MakeKuhnBox(2);
  const Grid cloud = MakeCloud(30, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1);
  cloud->GetPointData()->SetVectors(MakeArray<vtkIntArray>("v", 3, 30, 0, 9, 1));
  Deformer filter;
  const auto output = filter.Run(cloud, cage, Moved(cage, Affine));
  EXPECT_EQ(CompareArrays(cloud->GetPointData(), output->GetPointData(), "points"), "");
  EXPECT_TRUE(filter.WasSilent());
}

TEST(SubdivisionDeformationKept, RestMeshesMayBeSubdividedAlready)
{
  // What an earlier filter wrote down of the rest mesh is taken over: its creases, octahedra and
  // diagonals. So one level of a mesh of one level is two levels of the first.
  for (int scheme : { 0, 1 })
  {
    const Grid cage = MakeKuhnBox(2, 0.2, 5);
    const Grid bent = Moved(cage, Bend);
    const Grid carried = DeepCopy(cage);
    bent->GetPoints()->GetData()->SetName("bent");
    carried->GetPointData()->AddArray(bent->GetPoints()->GetData());
    const Grid rest = Execute(carried, 1,
      [scheme](Filter* f)
      {
        f->SetVolumeScheme(scheme);
        f->SetDetectFeatures(true);
        f->SetFeatureAngle(40.);
      });
    const Grid deformed = DeepCopy(rest);
    deformed->GetPoints()->SetData(rest->GetPointData()->GetArray("bent"));
    const Grid cloud = MakeCloud(200, { 0.1, 0.1, 0.1 }, { 1.9, 1.9, 1.9 }, 1);
    Deformer filter;
    filter->SetVolumeScheme(scheme);
    filter->SetDetectFeatures(true);
    filter->SetFeatureAngle(40.);
    const auto wanted = filter.Run(cloud, cage, bent);
    const vtkIdType outside = filter->GetNumberOfOutsidePoints();
    filter->SetDetectFeatures(false);
    filter->SetNumberOfLevels(1);
    const auto found = filter.Run(cloud, rest, deformed);
    EXPECT_EQ(filter->GetNumberOfOutsidePoints(), outside);
    for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_NEAR(GetPoint(found, i)[c], GetPoint(wanted, i)[c], 1e-12);
      }
    }
    // Without what was written down it is another mesh.
    rest->GetFieldData()->Initialize();
    const vtkIdType builds = filter->GetNumberOfTopologyBuilds();
    filter.Run(cloud, rest, deformed);
    EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), builds + 1);
  }
}

TEST(SubdivisionDeformationKept, GlobalIdsChooseDiagonals)
{
  // Two regular tetrahedra, each with three diagonals that are equally long: as in the subdivision.
  const double far = 5. / 3.;
  Grid fine[2];
  for (int k : { 0, 1 })
  {
    const Grid cage =
      MakeGrid({ { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 }, { far, far, -far } },
        { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 2, 1, 4 } } });
    vtkNew<vtkIdTypeArray> ids;
    for (vtkIdType id : k == 0 ? Ids{ 0, 1, 2, 3, 4 } : Ids{ 0, 2, 1, 3, 4 })
    {
      ids->InsertNextValue(id);
    }
    cage->GetPointData()->SetGlobalIds(ids);
    const Grid bent = Moved(cage, Bend);
    bent->GetPoints()->GetData()->SetName("bent");
    const Grid carried = DeepCopy(cage);
    carried->GetPointData()->AddArray(bent->GetPoints()->GetData());
    fine[k] = Execute(carried, 3);
    Deformer filter;
    filter->SetNumberOfLevels(3);
    const auto found = filter.Run(fine[k], cage, bent);
    for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_NEAR(GetPoint(found, i)[c],
          fine[k]->GetPointData()->GetArray("bent")->GetComponent(i, c), 1e-12);
      }
    }
  }
  EXPECT_NE(ComparePoints(fine[0], fine[1]), "");
}

TEST(SubdivisionDeformationKept, HiddenCellsHoldNothing)
{
  const Grid cage = MakeKuhnBox(2);
  const Grid cloud = MakeCloud(200, { 0.3, 0.3, 0.3 }, { 1.7, 1.7, 1.7 }, 1);
  Deformer filter;
  filter->SetNumberOfLevels(0);
  filter.Run(cloud, cage, cage);
  EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 0);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(cage->GetNumberOfCells());
  ghosts->Fill(0);
  ghosts->SetValue(3, vtkDataSetAttributes::HIDDENCELL);
  ghosts->SetValue(4, vtkDataSetAttributes::HIDDENCELL);
  cage->GetCellData()->AddArray(ghosts);
  filter.Run(cloud, cage, cage);
  EXPECT_GT(filter->GetNumberOfOutsidePoints(), 0);
  EXPECT_LT(filter->GetNumberOfOutsidePoints(), 50);
}

TEST(SubdivisionDeformationKept, NearestPointsTurnWithTheirTetrahedron)
{
  // Triangles of the boundary are in the mesh too, and equally near: tetrahedra come first.
  const Grid cage = DeepCopy(MakeKuhnBox(2));
  const vtkIdType triangle[3] = { 2, 5, 4 };
  cage->InsertNextCell(VTK_TRIANGLE, 3, triangle);
  const Grid cloud = MakeCloud(60, { -0.5, -0.5, -0.5 }, { 2.5, 2.5, -0.1 }, 1);
  cloud->GetPointData()->SetVectors(MakeArray<vtkDoubleArray>("v", 3, 60, -1, 1, 5));
  Deformer filter;
  filter->SetNumberOfLevels(0);
  filter->SetOutsidePointsToNearest();
  const auto output = filter.Run(cloud, cage, Moved(cage, Affine));
  EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 60);
  const Point zero = Affine({ 0, 0, 0 });
  for (vtkIdType i = 0; i < 60; ++i)
  {
    const double* v = cloud->GetPointData()->GetVectors()->GetTuple3(i);
    const Point wanted = Affine({ v[0], v[1], v[2] });
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(
        output->GetPointData()->GetVectors()->GetComponent(i, c), wanted[c] - zero[c], 1e-12);
    }
  }
}

TEST(SubdivisionDeformationKept, TheCylinderHoldsWhatIsNearItsRims)
{
  // Its ends stay flat and round up to their rims, which are creases.
  vtkNew<vtkSubdivisionModelSource> source;
  source->SetModelToCylinder();
  source->Update();
  const Grid cage = source->GetOutput();
  std::vector<Point> points;
  for (int i = 0; i < 24; ++i)
  {
    for (double z : { 0., 3. })
    {
      points.push_back({ 1.34 * std::cos(0.2618 * i), 1.34 * std::sin(0.2618 * i), z });
    }
  }
  const Grid cloud = MakeGrid(points, {});
  for (int scheme : { 0, 1 })
  {
    Deformer filter;
    filter->SetNumberOfLevels(3);
    filter->SetVolumeScheme(scheme);
    const auto moved = filter.Run(cloud, cage, Moved(cage, Affine));
    EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 0);
    EXPECT_LT(GetLargestError(moved, cloud, Affine), 1e-12);
    EXPECT_TRUE(filter.WasSilent());
    const Grid smooth = DeepCopy(cage);
    smooth->GetCellData()->GetArray("Singular")->Fill(0.);
    filter.Run(cloud, smooth, smooth);
    EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 48); // without creases it is round
  }
}
