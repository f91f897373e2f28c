// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MergedValues.h
 * Values of points that become one.
 */
#ifndef SubdivisionObjects_MergedValues_h
#define SubdivisionObjects_MergedValues_h

#include "vtkType.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

class vtkAbstractArray;

namespace subdivision
{

/// The values that merged points get.
enum class MergedValues
{
  First,
  Average,
  Keep
};

/// By how much values of two points differ: 0 if they are equal, infinity if there is no number.
double GetDifference(vtkAbstractArray* array, vtkIdType i, vtkIdType j);

/// Values of one array that differ at points which become one.
struct Replaced
{
  vtkIdType Points = 0;
  double Most = 0.; ///< of the differences that are finite
  bool IsTexture = false;

  void Add(const Replaced& other)
  {
    this->Points += other.Points;
    this->Most = std::max(this->Most, other.Most);
    this->IsTexture = this->IsTexture || other.IsTexture;
  }
};

/// By the names of arrays.
using ReplacedValues = std::map<std::string, Replaced>;

/// Warns of values that are replaced by values of the first point, and of texture coordinates;
/// `ofSides`: by JoinSides.
void DescribeReplaced(const ReplacedValues& replaced, MergedValues rule, bool ofSides,
  std::vector<std::string>& warnings);
/// Warns of cells with points that become one, and of points of one part that keep no values.
void DescribeCollapsed(vtkIdType cells, vtkIdType first, std::vector<std::string>& warnings);
void DescribeTorn(vtkIdType torn, std::vector<std::string>& warnings);

}

#endif
