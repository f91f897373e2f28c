// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Slices.h
 * An image as pictures, one for each layer and material, as printers read them.
 */
#ifndef SubdivisionObjects_Slices_h
#define SubdivisionObjects_Slices_h

#include <string>

class vtkDataObject;

namespace subdivide
{

/// Throws UsageError or Failure where slices cannot be written into a folder, which is made.
void CheckSlices(const std::string& folder);

/**
 * Writes layer00000_material3.png and so on, without a material layer00000.png: 8 bits, 255 inside.
 * A pixel is a sample, the first row that of the largest y. `Coverage`, where the image has it,
 * makes the pixels of boundaries grey; if `dithers`, they are black or white instead, as often as
 * they are covered, and no pixel is white in two materials. slices.json has the size and place of
 * pixels. Throws Failure.
 */
void WriteSlices(vtkDataObject* data, const std::string& folder, bool dithers);

}

#endif
