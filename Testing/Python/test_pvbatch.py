# SPDX-License-Identifier: BSD-3-Clause
"""Two ranks of pvbatch: each has its part of the work, and together they have it all.

Run without arguments this starts itself under mpiexec; it is skipped where there is none.
"""

import os
import shutil
import subprocess
import sys

SKIPPED = 77


def start():
    mpiexec, pvbatch = shutil.which("mpiexec"), shutil.which("pvbatch")
    if not mpiexec or not pvbatch:
        print("skipped: there is no mpiexec or no pvbatch")
        return SKIPPED
    # pvpython, which runs this, is an MPI process by itself: its own traces would mislead mpiexec.
    clean = {key: value for key, value in os.environ.items() if not key.startswith(("OMPI_", "PMIX_", "ORTE_"))}
    environment = dict(clean, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_btl_vader_single_copy_mechanism="none")
    ran = subprocess.run([mpiexec, "-n", "2", pvbatch, "--force-offscreen-rendering", __file__, "rank"],
                         env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300)
    print(ran.stdout)
    if ran.returncode != 0 or "two ranks agree" not in ran.stdout:
        print(f"mpiexec ended with {ran.returncode}")
        return 1
    return 0


def rank():
    import tools  # loads the plugin on both ranks
    from paraview import simple
    from paraview.modules.vtkRemotingCore import vtkProcessModule

    assert vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions() == 2
    model = simple.SubdivisionModel(Model="MaterialBlock")
    spheres = simple.Sphere()  # is made in two halves
    for source in (model, spheres):
        subdivision = simple.MultidimensionalSubdivision(Input=source, NumberOfLevels=2)
        own = simple.RemoveGhostInformation(Input=subdivision)  # ParaView asks for a layer of ghost cells
        own.UpdatePipeline()
        before, after = source.GetDataInformation(), own.GetDataInformation()
        factor = 64 if source is model else 16
        assert before.GetNumberOfCells() > 0
        assert after.GetNumberOfCells() == factor * before.GetNumberOfCells(), after.GetNumberOfCells()
    assert tools.FACTORS
    print("two ranks agree", flush=True)


if __name__ == "__main__":
    if sys.argv[1:] == ["rank"]:
        rank()
    else:
        sys.exit(start())
