// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionLabelSolidPieces.cxx
 * Connected labels stay connected, or a warning tells of them; solids are flat at the border of the
 * image; labels are exact.
 */
#include "LabelTools.h"
#include "Turns.h"

#include "vtkTable.h"
#include "vtkTrivialProducer.h"
#include "vtkTypeInt64Array.h"
#include "vtkTypeInt8Array.h"
#include "vtkTypeUInt64Array.h"

using namespace label_tools;

namespace
{

/// A ball with a thin vessel that winds through it.
Image MakeVessel(int n)
{
  return MakeImage({ n, n, n },
    [n](int i, int j, int k)
    {
      const double middle = (n - 1) / 2.;
      const double at[3] = { i - middle, j - middle, k - middle };
      if (at[0] * at[0] + at[1] * at[1] + at[2] * at[2] > middle * middle)
      {
        return 0;
      }
      const double winding = at[0] - .15 * n * std::sin(8. * k / n);
      return std::abs(winding) < 1.1 && std::abs(at[1] - .5) < 1.1 ? 2 : 1;
    });
}

/// The number of pieces that the cells of a label have, by points or by whole faces that they
/// share.
std::size_t CountPieces(vtkUnstructuredGrid* solid, double label, bool byFaces)
{
  vtkDataArray* labels = solid->GetCellData()->GetScalars();
  Ids first(solid->GetNumberOfCells());
  std::iota(first.begin(), first.end(), 0);
  const std::function<vtkIdType(vtkIdType)> find = [&](vtkIdType i)
  { return first[i] == i ? i : first[i] = find(first[i]); };
  std::map<Ids, vtkIdType> known;
  for (vtkIdType c = 0; c < solid->GetNumberOfCells(); ++c)
  {
    Ids cell = GetCell(solid, c);
    std::sort(cell.begin(), cell.end());
    for (int left = 0; labels->GetComponent(c, 0) == label && left < 4; ++left)
    {
      Ids part{ cell[left] };
      if (byFaces)
      {
        part = cell;
        part.erase(part.begin() + left);
      }
      const auto entry = known.emplace(part, c);
      first[find(c)] = find(entry.first->second);
    }
  }
  std::set<vtkIdType> pieces;
  for (const auto& entry : known)
  {
    pieces.insert(find(entry.second));
  }
  return pieces.size();
}

/// How many points of the solid's boundary are in the plane, and how far others of it near by are.
struct Flatness
{
  int InPlane = 0;
  double Farthest = 0.;
};

Flatness MeasureFlatness(vtkUnstructuredGrid* solid, int axis, double plane)
{
  std::map<Ids, int> faces;
  for (vtkIdType c = 0; c < solid->GetNumberOfCells(); ++c)
  {
    for (int left = 0; left < 4; ++left)
    {
      Ids face = GetCell(solid, c);
      face.erase(face.begin() + left);
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
  }
  Flatness found;
  for (const auto& [face, count] : faces)
  {
    double area[3];
    double edges[2][3];
    for (int c = 0; c < 3; ++c)
    {
      edges[0][c] = GetPoint(solid, face[1])[c] - GetPoint(solid, face[0])[c];
      edges[1][c] = GetPoint(solid, face[2])[c] - GetPoint(solid, face[0])[c];
    }
    for (int c = 0; c < 3; ++c)
    {
      area[c] = edges[0][(c + 1) % 3] * edges[1][(c + 2) % 3] -
        edges[0][(c + 2) % 3] * edges[1][(c + 1) % 3];
    }
    const double length = std::hypot(area[0], area[1], area[2]);
    const double distance = std::abs(GetPoint(solid, face[0])[axis] - plane);
    if (count == 1 && std::abs(area[axis]) > .95 * length && distance < .3)
    {
      ++found.InPlane;
      for (const vtkIdType p : face)
      {
        found.Farthest = std::max(found.Farthest, std::abs(GetPoint(solid, p)[axis] - plane));
      }
    }
  }
  return found;
}

}

TEST(SubdivisionLabelSolid, ThinLabelsStayConnected)
{
  const Image image = MakeVessel(40);
  for (const int connectivity :
    { vtkSubdivisionLabelSolid::FACES, vtkSubdivisionLabelSolid::CORNERS })
  {
    Made made;
    made->SetConnectivity(connectivity);
    made->SetNumberOfControlCells(4000);
    made->SetNumberOfLevels(0);
    vtkUnstructuredGrid* solid = made.Run(image);
    made.ExpectSilence();
    EXPECT_LE(solid->GetNumberOfCells(), 6 * 4000);
    EXPECT_EQ(CountPieces(solid, 2., true), 1u);
    EXPECT_EQ(CountPieces(solid, 1., true), 1u);
    // Otherwise it comes apart, which is told with the number of pieces.
    made->KeepConnectedOff();
    solid = made.Run(image);
    const std::size_t pieces = CountPieces(solid, 2., connectivity == 0);
    ASSERT_GT(pieces, 1u);
    EXPECT_EQ(made.Heard->CountWarnings("label 2 has 1 connected piece of voxels, and " +
                std::to_string(pieces) + " connected pieces in the output"),
      1);
  }
}

TEST(SubdivisionLabelSolid, PiecesThatBecomeOneAreTold)
{
  // Two slabs with a gap of one voxel, which most of its blocks do not see.
  const Image image = MakeImage({ 18, 12, 12 }, [](int i, int, int) { return i == 8 ? 0 : 5; });
  Made made;
  made->SetNumberOfControlCells(100);
  vtkUnstructuredGrid* solid = made.Run(image);
  EXPECT_EQ(CountPieces(solid, 5., false), 1u);
  EXPECT_EQ(made.Heard->CountWarnings(
              "label 5 has 2 connected pieces of voxels, and 1 connected piece in the output"),
    1);
}

TEST(SubdivisionLabelSolid, BordersOfTheImageAreFlat)
{
  // A slanted cylinder of two materials, which goes through the image.
  const auto rule = [](int i, int j, int k)
  {
    const double x = i - 8.2 - .3 * (k - 8);
    const double y = j - 7.9;
    return x * x + y * y > 30. ? 0 : x * x + y * y < 9. ? 2 : 1;
  };
  for (const auto& [cells, size] : { std::pair<int, int>{ 0, 17 }, { 400, 17 }, { 300, 19 } })
  {
    for (const int levels : turns::Some({ 0, 1, 2 }))
    {
      Made made;
      made->SetNumberOfControlCells(cells);
      made->SetNumberOfLevels(levels);
      vtkUnstructuredGrid* solid = made.Run(MakeImage({ 17, 17, size }, rule));
      EXPECT_TRUE(made.Heard->Errors.empty() && made.Heard->Inversions.empty());
      for (const double plane : { -.5, size - .5 })
      {
        const Flatness flatness = MeasureFlatness(solid, 2, plane);
        EXPECT_GT(flatness.InPlane, 20);
        EXPECT_LT(flatness.Farthest, 1e-12) << cells << " cells, " << levels << " levels";
      }
      EXPECT_NEAR(solid->GetBounds()[4], -.5, 1e-12);
      EXPECT_NEAR(solid->GetBounds()[5], size - .5, 1e-12);
    }
  }
  Made made;
  made->SetNumberOfControlCells(0);
  made->FlatBorderOff();
  vtkUnstructuredGrid* solid = made.Run(MakeImage({ 17, 17, 17 }, rule));
  EXPECT_GT(MeasureFlatness(solid, 2, -.5).Farthest, .01) << "round";
}

TEST(SubdivisionLabelSolid, AnImageWithoutBackgroundIsABox)
{
  const Image image = MakeImage({ 11, 8, 6 }, [](int i, int, int) { return i < 4 ? 2 : 1; });
  for (const int cells : { 0, 70 })
  {
    for (const int scheme :
      { vtkSubdivisionAlgorithm::BOX_SPLINE, vtkSubdivisionAlgorithm::TET_OCT })
    {
      Made made;
      made->SetNumberOfControlCells(cells);
      made->SetVolumeScheme(scheme);
      vtkUnstructuredGrid* solid = made.Run(image);
      made.ExpectSilence();
      double volume = 0.;
      for (vtkIdType c = 0; c < solid->GetNumberOfCells(); ++c)
      {
        volume += GetSignedVolume(solid, GetCell(solid, c));
      }
      EXPECT_NEAR(volume, 11. * 8. * 6., 1e-9);
    }
  }
}

TEST(SubdivisionLabelSolid, LabelsOf64BitsAreExact)
{
  using Signed = vtkTypeInt64;
  using Unsigned = vtkTypeUInt64;
  const auto expectLabels = [](vtkDataArray* labels, const std::vector<vtkVariant>& values)
  {
    labels->SetName("Tissue");
    labels->SetNumberOfTuples(64);
    const auto number = static_cast<vtkIdType>(values.size());
    for (vtkIdType i = 0; i < 64; ++i)
    {
      labels->SetVariantValue(i, values[static_cast<std::size_t>(i * number / 64)]);
    }
    const Image image = MakeImage({ 4, 4, 4 }, [](int, int, int) { return 1; });
    image->GetPointData()->SetScalars(labels);
    // A table with the last label twice, so that the message has to name it.
    vtkNew<vtkTable> table;
    const auto column = vtkSmartPointer<vtkDataArray>::Take(labels->NewInstance());
    column->SetName("Tissue");
    vtkNew<vtkIntArray> rows;
    rows->SetName("Row");
    for (vtkIdType i = 0; i <= number; ++i)
    {
      column->InsertNextTuple1(0.);
      column->SetVariantValue(i, values[static_cast<std::size_t>(std::min(i, number - 1))]);
      rows->InsertNextValue(static_cast<int>(i));
    }
    table->AddColumn(column);
    table->AddColumn(rows);
    vtkNew<vtkTrivialProducer> source;
    source->SetOutput(table);
    Made made;
    made->SetMaterialsConnection(source->GetOutputPort());
    vtkUnstructuredGrid* solid = made.Run(image);
    EXPECT_TRUE(made.Heard->Errors.empty());
    vtkDataArray* found = solid->GetCellData()->GetArray("Tissue");
    vtkDataArray* row = solid->GetCellData()->GetArray("Row");
    ASSERT_TRUE(found && row);
    EXPECT_EQ(found->GetDataType(), labels->GetDataType());
    std::set<vtkIdType> seen;
    for (vtkIdType c = 0; c < solid->GetNumberOfCells(); ++c)
    {
      const auto at = static_cast<vtkIdType>(row->GetComponent(c, 0));
      seen.insert(at);
      ASSERT_EQ(found->GetVariantValue(c), values[static_cast<std::size_t>(at)]);
    }
    EXPECT_EQ(static_cast<vtkIdType>(seen.size()), number);
    EXPECT_EQ(
      made.Heard->CountWarnings("several rows for label " + values.back().ToString() + ":"), 1);
  };
  const Signed large = Signed(1) << 53;
  expectLabels(vtkNew<vtkTypeInt64Array>(),
    { std::numeric_limits<Signed>::min(), -large - 1, -large, -3, large, large + 1,
      std::numeric_limits<Signed>::max() });
  expectLabels(vtkNew<vtkTypeUInt64Array>(),
    { Unsigned(7), Unsigned(large), Unsigned(large + 1), std::numeric_limits<Unsigned>::max() - 1,
      std::numeric_limits<Unsigned>::max() });
  expectLabels(vtkNew<vtkTypeInt8Array>(), { -128, -1, 65 });
  expectLabels(vtkNew<vtkDoubleArray>(), { -2., 3., 4096. });
}

TEST(SubdivisionLabelSolid, MissingLabelsAreBackground)
{
  const Image image = MakeImage({ 4, 4, 4 }, [](int, int, int) { return 1; });
  vtkNew<vtkFloatArray> labels;
  labels->SetName("Tissue");
  labels->SetNumberOfValues(64);
  labels->FillValue(3.f);
  labels->SetValue(5, std::numeric_limits<float>::quiet_NaN());
  labels->SetValue(6, std::numeric_limits<float>::infinity());
  image->GetPointData()->SetScalars(labels);
  Made made;
  made->SetNumberOfLevels(0);
  EXPECT_EQ(made.Run(image)->GetNumberOfCells(), 6 * 62);
  EXPECT_EQ(made.Heard->CountWarnings("2 voxels have a label that is not finite, the first is "
                                      "number 5"),
    1);
  labels->SetValue(7, 2.5f);
  image->Modified();
  labels->Modified();
  made.Run(image);
  made.ExpectError("the first is number 7: 2.5.");
}
