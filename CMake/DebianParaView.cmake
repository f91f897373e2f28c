# Debian 13 and testing name ParaView's Python modules vtkX.cpython-NNN-....so, while the CMake files of
# their paraview-dev ask for vtkX.so and end everything where that is missing. Nothing here links these
# modules, so the check is switched off for those that are missing, by what CMake's generated files
# look at: a target whose "xcframework" is a folder is taken to be there.
# Included before find_package(ParaView), at the same level.
set(given_dir "${ParaView_DIR}")
find_package(ParaView 999 QUIET) # refuses all, but tells where it looked
foreach (config IN LISTS ParaView_CONSIDERED_CONFIGS)
  get_filename_component(folder "${config}" DIRECTORY)
  file(GLOB target_files "${folder}/*Python*-targets.cmake" "${folder}/vtk/*Python*-targets.cmake")
  foreach (target_file IN LISTS target_files)
    file(STRINGS "${target_file}" lines REGEX "^add_library\\([^ ]+ MODULE IMPORTED")
    foreach (line IN LISTS lines)
      string(REGEX REPLACE "^add_library\\(([^ ]+) .*" "\\1" target "${line}")
      set("_cmake_import_check_xcframework_for_${target}" "${folder}")
    endforeach ()
  endforeach ()
endforeach ()
unset(ParaView_DIR CACHE)
if (given_dir)
  set(ParaView_DIR "${given_dir}" CACHE PATH "Folder of paraview-config.cmake")
endif ()
