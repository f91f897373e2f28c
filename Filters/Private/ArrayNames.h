// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ArrayNames.h
 * The names of all arrays that more than one file reads or writes.
 */
#ifndef SubdivisionObjects_ArrayNames_h
#define SubdivisionObjects_ArrayNames_h

namespace subdivision
{

constexpr const char* OriginalPointIdsName = "vtkOriginalPointIds";
constexpr const char* OriginalCellIdsName = "vtkOriginalCellIds";
constexpr const char* SingularName = "Singular";
constexpr const char* LimitNormalsName = "LimitNormals";
/// In field data; the names of all that this project writes there begin so.
constexpr const char* StampName = "Subdivision";

}

#endif
