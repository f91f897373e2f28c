// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Distribution.h
 * Runs a filter on blocks of a composite data set, and on the partitions of several ranks, as if
 * they were one mesh.
 */
#ifndef SubdivisionObjects_Distribution_h
#define SubdivisionObjects_Distribution_h

#include "Private/Distribution/Blocks.h"
#include "Private/Distribution/PartitionsOfRank.h"
#include "Private/Run/FilterRun.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkInformationVector;
class vtkMultiProcessController;

namespace subdivision
{

class KeptParts;

struct DistributionOptions
{
  /// Whether blocks that share points are one mesh. If not, each block is subdivided by itself.
  bool JoinBlocks = true;
  /// The ranks that have partitions of the mesh; null: this process has all.
  vtkMultiProcessController* Controller = nullptr;
  /// How many layers of cells around its own a rank needs so that its own results are the results
  /// of the whole mesh.
  int Layers = 2;
  /// The parts that are kept for the next execution; null: none.
  KeptParts* Kept = nullptr;
  /// How many layers of fine cells of other ranks the output gets, marked as duplicates.
  int GhostLayers = 0;
  /// Whether only vtkPolyData is accepted, and made; else vtkUnstructuredGrid is accepted too, and
  /// made.
  bool IsOfSurfaces = false;
  /// Whether to add the array BlockIndexName.
  bool AddBlockIndex = false;
  /// Whether points may have another value in each block (OwnValues.h), and copies of points that
  /// an earlier filter made are one point.
  bool KeepsOwnValues = false;
  /// Whether the work takes such copies too where it finds the array OwnBlockName, and the values
  /// of blocks differ.
  bool ReadsOwnBlocks = false;
  /// Set to whether blocks are several cases, some of whose points are at one place; may be null.
  bool* HasCases = nullptr;
  /// Warnings of earlier changes of the input.
  std::vector<std::string> Warnings;
  /// Adds to a copy of a block, which is its second argument, the filter's knowledge of the block.
  std::function<void(vtkPointSet*, vtkPointSet*)> Prepare;
  /// Changes cells of a mesh, of one block or of several that are joined, before the work; empty:
  /// nothing.
  std::function<vtkSmartPointer<vtkPointSet>(vtkPointSet*)> Change;
};

/// Gives the pipeline the data object for the output: a composite data set of the class of the
/// input, if that is one, else a mesh.
void RequestOutput(vtkDataObject* input, bool isOfSurfaces, vtkInformationVector* outputVector);

/**
 * Runs a filter on an input of any kind: a single mesh, or a composite data set, whose output has
 * the same structure, names and field data.
 *
 * If this is the only rank and the input is a single mesh, this is RunFilter. Else the blocks of
 * this rank (IdentifyPoints) and the cells around them that other ranks have (AddLayers) are joined
 * (Join), `work` is done on the result, and each block of the output takes the cells that came from
 * it. Duplicate (ghost) cells of the input are left out; the output has the duplicate cells that
 * GhostLayers asks for.
 *
 * Field arrays `SubdivisionBlockPoints` and `SubdivisionBlockCells` of the output say where its
 * points and cells are in the whole output (StampedParts.h); with them, a filter that gets all
 * blocks, or all parts on their ranks, goes on with the work of an earlier filter.
 *
 * All ranks call this together. They agree on going on after they read, and at the end; if one
 * fails, all fail, and rank 0 gives the message of the first that did.
 */
int RunDistributed(vtkAlgorithm* filter, vtkDataObject* input, vtkDataObject* output,
  const DistributionOptions& distribution, const FilterTraits& traits, RunOptions& options,
  const FilterWork& work);

/// Runs a filter on each block of the input by itself, without other ranks. The output is empty if
/// the user stops the filter in any of them.
int RunOnBlocks(vtkAlgorithm* filter, vtkDataObject* input, vtkDataObject* output,
  const FilterTraits& traits, RunOptions& options, const FilterWork& work);

/// RunDistributed for partitions whose blocks are given: the partitions of this rank, of which
/// tests and benchmarks have several.
bool RunPartitions(std::vector<std::vector<Block>>& blocks, PartitionsOfRank& partitions,
  const DistributionOptions& distribution, const FilterTraits& traits, RunOptions& options,
  const FilterWork& work);

}

#endif
