// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ServerManagerClasses.h
 * Classes of the plugin that ParaView makes by their names.
 */
#ifndef SubdivisionObjects_ServerManagerClasses_h
#define SubdivisionObjects_ServerManagerClasses_h

/// Tells the interpreters of ParaView, of clients and servers. Is called when the plugin is loaded.
void AddServerManagerClasses();

#endif
