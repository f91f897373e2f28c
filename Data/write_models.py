# SPDX-License-Identifier: BSD-3-Clause
"""Writes every model of vtkSubdivisionModelSource as an ASCII .vtu file.

    python3 write_models.py [FOLDER]        (pvpython in the ParaView flavour)

FOLDER is by default the one that this script lies in. `import subdivisionobjects` must work: put
the package of a build or an installation on PYTHONPATH.
"""

import pathlib
import sys

from subdivisionobjects import vtkSubdivisionModelSource
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter


def write_models(folder):
    for model in range(vtkSubdivisionModelSource.NUMBER_OF_MODELS):
        source = vtkSubdivisionModelSource()
        source.SetModel(model)
        path = folder / (source.GetModelAsString() + ".vtu")
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetDataModeToAscii()
        writer.SetCompressorTypeToNone()
        writer.SetFileName(str(path))
        if not writer.Write():
            raise OSError(f"cannot write {path}")
        grid = source.GetOutput()
        print(f"{path.name}: {grid.GetNumberOfPoints()} points, {grid.GetNumberOfCells()} cells")


if __name__ == "__main__":
    write_models(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
