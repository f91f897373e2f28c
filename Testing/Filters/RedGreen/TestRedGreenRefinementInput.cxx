// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenRefinementInput.cxx
 * vtkRedGreenRefinement: cells of any kind and dimension, meshes that are damaged or empty, arrays
 * of any kind, values that are not finite, input that changes with time.
 */
#include "RedGreenRefinementTools.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLongLongArray.h"
#include "vtkObjectFactory.h"
#include "vtkSphere.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGridAlgorithm.h"

using namespace red_green_refinement_tools;

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

void AddLevels(vtkUnstructuredGrid* grid, const std::vector<int>& levels)
{
  vtkNew<vtkLongLongArray> array;
  array->SetName("WantedLevel");
  for (int level : levels)
  {
    array->InsertNextValue(level);
  }
  grid->GetCellData()->AddArray(array);
}

/// How many cells of each kind each input cell has become.
using Kinds = std::map<vtkIdType, std::map<int, int>>;
Kinds CountKinds(vtkUnstructuredGrid* output)
{
  Kinds kinds;
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    ++kinds[GetOrigin(output, i)][static_cast<int>(GetKind(output, i))];
  }
  return kinds;
}

}

// ------------------------------------------------------------------------------------------------
// Cells

/// A tetrahedron, a triangle that is its face, a line that is an edge of both, and a vertex.
TEST(RedGreenCells, OfAllDimensionsFollowEachOther)
{
  const Grid input =
    MakeGrid(coretest::With(coretest::MakeTet(""), "", { { 0, 1, 2 }, { 1, 0 }, { 0 }, { 3, 4 } }));
  AddWeights(input);
  auto run = [&](const std::vector<int>& levels)
  {
    AddLevels(input, levels);
    const Grid output = RefineToWanted(input, 1);
    EXPECT_EQ(CheckConformity(input, output), "");
    return CountKinds(output);
  };
  const std::map<int, int> whole = { { 0, 1 } };
  const std::map<int, int> line = { { 1, 2 } };
  EXPECT_EQ(run({ 0, 0, 1, 0, 0 }),
    (Kinds{ { 0, { { 2, 2 } } }, { 1, { { 2, 2 } } }, { 2, line }, { 3, whole }, { 4, whole } }));
  EXPECT_EQ(run({ 0, 1, 0, 0, 0 }),
    (Kinds{ { 0, { { 4, 4 } } }, { 1, { { 1, 4 } } }, { 2, line }, { 3, whole }, { 4, whole } }));
  EXPECT_EQ(run({ 1, 0, 0, 0, 0 }),
    (Kinds{ { 0, { { 1, 8 } } }, { 1, { { 1, 4 } } }, { 2, line }, { 3, whole }, { 4, whole } }));
  EXPECT_EQ(run({ 0, 0, 0, 1, 1 }),
    (Kinds{ { 0, whole }, { 1, whole }, { 2, whole }, { 3, whole }, { 4, line } }));
}

/// Opposite edges of a tetrahedron, as two lines.
TEST(RedGreenCells, OppositeEdges)
{
  const Grid input = MakeGrid(coretest::With(coretest::MakeTet(""), "", { { 0, 1 }, { 2, 3 } }));
  AddWeights(input);
  AddLevels(input, { 0, 1, 1 });
  const Grid output = RefineToWanted(input, 1);
  EXPECT_EQ(CheckConformity(input, output), "");
  EXPECT_EQ(
    CountKinds(output), (Kinds{ { 0, { { 3, 4 } } }, { 1, { { 1, 2 } } }, { 2, { { 1, 2 } } } }));
}

/// What is no simplex is split into simplices, which are refined as if they had been the input.
TEST(RedGreenCells, ThatAreNoSimplicesAreSplitFirst)
{
  const Grid mixed = MakeMixedBox(2);
  std::vector<int> levels;
  for (vtkIdType i = 0; i < mixed->GetNumberOfCells(); ++i)
  {
    levels.push_back(i % 7 == 3 ? 2 : i % 5 == 0 ? 1 : 0);
  }
  AddLevels(mixed, levels);
  const Grid output = RefineToWanted(mixed);
  // The simplices as a mesh of their own.
  AddLevels(mixed, std::vector<int>(levels.size(), 0));
  const Grid split = RefineToWanted(mixed);
  EXPECT_GT(split->GetNumberOfCells(), mixed->GetNumberOfCells());
  const Grid simplices = Grid::New();
  simplices->CopyStructure(split);
  AddRandomNumbers(simplices);
  std::vector<int> ofSimplices;
  for (vtkIdType i = 0; i < split->GetNumberOfCells(); ++i)
  {
    ofSimplices.push_back(levels[GetOrigin(split, i)]);
  }
  AddLevels(simplices, ofSimplices);
  const Grid expected = RefineToWanted(simplices);
  EXPECT_EQ(GetCells(output), GetCells(expected));
  EXPECT_EQ(CompareValues(output->GetPoints()->GetData(), expected->GetPoints()->GetData()), "");
  EXPECT_EQ(CheckConformity(simplices, expected), "");
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    EXPECT_EQ(GetOrigin(output, i), GetOrigin(split, GetOrigin(expected, i)));
    EXPECT_GE(
      GetLevel(output, i), output->GetCellType(i) == VTK_VERTEX ? 0 : levels[GetOrigin(output, i)]);
  }
}

