// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Run/RunOptions.h"

#include "Private/ArrayNames.h"

#include <utility>

namespace subdivision
{

std::unique_ptr<PointArrays> StartPointArrays(const RunOptions& options, vtkPointSet* input,
  const SimplicesOfCells& cells, const std::vector<vtkIdType>& globalIds, bool isContinued,
  const std::function<void(const std::string&)>& warn, std::vector<std::string> replaced)
{
  PointArrayOptions arrays;
  arrays.InterpolateIntegers = options.InterpolateIntegers;
  arrays.HasMaterialFields = options.HasMaterialFields;
  arrays.Replaced = std::move(replaced);
  arrays.ChooseOriginalIds(input, options.GenerateOriginalIds, isContinued);
  arrays.Warn = warn;
  arrays.Precision = options.OutputPointsPrecision;
  if (options.GenerateLimitNormals)
  {
    arrays.Replaced.emplace_back(LimitNormalsName);
  }
  if (options.GenerateTangents)
  {
    arrays.Replaced.insert(arrays.Replaced.end(), { LimitTangentNames[0], LimitTangentNames[1] });
  }
  return std::make_unique<PointArrays>(
    input, cells, globalIds.data(), static_cast<vtkIdType>(globalIds.size()), arrays);
}

}
