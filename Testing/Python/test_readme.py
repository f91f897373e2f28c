# SPDX-License-Identifier: BSD-3-Clause
"""The Python lines of README and the guide for ParaView are run as they stand there, one block after the other."""

import os
import sys

import readme

from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

plugin = os.environ.get("SUBDIVISIONOBJECTS_PLUGIN", "")
if not os.path.isfile(plugin):
    sys.exit(f"SUBDIVISIONOBJECTS_PLUGIN names no file: '{plugin}'")


def make_what_readme_speaks_of():
    os.makedirs("build", exist_ok=True)
    if not os.path.islink("build/plugin"):  # as ./dev makes it
        os.symlink(os.path.dirname(plugin), "build/plugin")
    if not os.path.islink("Data"):  # as in the project's folder
        os.symlink(readme.PROJECT / "Data", "Data")
    sphere = vtkSphereSource()
    writer = vtkXMLPolyDataWriter()
    writer.SetInputConnection(sphere.GetOutputPort())
    writer.SetFileName("bunny.vtp")
    writer.SetDataModeToBinary()
    writer.Write()


make_what_readme_speaks_of()
blocks = [("README.md", block) for block in readme.blocks("python", before="## In Python, without ParaView")]
assert len(blocks) == 1, len(blocks)
for page in readme.GUIDE[:-1]:
    blocks += [(page.name, block) for block in readme.blocks("python", path=page)]
assert len(blocks) == 19, [name for name, _ in blocks]
for name, block in blocks:  # here and not in a function, as in a script
    exec(compile(block, name, "exec"))
for name in ("volume.png", "figure.png"):
    assert os.path.isfile(name), name
for name in ("smooth", "solids", "bent", "solid", "screw", "bunny", "topology", "cage", "probe", "smoothness"):
    proxy = globals()[name]
    proxy.UpdatePipeline()
    assert proxy.GetDataInformation().GetNumberOfCells() > 0, name
