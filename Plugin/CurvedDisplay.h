// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurvedDisplay.h
 * How finely ParaView draws curved cells.
 */
#ifndef SubdivisionObjects_CurvedDisplay_h
#define SubdivisionObjects_CurvedDisplay_h

/// A new display of a filter whose OutputCells are curved gets a Nonlinear Subdivision Level that
/// shows it: with ParaView's own, 1, an edge is drawn as two lines. That stays where the output has
/// curved lines, which VTK cannot draw finer, and on servers. Is called when the plugin is loaded;
/// does nothing in servers, which make no displays.
void AddCurvedDisplay();

#endif
