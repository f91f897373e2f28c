// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedNumbers.h
 * Numbers the points, edges and cells of several partitions of a mesh in the order of the whole
 * mesh.
 */
#ifndef SubdivisionObjects_SharedNumbers_h
#define SubdivisionObjects_SharedNumbers_h

#include "Core/Memory/IdSegments.h"
#include "Core/Memory/SimplexList.h"
#include "Private/Partitions/SharedDirectory.h"

#include "vtkType.h"

#include <array>
#include <functional>
#include <vector>

class vtkIdTypeArray;
class vtkPointSet;

namespace subdivision
{

struct SimplicesOfCells;

struct SharedNumbers
{
  /// The number of ids before each thing in the whole mesh: `Kinds` of them; -1 where no partition
  /// is sure that it exists, or where this one is not and has another size: there its part ends.
  std::vector<vtkIdType> First;
  std::vector<vtkIdType> Totals; ///< of each kind
};

/**
 * Numbers the things of all partitions, which call this together. The directory sorts their
 * messages and answers: two exchanges, 8 (Width + Kinds) bytes there and 8 Kinds bytes back for
 * each thing.
 */
SharedNumbers NumberTogether(const SharedKeys& things, OtherPartitions& others);

/// The same for control things of a kind, where varied segments (IdSegments.h) are further kinds of
/// ids, in the order of `lists`.
SharedNumbers NumberTogether(SharedKeys things, int kind,
  const std::vector<const IdSegments*>& lists, OtherPartitions& others);

/// The ids that things have in the whole mesh; -1 where they have none.
struct WholeIds
{
  std::vector<vtkIdType> Ids;
  vtkIdType Total = 0;

  /// Numbers things, of one kind, after all that are there. `places` in Ids; empty: the places at
  /// the end.
  void Add(
    const SharedKeys& things, OtherPartitions& others, const std::vector<vtkIdType>& places = {});
};

/// The numbers of points and cells of an output in the whole output.
struct WholeNumbers
{
  WholeIds Points;
  WholeIds Cells;

  /// Adds them as arrays to an output.
  void Write(vtkPointSet* output) const;
};

/// Finds the ids of lists of segments. `things`: of each kind its numbers.
std::vector<WholeIds> FindWholeIds(
  const std::vector<const IdSegments*>& lists, const std::vector<SharedNumbers>& things);
/// The same for one list, into an array; returns how many the whole mesh has.
vtkIdType FindWholeIds(
  const IdSegments& list, const std::vector<SharedNumbers>& things, vtkIdTypeArray* ids);

/// The place of each cell of an input in the order of the whole mesh. Poly data have their cells
/// kind by kind. All partitions call it.
std::vector<vtkIdType> PlaceCells(vtkPointSet* input, OtherPartitions& others);
/// Adds keys to things that are pieces of cells, the pieces of a cell one after the other: the
/// place of their cell, and which of its pieces they are; and whether the cell is own.
SharedKeys MakeKeysOfPieces(const std::vector<vtkIdType>& cells,
  const std::vector<vtkIdType>& places, OtherPartitions& others);
/// The same for the simplices of cells.
SharedKeys MakeKeysOfPieces(
  const SimplicesOfCells& simplices, const std::vector<vtkIdType>& places, OtherPartitions& others);

/// Which points of an input or output cells use that are made of own input cells; `inputCells`: of
/// each cell; empty: each is itself.
std::vector<char> FindOwnPoints(
  vtkPointSet* mesh, const std::vector<vtkIdType>& inputCells, const OtherPartitions& others);
/// The same where `isOwn` knows the cells of the mesh.
std::vector<char> FindOwnPoints(vtkPointSet* mesh, const std::function<bool(vtkIdType)>& isOwn);

/// Keys of the vertices of simplices that are no points of the input but centres, by the pieces
/// that they are first in: the first id of these, and which centre of their cell each is.
SharedKeys MakeCentreKeys(vtkIdType points, const SimplexView& simplices, const SharedKeys& pieces);

/// Numbers the points of the input, of which there are at most `points`, by their ids.
WholeIds NumberPoints(vtkIdType points, OtherPartitions& others);
/// The same for the vertices of simplices that are such pieces: points of the input, of which there
/// are `points`, then centres in the order in which cells first use them.
WholeIds NumberVertices(vtkIdType points, const SimplexView& simplices, const SharedKeys& pieces,
  OtherPartitions& others);
/// Numbers the cells of an output, which have the order of the input cells that they are parts of;
/// `places`: PlaceCells, `sources`: of each its input cell.
WholeIds NumberCells(const std::vector<vtkIdType>& places, const std::vector<vtkIdType>& sources,
  OtherPartitions& others);

}

#endif
