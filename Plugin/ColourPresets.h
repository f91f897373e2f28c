// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ColourPresets.h
 * The colours of rules as a preset of ParaView.
 */
#ifndef SubdivisionObjects_ColourPresets_h
#define SubdivisionObjects_ColourPresets_h

/// Adds the preset "Subdivision Rules", unless the user has one of this name. Is called when the
/// plugin is loaded.
void AddColourPresets();

#endif
