#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""./dev new filter NAME: writes the files that every public filter has.

The filter does nothing yet: it passes its input on. All that follows a pattern is there, so that it builds, is in
ParaView's menu, in Python and in the program, has a test, a page of the guide and a line in each list. Search the new
files for BEGIN HERE.
"""

import argparse
import pathlib
import re
import sys

LICENSE = "// SPDX-License-Identifier: BSD-3-Clause\n"

HEADER = LICENSE + """/**
 * @class   vtk@NAME@
 * @brief   @brief@
 *
 * BEGIN HERE: three sentences on what the filter does. Then its algorithm and source (paper, equation), its input and
 * output with shapes, units and arrays, boundaries, complexity, threads and ranks, errors.
 *
 * @par Input
 * vtkUnstructuredGrid, vtkPolyData or structured data; cells, bad cells and the cell arrays that
 * are read: see vtkSubdivisionAlgorithm.
 *
 * @par Output
 * A vtkUnstructuredGrid.
 *
 * @sa
 * vtkMultiDimensionalSubdivision
 */
#ifndef vtk@NAME@_h
#define vtk@NAME@_h

#include "vtkSubdivisionAlgorithm.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

class VTKSUBDIVISIONOBJECTS_EXPORT vtk@NAME@ : public vtkSubdivisionAlgorithm
{
public:
  static vtk@NAME@* New();
  vtkTypeMacro(vtk@NAME@, vtkSubdivisionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The output.
  vtkUnstructuredGrid* GetOutput() { return this->GetUnstructuredGridOutput(); }

protected:
  vtk@NAME@();
  ~vtk@NAME@() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtk@NAME@(const vtk@NAME@&) = delete;
  void operator=(const vtk@NAME@&) = delete;
};

#endif
"""

SOURCE = LICENSE + """#include "vtk@NAME@.h"

#include "Private/@NAME@/@NAME@.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtk@NAME@);

vtk@NAME@::vtk@NAME@() = default;
vtk@NAME@::~vtk@NAME@() = default;

int vtk@NAME@::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::@NAME@Options options;
  return this->Run(inputVector, outputVector, options,
    "Results at the borders of partitions are those of this partition alone.",
    "the cells of the input. Use a part of the input.",
    [&options](vtkPointSet* input, vtkPointSet* output)
    {
      return subdivision::Run@NAME@(input, options, vtkUnstructuredGrid::SafeDownCast(output));
    });
}

void vtk@NAME@::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
"""

WORK_HEADER = LICENSE + """/**
 * @file @NAME@.h
 * Does the work of vtk@NAME@.
 */
#ifndef SubdivisionObjects_@NAME@_h
#define SubdivisionObjects_@NAME@_h

#include "Private/@RUN@/RunOptions.h"

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

struct @NAME@Options : RunOptions
{
};

/// Returns false after an error (passed to Fail) or if Progress asks to stop. The caller then
/// empties the output.
bool Run@NAME@(vtkPointSet* input, const @NAME@Options& options, vtkUnstructuredGrid* output);

}

#endif
"""

WORK = LICENSE + """#include "Private/@NAME@/@NAME@.h"

#include "vtkUnstructuredGrid.h"

namespace subdivision
{

bool Run@NAME@(vtkPointSet* input, const @NAME@Options& options, vtkUnstructuredGrid* output)
{
  if (options.Progress && options.Progress(0.))
  {
    return false;
  }
  // BEGIN HERE. CellsToSimplices.h reads cells of any type; ControlMesh.h knows marks and stamps, too.
  output->ShallowCopy(vtkUnstructuredGrid::SafeDownCast(input));
  return true;
}

}
"""

TEST = LICENSE + """/**
 * @file Test@NAME@.cxx
 * vtk@NAME@ does what its documentation says.
 */
#include "MultiDimensionalSubdivisionTools.h"

#include "vtk@NAME@.h"

using namespace multi_dimensional_subdivision_tools;

TEST(@NAME@, PassesItsInputOn)
{
  const Grid input = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } } });
  vtkNew<Messages> messages;
  vtkNew<vtk@NAME@> filter;
  messages->Watch(filter);
  filter->SetInputDataObject(input);
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 1); // BEGIN HERE
}
"""

PROXY = """<ServerManagerConfiguration>
  <ProxyGroup name="filters">
    <SourceProxy base_proxygroup="internal_filters"
                 base_proxyname="SolidSubdivisionAlgorithm"
                 class="vtk@NAME@"
                 label="@LABEL@"
                 name="@NAME@">
      <Documentation long_help="@brief@."
                     short_help="@brief@.">
BEGIN HERE: what the filter does, for somebody who reads it in ParaView, and where its mathematics is from. It passes
its input on so far, and so has no options of its own.
      </Documentation>

      <Hints>
        <ShowInMenu category="Subdivision Objects"
                    icon=":/pqWidgets/Icons/pqNodeSetData.svg" />
      </Hints>
    </SourceProxy>
  </ProxyGroup>
