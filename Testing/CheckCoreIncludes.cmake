# cmake -D CORE=<source>/Filters/Core -P CheckCoreIncludes.cmake
# Fails when a file in Core includes a VTK data model or pipeline header, or looks into a higher room.
file(GLOB_RECURSE files "${CORE}/*.h" "${CORE}/*.cxx")
if (NOT files)
  message(FATAL_ERROR "no source files in ${CORE}")
endif ()
set(forbidden
  "^[ \t]*#[ \t]*include[ \t]*[<\"](Private/|\\.\\./|vtkSubdivision|vtk[A-Za-z0-9]*(Algorithm|DataSet|DataObject|Grid|PolyData|PointSet|PointData|CellData|FieldData|Filter|Executive|Information|Pipeline))")
set(bad 0)
foreach (file IN LISTS files)
  file(STRINGS "${file}" lines REGEX "${forbidden}")
  foreach (line IN LISTS lines)
    message("${file}: ${line}")
    set(bad 1)
  endforeach ()
endforeach ()
if (bad)
  message(FATAL_ERROR "Filters/Core must not include these headers")
endif ()
