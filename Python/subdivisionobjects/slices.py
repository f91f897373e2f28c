# SPDX-License-Identifier: BSD-3-Clause
"""An image as pictures, one for each layer and material, as the program writes them."""

import json
import os

import numpy as np

from . import files, meshes
from .arrays import Image

ROOT = 1.2207440846057596  # of x^4 = x + 1: thresholds are spread evenly in each direction


def save(image, folder, dither=False):
    """Writes layer00000_material3.png and so on, and slices.json."""
    materials, cover = layers(image)
    try:
        writer = files.make("vtkIOImage.vtkPNGWriter")
    except ImportError as error:
        raise ValueError(f"slices cannot be written: this VTK was built without the module IOImage ({error})") from None
    folder = os.fspath(folder)
    os.makedirs(folder, exist_ok=True)
    depth, height, width = image["vtkValidPointMask"].shape[:3]
    rows, columns = np.mgrid[:height, :width]
    for layer in range(depth):
        covered = cover(layer).astype(float)
        if dither:
            ends = np.cumsum(covered, axis=-1)
            threshold = (0.5 + columns / ROOT + rows / (ROOT * ROOT) + layer / (ROOT * ROOT * ROOT))[..., np.newaxis]
            threshold -= np.floor(threshold)
            covered = (threshold >= np.concatenate([np.zeros_like(ends[..., :1]), ends[..., :-1]], axis=-1)) \
                & (threshold < ends)
        pixels = np.floor(255.0 * covered + 0.5).astype(np.uint8)
        for number, material in enumerate(materials):
            picture = meshes.from_image(Image({"": pixels[np.newaxis, ..., number]}, (0, 0, 0), (1, 1, 1)))
            picture.GetPointData().SetScalars(picture.GetPointData().GetArray(0))
            name = f"layer{layer:05}{f'_material{material}' if material else ''}.png"
            files.write_whole(writer, picture, os.path.join(folder, name))
    with open(os.path.join(folder, "slices.json"), "w", encoding="utf-8") as file:
        sizes, first = ([float(f"{number:.15g}") for number in numbers] for numbers in (image.spacing, image.origin))
        json.dump({"pixel_and_layer": sizes, "middle_of_first_pixel": first, "columns": width, "rows": height,
                   "layers": depth, "materials": materials}, file, indent=2)
        file.write("\n")


def layers(image):
    """Names of materials, one without a name where there are none, and a function of a layer: how much of each sample
    they have."""
    if "vtkValidPointMask" not in image:
        raise ValueError("slices are of an image that sample() makes, with vtkValidPointMask")
    if meshes.COVERAGE in image:
        covers = image[meshes.COVERAGE]
        covers = covers if covers.ndim == 4 else covers[..., np.newaxis]
        names = list(image.materials) or [""]
        if len(names) != covers.shape[3]:
            raise ValueError(f"Coverage has {covers.shape[3]} components, but there are {len(names)} materials")
        return names, lambda layer: covers[layer]
    inside = image["vtkValidPointMask"] != 0
    found, numbers = [], None
    if "Material" in image:
        found, numbers = np.unique(image["Material"][inside], return_inverse=True)
    if not len(found):
        return [""], lambda layer: inside[layer][..., np.newaxis]
    of_sample = np.full(inside.shape, -1, dtype=np.int32)
    of_sample[inside] = numbers.ravel()
    return list(map(name_of, found)), lambda layer: of_sample[layer][..., np.newaxis] == np.arange(len(found))


def name_of(material):
    """15 digits where they are enough, so that 0.1 is 0.1, and no two materials have one name."""
    text = f"{material:.15g}"
    return text if float(text) == material or material != material else f"{material:.17g}"
