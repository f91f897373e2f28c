// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TextTable.h
 * Tables as texts, .csv and .tsv, before VTK reads them: it fills what is missing without a word.
 */
#ifndef SubdivisionObjects_TextTable_h
#define SubdivisionObjects_TextTable_h

#include <string>

namespace subdivide
{

/// The separator of a .csv or .tsv file: a tab, a comma, or a semicolon if the first line has no
/// comma.
char FindSeparator(const std::string& name);

/// Throws Failure if a row has more or fewer values than the first one has titles, or two columns
/// the same title; warns where there is nothing between separators.
void CheckTextTable(const std::string& name);

/// The title of a column, without blanks around it and without the mark at the beginning of a file.
std::string GetTitle(std::string title);

}

#endif
