// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceSubdivision.h
 * Does the work of vtkSurfaceSubdivision without Adaptive.
 */
#ifndef SubdivisionObjects_SurfaceSubdivision_h
#define SubdivisionObjects_SurfaceSubdivision_h

#include "Core/Surfaces/Steps/SurfaceSchemes.h"
#include "Private/Control/RunOptions.h"

#include <memory>
#include <vector>

class vtkPolyData;

namespace subdivision
{

/// What a surface filter keeps between executions: the levels of each mesh that it saw in its last
/// update.
class SurfaceCache
{
public:
  /// The levels of one mesh, for either type of ids.
  struct Kept
  {
    virtual ~Kept() = default;
    virtual std::size_t GetMemorySize() const = 0;
    bool Used = true;
  };
  std::vector<std::unique_ptr<Kept>> Entries;
  /// How often topology was built since the cache exists.
  vtkIdType NumberOfBuilds = 0;

  /// Forgets the levels that were not used since the last call.
  void ForgetUnused();
  std::size_t GetMemorySize() const;
};

struct SurfaceOptions : RunOptions
{
  SurfaceSchemeKind Scheme = SurfaceSchemeKind::Loop;
  int Levels = 1;
  bool ModifiedBoundary = true;
  bool ProjectToLimit = false;
  bool GenerateLimitNormals = false;
  bool GenerateTangents = false;
  bool Use32BitIds = false;
  bool JoinSeams = true;
  /// Point arrays of the input, null where there is none: angles in degrees, flatness s.
  vtkSmartPointer<vtkDataArray> Angles;
  vtkSmartPointer<vtkDataArray> Flatness;
  /// Where levels are kept; null: nowhere.
  SurfaceCache* Cache = nullptr;
};

/// Returns false after an error (passed to Fail) or if Progress asks to stop. The caller then
/// empties the output.
bool SubdivideSurface(vtkPolyData* input, const SurfaceOptions& options, vtkPolyData* output);

}

#endif
