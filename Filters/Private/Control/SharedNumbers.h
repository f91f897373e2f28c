// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedNumbers.h
 * Numbers what several partitions of a mesh have in the order in which the whole mesh has it.
 */
#ifndef SubdivisionObjects_SharedNumbers_h
#define SubdivisionObjects_SharedNumbers_h

#include "Core/Memory/IdSegments.h"
#include "Core/Memory/SimplexList.h"

#include "vtkType.h"

#include <array>
#include <functional>
#include <vector>

class vtkIdTypeArray;
class vtkPointSet;

namespace subdivision
{

class Partners;

/// Things by which partitions know each other's points, edges and cells: a key of `Width` ids each,
/// none of them negative. Equal keys are one thing, and the lexicographic order of keys is that of
/// the whole mesh.
struct SharedKeys
{
  int Width = 1;
  std::vector<vtkIdType> Keys;
  /// Of each thing, whether this partition is sure that it exists: it belongs to an own cell.
  std::vector<char> Own;
  /// How many ids of several kinds each thing gets: `Kinds` numbers for each. Empty: one of one
  /// kind.
  int Kinds = 1;
  std::vector<vtkIdType> Sizes;
};

struct SharedNumbers
{
  /// The number of ids before each thing in the whole mesh: `Kinds` of them; -1 where no partition
  /// is sure that it exists, or where this one is not and has another size: there its part ends.
  std::vector<vtkIdType> First;
  std::vector<vtkIdType> Totals; ///< of each kind
};

/**
 * Numbers the things of all partitions, which call this together. A directory, spread over the
 * partitions by the first id of the key, sorts what they send and answers: two exchanges, about 8
 * (Width + Kinds) bytes there and 8 Kinds bytes back for each thing.
 */
SharedNumbers NumberTogether(const SharedKeys& things, Partners& partners);

/// The same for control things of a kind, where varied segments (IdSegments.h) are further kinds of
/// ids, in the order of `lists`.
SharedNumbers NumberTogether(
  SharedKeys things, int kind, const std::vector<const IdSegments*>& lists, Partners& partners);

/// The ids that a list has in the whole mesh; -1 where things have none.
struct WholeIds
{
  std::vector<vtkIdType> Ids;
  vtkIdType Total = 0;
};

/// Finds the ids of lists of segments. `things`: of each kind its numbers.
std::vector<WholeIds> FindWholeIds(
  const std::vector<const IdSegments*>& lists, const std::vector<SharedNumbers>& things);
/// The same for one list, into an array; returns how many the whole mesh has.
vtkIdType FindWholeIds(
  const IdSegments& list, const std::vector<SharedNumbers>& things, vtkIdTypeArray* ids);

/// The place of each cell of an input in the order of the whole mesh. Poly data have their cells
/// kind by kind. All partitions call it.
std::vector<vtkIdType> PlaceCells(vtkPointSet* input, Partners& partners);
/// Adds keys to things that are pieces of cells, those of a cell one after the other: the place of
/// their cell, and which of its pieces they are; and whether the cell is own.
SharedKeys MakeKeysOfPieces(
  const std::vector<vtkIdType>& cells, const std::vector<vtkIdType>& places, Partners& partners);

/// Which points of an input or output cells use that are made of own input cells; `inputCells`: of
/// each cell; empty: each is itself.
std::vector<char> FindOwnPoints(
  vtkPointSet* mesh, const std::vector<vtkIdType>& inputCells, const Partners& partners);
/// The same where `isOwn` knows the cells of the mesh.
std::vector<char> FindOwnPoints(vtkPointSet* mesh, const std::function<bool(vtkIdType)>& isOwn);

/// Keys of the vertices of simplices that are no points of the input but centres, by the pieces
/// that they are first in: the first id of these, and which centre of their cell each is.
SharedKeys MakeCentreKeys(vtkIdType points, const SimplexView& simplices, const SharedKeys& pieces);

/// Numbers the vertices of simplices, which are such pieces: points of the input, of which there
/// are `points`, by their ids, then centres in the order in which cells first use them.
SharedNumbers NumberVertices(
  vtkIdType points, const SimplexView& simplices, const SharedKeys& pieces, Partners& partners);

}

#endif
