// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Forecast.h
 * How much a filter would make, for the client, before it is applied.
 */
#ifndef SubdivisionObjects_Forecast_h
#define SubdivisionObjects_Forecast_h

#include "ForecastRules.h"

#include <string>
#include <vector>

class vtkSMProxy;

/// The properties by which a forecast changes.
const std::vector<std::string>& GetForetellingProperties();

/// What a filter would make by so many levels, or as many as its panel shows, with the other values
/// that this shows. The server counts the cells of the input, and nothing is made.
Forecast Foretell(vtkSMProxy* filter, int levels = -1);

/// Two levels where the output stays below a million cells: for filters that the user made by the
/// menu, since scripts count on the default of the class.
void SetFirstLevels(vtkSMProxy* filter);

#endif
