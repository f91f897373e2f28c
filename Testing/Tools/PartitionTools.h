// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PartitionTools.h
 * Parts of a mesh, and whether what a filter makes of them is what it makes of the whole.
 */
#ifndef SubdivisionObjects_PartitionTools_h
#define SubdivisionObjects_PartitionTools_h

#include "MultiDimensionalSubdivisionTools.h"

#include "Private/Distribution/Distribution.h"
#include "Private/Partitions/OtherPartitions.h"

#include "vtkPointSet.h"

#include <atomic>

namespace partition_tools
{

using Mesh = vtkSmartPointer<vtkPointSet>;

/// The cell array by which cells of parts and of the whole are compared.
constexpr const char* CellName = "NumberOfCell";

/// Numbers the cells, so that parts of the mesh know which they have.
void NumberCells(vtkPointSet* mesh);

constexpr const char* WantedName = "Wanted";
constexpr const char* FieldName = "Field";

/// Adds what criteria read: a wanted level that is high in few cells, and a field with a front.
void AddFields(vtkPointSet* mesh);

/// The built-in models and a box with cells of all kinds, with arrays and numbers.
std::vector<Mesh> MakeMeshes();

/// The surfaces, curves and points of a mesh, with numbers.
Mesh MakeSkin(vtkPointSet* mesh);

enum class KnownBy
{
  Coordinates,
  GlobalIds ///< of points and cells: their indices in the whole
};

/// Parts of a mesh: `partOf[c]` is that of cell c. Points that no cell uses go to the first part.
std::vector<Mesh> Cut(vtkPointSet* whole, const std::vector<int>& partOf, int parts, KnownBy known);

/// Each cell goes to a part by chance.
std::vector<int> CutByChance(vtkPointSet* whole, int parts, unsigned seed);

/// Slabs along x.
std::vector<int> CutInSlabs(vtkPointSet* whole, int parts);

/// A way to cut a mesh.
struct Partition
{
  const char* Name;
  int Parts;
  int Blocks; ///< of each part
  bool ByChance;
  KnownBy Known = KnownBy::GlobalIds;
  int Empty = 0; ///< parts without cells before these
};

/// Ways that differ enough for most tests.
inline const Partition CommonPartitions[] = { { "halves", 2, 1, false },
  { "slabs after an empty part", 3, 2, false, KnownBy::GlobalIds, 1 },
  { "cell by cell", 3, 1, true }, { "cell by cell on many", 8, 1, true, KnownBy::GlobalIds, 2 } };

std::vector<Mesh> Cut(vtkPointSet* whole, const Partition& partition);

/// What a filter makes of the parts of a mesh. Returns whether it is done.
bool RunOnParts(const std::vector<Mesh>& cut, const Partition& partition,
  const subdivision::DistributionOptions& distribution, subdivision::RunOptions& options,
  const subdivision::FilterWork& work, std::vector<Mesh>& outputs);

/// The whole mesh as parts have it that know their points by coordinates only: its points are
/// numbered as they come.
Mesh Renumber(const std::vector<Mesh>& cut);

/// Counts the exchanges of a round, which begins with a sum of marks and ends with one of cells.
class CountingExchange : public subdivision::OtherPartitions
{
public:
  CountingExchange(OtherPartitions* of, std::atomic<int>& most)
    : Of(of)
    , Most(most)
  {
  }
  int GetPartition() const override { return this->Of->GetPartition(); }
  int GetNumberOfPartitions() const override { return this->Of->GetNumberOfPartitions(); }
  const std::vector<vtkIdType>& GetPointIds() const override { return this->Of->GetPointIds(); }
  const std::vector<vtkIdType>& GetCellIds() const override { return this->Of->GetCellIds(); }
  bool IsOwn(vtkIdType cell) const override { return this->Of->IsOwn(cell); }
  const std::vector<int>& GetNeighbours(vtkIdType cell) const override
  {
    return this->Of->GetNeighbours(cell);
  }
  bool Send(Messages& messages) override
  {
    const bool hasSent = this->Of->Send(messages);
    this->Sent += hasSent ? 1 : 0;
    if (this->Sent > this->Most && this->IsInRound)
    {
      this->Most = this->Sent;
    }
    return hasSent;
  }
  std::vector<vtkIdType> Gather(vtkIdType own) override
  {
    this->Sent = 0;
    this->IsInRound = true;
    return this->Of->Gather(own);
  }

private:
  OtherPartitions* Of;
  std::atomic<int>& Most;
  int Sent = 0;
  bool IsInRound = false;
};

/// Whether the parts of an output have the cells of the whole output, each once, with the same
/// points, coordinates and arrays, bit for bit. Both come from meshes with NumberCells.
void ExpectWhole(vtkPointSet* whole, const std::vector<Mesh>& parts);

/// Whether global ids of the parts of an output are the indices of the whole, and each cell is
/// there once.
void ExpectIndices(vtkPointSet* whole, const std::vector<Mesh>& parts);

/// Whether the ghost cells of a part of an output are the cells of the whole output that share a
/// point with its own. Cells are told apart by the places of their points.
void ExpectGhosts(vtkPointSet* whole, vtkPointSet* part);

}

#endif
