// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestFeaturesMarksPassedOn.cxx
 * A filter without levels marks for those filters that have no marks of their own.
 */
#include "MarkTools.h"
#include "SubdivisionDeformationTools.h"

#include "vtkRedGreenRefinement.h"

using namespace deformation_tools;

namespace
{

Grid Refine(vtkUnstructuredGrid* mesh)
{
  vtkNew<vtkRedGreenRefinement> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetPlacementToLimit();
  filter->RefineByAttributeErrorOff();
  filter->RefineByEdgeLengthOn();
  filter->SetMaximumEdgeLength(mesh->GetLength() / 5.);
  filter->SetMaximumLevel(2);
  filter->SetInputDataObject(mesh);
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty());
  return filter->GetOutput();
}

vtkSmartPointer<vtkPointSet> Deform(vtkUnstructuredGrid* object, vtkUnstructuredGrid* cage)
{
  Deformer filter;
  const auto made = filter.Run(object, cage, Moved(cage, Bend));
  EXPECT_TRUE(filter.GetErrors().empty());
  return made;
}

}

TEST(FeaturesMarksPassedOn, AreFlaggedCellsInRefinementAndDeformation)
{
  int changed = 0;
  for (const Grid& mesh : MakeMarkMeshes())
  {
    const Grid simplices = ExecuteQuietly(mesh, 0, {});
    RemoveStamp(simplices);
    const Grid object = ExecuteQuietly(mesh, 1, {});
    const std::vector<char> marked = Draw(simplices->GetNumberOfPoints(), 0.6, 7);
    for (const Meaning& meaning : Meanings)
    {
      SCOPED_TRACE(std::to_string(simplices->GetNumberOfCells()) + " cells, meaning " +
        std::to_string(&meaning - Meanings));
      const Grid flagged = AddFlagged(simplices, FindMarked(simplices, simplices, marked, meaning));
      const Grid copy = DeepCopy(simplices);
      AddMarks(copy, marked);
      const Grid marking = ExecuteQuietly(copy, 0,
        [&](Filter* filter)
        {
          SetMarks(filter);
          SetMeaning(filter, meaning);
        });
      ExpectSame(Refine(marking), Refine(flagged));
      ExpectSame(Deform(object, marking), Deform(object, flagged));
      if (HasFatalFailure())
      {
        return;
      }
      changed += ComparePoints(Refine(marking), Refine(simplices)).empty() ? 0 : 1;
      changed += ComparePoints(Deform(object, marking), Deform(object, simplices)).empty() ? 0 : 1;
    }
  }
  EXPECT_GT(changed, 30);
}