TEST(RedGreenCells, OfPolyData)
{
  const Grid grid = MakeGrid(coretest::FindInZoo("Icosahedron"));
  vtkNew<vtkPolyData> poly;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1, 2 });
  poly->SetPoints(grid->GetPoints());
  poly->SetPolys(grid->GetCells());
  poly->SetLines(lines);
  const Grid output = Refine(poly,
    [](Filter* filter)
    {
      filter->RefineByEdgeLengthOn();
      filter->SetMaximumEdgeLength(0.);
      filter->SetMaximumLevel(1);
    });
  EXPECT_EQ(output->GetNumberOfCells(), 4 + 4 * 20);
  EXPECT_EQ(output->GetNumberOfPoints(), 12 + 30);
}

TEST(RedGreenCells, ThatCannotBeReadArePassedOver)
{
  const Grid input = multi_dimensional_subdivision_tools::MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { .5, 0, 0 }, { NotANumber, 0, 0 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_CONVEX_POINT_SET, { 0, 1, 4 } },
      { VTK_TETRA, { 0, 1, 1, 2 } }, { VTK_TRIANGLE, { 0, 1, 5 } }, { VTK_TETRA, { 0, 2, 1, 3 } },
      { VTK_TETRA, { 0, 1, 2, 4 } } });
  vtkNew<Messages> messages;
  const Grid output = Refine(
    input,
    [](Filter* filter)
    {
      filter->RefineByEdgeLengthOn();
      filter->SetMaximumEdgeLength(0.);
      filter->SetMaximumLevel(1);
    },
    messages);
  EXPECT_EQ(messages->Warnings.size(), 4u);
  EXPECT_EQ(messages->CountWarnings("1 point hangs"), 1); // point 4, on an edge
  EXPECT_TRUE(messages->Errors.empty());
  // An inverted tetrahedron stays inverted, a flat one flat.
  ASSERT_EQ(output->GetNumberOfCells(), 24);
  const std::set<vtkIdType> kept = { 0, 4, 5 };
  for (vtkIdType i = 0; i < 24; ++i)
  {
    const vtkIdType origin = GetOrigin(output, i);
    EXPECT_EQ(kept.count(origin), 1u);
    EXPECT_NEAR(GetVolume(output, i), origin == 0 ? 1. / 48. : origin == 4 ? -1. / 48. : 0., 1e-15);
  }
}

TEST(RedGreenCells, WithoutAny)
{
  vtkNew<vtkUnstructuredGrid> nothing;
  vtkNew<vtkPolyData> nothingElse;
  const Grid points =
    multi_dimensional_subdivision_tools::MakeGrid({ { 1, 2, 3 }, { 4, 5, 6 } }, {});
  const Grid vertices = multi_dimensional_subdivision_tools::MakeGrid(
    { { 1, 2, 3 }, { 4, 5, 6 } }, { { VTK_VERTEX, { 1 } }, { VTK_POLY_VERTEX, { 0, 1 } } });
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(100.);
  for (vtkDataObject* input :
    { static_cast<vtkDataObject*>(nothing), static_cast<vtkDataObject*>(nothingElse),
      static_cast<vtkDataObject*>(points), static_cast<vtkDataObject*>(vertices) })
  {
    for (int placement : { Filter::LINEAR, Filter::LIMIT })
    {
      vtkNew<Messages> messages;
      const Grid output = Refine(
        input,
        [&](Filter* filter)
        {
          filter->RefineByEdgeLengthOn();
          filter->RefineByFunctionOn();
          filter->SetImplicitFunction(sphere);
          filter->RefineByGeometricErrorOn();
          filter->SetGeometricTolerance(0.);
          filter->SetPlacement(placement);
        },
        messages);
      EXPECT_TRUE(messages->Errors.empty() && messages->Warnings.empty());
      EXPECT_EQ(output->GetNumberOfPoints(), vtkPointSet::SafeDownCast(input)->GetNumberOfPoints());
      EXPECT_EQ(output->GetNumberOfCells(), input == vertices ? 3 : 0);
    }
  }
}

