#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""./dev new filter writes a filter that compiles, and that the lists of the project know.

usage: check_new_filter.py SOURCES CMAKE COMPILER INCLUDES   (INCLUDES: folders, separated by semicolons)
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

NAME = "TryOfAFilter"
FOLDERS = ("CMake", "Documentation", "Filters", "Plugin", "Testing")
LISTS = ("Filters/CMakeLists.txt", "Filters/README.md", "Testing/CheckIncludes.cmake", "Plugin/Descriptions.cmake",
         "Documentation/Guide/README.md", "Testing/Python/test_plugin.py", "CHANGELOG.md")


def main():
    sources, cmake, compiler, includes = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name in FOLDERS:
            shutil.copytree(pathlib.Path(sources, name), root / name,
                            ignore=shutil.ignore_patterns("*.png", "__pycache__", "pictures"))
        shutil.copy(pathlib.Path(sources, "CHANGELOG.md"), root)
        make = [sys.executable, root / "CMake/new_filter.py"]
        subprocess.run([*make, NAME], check=True)
        for path in LISTS:
            assert NAME in (root / path).read_text(), f"{path} does not know the filter"
        assert subprocess.run([*make, NAME], capture_output=True).returncode != 0, "written twice"
        assert subprocess.run([*make, "lower"], capture_output=True).returncode != 0, "a bad name is taken"
        subprocess.run([cmake, "-D", f"FILTERS={root / 'Filters'}", "-P", root / "Testing/CheckIncludes.cmake"], check=True)
        flags = [f"-I{root / 'Filters'}", *(f"-I{path}" for path in includes.split(";") if path)]
        for path in (f"Filters/vtk{NAME}.cxx", f"Filters/Private/{NAME}/{NAME}.cxx", f"Testing/Filters/{NAME}/Test{NAME}.cxx"):
            subprocess.run([compiler, "-std=c++17", "-fsyntax-only", *flags, root / path], check=True)


if __name__ == "__main__":
    main()
