// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ArrayNames.h
 * Names of arrays that several folders read or write.
 */
#ifndef SubdivisionObjects_ArrayNames_h
#define SubdivisionObjects_ArrayNames_h

#include <string>

namespace subdivision
{

constexpr const char* OriginalPointIdsName = "vtkOriginalPointIds";
constexpr const char* OriginalCellIdsName = "vtkOriginalCellIds";
constexpr const char* SingularName = "Singular";
/// The cell array that says from which block a cell of a joined mesh is: the index of a block of
/// this rank, NoBlock for a cell of another rank. Filters carry it to the descendants of the cell.
constexpr const char* BlockName = "SubdivisionBlock";
constexpr int NoBlock = -1;
/// The cell array with the selected cells of a mesh that is joined of several blocks.
constexpr const char* SelectedName = "SubdivisionSelected";
/// The arrays that flag selected points and cells which become singular.
constexpr const char* MarkedName = "SubdivisionMarked";
/// The arrays with the numbers that points and cells of a part of an output have in the output of
/// the whole mesh.
constexpr const char* PointNumbersName = "SubdivisionPointNumber";
constexpr const char* CellNumbersName = "SubdivisionCellNumber";
/// The cell array of a surface that was made of a grid: which cell of the grid each cell is.
constexpr const char* SourceCellsName = "SubdivisionSourceCells";
/// The cell array that tells which tetrahedra are the pieces of one octahedron; -1 for all others.
constexpr const char* OctahedraName = "OctahedronId";
constexpr const char* LimitNormalsName = "LimitNormals";
/// Of the limit at places: derivatives by the parameters of the cell, and curvatures.
constexpr const char* PlaceDerivativeNames[3] = { "DerivativeU", "DerivativeV", "DerivativeW" };
constexpr const char* MeanCurvatureName = "MeanCurvature";
constexpr const char* GaussianCurvatureName = "GaussianCurvature";
/// Where a scheme is known not to be smooth: of points and of cells.
constexpr const char* FailingName = "Failing";
constexpr const char* LimitTangentNames[2] = { "LimitTangent1", "LimitTangent2" };
/// The point array that says which points are the same one (MaterialFields.h).
constexpr const char* MaterialPointIdsName = "MaterialPointIds";
/// The cell array of parts between which values jump, because MergePoints kept them.
constexpr const char* MergedPartsName = "SubdivisionMergedParts";
/// The cell array of the colour of each cell's material, and how names of the point arrays begin
/// that have the values of one colour: both are there during the work only.
constexpr const char* ColourName = "SubdivisionColour";
constexpr const char* FieldName = "SubdivisionField";
/// The field array of the stamp. The names of the other field arrays that belong to a stamp of
/// Stamp.h or SurfaceStamp.h begin with it.
constexpr const char* StampName = "Subdivision";

/// The field array of the stamp of a whole surface (SurfaceStamp.h).
constexpr const char* SurfaceStampName = "SubdivisionSurface";

/// Whether a field array belongs to a stamp.
inline bool BelongsToStamp(const char* name)
{
  return name && std::string(name).rfind(StampName, 0) == 0;
}

/// The name of the point array that has the values of one colour, with weights.
inline std::string MakeFieldName(int colour, const std::string& name)
{
  return FieldName + std::to_string(colour) + ":" + name;
}

/// Whether a point array has such a name.
inline bool IsWeighted(const char* name)
{
  return name && std::string(name).rfind(FieldName, 0) == 0;
}

/// The name of the array whose values it has.
inline std::string GetFieldName(const std::string& name)
{
  return name.substr(name.find(':') + 1);
}

/// The colour in such a name.
inline int GetColour(const char* name)
{
  return std::stoi(name + std::string(FieldName).size());
}

}

#endif
