// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridKept.h
 * The data that a filter keeps between executions for a mesh whose cells keep their types: the
 * levels and the cells of the output.
 */
#ifndef SubdivisionObjects_HybridKept_h
#define SubdivisionObjects_HybridKept_h

#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/PointArrays.h"
#include "Private/Run/KeptEntries.h"
#include "Private/Uniform/HybridInput.h"
#include "Private/Uniform/HybridOutput.h"
#include "Private/Uniform/OperatorCache.h"

#include <vector>

namespace subdivision
{

/// The levels of a mesh, whose rows are made again in each execution: stored rows would take some
/// times as much memory as the level that they are made of.
template <typename Id>
struct KeptHybrid : KeptEntry
{
  HybridRules Rules = HybridRules::Smooth;
  bool Use32BitIds = false;
  std::vector<vtkIdType> ControlSources; ///< the cell of the input of each control cell
  HybridChoices Choices;                 ///< for smooth rules
  std::vector<int> Colours; ///< of materials, of each control cell; empty: no array has weights

  std::vector<HybridLevel<Id>> Levels; ///< before each step
  HybridOutput<Id> Output;             ///< none where it has octahedra, which are cut by the points
  SharedArrays Handed;                 ///< of Output
  LimitOperators<Id> Limit;            ///< normals and tangents; none: nobody asked for them yet

  /// Whether cells equal the control mesh, and nobody wrote into the output's cells.
  bool HasCells(const CellList<Id>& cells) const;
  /// Keeps the output's cells, unless they depend on points.
  void TakeOutput(HybridOutput<Id> output);
  /// The parts of the last level that WriteHybridCells reads.
  CellComplex<Id> CopyLast() const;
  std::size_t GetMemorySize() const override;
};

}

#endif
