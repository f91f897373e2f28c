// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AddClient.h
 * The door of the part that only ParaView's client with its windows has. It needs no header of Qt.
 */
#ifndef SubdivisionObjects_AddClient_h
#define SubdivisionObjects_AddClient_h

/// Tells the client of the widgets of this folder. Is called when the plugin is loaded; does
/// nothing in pvpython, pvbatch and servers, which have no windows.
void AddClient();

#endif
