// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Precompiled.h
 * Headers that many files of Core and Private include, compiled once for all of them. Every file
 * includes what it needs all the same: `./dev bench` builds without precompiled headers.
 */
#ifndef SubdivisionObjects_Precompiled_h
#define SubdivisionObjects_Precompiled_h

#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#endif
