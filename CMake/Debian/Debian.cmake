# What the Debian packages hold beside what is installed anyway, and what their control files say.
# Included by CMake/Package.cmake. One component each; a component that is not named makes no package.
set(SUBDIVISIONOBJECTS_DEBIAN_REVISION "1" CACHE STRING "Debian revision of the packages")
set(SUBDIVISIONOBJECTS_DEBIAN_SUITE "unstable" CACHE STRING "Debian suite that the packages are for")

set(version "${PROJECT_VERSION}-${SUBDIVISIONOBJECTS_DEBIAN_REVISION}")
set(templates "${CMAKE_CURRENT_SOURCE_DIR}/CMake/Debian")
set(debian_dir "${CMAKE_BINARY_DIR}/debian")

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE "${SUBDIVISIONOBJECTS_DEBIAN_REVISION}")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)

# "copyright" holds the licence word for word: lines moved in by a space, empty ones as a dot.
file(READ LICENSE licence)
string(REGEX REPLACE "^BSD 3-Clause License\n+Copyright[^\n]*\nAll rights reserved\\.\n+" "" licence "${licence}")
string(STRIP "${licence}" licence)
string(REPLACE "\n" "\n " licence "${licence}")
string(REPLACE "\n \n" "\n .\n" licence "${licence}")
configure_file("${templates}/copyright.in" "${debian_dir}/copyright" @ONLY)

# debian_package(COMPONENT NAME SECTION TEXT): the files and fields that every package has. TEXT is the
# one line that lists show, then the paragraph below it.
find_program(GZIP_EXECUTABLE gzip REQUIRED)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC) # SOURCE_DATE_EPOCH in the environment goes first
macro (debian_package component name section text)
  list(APPEND CPACK_COMPONENTS_ALL "${component}")
  string(TOUPPER "${component}" upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME "${name}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION "${section}")
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${text}")
  set(package "${name}")
  configure_file("${templates}/changelog.in" "${debian_dir}/${name}/changelog.Debian" @ONLY)
  configure_file(CHANGELOG.md "${debian_dir}/${name}/changelog" COPYONLY)
  execute_process(COMMAND "${GZIP_EXECUTABLE}" -9nf changelog.Debian changelog
    WORKING_DIRECTORY "${debian_dir}/${name}" COMMAND_ERROR_IS_FATAL ANY)
  install(
    FILES
      "${debian_dir}/copyright"
      "${debian_dir}/${name}/changelog.Debian.gz"
      "${debian_dir}/${name}/changelog.gz"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/${name}"
    COMPONENT "${component}")
endmacro ()

# control_file(COMPONENT FILE): a maintainer script or another control file of the package.
macro (control_file component file)
  string(TOUPPER "${component}" upper)
  list(APPEND CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA "${file}")
endmacro ()

set(CPACK_COMPONENTS_ALL)
set(about "SubdivisionObjects makes smooth objects of coarse meshes. One filter
subdivides solids, surfaces and curves in one mesh, with creases,
materials and joints; others refine a mesh locally, deform things by it,
and make subdivision surfaces.")
if (SUBDIVISIONOBJECTS_BUILD_PLUGIN)
  debian_package(plugin paraview-plugin-subdivisionobjects science
    "ParaView plugin for multi-dimensional subdivision
${about}
.
This package holds the plugin, which ParaView, pvpython and pvserver
load when they start.")
  # A plugin works only in the ParaView that it was built against; libraries do not say so, packages can.
  math(EXPR next "${ParaView_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PLUGIN_PACKAGE_DEPENDS
    "paraview (>= ${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}), paraview (<< ${ParaView_VERSION_MAJOR}.${next}~)")
  set(CPACK_DEBIAN_PLUGIN_PACKAGE_RECOMMENDS "python3-paraview")

  # ParaView reads from paraview.conf which plugins it has: from the one in its folder of libraries, which
  # Debian's package brings (from Debian 13 on), or else from one beside the executable. Debian's is put
  # aside for one that has a line more: scripts of the package do that, and undo it.
  string(REGEX REPLACE "/[^/]*$" "" conf_dir "${PARAVIEW_PLUGIN_SUBDIR}")
  set(conf_dir "${CMAKE_INSTALL_FULL_LIBDIR}/${conf_dir}")
  set(conf_lines "")
  if (EXISTS "${conf_dir}/paraview.conf")
    file(READ "${conf_dir}/paraview.conf" conf_lines)
    string(STRIP "${conf_lines}\n" conf_lines)
    string(APPEND conf_lines "\n")
    foreach (script preinst postrm)
      configure_file("${templates}/plugin-${script}.in" "${debian_dir}/plugin/${script}" @ONLY)
      control_file(plugin "${debian_dir}/plugin/${script}")
    endforeach ()
  else ()
    set(conf_dir "${CMAKE_INSTALL_FULL_BINDIR}")
  endif ()
  file(RELATIVE_PATH conf_plugins "${conf_dir}"
    "${CMAKE_INSTALL_FULL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/subdivisionobjects.plugins.xml")
  file(WRITE "${debian_dir}/paraview.conf" "${conf_lines}${conf_plugins}\n")
  install(FILES "${debian_dir}/paraview.conf" DESTINATION "${conf_dir}" COMPONENT plugin)
else ()
  set(library "libvtksubdivisionobjects${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}") # after the soname
  debian_package(runtime "${library}" libs
    "VTK filters for multi-dimensional subdivision - library
${about}
.
This package holds the shared library, a module of VTK.")
  debian_package(development libvtksubdivisionobjects-dev libdevel
    "VTK filters for multi-dimensional subdivision - development files
${about}
.
This package holds the headers and the files for CMake.")
  if (TARGET subdivide)
    debian_package(program subdivisionobjects science
      "Program for multi-dimensional subdivision
${about}
.
This package holds the program subdivide, which reads and writes the files
of VTK.")
    set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${library} (= ${version})")
  endif ()
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
  # Where dpkg-shlibdeps finds the library that the Python module is linked to.
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
  math(EXPR next "${VTK_MINOR_VERSION} + 1")
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "${library} (= ${version}), libvtk9-dev (>= ${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION}), libvtk9-dev (<< ${VTK_MAJOR_VERSION}.${next}~)")
  control_file(runtime "${templates}/triggers")
  if (python_dir)
    debian_package(python python3-subdivisionobjects python
      "VTK filters for multi-dimensional subdivision - Python 3
${about}
.
This package holds the Python package subdivisionobjects.")
    math(EXPR next "${Python3_VERSION_MINOR} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "${library} (= ${version}), python3 (>= 3.${Python3_VERSION_MINOR}~), python3 (<< 3.${next}), python3-vtk9, python3-numpy")
    # Compiled Python is made when it is installed, and has to go with it.
    foreach (script postinst prerm)
      configure_file("${templates}/python-${script}" "${debian_dir}/python/${script}" COPYONLY)
      control_file(python "${debian_dir}/python/${script}")
    endforeach ()
  endif ()
endif ()
