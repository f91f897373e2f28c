// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MarkTools.h
 * Meshes whose points are marked, and the same with flagged cells.
 */
#ifndef SubdivisionObjects_MarkTools_h
#define SubdivisionObjects_MarkTools_h

#include "FeatureTools.h"

namespace feature_tools
{

struct Meaning
{
  bool Corners;
  bool Creases;
  bool Surfaces;
};
inline const Meaning Meanings[] = { { true, false, false }, { false, true, false },
  { false, false, true }, { true, true, true } };

template <typename Marking>
void SetMeaning(Marking* filter, const Meaning& meaning)
{
  filter->SetMarkCorners(meaning.Corners);
  filter->SetMarkCreases(meaning.Creases);
  filter->SetMarkSurfaces(meaning.Surfaces);
}

template <typename Marking>
void SetMarks(Marking* filter)
{
  filter->SetInputArrayToProcess(8, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Marks");
}

/// Marks a share of the points.
std::vector<char> Draw(vtkIdType points, double share, unsigned seed);

template <typename Array = vtkIntArray>
void AddMarks(vtkPointSet* mesh, const std::vector<char>& marked, const char* name = "Marks")
{
  vtkNew<Array> array;
  array->SetName(name);
  for (const char mark : marked)
  {
    array->InsertNextTuple1(mark);
  }
  mesh->GetPointData()->AddArray(array);
}

/// The vertices, edges and faces that marks make singular, found by VTK's cells. Faces of more than
/// three points as the triangles that `simplices` has of them.
std::vector<Cell> FindMarked(vtkPointSet* mesh, vtkUnstructuredGrid* simplices,
  const std::vector<char>& marked, Meaning meaning);

/// The mesh with flagged cells after its own.
Grid AddFlagged(vtkUnstructuredGrid* mesh, const std::vector<Cell>& cells);

/// Points, values and the first cells are equal, bit for bit.
void ExpectSame(vtkPointSet* marked, vtkPointSet* flagged, const char* but = "Marks");

/// Small meshes of every kind, with a point array.
std::vector<Grid> MakeMarkMeshes();

/// Warnings are allowed, errors are not.
Grid ExecuteQuietly(vtkDataObject* input, int levels, const Configure& configure);

}

#endif
