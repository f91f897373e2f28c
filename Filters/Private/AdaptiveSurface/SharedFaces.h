// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedFaces.h
 * Adaptive sqrt(3) refinement of a surface of which several partitions have parts.
 */
#ifndef SubdivisionObjects_SharedFaces_h
#define SubdivisionObjects_SharedFaces_h

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Private/AdaptiveSurface/AdaptiveSurfaceMarks.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Surface/SurfaceCells.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace subdivision
{

// ------------------------------------------------------------------------------------------------
// Messages

/**
 * Passes on splits between partitions. Each marks its own faces, and splits in its copies of other
 * faces all that must be split before. It sends the splits that are in its own faces, or beside
 * them, to the partitions that have copies of these. They split these faces, and all that must be
 * split before, and so on, until nobody has anything new. As the set of split faces does not depend
 * on the order of splits, it is then the same as in the whole surface in all faces that share a
 * point with an own one.
 *
 * Faces that must be split before a face are at most two layers of control faces away from it: one
 * for the control faces themselves, and less than one for the smaller faces of all later levels. So
 * with three layers of copies (LayersOfAdaptiveSurface) no split comes near to the outermost edges,
 * at which the copies have a boundary and the surface has none.
 *
 * A face is known to others by its control face and by which child it is of each face between.
 */
template <typename Id>
class SharedFaces
{
public:
  SharedFaces(const SurfaceCells& cells, const SurfaceLevel<Id>& control,
    AdaptiveSqrtThree<Id>& mesh, OtherPartitions& others)
    : Cells(cells)
    , Mesh(mesh)
    , Others(others)
    , OwnLines(mesh.GetNumberOfSegments(), 0)
    , Carriers(mesh)
  {
    for (const std::size_t f : InTurn(cells.FaceCells.size()))
    {
      const vtkIdType cell = cells.FaceCells[f];
      const bool isFirst = f == 0 || cell != cells.FaceCells[f - 1];
      this->FirstOfCell.push_back(isFirst ? static_cast<Id>(f) : this->FirstOfCell.back());
      this->FirstFaces.emplace(others.GetCellIds()[cell], this->FirstOfCell.back());
      this->Scope.Faces.push_back(others.IsOwn(cell) ? 1 : 0);
      this->OwnGiven += this->Scope.Faces.back();
    }
    for (const vtkIdType cell : InTurn(cells.VertexCells))
    {
      this->OwnGiven += others.IsOwn(cell) ? 1 : 0;
    }
    for (const vtkIdType line : InTurn(control.Lines.size()))
    {
      const int own = others.IsOwn(cells.SegmentCells[line]) ? 1 : 0;
      this->OwnLines[mesh.GetSegmentOfEdge(control.Lines[line] / 2)] += own;
      this->OwnGiven += own;
    }
    for (const vtkIdType s : InTurn(mesh.GetNumberOfSegments()))
    {
      const auto& segment = mesh.GetSegmentAt(static_cast<Id>(s));
      bool isAtOwn = this->OwnLines[s] > 0;
      for (Id i = 0; i < segment.NumberOfSides; ++i)
      {
        isAtOwn = isAtOwn || this->IsOwn(mesh.GetSide(segment, i) / 3);
      }
      this->Scope.Segments.push_back(isAtOwn ? 1 : 0);
    }
    this->Restart();
  }

  const AdaptiveScope& GetScope() const { return this->Scope; }
  /// Does the splits of a round. Returns false if there would be more than `mostCells` cells here;
  /// then some are missing.
  bool Split(const std::vector<AdaptiveMark<Id>>& marks, std::size_t count, vtkIdType mostCells)
  {
    bool fits = true;
    for (std::size_t i = 0; i < count && fits; ++i)
    {
      const Id face = marks[i].Face;
      fits = face < 0 ? this->Mesh.Cut(-1 - face, mostCells) : this->Mesh.Split(face, mostCells);
    }
    for (;;)
    {
      Paths paths = this->TakeNew();
      if (!this->Others.SendLists(paths))
      {
        return fits;
      }
      fits = fits && this->Receive(paths, mostCells);
    }
  }

  /// The mesh is again as it was when a round began.
  void Restart()
  {
    this->Carriers.Restart();
    this->Carriers.Continue();
    this->Known = this->Mesh.GetNumberOfSplits();
    this->OwnSplits = 0;
    for (vtkIdType i = 0; i < this->Known; ++i)
    {
      this->OwnSplits += this->IsOwn(this->Carriers[this->Mesh.GetSplit(i)].GetSmallest()) ? 1 : 0;
    }
  }
  /// The number of triangles, pieces of line cells and vertex cells. Its sum over all partitions is
  /// the number of the whole surface.
  /// A split makes two more triangles, and so does the cut of a line.
  vtkIdType CountOwnCells() const
  {
    vtkIdType count = this->OwnGiven + 2 * this->OwnSplits;
    std::vector<int> lines = this->OwnLines;
    for (const Id s : InTurn(this->Mesh.GetNumberOfSegments()))
    {
      const auto& segment = this->Mesh.GetSegmentAt(s);
      if (segment.Parent >= 0)
      {
        lines.push_back(lines[segment.Parent]);
      }
      count += segment.Children >= 0 ? 2 * lines[s] : 0;
    }
    return count;
  }

private:
  /// Where a face is: four children in a byte.
  struct Path
  {
    vtkIdType Cell;
    std::int32_t Triangle; ///< of the cell
    std::int32_t Level;
    std::array<unsigned char, 16> Children;
  };

  bool IsOwn(Id controlFace) const { return this->Scope.Faces[controlFace] != 0; }
  /// Adds the partitions that have copies of the own control faces in which a face lies.
  void AddHolders(Id face, std::vector<int>& partitions) const
  {
    const Carrier<Id>& carrier = this->Carriers[face];
    for (const Id control : { carrier.First, carrier.Second })
    {
      if (this->IsOwn(control))
      {
        const auto& holders = this->Others.GetNeighbours(this->Cells.FaceCells[control]);
        partitions.insert(partitions.end(), holders.begin(), holders.end());
      }
    }
  }
  Path FindPath(Id face) const
  {
    Path path{};
    path.Level = this->Mesh.GetLevel(face);
    for (int level = path.Level; level-- > 0;)
    {
      const Id parent = this->Mesh.GetParent(face);
      const int child = static_cast<int>(face - this->Mesh.GetChild(3 * parent));
      path.Children[level / 4] |= static_cast<unsigned char>(child << (2 * (level % 4)));
      face = parent;
    }
    path.Cell = this->Others.GetCellIds()[this->Cells.FaceCells[face]];
    path.Triangle = static_cast<std::int32_t>(face - this->FirstOfCell[face]);
    return path;
  }

  using Paths = Exchange::Lists<Path>; ///< of split faces
  /// The splits that no other partition was told of, for the partitions with copies of the faces.
  Paths TakeNew()
  {
    this->Carriers.Continue();
    Paths paths;
    std::vector<int> to;
    for (; this->Known < this->Mesh.GetNumberOfSplits(); ++this->Known)
    {
      const Id face = this->Mesh.GetSplit(this->Known);
      this->OwnSplits += this->IsOwn(this->Carriers[face].GetSmallest()) ? 1 : 0;
      to.clear();
      this->AddHolders(face, to);
      for (Id corner = 3 * face; corner < 3 * face + 3; ++corner)
      {
        // An own face marks the faces beside it too.
        if (this->Mesh.GetTwin(corner) >= 0)
        {
          this->AddHolders(this->Mesh.GetTwin(corner) / 3, to);
        }
      }
      SortDistinct(to);
      for (const int partition : to)
      {
        paths[partition].push_back(this->FindPath(face));
      }
    }
    return paths;
  }
  bool Receive(const Paths& paths, vtkIdType mostCells)
  {
    for (const auto& [from, list] : paths)
    {
      for (const Path& path : list)
      {
        if (!this->SplitAt(path, mostCells))
        {
          return false;
        }
      }
    }
    return true;
  }
  /// Splits the face of a path, and before it the faces on the way. A child between two faces is
  /// there when the second one is split, too.
  bool SplitAt(const Path& path, vtkIdType mostCells)
  {
    const auto found = this->FirstFaces.find(path.Cell);
    if (found == this->FirstFaces.end())
    {
      return true;
    }
    Id face = found->second + static_cast<Id>(path.Triangle);
    for (int level = 0; level < path.Level; ++level)
    {
      const int child = path.Children[level / 4] >> (2 * (level % 4)) & 3;
      const Id corner = 3 * face + static_cast<Id>(child);
      if (!this->Mesh.Split(face, mostCells) ||
        (!this->Mesh.IsThere(this->Mesh.GetChild(corner)) &&
          !this->Mesh.Split(this->Mesh.GetTwin(corner) / 3, mostCells)))
      {
        return false;
      }
      face = this->Mesh.GetChild(corner);
    }
    return this->Mesh.Split(face, mostCells);
  }

  const SurfaceCells& Cells;
  AdaptiveSqrtThree<Id>& Mesh;
  OtherPartitions& Others;
  AdaptiveScope Scope;
  vtkIdType OwnGiven = 0;                       ///< cells of the input
  std::vector<int> OwnLines;                    ///< on each control segment
  std::vector<Id> FirstOfCell;                  ///< of each control face: the first of its cell
  std::unordered_map<vtkIdType, Id> FirstFaces; ///< by the id of the cell
  AdaptiveSqrtThreeCarriers<Id> Carriers;
  vtkIdType OwnSplits = 0;
  vtkIdType Known = 0; ///< splits that were sent
};

}

#endif
