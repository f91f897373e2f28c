# shellcheck shell=bash
# ./dev test --asan, ./dev test --tsan, ./dev lint, ./dev fuzz, ./dev mutate and ./dev reliability: tests under sanitizers,
# programs that look for faults in the sources, fuzzers, changed lines that tests have to see, and figures of all that.
# Sourced by ./dev.

# The tree of a sanitizer. That of asan has the fuzzers, too: both need the library with the same checks, by Clang.
configure_sanitizer() # asan|tsan
{
  local packages=("${vtk_packages[@]}")
  [ "$1" = tsan ] || packages+=(clang libclang-rt-dev)
  need "${packages[@]}"
  use_vtk
  configure "$1" "${vtk_options[@]}"
}

# The C++ tests with checks of addresses, leaks and undefined behaviour (asan) or of threads (tsan). The figures of a run
# of all tests take the place of earlier ones, those of some tests are put among them.
sanitize() # asan|tsan [NAME]
{
  local tree=$1 name=${2:-} options=$root/Testing/Sanitizers log passed=yes
  configure_sanitizer "$tree"
  # Lists of tests are made while building, by the tests themselves.
  ASAN_OPTIONS=detect_leaks=0 build "$tree" SubdivisionObjectsTests SubdivisionObjectsCoreTests SubdivisionObjectsProgramTests
  say "C++ tests under $tree"
  log=$build/test-$tree.log
  ASAN_OPTIONS=detect_stack_use_after_return=1:allocator_may_return_null=1 UBSAN_OPTIONS=print_stacktrace=1 \
    LSAN_OPTIONS="suppressions=$options/leaks.txt:print_suppressions=0" \
    TSAN_OPTIONS="suppressions=$options/threads.txt:allocator_may_return_null=1" \
    ctest --test-dir "$build/$tree" --output-on-failure --parallel "$jobs" --no-tests=error \
    --label-regex '^(cxx|core|program)$' ${name:+-R "$name"} 2>&1 | tee "$log" || passed=no
  [ -n "$name" ] || rm -f "$build/reliability/$tree.json"
  python3 "$root/Testing/Reliability/results.py" tests "$root" "$build" "$tree" "$log"
  [ $passed = yes ]
}

# Tests that take ids of type int whatever the size: they name the type, or what they call works on stars, or in batches
# of vertices and places. There a table that is too large is an error of the filter.
any_ids='Smoothness|EvaluateLimit|LimitProbe|BezierCells|Deformation|RedGreen(Random|LimitDifference|LimitBatches|OfFile)'
any_ids+='|RedGreen.SameBits|NarrowIdsChangeNothing|Valence2000|NormalsSettleFast|FourEight|TwelveLevels'

# The C++ tests of filters where ids of type int only reach to 30,000, so that many meshes of the tests are too large for
# them; a table that is too large for the ids that were chosen is an error.
narrow() # [NAME]
{
  local name=${1:-}
  need "${vtk_packages[@]}"
  use_vtk
  configure narrow "${vtk_options[@]}"
  build narrow SubdivisionObjectsTests
  say "C++ tests with narrow ids"
  ctest --test-dir "$build/narrow" --output-on-failure --parallel "$jobs" --no-tests=error --label-regex '^cxx$' -E "$any_ids" ${name:+-R "$name"}
}

# clang-tidy, with the checks of .clang-tidy, and cppcheck over Filters and Program, or over sources whose names match
# NAME. Whatever they say is an error.
lint() # [NAME]
{
  local name=${1:-.} bad=0 files
  need "${vtk_packages[@]}" clang-tidy cppcheck
  use_vtk
  configure lint "${vtk_options[@]}"
  files=$(find "$root/Filters" "$root/Program" -name '*.cxx' | grep -E -- "$name" | sort) || die "no source matches $name"
  say "cppcheck"
  xargs -P "$jobs" -n 20 cppcheck --enable=warning,performance,portability --std=c++17 --language=c++ --quiet \
    --error-exitcode=1 -I "$root/Filters" --suppress=missingIncludeSystem \
    --suppressions-list="$root/Testing/Lint/cppcheck.txt" <<<"$files" || bad=1
  say "clang-tidy"
  xargs -P "$jobs" -n 1 clang-tidy --quiet --warnings-as-errors='*' -p "$build/lint" <<<"$files" 2>"$build/lint/errors.log" || bad=1
  [ $bad = 0 ] || die "see above; Testing/Lint/cppcheck.txt and .clang-tidy have what is not to be told"
}

