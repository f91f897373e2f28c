// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Layers.h
 * Brings the cells of other partitions that lie around the cells of a partition.
 */
#ifndef SubdivisionObjects_Layers_h
#define SubdivisionObjects_Layers_h

#include "Private/Distribution/JoinedMesh.h"
#include "Private/Partitions/OtherPartitions.h"

#include <map>
#include <vector>

namespace subdivision
{

/// Which cells of its own a partition has sent to others: by their number, of each of its parts, 1
/// for each cell that was sent.
using Copies = std::map<int, std::vector<std::vector<char>>>;

/// The cells that a partition sent and got, so that it can send new values of them.
struct SentLayers
{
  struct Cells
  {
    size_t Part;
    std::vector<vtkIdType> Points;
    std::vector<vtkIdType> Cells;
  };
  Copies OfFirst;                        ///< for the first layer
  std::map<int, std::vector<Cells>> Out; ///< to each partition, in this order
  std::map<int, std::vector<size_t>> In; ///< from each partition: the parts that were added
};

/**
 * Adds to the parts of a partition the cells of all others that share a point with one of its
 * cells, then the cells that share a point with these, and so on, `layers` times, with their points
 * and arrays. Of cells of any dimension, and through third partitions. Points and cells have ids
 * (IdentifyPoints). All partitions call this together.
 *
 * A directory knows which partitions have cells at a point; it is spread over the partitions by the
 * id of the point. Three exchanges for each layer. A partition sends 16 bytes for each of its
 * points, and each cell once to each partition that needs it.
 *
 * The descendants of a control simplex (MeshPart::Levels) travel together, and its corners are the
 * points that count. Then one exchange more brings the simplices that lie inside the last layer:
 * without them lines and triangles that are faces of its solids would be numbered in another order.
 *
 * Returns the cells that the partition sent and got.
 */
SentLayers AddLayers(std::vector<MeshPart>& parts, int layers, Exchange& exchange);

/// Gives the parts that AddLayers added the values that their cells have now. One exchange, of
/// coordinates and arrays.
void SendValuesAgain(std::vector<MeshPart>& parts, const SentLayers& sent, Exchange& exchange);

}

#endif
