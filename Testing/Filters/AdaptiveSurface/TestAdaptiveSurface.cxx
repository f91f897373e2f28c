// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveSurfaceSubdivision: criteria, arrays, limits, bad input.

#include "AdaptiveFilterTools.h"

#include "vtkMath.h"
#include "vtkStringArray.h"
#include "vtkTriangle.h"

using namespace adaptive_filter_tools;

namespace
{

double GetLongestEdge(vtkPolyData* mesh)
{
  double longest = 0.;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(cell, ids);
    const vtkIdType size = ids->GetNumberOfIds();
    for (vtkIdType i = 0; i < size; ++i)
    {
      Point a;
      Point b;
      mesh->GetPoint(ids->GetId(i), a.data());
      mesh->GetPoint(ids->GetId((i + 1) % size), b.data());
      longest = std::max(longest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
  }
  return longest;
}

}

TEST(AdaptiveSurface, EverythingWantedIsTheUniformMeshAtTheLimit)
{
  std::map<std::string, PolyData> inputs;
  for (const auto& [name, model] : MakeZoo(true))
  {
    inputs[name] = MakeInput(model);
  }
  inputs.erase("pillow"); // its points have the same limit, so that nothing is worth a split
  inputs["hill"] = MakeHill(6);
  for (const auto& [name, input] : inputs)
  {
    for (int level : { 0, 1, 2, 5 })
    {
      SCOPED_TRACE(name + ", level " + std::to_string(level));
      const PolyData uniform = RunPlainSqrtThree(input, level);
      auto marked = PolyData::New();
      marked->ShallowCopy(input);
      WantLevel(marked, 7);
      const PolyData output = Refine(marked,
        [level](Filter* filter)
        {
          filter->RefineByWantedLevelOn();
          filter->SetMaximumLevel(level);
        });
      ASSERT_EQ(output->GetNumberOfPoints(), uniform->GetNumberOfPoints());
      ASSERT_EQ(output->GetNumberOfPolys(), uniform->GetNumberOfPolys());
      ASSERT_EQ(output->GetNumberOfLines(), uniform->GetNumberOfLines());
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        Point a;
        Point b;
        output->GetPoint(i, a.data());
        uniform->GetPoint(i, b.data());
        ASSERT_LT(GetDistance(a, b), 1e-12 * std::max(1., input->GetLength()));
      }
      for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
      {
        vtkNew<vtkIdList> a;
        vtkNew<vtkIdList> b;
        output->GetCellPoints(i, a);
        uniform->GetCellPoints(i, b);
        ASSERT_EQ(a->GetNumberOfIds(), b->GetNumberOfIds());
        for (vtkIdType p = 0; p < a->GetNumberOfIds(); ++p)
        {
          ASSERT_EQ(a->GetId(p), b->GetId(p)) << "cell " << i;
        }
      }
      for (const char* array : { "OfCell", "Label", "Name" })
      {
        vtkAbstractArray* a = output->GetCellData()->GetAbstractArray(array);
        vtkAbstractArray* b = uniform->GetCellData()->GetAbstractArray(array);
        a = a ? a : output->GetPointData()->GetAbstractArray(array);
        b = b ? b : uniform->GetPointData()->GetAbstractArray(array);
        ASSERT_EQ(a != nullptr, b != nullptr);
        for (vtkIdType i = 0; a && i < a->GetNumberOfTuples(); ++i)
        {
          ASSERT_EQ(a->GetVariantValue(i), b->GetVariantValue(i)) << array << " " << i;
        }
      }
    }
  }
}

TEST(AdaptiveSurface, EdgesGetShortEnough)
{
  const PolyData input = MakeHill(5);
  for (double length : { 0.7, 0.2, 0.05 })
  {
    const PolyData output = Refine(input,
      [length](Filter* filter)
      {
        filter->RefineByEdgeLengthOn();
        filter->SetMaximumEdgeLength(length);
        filter->SetMaximumLevel(20);
      });
    EXPECT_LE(GetLongestEdge(output), length);
    EXPECT_GT(GetLongestEdge(output), 0.2 * length);
  }
}

