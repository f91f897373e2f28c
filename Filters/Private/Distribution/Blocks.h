// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Blocks.h
 * The blocks of the input and of the output of a filter.
 */
#ifndef SubdivisionObjects_Blocks_h
#define SubdivisionObjects_Blocks_h

#include "Private/Distribution/JoinedMesh.h"

#include <functional>
#include <string>

class vtkDataObject;
class vtkFieldData;

namespace subdivision
{

/// The cell array with the composite index of the block that a cell is from.
constexpr const char* BlockIndexName = "SubdivisionBlockIndex";

/// A block, or the whole input where it is no composite data set.
struct Block
{
  vtkSmartPointer<vtkPointSet> Input;
  vtkSmartPointer<vtkPointSet> Output;
  unsigned int CompositeIndex = 0;
};

/// The blocks of a data object that have points; null: none. `isOfSurfaces`: vtkPolyData only, else
/// vtkUnstructuredGrid too; `warn` is told of other blocks.
std::vector<Block> GetBlocks(
  vtkDataObject* input, bool isOfSurfaces, const std::function<void(const std::string&)>& warn);

/// Replaces inputs by copies with further arrays: with `addIndex` the cell array
/// BlockIndexName, and the arrays that `prepare` adds to the copy.
void PrepareBlocks(std::vector<Block>& blocks, bool addIndex,
  const std::function<void(vtkPointSet*, vtkPointSet*)>& prepare);

/// Writes the outputs of the blocks: into a composite data set of the structure of `input`, in
/// which a block without points is empty, or, if `input` is a single mesh, into `output` itself.
void SetOutputs(
  vtkDataObject* input, const std::vector<Block>& blocks, bool isOfSurfaces, vtkDataObject* output);

/// Adds to points that no cell uses the number of their block, so that the block can take them.
void AddPointBlocks(const std::vector<MeshPart>& parts, JoinedMesh& joined);

struct OutputOptions
{
  /// Whether points have the type that they have in the block.
  bool OwnPrecision = true;
  /// How many layers of cells of others around its own a block gets, marked as duplicates
  /// (vtkGhostType), and so are the points that only these have.
  int GhostLayers = 0;
  /// Whether to add global ids: the numbers in the whole output.
  bool GlobalIds = false;
};

/// Writes the outputs of blocks: their cells and points of `whole`, with the arrays that the block
/// had and the arrays that the filter made, original ids that count the block's own points and
/// cells, and its field data.
void TakeOutputs(const JoinedMesh& joined, vtkPointSet* whole, const OutputOptions& options,
  std::vector<Block>& blocks);

/// Shares field arrays; `withStamp`: also the arrays of a stamp.
void AddFieldData(vtkFieldData* from, bool withStamp, vtkFieldData* to);

/// Adds global ids to the points and cells of an output that is the whole: their indices.
void AddGlobalIds(vtkPointSet* output);

}

#endif