// ------------------------------------------------------------------------------------------------
// Arrays

/// A new point of a line between 0 and 1, with the arrays of AddArrays.
TEST(RedGreenArrays, OfEachKindAtNewPoints)
{
  const Grid input = multi_dimensional_subdivision_tools::MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 9, 9, 9 } }, { { VTK_LINE, { 0, 1 } } });
  AddArrays(input);
  vtkPointData* in = input->GetPointData();
  for (const bool swapped : { false, true })
  {
    vtkNew<vtkIdTypeArray> global;
    global->SetName("Global");
    for (vtkIdType id : { swapped ? 9 : 4, swapped ? 4 : 9, 1 })
    {
      global->InsertNextValue(id);
    }
    in->SetGlobalIds(global);
    const vtkIdType first = swapped ? 1 : 0; // whose global id is smaller
    for (const bool integers : { false, true })
    {
      const Grid output = Refine(input,
        [&](Filter* filter)
        {
          filter->RefineByEdgeLengthOn();
          filter->SetMaximumEdgeLength(0.5);
          filter->SetInterpolateIntegers(integers);
          filter->GenerateOriginalIdsOn();
        });
      ASSERT_EQ(output->GetNumberOfPoints(), 4);
      vtkPointData* out = output->GetPointData();
      EXPECT_FALSE(out->GetGlobalIds());
      EXPECT_FALSE(out->HasArray("Global"));
      for (const char* name : { "float", "double", "int", "byte", "rgb", "rgba", "bit" })
      {
        vtkDataArray* values = out->GetArray(name);
        ASSERT_TRUE(values) << name;
        for (int c = 0; c < values->GetNumberOfComponents(); ++c)
        {
          const std::string kind = name;
          const double a = in->GetArray(name)->GetComponent(0, c);
          const double b = in->GetArray(name)->GetComponent(1, c);
          const bool isSmooth =
            kind == "float" || kind == "double" || kind[0] == 'r' || (integers && kind != "bit");
          const double taken = in->GetArray(name)->GetComponent(first, c);
          const double allowed = kind == "float" ? 1e-6 : kind == "double" ? 1e-15 : 0.5;
          EXPECT_NEAR(
            values->GetComponent(3, c), isSmooth ? (a + b) / 2. : taken, isSmooth ? allowed : 0.)
            << name;
          EXPECT_EQ(values->GetComponent(1, c), b) << name;
        }
      }
      auto* words = vtkStringArray::SafeDownCast(out->GetAbstractArray("string"));
      EXPECT_EQ(words->GetValue(3), "n" + std::to_string(first));
      EXPECT_EQ(out->GetArray("vtkOriginalPointIds")->GetComponent(1, 0), 1.);
      EXPECT_EQ(out->GetArray("vtkOriginalPointIds")->GetComponent(3, 0), -1.);
      EXPECT_STREQ(out->GetScalars()->GetName(), "float");
      EXPECT_STREQ(out->GetVectors()->GetName(), "double");
      EXPECT_STREQ(out->GetArray("double")->GetComponentName(1), "middle");
      EXPECT_TRUE(output->GetFieldData()->HasArray("TimeValue"));
      EXPECT_TRUE(output->GetFieldData()->HasArray("names"));
    }
  }
}

/// A criterion by integers sees what the output has.
TEST(RedGreenArrays, CriteriaSeeIntegersAsTheyAre)
{
  const Grid line = multi_dimensional_subdivision_tools::MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 } }, { { VTK_LINE, { 0, 1 } } });
  vtkNew<vtkIntArray> labels;
  labels->SetName("labels");
  labels->InsertNextValue(0);
  labels->InsertNextValue(8);
  line->GetPointData()->SetScalars(labels);
  for (bool integers : { false, true })
  {
    const Grid output = Refine(line,
      [integers](Filter* filter)
      {
        filter->RefineByAttributeErrorOn();
        filter->SetAttributeTolerance(0.3);
        filter->SetMaximumLevel(5);
        filter->SetInterpolateIntegers(integers);
      });
    // Labels jump somewhere on every level; numbers between them do not for long.
    EXPECT_EQ(output->GetNumberOfCells(), integers ? 4 : 6);
  }
}