# Each fuzzer for its part of the time, or one for all of it. What it finds new stays in build/fuzz/corpus, and a crash in
# build/fuzz/crashes.
fuzz() # [SECONDS [Filters|Files]]
{
  local seconds=${1:-120} names=(${2:-Filters Files}) name start
  [[ "$seconds" =~ ^[0-9]+$ ]] && seconds=$((seconds / ${#names[@]})) && [ "$seconds" -gt 0 ] ||
    die "for how many seconds? ./dev fuzz 600"
  [[ "${names[*]}" =~ ^(Filters Files|Filters|Files)$ ]] || die "no such fuzzer: ${names[*]}"
  configure_sanitizer asan
  build asan FuzzFilters FuzzFiles
  mkdir -p "$build/fuzz/crashes"
  for name in "${names[@]}"; do
    mkdir -p "$build/fuzz/corpus/$name"
    say "Fuzz$name for $seconds s"
    start=$SECONDS
    (cd "$build/fuzz" && LSAN_OPTIONS="suppressions=$root/Testing/Sanitizers/leaks.txt:print_suppressions=0" \
      ASAN_OPTIONS=allocator_may_return_null=1 \
      "$build/asan/bin/Fuzz$name" "corpus/$name" "$root/Testing/Fuzz/Corpus/$name" -max_total_time="$seconds" \
      -rss_limit_mb=2500 -timeout=30 -max_len=4096 -print_final_stats=1 -artifact_prefix=crashes/ 2>&1 |
      tee "Fuzz$name.log" | grep -E '^(stat::|==|SUMMARY|Test unit|[a-z-]+: )' || true)
    python3 "$root/Testing/Reliability/results.py" fuzz "$root" "$build" "$name" "$build/fuzz/Fuzz$name.log" $((SECONDS - start))
    ! grep -q '^SUMMARY' "$build/fuzz/Fuzz$name.log" || die "Fuzz$name found a fault: see build/fuzz/Fuzz$name.log"
  done
}

# Changes lines of Filters one at a time, and sees whether a test fails (Testing/Mutations/README.md).
mutate() # [PLACE...] [OPTION OF mutate.py...]
{
  need "${vtk_packages[@]}" "${compared_packages[@]}"
  use_vtk
  configure vtk "${vtk_options[@]}"
  build vtk Filters SubdivisionObjectsTests SubdivisionObjectsCoreTests
  python3 "$root/Testing/Mutations/mutate.py" "$root" "$build/vtk" "$@"
}

# Counts inputs, allocations that fail and times to stop, and writes Documentation/Reliability.md with what the other
# commands left; `fuzz`, `mutations` and `tests` measure nothing, and write the page alone.
reliability() # [inputs|memory|abort...] | fuzz | mutations | tests
{
  case "$*" in
    fuzz | mutations | tests)
      python3 "$root/Testing/Reliability/write_page.py" "$root" "$build"
      return 0
      ;;
  esac
  need "${vtk_packages[@]}" "${compared_packages[@]}"
  use_vtk
  configure vtk "${vtk_options[@]}"
  build vtk SubdivisionObjectsTests SubdivisionObjectsFaultTests vtkSubdivisionObjectsPython SubdivisionObjectsPythonFunctions
  python3 "$root/Testing/Reliability/measure.py" "$root" "$build" "$build/vtk" "$@"
  python3 "$root/Testing/Reliability/write_page.py" "$root" "$build"
}
