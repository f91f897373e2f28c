# SPDX-License-Identifier: BSD-3-Clause
"""A server of three ranks: its result has no crack, and its picture is that of the built-in server."""

import os
import shutil
import socket
import subprocess
import unittest

import numpy as np
import tools
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter

try:
    from vtkmodules.vtkFiltersCore import vtkExtractCells
except ImportError:  # VTK 9.1
    from vtkmodules.vtkFiltersExtraction import vtkExtractCells

RANKS = 3
FILE = os.path.join(os.environ.get("SUBDIVISIONOBJECTS_DATA", ""), "MaterialBlock.vtu")
PROGRAMS = shutil.which("mpirun"), shutil.which("pvserver")


def start_server():
    """The server, and the port that it listens to."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    # pvpython, which runs this, is an MPI process by itself: its own traces would mislead mpirun.
    clean = {key: value for key, value in os.environ.items() if not key.startswith(("OMPI_", "PMIX_", "ORTE_"))}
    environment = dict(clean, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_mpi_yield_when_idle="1",
                       PRTE_MCA_rmaps_default_mapping_policy=":oversubscribe",
                       OMPI_MCA_btl_vader_single_copy_mechanism="none", VTK_SMP_MAX_THREADS="2")
    server = subprocess.Popen([PROGRAMS[0], "-np", str(RANKS), PROGRAMS[1], "--force-offscreen-rendering",
                               f"--server-port={port}"], env=environment, stdout=subprocess.PIPE, text=True)
    for line in server.stdout:
        if "Accepting connection" in line:
            return server, port
    raise RuntimeError("pvserver did not start")


def points_of(grid):
    return vtk_to_numpy(grid.GetPoints().GetData()) if grid.GetNumberOfPoints() else np.empty((0, 3))


def write_pieces(name):
    """The file in pieces of consecutive cells, one for each rank."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(FILE)
    reader.Update()
    mesh = reader.GetOutput()
    for piece in range(RANKS):
        extract = vtkExtractCells()
        extract.SetInputData(mesh)
        extract.AddCellRange(mesh.GetNumberOfCells() * piece // RANKS,
                             mesh.GetNumberOfCells() * (piece + 1) // RANKS - 1)
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetInputConnection(extract.GetOutputPort())
        writer.SetFileName(f"{name}_{piece}.vtu")
        writer.SetDataModeToAscii()  # ParaView 5.11 with a newer Expat reads no appended data
        writer.Write()

    def arrays(data):
        types = {"float": "Float32", "double": "Float64", "int": "Int32", "vtkIdType": "Int64", "unsigned char": "UInt8"}
        return "".join(f'<PDataArray type="{types[array.GetDataTypeAsString()]}" Name="{array.GetName()}" '
                       f'NumberOfComponents="{array.GetNumberOfComponents()}"/>'
                       for array in map(data.GetArray, range(data.GetNumberOfArrays())))

    point_type = {10: "Float32", 11: "Float64"}[mesh.GetPoints().GetDataType()]
    pieces = "".join(f'<Piece Source="{name}_{piece}.vtu"/>' for piece in range(RANKS))
    with open(f"{name}.pvtu", "w", encoding="ascii") as file:
        file.write(f"""<?xml version="1.0"?>
<VTKFile type="PUnstructuredGrid" version="0.1" byte_order="LittleEndian">
  <PUnstructuredGrid GhostLevel="0">
    <PPointData>{arrays(mesh.GetPointData())}</PPointData>
    <PCellData>{arrays(mesh.GetCellData())}</PCellData>
    <PPoints><PDataArray type="{point_type}" NumberOfComponents="3"/></PPoints>
    {pieces}
  </PUnstructuredGrid>
</VTKFile>
""")
    return os.path.abspath(f"{name}.pvtu")


def subdivided(reader):
    return simple.MultidimensionalSubdivision(Input=reader, NumberOfLevels=2)


def picture(proxy, name):
    view = simple.CreateView("RenderView")
    view.ViewSize = [400, 300]
    view.OrientationAxesVisibility = 0
    display = simple.Show(proxy, view)
    display.SetRepresentationType("Surface")
    simple.ColorBy(display, ("POINTS", "Tension"))
    display.RescaleTransferFunctionToDataRange(False, True)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [7, -6, 5], [1, 1, 1.5], [0, 0, 1]
    simple.SaveScreenshot(os.path.abspath(name), view)
    reader = vtkPNGReader()
    reader.SetFileName(os.path.abspath(name))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)


@unittest.skipUnless(all(PROGRAMS), "there is no mpirun or no pvserver")
class Server(unittest.TestCase):
    def test_is_as_built_in(self):
        file_name = write_pieces("pieces")
        whole = subdivided(simple.XMLUnstructuredGridReader(FileName=[FILE], TimeArray="None"))
        expected = picture(whole, "built-in.png")
        grid = tools.output(whole)
        server, port = start_server()
        try:
            simple.Connect("127.0.0.1", port)
            for remote in (True, False):
                simple.LoadPlugin(tools.plugin, remote=remote, ns=vars(simple))
            simple.GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = 0  # the ranks are to draw
            parts = simple.XMLPartitionedUnstructuredGridReader(FileName=[file_name], TimeArray="None")
            joined = subdivided(parts)
            shares = simple.ProcessIds(Input=parts) if hasattr(simple, "ProcessIds") else simple.ProcessIdScalars(Input=parts)
            shares.UpdatePipeline()
            self.assertGreater(shares.PointData["ProcessId" if "ProcessId" in shares.PointData.keys() else
                                                "PointProcessIds"].GetRange()[1], 0, "one rank has all")
            own = simple.RemoveGhostInformation(Input=joined)  # ParaView asks for a layer of ghost cells
            own.UpdatePipeline()
            information = own.GetDataInformation()
            self.assertEqual(information.GetNumberOfCells(), grid.GetNumberOfCells())
            self.assertGreater(information.GetNumberOfPoints(), grid.GetNumberOfPoints())  # borders are there twice
            points = np.concatenate([points_of(servermanager.Fetch(own, rank)) for rank in range(RANKS)])
            self.assertEqual(len(points), information.GetNumberOfPoints())
            self.assertEqual(len(np.unique(points, axis=0)), grid.GetNumberOfPoints(), "there is a crack")
            seen = picture(joined, "server.png")
            self.assertGreater((expected != expected[0]).any(axis=1).mean(), 0.05, "the picture is empty")
            different = abs(seen - expected).max(axis=1) > 16
            self.assertLess(different.mean(), 0.005)
        finally:
            server.terminate()
            server.communicate(timeout=60)


if __name__ == "__main__":
    tools.main()
