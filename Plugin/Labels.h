// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Labels.h
 * The labels of panels, for messages.
 */
#ifndef SubdivisionObjects_Labels_h
#define SubdivisionObjects_Labels_h

/// From now on messages of the filters name options as the panels do. Is called when the plugin is
/// loaded.
void AddLabels();

#endif
