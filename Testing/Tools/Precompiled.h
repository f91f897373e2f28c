// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Precompiled.h
 * What most tests include, compiled once for all of them. Every file includes what it needs all the
 * same, so that it compiles without this one.
 */
#ifndef Precompiled_h
#define Precompiled_h

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#endif