</ServerManagerConfiguration>
"""

PAGE = """# @LABEL@

BEGIN HERE: a picture. You have ..., and you want ...: take this filter (class `vtk@NAME@`, Python
`subdivisionobjects.@function@`).

## When to use it

## What comes out

<!-- properties -->

<!-- end -->

## Pitfalls
"""

ROOM = """# Private/@NAME@

The work of vtk@NAME@.

- `@NAME@.h`: BEGIN HERE.

May include Core, Reading, Arrays, Control.
"""


def fail(text):
    sys.exit("dev: " + text)


def words(name):
    return re.findall(r"[A-Z][a-z0-9]*", name)


class Project:
    """Files of a checkout: those that are new, and lists that get a line."""

    def __init__(self, root, name):
        self.root = pathlib.Path(root)
        self.changes = {}
        run = "Run" if (self.root / "Filters/Private/Run/RunOptions.h").exists() else "Control"
        self.values = {"NAME": name, "LABEL": " ".join(words(name)), "RUN": run,
                       "brief": " ".join(words(name)).lower(), "function": "_".join(words(name)).lower()}

    def fill(self, text):
        return re.sub(r"@(\w+)@", lambda match: self.values.get(match[1], match[0]), text)

    def add(self, path, text):
        path = self.fill(path)
        if (self.root / path).exists():
            fail(f"{path} is there already")
        self.changes[path] = self.fill(text)

    def insert(self, path, before, line):
        """Puts a line in front of the first one that `before` matches."""
        text = (self.root / path).read_text()
        match = re.search(before, text, re.MULTILINE)
        if not match:
            fail(f"{path} has no line like {before}: it changed, and CMake/new_filter.py has to follow")
        self.changes[path] = text[:match.start()] + self.fill(line) + text[match.start():]

    def write(self):
        for path, text in self.changes.items():
            (self.root / path).parent.mkdir(parents=True, exist_ok=True)
            (self.root / path).write_text(text)
            print(path)


def main():
    parser = argparse.ArgumentParser(prog="./dev new filter", description=__doc__)
    parser.add_argument("name", metavar="NAME", help="the name of the class without vtk, MeshQuality for instance")
    parser.add_argument("--root", default=pathlib.Path(__file__).resolve().parent.parent, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    name = arguments.name
    if name != "".join(words(name)) or len(words(name)) < 2:
        fail(f"{name}: a name is two words or more, each with a capital letter: MeshQuality for instance")
    project = Project(arguments.root, name)
    project.add("Filters/vtk@NAME@.h", HEADER)
    project.add("Filters/vtk@NAME@.cxx", SOURCE)
    project.add("Filters/Private/@NAME@/@NAME@.h", WORK_HEADER)
    project.add("Filters/Private/@NAME@/@NAME@.cxx", WORK)
    project.add("Filters/Private/@NAME@/README.md", ROOM)
    project.add("Testing/Filters/@NAME@/Test@NAME@.cxx", TEST)
    project.add("Plugin/@NAME@.xml", PROXY)
    project.add("Documentation/Guide/@NAME@.md", PAGE)
    project.insert("Filters/CMakeLists.txt", r"^  vtkExtractDimensions$", "  vtk@NAME@\n")
    project.insert("Filters/README.md", r"^- `vtkSubdivisionAlgorithm`", "- `vtk@NAME@`: @brief@.\n")
    project.insert("Testing/CheckIncludes.cmake", r"^room\(Private/Models\)",
                   "room(Private/@NAME@ Core Private Private/Reading Private/Arrays "
                   + ("${control}" if project.values["RUN"] == "Run" else "Private/Control") + ")\n")
    project.insert("Plugin/Descriptions.cmake", r" MultiDimensionalSubdivision RedGreenRefinement", " @NAME@")
    project.insert("Documentation/Guide/README.md", r"^- \[Extract Dimensions\]", "- [@LABEL@](@NAME@.md): @brief@.\n")
    project.insert("Testing/Python/test_plugin.py", r'^        "ExtractDimensions": \(',
                   '        "@NAME@": ("@LABEL@", "' + "".join(words(name)) + '"),\n')
    project.insert("CHANGELOG.md", r"^- ", "- `vtk@NAME@` (\"@LABEL@\"): @brief@.\n")
    project.write()
    print("Now: search these files for BEGIN HERE; ./dev format; ./dev try " + name + "; cmake --build build/vtk "
          "--target guide_tables writes the table of the page.\nDocumentation/Contributing.md, \"Add a public filter\", "
          "has the tests of all filters that a new one should join.")


if __name__ == "__main__":
    main()
