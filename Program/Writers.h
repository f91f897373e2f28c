// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Writers.h
 * Writes data of one class into a file, with VTK's writers. Each returns whether the file is whole.
 */
#ifndef SubdivisionObjects_Writers_h
#define SubdivisionObjects_Writers_h

class vtkDataObject;

namespace subdivide
{

/// .vti, .vtp, .vtr, .vts, .vtt and .vtu, by the class of the data.
bool WriteXml(vtkDataObject* data, const char* name);

/// .pvtp and .pvtu, in one piece.
bool WritePieces(vtkDataObject* data, const char* name);

/// .vtm, with a folder beside it.
bool WriteBlocks(vtkDataObject* data, const char* name);

bool WriteObj(vtkDataObject* data, const char* name);
bool WritePly(vtkDataObject* data, const char* name);
bool WriteStl(vtkDataObject* data, const char* name);
bool WriteLegacy(vtkDataObject* data, const char* name);
#ifdef SUBDIVISIONOBJECTS_IOEXODUS
bool WriteExodus(vtkDataObject* data, const char* name);
#endif
#ifdef SUBDIVISIONOBJECTS_IOOPENVDB
bool WriteVdb(vtkDataObject* data, const char* name);
#endif

}

#endif
