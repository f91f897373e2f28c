# cmake -D DATA=<source>/Data -D OUTPUT=<file> -P WriteTables.cmake
# Writes the .vtu files of a folder as tables of C++, one model for each: what Models.h declares.

# append_table(ARRAY TYPE COUNT): the numbers of an array of the file as a table; COUNT says how many there must be.
macro (append_table array type count)
  if (NOT content MATCHES "<DataArray[^>]* Name=\"${array}\"[^>]* format=\"ascii\"[^>]*>([^<]*)")
    message(FATAL_ERROR "${file} has no array ${array} of text. Save it as ASCII, with one piece and without compression.")
  endif ()
  string(REGEX MATCHALL "[^ \n]+" numbers "${CMAKE_MATCH_1}")
  list(LENGTH numbers length)
  if (NOT "${count}" STREQUAL "any" AND NOT length EQUAL "${count}")
    message(FATAL_ERROR "${file}: the array ${array} has ${length} numbers instead of ${count}.")
  endif ()
  list(JOIN numbers ", " numbers)
  string(APPEND tables "const ${type} ${name}${array}[] = { ${numbers} };\n")
  string(APPEND members ", ${name}${array}")
endmacro ()

file(GLOB files "${DATA}/*.vtu")
set(tables "")
set(models "")
foreach (file IN LISTS files)
  get_filename_component(name "${file}" NAME_WE)
  file(READ "${file}" content)
  if (NOT content MATCHES "<Piece NumberOfPoints=\"([0-9]+)\" +NumberOfCells=\"([0-9]+)\"")
    message(FATAL_ERROR "${file} is no file of an unstructured grid. Save it as .vtu.")
  endif ()
  set(points "${CMAKE_MATCH_1}")
  set(cells "${CMAKE_MATCH_2}")
  math(EXPR coordinates "3 * ${points}")
  set(members "${points}, ${cells}")
  append_table(Points double ${coordinates})
  append_table(Tension double ${points})
  append_table(connectivity vtkIdType any)
  append_table(offsets vtkIdType ${cells})
  append_table(types "unsigned char" ${cells})
  append_table(MaterialId int ${cells})
  append_table(Singular int ${cells})
  string(APPEND models "const Model ${name} = { ${members} };\n")
endforeach ()
file(WRITE "${OUTPUT}" "// Written by WriteTables.cmake.
#include \"Private/Models/Models.h\"
namespace subdivision
{
namespace
{
${tables}}
${models}}
")