// ------------------------------------------------------------------------------------------------
// Values that are not finite

TEST(RedGreenNotFinite, EdgesWithoutAValueAreNotRefinedAndCounted)
{
  for (int kind : { Filter::JUMP, Filter::LIMIT_DIFFERENCE })
  {
    for (double value : { NotANumber, std::numeric_limits<double>::infinity(),
           -std::numeric_limits<double>::infinity() })
    {
      // Two lines far apart: the one has the value.
      const Grid input = multi_dimensional_subdivision_tools::MakeGrid(
        { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 2, 1, 0 } },
        { { VTK_POLY_LINE, { 0, 1, 2 } }, { VTK_POLY_LINE, { 3, 4, 5 } } });
      vtkNew<vtkDoubleArray> values;
      values->SetName("V");
      for (double v : { 0., value, 1., 0., 5., 1. })
      {
        values->InsertNextValue(v);
      }
      input->GetPointData()->SetScalars(values);
      vtkNew<Messages> messages;
      const Grid output = Refine(
        input,
        [kind](Filter* filter)
        {
          filter->RefineByAttributeErrorOn();
          filter->SetAttributeErrorKind(kind);
          filter->SetAttributeTolerance(0.01);
        },
        messages);
      EXPECT_EQ(messages->Warnings.size(), 1u);
      EXPECT_EQ(messages->CountWarnings("does not refine 2 edges: the point array \"V\""), 1);
      const Kinds kinds = CountKinds(output);
      EXPECT_EQ(kinds.at(0), (std::map<int, int>{ { 0, 2 } })) << kind;
      EXPECT_GT(kinds.at(1).at(1), 8) << kind;
    }
  }
}

TEST(RedGreenNotFinite, NoCellIsInARangeByThem)
{
  const Grid box = MakeBox(1);
  AddValues(box);
  box->GetPointData()->GetArray("V")->SetComponent(3, 0, NotANumber);
  const Grid output = Refine(box,
    [](Filter* filter)
    {
      filter->RefineByArrayRangeOn();
      filter->SetInputArrayToProcess(6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "V");
      filter->SetArrayRange(50., 60.);
    });
  EXPECT_EQ(output->GetNumberOfCells(), 6);
  // Where no value is a number, that is said.
  box->GetPointData()->GetArray("V")->Fill(NotANumber);
  box->GetPointData()->GetArray("V")->Modified();
  vtkNew<Messages> messages;
  Refine(
    box,
    [](Filter* filter)
    {
      filter->RefineByArrayRangeOn();
      filter->SetInputArrayToProcess(6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "V");
    },
    messages);
  EXPECT_EQ(messages->CountWarnings("RefineByArrayRange refines nothing: the array \"V\""), 1);
}

// ------------------------------------------------------------------------------------------------
// Time

namespace
{

/// A line whose values jump at a place that moves with time.
class MovingJump : public vtkUnstructuredGridAlgorithm
{
public:
  static MovingJump* New();
  vtkTypeMacro(MovingJump, vtkUnstructuredGridAlgorithm);

protected:
  MovingJump() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* out) override
  {
    const double times[] = { 0., 1., 2. };
    out->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times, 3);
    const double range[] = { 0., 2. };
    out->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* out) override
  {
    const double time =
      out->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    const Grid grid = multi_dimensional_subdivision_tools::MakeGrid(
      { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } },
      { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 1, 2 } }, { VTK_LINE, { 2, 3 } } });
    vtkNew<vtkDoubleArray> values;
    values->SetName("V");
    for (int i = 0; i < 4; ++i)
    {
      values->InsertNextValue(i <= time ? 0. : 1.);
    }
    grid->GetPointData()->SetScalars(values);
    vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(out);
    output->ShallowCopy(grid);
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    return 1;
  }
};
vtkStandardNewMacro(MovingJump);

}

TEST(RedGreenTime, EachStepIsRefinedByItself)
{
  vtkNew<MovingJump> source;
  vtkNew<Filter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  for (int step : { 0, 1, 2, 0 })
  {
    filter->UpdateTimeStep(step);
    const Kinds kinds = CountKinds(filter->GetOutput());
    for (int line = 0; line < 3; ++line)
    {
      EXPECT_EQ(kinds.at(line).count(1), line == step ? 1u : 0u) << step;
    }
    EXPECT_EQ(filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), step);
  }
}
