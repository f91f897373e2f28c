# SPDX-License-Identifier: BSD-3-Clause
"""What pictures of shapes side by side share: guide_pictures.py and its siblings make them."""

import demo_pictures as look
import numpy as np
import picture_files
from vtkmodules.util.numpy_support import numpy_to_vtk

BLUE = (0.62, 0.74, 0.86)
VIEW = (0.6, -1.0, 0.45)


def add_array(data, name, values):
    array = numpy_to_vtk(np.asarray(values), deep=True)
    array.SetName(name)
    data.AddArray(array)


def output(proxy):
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(0)


def points_of(data):
    return look.points_of(data).astype(float)


def write(name, shown, direction, columns=3):
    """shown: (caption, actors, points that the picture has to have in it)."""
    frame = np.concatenate([points for _, _, points in shown])
    images = [look.render(actors, [look.caption(words)], frame, direction) for words, actors, _ in shown]
    picture_files.write_figure(images, f"gallery_{name}", columns)