/// An octahedron; where all faces are as small, adjacent ones are the flatter for it.
TEST(AdaptiveSurface, CurvatureIsMetWhateverTheSize)
{
  auto run = [](double size, double angle)
  {
    Model octahedron;
    octahedron.Points = { { size, 0., 0. }, { 0., size, 0. }, { -size, 0., 0. }, { 0., -size, 0. },
      { 0., 0., size }, { 0., 0., -size } };
    octahedron.Faces = { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 }, { 1, 0, 5 },
      { 2, 1, 5 }, { 3, 2, 5 }, { 0, 3, 5 } };
    return Refine(MakeInput(octahedron),
      [angle](Filter* filter)
      {
        filter->RefineByCurvatureOn();
        filter->SetMaximumAngle(angle);
        filter->SetMaximumLevel(14);
      });
  };
  for (double angle : { 30., 9. })
  {
    const PolyData output = run(1., angle);
    output->BuildLinks();
    auto getNormal = [&output](vtkIdType cell, double* normal)
    {
      vtkTriangle::ComputeNormal(
        output->GetPoints(), 3, output->GetCell(cell)->PointIds->GetPointer(0), normal);
    };
    double largest = 0.;
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      double own[3];
      double other[3];
      getNormal(cell, own);
      vtkNew<vtkIdList> ids;
      output->GetCellPoints(cell, ids);
      for (vtkIdType k = 0; k < 3; ++k)
      {
        vtkNew<vtkIdList> others;
        output->GetCellEdgeNeighbors(cell, ids->GetId(k), ids->GetId((k + 1) % 3), others);
        ASSERT_EQ(others->GetNumberOfIds(), 1);
        getNormal(others->GetId(0), other);
        largest = std::max(largest, vtkMath::AngleBetweenVectors(own, other));
      }
    }
    EXPECT_LE(vtkMath::DegreesFromRadians(largest), angle);
    EXPECT_GT(vtkMath::DegreesFromRadians(largest), 0.2 * angle);
    EXPECT_EQ(run(64., angle)->GetNumberOfCells(), output->GetNumberOfCells());
  }
}

TEST(AdaptiveSurface, AttributesAreMetAndTheRestIsLeftAlone)
{
  const PolyData input = MakeHill(8);
  const double range = input->GetPointData()->GetScalars()->GetRange()[1];
  for (double tolerance : { 0.2, 0.05 })
  {
    const PolyData output = Refine(input,
      [tolerance](Filter* filter)
      {
        filter->RefineByAttributeErrorOn();
        filter->SetAttributeTolerance(tolerance);
        filter->SetMaximumLevel(20);
      });
    vtkDataArray* values = output->GetPointData()->GetArray("Value");
    EXPECT_EQ(output->GetPointData()->GetScalars(), values);
    double largest = 0.;
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      vtkNew<vtkIdList> ids;
      output->GetCellPoints(cell, ids);
      for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
      {
        largest = std::max(largest,
          std::abs(
            values->GetComponent(ids->GetId(i), 0) - values->GetComponent(ids->GetId(0), 0)));
      }
    }
    EXPECT_LE(largest, tolerance * range * (1. + 1e-6));
    EXPECT_EQ(output->GetCellData()->GetArray("Generation")->GetRange()[0], 0.);
    // The height is an attribute, too.
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      ASSERT_NEAR(values->GetComponent(i, 0), output->GetPoint(i)[2], 1e-6);
    }
  }
  const PolyData limit = Refine(input,
    [](Filter* filter)
    {
      filter->RefineByAttributeErrorOn();
      filter->SetAttributeErrorKindToLimitDifference();
      filter->SetAttributeTolerance(0.002);
      filter->SetMaximumLevel(20);
    });
  const PolyData geometric = Refine(input,
    [range](Filter* filter)
    {
      filter->RefineByGeometricErrorOn();
      filter->RelativeToleranceOff();
      filter->SetGeometricTolerance(0.002 * range);
      filter->SetMaximumLevel(20);
    });
  EXPECT_GT(limit->GetNumberOfCells(), input->GetNumberOfCells());
  EXPECT_GT(2 * limit->GetNumberOfCells(), geometric->GetNumberOfCells());
  EXPECT_LT(limit->GetNumberOfCells(), 4 * geometric->GetNumberOfCells());
}

