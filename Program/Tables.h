// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Tables.h
 * Tables as texts.
 */
#ifndef SubdivisionObjects_Tables_h
#define SubdivisionObjects_Tables_h

#include <iosfwd>

class vtkDataObject;
class vtkTable;

namespace subdivide
{

/// A part for each row, with a line for each column, and its remainder behind it.
void PrintTable(vtkTable* table, std::ostream& out);

///@{
/// A file of a table. Returns whether it is whole. In .csv files components are columns; in .json
/// files, {"rows": [{...}, ...]}, they are lists, and what is no number is null.
bool WriteCsv(vtkDataObject* table, const char* name);
bool WriteJson(vtkDataObject* table, const char* name);
///@}

}

#endif
