# SPDX-License-Identifier: BSD-3-Clause
"""Curved cells of each rank are those of one process, bit for bit: also of red-green refinement, and repaired ones."""

import re

import numpy as np
import rank_tools as ranks
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_STRING, vtkObject
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

import subdivisionobjects

MODELS = subdivisionobjects.vtkSubdivisionModelSource
RED_GREEN = {"RefineByAttributeError": 0, "RefineByEdgeLength": 1, "MaximumEdgeLength": 0.5, "MaximumLevel": 2, "Placement": 1}
SLOW = {**RED_GREEN, "MaximumLevel": 1}
JUMPING = {"PreserveInterfaces": 1, "InterfaceValues": 1}
UNIFORM, LOCAL = "vtkMultiDimensionalSubdivision", "vtkRedGreenRefinement"
CASES = [(LOCAL, MODELS.MIXED_DIMENSIONS, {**RED_GREEN, "OutputCells": 1}),
         (LOCAL, MODELS.MATERIAL_BLOCK, {**RED_GREEN, "OutputCells": 2, "CellOrder": 4}),
         (LOCAL, MODELS.MATERIAL_BLOCK, {**RED_GREEN, **JUMPING, "OutputCells": 1}),
         (LOCAL, MODELS.SHIP, {**RED_GREEN, "OutputCells": 1, "VolumeScheme": 1, "MaximumEdgeLength": 0.8}),
         (LOCAL, MODELS.MIXED_DIMENSIONS, {**SLOW, "OutputCells": 2, "CellOrder": 3}),
         (LOCAL, MODELS.MATERIAL_BLOCK, {**SLOW, **JUMPING, "OutputCells": 2, "CellOrder": 3}),
         (LOCAL, MODELS.SHIP, {**SLOW, "OutputCells": 2, "CellOrder": 3, "VolumeScheme": 1, "MaximumEdgeLength": 4.0}),
         (UNIFORM, MODELS.MATERIAL_BLOCK, {**JUMPING, "NumberOfLevels": 1, "OutputCells": 2}),
         (UNIFORM, MODELS.SCREW, {"NumberOfLevels": 0, "OutputCells": 3, "CellOrder": 4})]
REPAIRED = [(UNIFORM, MODELS.MIXED_DIMENSIONS, {"NumberOfLevels": 0, "OutputCells": 2}),
            (UNIFORM, MODELS.SPRING_AND_VALVE, {"NumberOfLevels": 0, "OutputCells": 3, "CellOrder": 4}),
            (UNIFORM, MODELS.MATERIAL_BLOCK, {"NumberOfLevels": 0, "OutputCells": 3, "CellOrder": 4})]


def model(number):
    source = MODELS()
    source.SetModel(number)
    source.Update()
    return ranks.numbered(source.GetOutput())


def run_filter(name, options, data, controller, messages):
    made = getattr(subdivisionobjects, name)()
    made.SetController(controller)

    def keep(_, __, text):
        messages.append(text)
    keep.CallDataType = VTK_STRING
    for event in ("WarningEvent", "ErrorEvent"):
        made.AddObserver(event, keep)
    for key, value in options.items():
        getattr(made, "Set" + key)(value)
    made.SetInputDataObject(data)
    vtkObject.GlobalWarningDisplayOn()
    made.Update()
    vtkObject.GlobalWarningDisplayOff()
    return made.GetOutputDataObject(0)


def parts_of(mesh, find, count):
    """The parts of this rank, `count` of each."""
    part_of = find(mesh, count * ranks.RANKS)
    return [ranks.take(mesh, np.nonzero(part_of == count * ranks.RANK + i)[0], with_ids=True) for i in range(count)]


def repair_of(messages):
    """How many cells were repaired, and how far nodes moved."""
    texts = [text.split("): ")[-1].split(" at most")[0] for text in messages if "went back" in text]
    return [re.sub(" is cell [^:]*", "", text) for text in texts]


def run():
    failures, sizes = [], []
    for turn, (name, number, options) in enumerate(CASES + REPAIRED):
        mesh = model(number)
        told = []
        whole = run_filter(name, options, mesh, None, told)
        find = (ranks.by_chance, ranks.in_slabs, ranks.on_last_rank)[turn % 3]
        ours = []
        outputs = [run_filter(name, options, parts_of(mesh, find, 1)[0], ranks.controller, ours)]
        text = f"{name} of model {number}, {options}, {find.__name__}"
        if (name, number, options) in REPAIRED and not repair_of(told):
            failures.append(f"{text}: nothing was repaired")
        if not ranks.RANK and repair_of(ours) != repair_of(told):
            failures.append(f"{text}: {repair_of(ours)} instead of {repair_of(told)}")
        if turn % 2:
            blocks = vtkMultiBlockDataSet()
            for i, part in enumerate(parts_of(mesh, find, 2)):
                blocks.SetBlock(i, part)
            made = run_filter(name, options, blocks, ranks.controller, [])
            outputs.append([made.GetBlock(0), made.GetBlock(1)])
        for output in outputs:
            blocks = output if isinstance(output, list) else [output]
            for block in blocks:
                failures += [f"{text}: {found}" for found in ranks.differences(whole, block)]
            sizes.append((text, sum(block.GetNumberOfCells() for block in blocks), whole.GetNumberOfCells()))
        valid = vtk_to_numpy(whole.GetCellData().GetArray("Valid"))
        if not valid.all() or whole.GetCell(0).IsLinear():
            failures.append(f"{text}: {(valid == 0).sum()} cells are not valid, or linear")
    sums = ranks.totals([size for _, size, _ in sizes])
    return failures + [f"{text}: {found} cells together instead of {all_of}"
                       for found, (text, _, all_of) in zip(sums, sizes) if found != all_of]


ranks.main(run)
