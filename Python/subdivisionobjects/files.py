# SPDX-License-Identifier: BSD-3-Clause
"""Meshes from files and to files: by VTK, for solvers, and by meshio where it is installed."""

import importlib
import os

import numpy as np

from .execution import listen_to

# Modules and classes of VTK, by endings of names.
READERS = {
    ".vtu": "vtkIOXML.vtkXMLUnstructuredGridReader",
    ".vtp": "vtkIOXML.vtkXMLPolyDataReader",
    ".vti": "vtkIOXML.vtkXMLImageDataReader",
    ".vts": "vtkIOXML.vtkXMLStructuredGridReader",
    ".vtr": "vtkIOXML.vtkXMLRectilinearGridReader",
    ".vtm": "vtkIOXML.vtkXMLMultiBlockDataReader",
    ".pvtu": "vtkIOXML.vtkXMLPUnstructuredGridReader",
    ".pvtp": "vtkIOXML.vtkXMLPPolyDataReader",
    ".vtk": "vtkIOLegacy.vtkGenericDataObjectReader",
    ".stl": "vtkIOGeometry.vtkSTLReader",
    ".obj": "vtkIOGeometry.vtkOBJReader",
    ".ply": "vtkIOPLY.vtkPLYReader",
    ".mha": "vtkIOImage.vtkMetaImageReader",
    ".mhd": "vtkIOImage.vtkMetaImageReader",
    ".nrrd": "vtkIOImage.vtkNrrdReader",
}
IMAGE_WRITERS = {".vti": "vtkIOXML.vtkXMLImageDataWriter", ".vtk": "vtkIOLegacy.vtkGenericDataObjectWriter",
                 ".vdb": "vtkIOOpenVDB.vtkOpenVDBWriter"}
WRITERS = {
    ".vtu": "vtkIOXML.vtkXMLUnstructuredGridWriter",
    ".vtp": "vtkIOXML.vtkXMLPolyDataWriter",
    ".vtk": "vtkIOLegacy.vtkGenericDataObjectWriter",
    ".stl": "vtkIOGeometry.vtkSTLWriter",
    ".obj": "vtkIOGeometry.vtkOBJWriter",
    ".ply": "vtkIOPLY.vtkPLYWriter",
}


def make(path):
    """An object of a class of VTK, by its module and name."""
    module, name = path.split(".")
    return getattr(importlib.import_module(f"vtkmodules.{module}"), name)()


def by_meshio(call, name, known, mesh=None):
    """Reads or writes a file whose ending is none of those that are known."""
    try:
        meshio = importlib.import_module("meshio")
    except ImportError:
        raise ValueError(
            f"{name!r} ends with none of {', '.join(known)}; meshio, which has more formats, is not installed"
        ) from None
    try:
        return getattr(meshio, call)(*[name] if mesh is None else (name, to_meshio(mesh)))
    # Some versions end where they know no format; 5.0 knows no wedges with 15 nodes.
    except (SystemExit, KeyError, meshio.ReadError, meshio.WriteError) as error:
        raise ValueError(f"meshio cannot {call} {name!r}: {error}") from None


def read(name):
    """What is in a file: a data set of VTK, or a mesh of meshio."""
    name = os.fspath(name)
    if not os.path.isfile(name):
        raise FileNotFoundError(f"there is no file {name!r}")
    found = READERS.get(os.path.splitext(name)[1].lower())
    if not found:
        return by_meshio("read", name, READERS)
    reader = make(found)
    reader.SetFileName(name)
    try:
        with listen_to(reader):
            reader.Update()
    except RuntimeError as error:
        raise ValueError(f"{name!r} cannot be read: {error}") from None
    data = reader.GetOutputDataObject(0)
    if data is None or not data.GetNumberOfElements(0):
        raise ValueError(f"there is no mesh in {name!r}")
    return data


def save(mesh, name, groups=None):
    """Writes a mesh in the format of the ending of the name."""
    from . import solvers

    name = os.fspath(name)
    ending = os.path.splitext(name)[1].lower()
    if ending in solvers.WRITERS:
        solvers.write(mesh, name, groups)
        return
    if groups is not None:
        raise ValueError(f"groups are for {', '.join(solvers.WRITERS)}: {name!r} has all cell arrays")
    if ending not in WRITERS:
        by_meshio("write", name, (*WRITERS, *solvers.WRITERS), mesh)
        return
    data = mesh.to_vtk()
    for path in steps(ending, data.IsA("vtkPolyData")):
        made = make(path)
        made.SetInputData(data)
        made.Update()
        data = made.GetOutput()
    if ending in (".stl", ".ply") and not data.GetNumberOfPolys():
        raise ValueError(f"there are no triangles for {name!r}: .vtu holds all cells")
    write_whole(make(WRITERS[ending]), data, name)


def save_image(image, name):
    """Writes an image in the format of the ending of the name."""
    name = os.fspath(name)
    ending = os.path.splitext(name)[1].lower()
    if ending not in IMAGE_WRITERS:
        raise ValueError(f"{name!r} ends with none of {', '.join(IMAGE_WRITERS)}, which hold images")
    try:
        writer = make(IMAGE_WRITERS[ending])
    except ImportError as error:
        raise ValueError(f"{name!r} cannot be written: this VTK was built without the module "
                         f"{IMAGE_WRITERS[ending].split('.')[0][3:]} ({error}); .vti files hold images, too") from None
    write_whole(writer, image.to_vtk(), name)


def steps(ending, is_surface):
    """The filters that make what a format can hold of a grid, or of a surface or points alone."""
    if ending in (".vtk", ".vtu"):
        return ["vtkFiltersCore.vtkAppendFilter"] if is_surface and ending == ".vtu" else []
    made = [] if is_surface else ["vtkFiltersGeometry.vtkGeometryFilter"]
    return made + (["vtkFiltersCore.vtkTriangleFilter"] if ending in (".stl", ".ply") else [])


def write_whole(writer, data, name):
    """Writes a file beside the one of this name, and puts it there when it is whole."""
    folder = os.path.dirname(name) or "."
    if not os.path.isdir(folder):
        raise FileNotFoundError(f"there is no folder {folder!r}")
    part = os.path.join(folder, f".part-{os.getpid()}-{os.path.basename(name)}")
    writer.SetInputData(data)
    writer.SetFileName(part)
    for binary in ("SetDataModeToBinary", "SetFileTypeToBinary"):  # ParaView 5.11 does not read appended data
        getattr(writer, binary, lambda: None)()
    try:
        with listen_to(writer):
            done = writer.Write()
        if done == 0 or not os.path.exists(part):
            raise RuntimeError("the disk may be full")
        os.replace(part, name)
    except (RuntimeError, OSError) as error:
        raise OSError(f"{name!r} was not written: {error}") from None
    finally:
        if os.path.exists(part):
            os.remove(part)


def to_meshio(mesh):
    """Arrays as a meshio.Mesh: a block for each type of cells."""
    meshio = importlib.import_module("meshio")
    blocks = [("polygon" if name.startswith("polygon") else name, rows) for name, rows in mesh.cells_by_type().items()]
    ends = np.cumsum([len(rows) for _, rows in blocks])[:-1]
    return meshio.Mesh(
        mesh.points,
        blocks,
        point_data=dict(mesh.point_data),
        cell_data={name: np.split(values, ends) for name, values in mesh.cell_data.items()},
        field_data=dict(mesh.field_data),
    )
