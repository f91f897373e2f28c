// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/OperatorCache.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"

namespace subdivision
{

template <typename Id>
template <typename Level>
LimitOperators<Id>::LimitOperators(const Level& level, const SemiSharpStages<Id>& creases,
  const ControlSolids& solids, bool project, bool generateNormals, bool generateTangents)
  : HasNormals(generateNormals)
  , HasTangents(generateTangents)
{
  if (project)
  {
    this->Rows = BuildLimitRows(level, creases);
  }
  if (generateNormals || generateTangents)
  {
    this->Tangents = BuildLimitTangents(level, creases, solids);
  }
}

template <typename Id>
void LimitOperators<Id>::Apply(PointArrays& arrays, const std::vector<vtkIdType>& inverted,
  const Buffer<unsigned char>& turned) const
{
  const vtkIdType size = arrays.GetPoints()->GetNumberOfTuples();
  if (this->HasTangents)
  {
    Buffer<double> values[2] = { Buffer<double>(3 * size), Buffer<double>(3 * size) };
    ComputeLimitTangents(this->Tangents, arrays.GetCoordinates(), inverted, turned,
      values[0].data(), values[1].data());
    arrays.SetLimitTangents(values);
  }
  if (this->HasNormals)
  {
    Buffer<double> normals(3 * size);
    ComputeLimitNormals(this->Tangents, arrays.GetCoordinates(), inverted, turned, normals.data());
    arrays.SetLimitNormals(normals);
  }
  arrays.Project(this->Rows);
}

SUBDIVISION_COMPILE(struct LimitOperators);

#define SUBDIVISION_LIMIT_OPERATORS(Scheme)                                                        \
  template LimitOperators<Scheme::Id>::LimitOperators(const Scheme::Level&,                        \
    const SemiSharpStages<Scheme::Id>&, const ControlSolids&, bool, bool, bool)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_LIMIT_OPERATORS);

}
