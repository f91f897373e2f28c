# Packages by CPack: what `./dev package` (CMake/Debian/package.sh) makes of a build tree.
#   cpack -G TGZ   everything in one archive, to be unpacked anywhere
#   cpack -G DEB   with SUBDIVISIONOBJECTS_DEBIAN: the plugin's package, or the four of the VTK module
set(CPACK_PACKAGE_NAME SubdivisionObjects)
set(CPACK_PACKAGE_VENDOR "SubdivisionObjects developers")
set(CPACK_PACKAGE_CONTACT "SubdivisionObjects developers <developers@subdivisionobjects.example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # or CPack puts it before every component's own
set(CPACK_STRIP_FILES ON)
# Folders as everybody can read them, whatever the umask of who packs.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(SUBDIVISIONOBJECTS_SYSTEM "${CMAKE_SYSTEM_NAME}" CACHE STRING "What the archive's name calls the system")
if (SUBDIVISIONOBJECTS_BUILD_PLUGIN)
  set(flavour "paraview${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}")
else ()
  set(flavour "vtk${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION}")
endif ()
set(CPACK_PACKAGE_FILE_NAME
  "SubdivisionObjects-${PROJECT_VERSION}-${flavour}-${SUBDIVISIONOBJECTS_SYSTEM}-${CMAKE_SYSTEM_PROCESSOR}")

if (SUBDIVISIONOBJECTS_DEBIAN)
  include(CMake/Debian/Debian.cmake)
endif ()
include(CPack)