TEST(AdaptiveSurface, RangesAndLevelsOfCells)
{
  const PolyData input = MakeHill(6);
  auto run = [&](int association)
  {
    return Refine(input,
      [association](Filter* filter)
      {
        filter->RefineByArrayRangeOn();
        filter->SetInputArrayToProcess(6, 0, 0, association, association == 1 ? "OfCell" : "Value");
        filter->SetArrayRange(association == 1 ? 10. : 1., association == 1 ? 10. : 9.);
        filter->SetMaximumLevel(4);
      });
  };
  const PolyData ofCells = run(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  vtkDataArray* cells = ofCells->GetCellData()->GetArray("OfCell");
  auto* originals =
    vtkIdTypeArray::SafeDownCast(ofCells->GetCellData()->GetArray("vtkOriginalCellIds"));
  ASSERT_NE(originals, nullptr);
  vtkIdType finest = 0;
  for (vtkIdType i = 0; i < ofCells->GetNumberOfCells(); ++i)
  {
    EXPECT_EQ(cells->GetComponent(i, 0), 0.5 * static_cast<double>(originals->GetValue(i)));
    finest += ofCells->GetCellData()->GetArray("Generation")->GetComponent(i, 0) == 8. ? 1 : 0;
  }
  EXPECT_GT(finest, 40);
  EXPECT_LT(ofCells->GetNumberOfCells(), input->GetNumberOfCells() + 400);
  const PolyData ofPoints = run(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  vtkDataArray* values = ofPoints->GetPointData()->GetArray("Value");
  for (vtkIdType i = 0; i < ofPoints->GetNumberOfCells(); ++i)
  {
    vtkNew<vtkIdList> ids;
    ofPoints->GetCellPoints(i, ids);
    for (vtkIdType p = 0; p < ids->GetNumberOfIds(); ++p)
    {
      if (values->GetComponent(ids->GetId(p), 0) > 1.01 && ids->GetNumberOfIds() == 3)
      {
        EXPECT_GE(ofPoints->GetCellData()->GetArray("Generation")->GetComponent(i, 0), 7.);
      }
    }
  }
}

/// Every second face runs around the other way.
PolyData TurnSomeFaces(vtkPolyData* input)
{
  const auto turned = PolyData::New();
  turned->DeepCopy(input);
  turned->BuildCells();
  for (vtkIdType cell = 0; cell < turned->GetNumberOfCells(); cell += 2)
  {
    if (turned->GetCellType(cell) == VTK_TRIANGLE)
    {
      turned->ReverseCell(cell);
    }
  }
  return turned;
}

TEST(AdaptiveSurface, NormalsAreThoseOfTheUniformMesh)
{
  std::map<std::string, PolyData> inputs;
  for (const char* name : { "triangle", "two triangles", "tetrahedron", "bow tie", "free line" })
  {
    inputs[name] = MakeInput(MakeZoo(true)[name]);
  }
  inputs["hill"] = MakeHill(6);
  for (const char* name : { "hill", "tetrahedron", "two triangles" })
  {
    inputs[std::string("turned ") + name] = TurnSomeFaces(inputs[name]);
  }
  // A part of two triangles, one of them turned over, with a third one at their edge.
  Model book = MakeZoo(true)["two triangles"];
  book.Faces[1] = { book.Faces[1][0], book.Faces[1][2], book.Faces[1][1] };
  book.Points.push_back({ 0.4, 0.3, 1. });
  const int last = static_cast<int>(book.Points.size()) - 1;
  book.Faces.push_back({ book.Faces[0][0], book.Faces[0][1], last });
  inputs["book"] = MakeInput(book);
  for (const auto& [name, input] : inputs)
  {
    for (int level : { 0, 1, 2, 3, 4 })
    {
      SCOPED_TRACE(name + ", level " + std::to_string(level));
      const PolyData uniform = RunPlainSqrtThree(input, level);
      auto marked = PolyData::New();
      marked->ShallowCopy(input);
      WantLevel(marked, 9);
      const PolyData output = Refine(marked,
        [level](Filter* filter)
        {
          filter->RefineByWantedLevelOn();
          filter->SetMaximumLevel(level);
          filter->GenerateLimitNormalsOn();
          filter->GenerateTangentsOn();
        });
      vtkDataArray* normals = output->GetPointData()->GetArray("LimitNormals");
      vtkDataArray* expected = uniform->GetPointData()->GetArray("LimitNormals");
      ASSERT_NE(normals, nullptr);
      ASSERT_EQ(normals->GetNumberOfTuples(), expected->GetNumberOfTuples());
      for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
      {
        Point a;
        Point b;
        normals->GetTuple(i, a.data());
        expected->GetTuple(i, b.data());
        ASSERT_LT(GetDistance(a, b), 1e-9) << "point " << i;
      }
      EXPECT_NE(output->GetPointData()->GetArray("LimitTangent2"), nullptr);
    }
  }
}

TEST(AdaptiveSurface, StopsAtItsLimitsAndSaysSo)
{
  const PolyData input = MakeHill(6);
  for (vtkIdType most : { 20, 100, 500, 3000 })
  {
    vtkNew<Messages> messages;
    const PolyData output = Refine(
      input,
      [most](Filter* filter)
      {
        filter->RefineByGeometricErrorOn();
        filter->SetGeometricTolerance(0.);
        filter->SetMaximumLevel(60);
        filter->SetMaximumNumberOfCells(most);
      },
      messages);
    EXPECT_LE(output->GetNumberOfCells(), std::max(most, input->GetNumberOfCells()));
    EXPECT_GT(output->GetNumberOfCells(), most - 10);
    EXPECT_EQ(messages->CountWarnings("MaximumNumberOfCells"), most == 20 ? 2 : 1);
    EXPECT_TRUE(messages->Errors.empty());
  }
  // One triangle, as deep as numbers go.
  vtkNew<Messages> messages;
  const PolyData triangle =
    MakeInput({ { { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. } }, { { 0, 1, 2 } }, {}, {} });
  const PolyData output = Refine(
    triangle,
    [](Filter* filter)
    {
      filter->RefineByEdgeLengthOn();
      filter->SetMaximumEdgeLength(0.);
      filter->SetMaximumLevel(60);
      filter->SetMaximumNumberOfCells(20000);
    },
    messages);
  EXPECT_LE(output->GetNumberOfCells(), 20000);
  EXPECT_EQ(messages->CountWarnings("MaximumNumberOfCells"), 1);
}

TEST(AdaptiveSurface, SameBitsForAnyNumberOfThreads)
{
  const PolyData input = MakeHill(30);
  const PolyData result = multi_dimensional_subdivision_tools::MakeInThreads(
    [&]
    {
      return Refine(input,
        [](Filter* filter)
        {
          filter->RefineByGeometricErrorOn();
          filter->SetGeometricTolerance(2e-5);
          filter->RefineByAttributeErrorOn();
          filter->SetAttributeTolerance(0.01);
          filter->SetMaximumLevel(12);
        });
    });
  EXPECT_GT(result->GetNumberOfPolys(), 20000);
  EXPECT_EQ(result->GetPointData()->GetAbstractArray("Name")->GetNumberOfTuples(),
    result->GetNumberOfPoints());
}

TEST(AdaptiveSurface, BadInputIsToldOrTaken)
{
  vtkNew<Messages> messages;
  // Without an array the geometry counts.
  PolyData input = MakeHill(3);
  input->GetPointData()->Initialize();
  const PolyData refined =
    Refine(input, [](Filter* filter) { filter->RefineByAttributeErrorOn(); }, messages);
  EXPECT_GT(refined->GetNumberOfPolys(), input->GetNumberOfPolys());
  EXPECT_TRUE(messages->Warnings.empty());
  // Arrays that are not there.
  Refine(input, [](Filter* filter) { filter->RefineByArrayRangeOn(); }, messages);
  EXPECT_FALSE(messages->Errors.empty());
  messages->Errors.clear();
  Refine(input, [](Filter* filter) { filter->RefineByWantedLevelOn(); }, messages);
  EXPECT_FALSE(messages->Errors.empty());
  // Values and coordinates that are not finite.
  for (double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    messages->Warnings.clear();
    input = MakeHill(4);
    input->GetPointData()->GetScalars()->SetComponent(7, 0, bad);
    PolyData output = Refine(
      input,
      [](Filter* filter)
      {
        filter->RefineByAttributeErrorOn();
        filter->SetMaximumLevel(6);
      },
      messages);
    EXPECT_EQ(messages->CountWarnings("not finite"), 1);
    EXPECT_GT(output->GetNumberOfCells(), input->GetNumberOfCells());
    Point point;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      output->GetPoint(i, point.data());
      ASSERT_TRUE(std::isfinite(point[0] + point[1] + point[2]));
    }
    input->GetPoints()->SetPoint(3, bad, 0., 0.);
    output = Refine(
      input,
      [](Filter* filter)
      {
        filter->RefineByGeometricErrorOn();
        filter->SetMaximumLevel(6);
      },
      messages);
    EXPECT_GE(output->GetNumberOfCells(), input->GetNumberOfCells());
  }
  // No cells, and no points.
  const PolyData empty = PolyData::New();
  EXPECT_EQ(Refine(empty, [](Filter*) {})->GetNumberOfPoints(), 0);
  empty->SetPoints(vtkNew<vtkPoints>());
  EXPECT_EQ(Refine(empty, [](Filter*) {})->GetNumberOfCells(), 0);
  empty->GetPoints()->InsertNextPoint(1., 2., 3.);
  EXPECT_EQ(Refine(empty, [](Filter*) {})->GetNumberOfPoints(), 1);
}

TEST(AdaptiveSurface, AValenceOf2000AndFreeLines)
{
  const PolyData fan = MakeInput(MakeFan(2000, false));
  const PolyData output = Refine(fan,
    [](Filter* filter)
    {
      filter->RefineByEdgeLengthOn();
      filter->SetMaximumEdgeLength(0.3);
      filter->SetMaximumLevel(10);
    });
  EXPECT_GT(output->GetNumberOfPolys(), 6000);
  const PolyData lines = MakeInput(MakeZoo(true)["free line"]);
  const PolyData cut = Refine(lines,
    [](Filter* filter)
    {
      filter->RefineByGeometricErrorOn();
      filter->SetGeometricTolerance(1e-3);
      filter->SetMaximumLevel(10);
    });
  EXPECT_GT(cut->GetNumberOfLines(), 3 * lines->GetNumberOfLines());
  EXPECT_EQ(
    cut->GetCellData()->GetArray("Generation")->GetNumberOfTuples(), cut->GetNumberOfCells());
}
