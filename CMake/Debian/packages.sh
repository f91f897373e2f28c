# shellcheck shell=bash
# Which Debian packages each command of ./dev needs, by suite: the only place that names them.
# Sourced by ./dev. Version numbers of VTK and ParaView stand here and nowhere else.

# What this system calls itself: bookworm, trixie, forky, or something that we have no list for.
# shellcheck disable=SC2153
system_suite() { (. /etc/os-release 2>/dev/null && echo "${VERSION_CODENAME:-unknown}") || echo unknown; }
system_name() { (. /etc/os-release 2>/dev/null && echo "${PRETTY_NAME:-an unknown system}") || echo "an unknown system"; }

# For a system without lists, with --no-install: what is there under its usual name.
formatter=clang-format
tools=() paraview_packages=() client_packages=() vtk_packages=() test_packages=() compared_packages=() peer_packages=() docs_packages=() analysis_packages=() debian_packages=()

# package_lists SUITE: sets the lists below, vtk_version, and debian_revision of our packages (sorted
# so that those of a newer suite are newer); false for a suite that is not known.
package_lists()
{
  tools=(cmake g++ ninja-build libgtest-dev)
  docs_packages=(doxygen python3)
  analysis_packages=(python3-matplotlib python3-scipy)
  debian_packages=(dpkg-dev file gzip lintian)
  # What tests multiply matrices and count instructions with; without it these say "skipped". ccache, so that a fresh
  # machine of the same suite does not compile the same sources again; xvfb for pictures of scripts.
  test_packages=(python3-scipy valgrind ccache xvfb)
  # Other libraries and programs that tests compare with, and solvers that examples run; without them the tests say "skipped".
  compared_packages=(libopenmesh-dev libcgal-dev)
  peer_packages=(libosd-dev libopenmesh-dev libcgal-dev libdune-grid-dev libdune-uggrid-dev)

  # What the CMake files of VTK and ParaView look for and their packages do not bring.
  local beneath=(libopenmpi-dev libpython3-dev libtbb-dev libeigen3-dev libdouble-conversion-dev libexpat1-dev liblz4-dev
    liblzma-dev zlib1g-dev libutfcpp-dev)
  # client_packages: with what tests reach the widgets of ParaView's client; without it that test says "skipped".
  client_packages=(python3-pyqt6)
  local qt5=(qtbase5-dev qttools5-dev libqt5svg5-dev libqt5opengl5-dev)
  local qt6=(qt6-base-dev qt6-tools-dev qt6-svg-dev)
  paraview_packages=(paraview-dev python3-paraview python3-numpy openmpi-bin xvfb)
  # Up to Debian 13 ParaView has a VTK of its own, and its Python excludes that of plain VTK.
  paraview_has_own_vtk=yes
  vtk_conflicts=yes
  case $1 in
    bookworm)
      vtk_version=9.1
      debian_revision=1~deb12
      formatter=clang-format-19
      # Not tried on later suites.
      compared_packages+=(libosd-dev gmsh python3-gmsh calculix-ccx python3-meshio python3-netcdf4 python3-dolfinx)
      paraview_packages+=("${qt5[@]}" qtxmlpatterns5-dev-tools)
      client_packages=(python3-pyqt5)
      ;;
    trixie)
      vtk_version=9.3
      debian_revision=1~deb13
      formatter=clang-format-19
      paraview_packages+=("${qt6[@]}" qtxmlpatterns5-dev-tools)
      ;;
    forky)
      vtk_version=9.6
      debian_revision=1~deb14
      formatter=clang-format-22
      paraview_packages+=("${qt6[@]}" xsltproc)
      paraview_has_own_vtk=no
      vtk_conflicts=no
      beneath+=(nlohmann-json3-dev libjsoncpp-dev)
      ;;
    *) return 1 ;;
  esac
  vtk_libraries=("libvtk$vtk_version" "libvtk$vtk_version-qt" vtk9)
  vtk_packages=("${tools[@]}" "${beneath[@]}" python3 python3-numpy openmpi-bin "${vtk_libraries[@]}")
  paraview_packages+=("${tools[@]}" "${beneath[@]}")
  [ $paraview_has_own_vtk = yes ] || paraview_packages+=("${vtk_libraries[@]}")
}
