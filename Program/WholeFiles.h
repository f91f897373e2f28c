// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WholeFiles.h
 * Whether files that VTK reads or writes without looking are as long as they say.
 */
#ifndef SubdivisionObjects_WholeFiles_h
#define SubdivisionObjects_WholeFiles_h

#include <string>

class vtkPolyData;

namespace subdivide
{

/// Whether a .ply file has points and faces, and all that its header tells of.
bool IsWholePly(const std::string& name);

/// Whether a .stl file has as many triangles as it tells, or, if it is a text, an end.
bool IsWholeStl(const std::string& name);

/// Whether an .obj file has all points and cells of a surface, and ends with a whole line.
bool HasAllOfObj(const std::string& name, vtkPolyData* surface);

}

#endif
