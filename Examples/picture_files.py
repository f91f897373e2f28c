# SPDX-License-Identifier: BSD-3-Clause
"""Images: made smaller, put side by side, and written, as they are or as small files."""

import os
import struct
import zlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkImagingCore import vtkImageConstantPad, vtkImageResize
from vtkmodules.vtkIOImage import vtkPNGWriter


def shrunk(image, factor):
    width, height, _ = image.GetDimensions()
    if factor == 1.0:
        return image
    producer = vtkTrivialProducer()
    producer.SetOutput(image)
    shrink = vtkImageResize()
    shrink.SetInputConnection(producer.GetOutputPort())
    shrink.SetOutputDimensions(round(factor * width), round(factor * height), 1)
    shrink.Update()
    return shrink.GetOutput()


def append(images, axis):
    joined = vtkImageAppend()
    joined.SetAppendAxis(axis)
    for image in images:
        joined.AddInputData(image)
    joined.Update()
    return joined.GetOutput()


def padded(image, width):
    """With white at the right, to a width."""
    pad = vtkImageConstantPad()
    pad.SetInputData(image)
    pad.SetConstant(255)
    pad.SetOutputWholeExtent(0, width - 1, 0, image.GetDimensions()[1] - 1, 0, 0)
    pad.Update()
    return pad.GetOutput()


def pixels_of(image):
    """Rows from the bottom, columns, channels; changes are changes of the image."""
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)


def halved(image):
    pixels = pixels_of(image).astype(np.uint16)
    pixels = pixels[:pixels.shape[0] // 2 * 2, :pixels.shape[1] // 2 * 2]
    mean = (pixels[::2, ::2] + pixels[1::2, ::2] + pixels[::2, 1::2] + pixels[1::2, 1::2] + 2) // 4
    made = vtkImageData()
    made.SetDimensions(mean.shape[1], mean.shape[0], 1)
    made.GetPointData().SetScalars(numpy_to_vtk(mean.astype(np.uint8).reshape(-1, mean.shape[2]), deep=True))
    return made


def framed(image, width=20):
    """With a white frame, for details that fill the image."""
    pixels = pixels_of(image)
    pixels[:width] = pixels[-width:] = 255
    pixels[:, :width] = pixels[:, -width:] = 255
    return image


def contact_sheet(rows):
    """Rows of images, of which some may be shorter."""
    joined = [append(row, 0) for row in rows]
    width = max(row.GetDimensions()[0] for row in joined)
    return append([padded(row, width) for row in reversed(joined)], 1)  # images count from the bottom


def wrapped(images, columns):
    """A contact sheet of images one after the other."""
    return contact_sheet([images[i:i + columns] for i in range(0, len(images), columns)])


def write_png(image, file_name):
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(file_name)
    writer.SetCompressionLevel(6)
    writer.Write()


def median_cut(colours, counts, wanted):
    """Boxes of colours of 6 bits per channel: the number of the box of each, and the mean of each box in 8 bits."""
    boxes = [np.arange(len(colours))]
    while len(boxes) < wanted:
        sizes = [np.ptp(colours[box], axis=0).max() * counts[box].sum() ** 0.3 for box in boxes]
        widest = int(np.argmax(sizes))
        if sizes[widest] == 0:
            break
        box = boxes[widest]
        axis = int(np.argmax(np.ptp(colours[box], axis=0)))
        low = colours[box, axis] <= (colours[box, axis].min() + colours[box, axis].max()) // 2
        boxes[widest] = box[low]
        boxes.append(box[~low])
    ids = np.zeros(len(colours), np.int64)
    for i, box in enumerate(boxes):
        ids[box] = i
    means = [np.average(colours[box], axis=0, weights=counts[box]) for box in boxes]
    return ids, np.clip(np.round(np.array(means) * 4 + 1.5), 0, 255).astype(np.uint8)


LARGEST_SMALL_FILE = 60_000  # bytes


def write_small_png(image, file_name):
    """With a palette, which takes a third of the space; with fewer colours, and smaller, if the file is too large."""
    for colours in (192, 64, 24):
        content = palette_png(image, colours)
        if len(content) <= LARGEST_SMALL_FILE:
            break
    while len(content) > LARGEST_SMALL_FILE:
        image = shrunk(image, 0.9)
        content = palette_png(image, 24)
    with open(file_name, "wb") as file:
        file.write(content)


def palette_png(image, colours):
    """The bytes of a PNG file with some colours and white."""
    pixels = pixels_of(image)[::-1]  # images count from the bottom
    height, width, _ = pixels.shape
    codes = (pixels.astype(np.int64) >> 2) @ (1 << 12, 1 << 6, 1)
    used, counts = np.unique(codes, return_counts=True)
    ids_of_used, palette = median_cut(np.stack([used >> 12, used >> 6 & 63, used & 63], axis=1), counts, colours)
    ids = ids_of_used.astype(np.uint8)[np.searchsorted(used, codes)]
    ids[np.all(pixels == 255, axis=2)] = colours  # the background stays white
    palette = np.concatenate([palette, np.full((colours + 1 - len(palette), 3), 255, np.uint8)])
    rows = np.concatenate([np.zeros((height, 1), np.uint8), ids], axis=1)  # 0: rows are not filtered
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)), (b"PLTE", palette.tobytes()),
              (b"IDAT", zlib.compress(rows.tobytes(), 9)), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
        for name, content in chunks)


def write_figure(images, name, columns):
    """Images in columns, in two files: NAME.png to be printed, and guide/NAME.png for Documentation/Guide/pictures."""
    sheet = halved(wrapped(images, columns))
    write_png(sheet, f"{name}.png")
    os.makedirs("guide", exist_ok=True)
    small = halved(sheet)
    write_small_png(shrunk(small, min(1.0, 1200 / small.GetDimensions()[0])), f"guide/{name}.png")
