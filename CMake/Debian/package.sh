# shellcheck shell=bash
# ./dev package: Debian packages and archives of both flavours, and the sources, into build/packages.
# Sourced by ./dev. What goes into which package: CMake/Debian/Debian.cmake.

package() # [--check [SUITE]]
{
  case ${1:-} in
    "") package_all ;;
    --check) package_check "${2:-$(system_suite)}" ;;
    *) die "no such option: $1 (./dev package, ./dev package --check [SUITE])" ;;
  esac
}

package_all()
{
  check_conflict
  need "${debian_packages[@]}" "${vtk_packages[@]}" "${paraview_packages[@]}"
  command -v dpkg-shlibdeps >/dev/null || die "no dpkg-shlibdeps here: Debian packages are made on Debian"
  packages=$build/packages
  rm -rf "$packages"
  mkdir -p "$packages"
  umask 022
  package_date
  package_sources
  use_vtk
  package_flavour package-vtk "${vtk_options[@]}"
  use_paraview
  package_flavour package-paraview "${paraview_options[@]}"
  package_lint
  say "packages in build/packages"
  (cd "$packages" && ls -sh1 -- *)
}

# The same sources give the same packages: the only date in them is that of the last change.
package_date()
{
  [ -z "${SOURCE_DATE_EPOCH:-}" ] || return 0
  SOURCE_DATE_EPOCH=$(git -C "$root" log -1 --format=%ct 2>/dev/null || stat -c %Y "$root/CHANGELOG.md")
  export SOURCE_DATE_EPOCH
}

package_sources()
{
  local name
  name=SubdivisionObjects-$(sed -n 's/^  VERSION \([0-9.]*\)$/\1/p' "$root/CMakeLists.txt")
  # An unpacked archive of sources can stand in a clone of something else.
  if [ "$(git -C "$root" rev-parse --show-toplevel 2>/dev/null)" != "$root" ]; then
    say "no archive of sources: this is not a clone"
    return 0
  fi
  [ -z "$(git -C "$root" status --porcelain)" ] || say "note: what is not committed is not in the archive of sources"
  git -C "$root" archive --format=tar.gz --prefix="$name/" -o "$packages/$name.tar.gz" HEAD
}

# package_flavour PRESET [OPTION...]: one build, then the archive and the Debian packages of it. They
# differ in what is installed alone, so nothing is compiled again between them.
package_flavour()
{
  local preset=$1 compile link
  shift
  # Debian's hardening; optimisation and debugging stay those of CMake. Paths are cut off, because
  # messages of VTK name the file that they come from.
  compile=$(package_flags CPPFLAGS CXXFLAGS)
  link=$(package_flags LDFLAGS)
  configure "$preset" "$@" "-DCMAKE_CXX_FLAGS=$compile \"-ffile-prefix-map=$root=.\"" \
    "-DCMAKE_SHARED_LINKER_FLAGS=$link" "-DCMAKE_MODULE_LINKER_FLAGS=$link" \
    "-DSUBDIVISIONOBJECTS_SYSTEM=$(system_suite)" "-DSUBDIVISIONOBJECTS_DEBIAN_SUITE=$(system_suite)" \
    "-DSUBDIVISIONOBJECTS_DEBIAN_REVISION=$debian_revision"
  package_pack "$preset" TGZ -DSUBDIVISIONOBJECTS_DEBIAN=OFF
  package_pack "$preset" DEB -DSUBDIVISIONOBJECTS_DEBIAN=ON
}

package_flags() # VARIABLE...
{
  local variable flag flags=()
  for variable in "$@"; do
    for flag in $(DEB_BUILD_MAINT_OPTIONS="hardening=+all reproducible=-fixfilepath,-fixdebugpath" dpkg-buildflags --get "$variable"); do
      [[ "$flag" =~ ^-(g|O2)$ ]] || flags+=("$flag")
    done
  done
  echo "${flags[*]}"
}

package_pack() # PRESET GENERATOR OPTION
{
  local tree=$build/$1 log=$build/$1-$2.log
  cmake "$3" "$tree" >"$log" 2>&1 || { tail -n 40 "$log" >&2; return 1; }
  build "$1"
  say "packing build/$1 ($2)"
  rm -rf "$tree/cpack"
  (cd "$tree" && cpack -G "$2" -B "$tree/cpack" >>"$log" 2>&1) || { tail -n 40 "$log" >&2; return 1; }
  mv "$tree"/cpack/*.* "$packages/"
}

package_lint()
{
  say "lintian"
  lintian --allow-root --fail-on error "$packages"/*.deb ||
    die "lintian finds errors in the packages, see above"
}

# ---------------------------------------------------------------- are they any good?

# package_check SUITE: installs the packages on a minimal Debian, uses and removes them (Testing/Packages/check).
package_check()
{
  local suite=$1 packages status=0
  package_lists "$suite" || die "no such suite: $suite (bookworm, trixie, forky)"
  packages=$build/packages
  place=$build/fresh/$suite
  # What ./dev fresh SUITE ./dev package made.
  [ "$suite" = "$(system_suite)" ] || packages=$place/packages
  [ -n "$(find "$packages" -name '*.deb' 2>/dev/null)" ] || die "no packages in $packages: first run ./dev package there"
  not_checked_without root debootstrap unshare
  mkdir -p "$place/archives/partial"
  fresh_base "$suite"
  target=$place/packages-root
  rm -rf "$target"
  cp -a --reflink=auto "$place/base" "$target"
  mkdir "$target/check"
  cp -a "$packages"/*.deb "$packages"/*.tar.gz "$root/Testing/Packages" "$root/Examples/Cxx" "$target/check/"
  say "checking the packages on a minimal $suite"
  fresh_inside root /check ./Packages/check 2>&1 | tee "$place/packages-check.log" || status=$?
  rm -rf "$target"
  return $status
}
