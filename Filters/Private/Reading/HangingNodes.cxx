// SPDX-License-Identifier: BSD-3-Clause
//
// The steps: find the faces and edges that no two cells share; ask a tree of their points which of
// them lie on which face or edge; for each edge list its points, for each face the faces that cover
// it; write the cells that have such an edge or face anew.
#include "Private/Reading/HangingNodes.h"

#include "Core/Memory/Sorting.h"
#include "Core/Solids/Location/SimplexTree.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/CellFaces.h"
#include "Private/Reading/FlatPart.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace subdivision
{
namespace
{

using Loop = std::vector<vtkIdType>;
using Edge = std::pair<vtkIdType, vtkIdType>;

Edge MakeEdge(vtkIdType a, vtkIdType b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// A face of a solid that no other solid has.
struct OpenFace
{
  vtkIdType Cell;
  Loop Points; ///< looks outwards
  Loop Inside; ///< points inside of it
};

/// Whether a cell can have other points.
bool CanChange(int type)
{
  return !IsNonLinear(type) && type != VTK_TRIANGLE_STRIP;
}

class Closing
{
public:
  explicit Closing(vtkPointSet* mesh)
    : Mesh(mesh)
    , Cells(mesh)
    , Checked(CheckCells(mesh, this->Cells))
    , X(3 * mesh->GetNumberOfPoints())
  {
    this->ReadPoints();
    this->FindOpen();
  }
  /// Finds all points that hang. Returns false if there are none.
  bool Find()
  {
    for (OpenFace& face : InTurn(this->OpenFaces))
    {
      this->FindOn(face.Points.data(), static_cast<vtkIdType>(face.Points.size()), face.Inside);
    }
    Loop inside;
    this->ForEachLoop(
      [&](vtkIdType cell, int dimension, const vtkIdType* loop, vtkIdType size)
      {
        inside.clear();
        if (dimension < 3 && !this->Candidates.empty() && this->FindOn(loop, size, inside) &&
          !inside.empty())
        {
          this->Fail(cell);
        }
      });
    this->HasEdge = Buffer<unsigned char>(this->Mesh->GetNumberOfPoints(), 0);
    for (auto& [edge, points] : this->OnEdges)
    {
      std::sort(points.begin(), points.end());
      points.erase(std::unique(points.begin(), points.end()), points.end());
      this->HasEdge[edge.first] = 1;
      this->HasEdge[edge.second] = 1;
    }
    this->FindCovers();
    return !this->OnEdges.empty() || !this->Covered.empty();
  }
  vtkSmartPointer<vtkPointSet> Write()
  {
    static const int grown[4] = { VTK_POLY_VERTEX, VTK_POLY_LINE, VTK_POLYGON, FaceLoops };
    auto* surface = vtkPolyData::SafeDownCast(this->Mesh);
    vtkNew<vtkCellArray> lists[4];
    vtkNew<vtkUnsignedCharArray> types;
    CellFaces faces(this->Mesh, this->Cells);
    std::vector<vtkIdType> scratch;
    Loop points;
    for (const vtkIdType c : InTurn(this->Cells.GetNumberOfCells()))
    {
      CellIds ids = this->Cells.GetCell(c, scratch);
      int type = this->Cells.GetCellType(c);
      const int list = surface ? (type == VTK_TRIANGLE_STRIP ? 3 : GetDimensionOfType(type)) : 0;
      const bool takesPart = TakesPart(this->Checked.States[static_cast<std::size_t>(c)]);
      if (takesPart && this->WriteCell(c, faces, ids, points))
      {
        if (CanChange(type))
        {
          ids = { points.data(), static_cast<vtkIdType>(points.size()) };
          type = grown[GetDimensionOfType(type)];
        }
        else
        {
          this->Fail(c);
        }
      }
      lists[list]->InsertNextCell(ids.Size, ids.Ids);
      types->InsertNextValue(static_cast<unsigned char>(type));
    }
    auto made = vtkSmartPointer<vtkPointSet>::Take(this->Mesh->NewInstance());
    made->ShallowCopy(this->Mesh);
    if (surface)
    {
      auto* to = vtkPolyData::SafeDownCast(made);
      to->SetVerts(lists[0]);
      to->SetLines(lists[1]);
      to->SetPolys(lists[2]);
      to->SetStrips(lists[3]);
    }
    else
    {
      vtkUnstructuredGrid::SafeDownCast(made)->SetCells(types, lists[0]);
    }
    return made;
  }
  std::string Describe() const
  {
    if (this->Failed == 0)
    {
      return {};
    }
    return "CloseHangingNodes: " + std::to_string(this->Failed) +
      (this->Failed == 1
          ? " cell does not fit to those beside it, and cannot be cut so that it does "
            "(cell "
          : " cells do not fit to those beside them, and cannot be cut so that they do "
            "(the first is cell ") +
      std::to_string(this->FirstFailed) +
      "): cells come apart there. Make faces that cover each other whole, and apply Triangulate to "
      "strips and non-linear cells first.";
  }

private:
  /// Calls visit(cell, dimension, loop, size) for faces of solids, cells that are surfaces, and
  /// segments of lines.
  template <typename Visit>
  void ForEachLoop(const Visit& visit) const
  {
    CellFaces faces(this->Mesh, this->Cells);
    std::vector<vtkIdType> scratch;
    for (const vtkIdType c : InTurn(this->Cells.GetNumberOfCells()))
    {
      if (TakesPart(this->Checked.States[static_cast<std::size_t>(c)]))
      {
        this->VisitCell(c, faces, this->Cells.GetCell(c, scratch), visit);
      }
    }
  }

  template <typename Visit>
  void VisitCell(vtkIdType cell, CellFaces& faces, const CellIds& ids, const Visit& visit) const
  {
    const int dimension = GetDimensionOfType(this->Cells.GetCellType(cell));
    if (dimension >= 2)
    {
      faces.ForEach(cell, ids,
        [&](const vtkIdType* loop, vtkIdType size) { visit(cell, dimension, loop, size); });
    }
    for (vtkIdType i = 0; dimension == 1 && i + 1 < ids.Size; ++i)
    {
      visit(cell, 1, ids.Ids + i, 2);
    }
  }

  void ReadPoints()
  {
    Box box;
    for (const vtkIdType i : InTurn(this->Mesh->GetNumberOfPoints()))
    {
      this->Mesh->GetPoint(i, this->X.data() + 3 * i);
      const double* x = this->X.data() + 3 * i;
      if (x[0] - x[0] == 0. && x[1] - x[1] == 0. && x[2] - x[2] == 0.) // finite
      {
        box.Add(x);
      }
    }
    double half = 0.;
    for (int k = 0; k < 3; ++k)
    {
      half = std::max(half, 0.5 * box.High[k] - 0.5 * box.Low[k]);
    }
    ForEach(this->X.size(),
      [&](vtkIdType i)
      {
        const double middle = 0.5 * box.High[i % 3] + 0.5 * box.Low[i % 3];
        this->X[i] = half > 0. ? (this->X[i] - middle) / half : 0.;
      });
  }
  void FindOpen()
  {
    const std::vector<std::uint64_t> faces = this->ListSingles(3);
    const std::vector<std::uint64_t> edges = this->ListSingles(2);
    const auto isIn = [](const std::vector<std::uint64_t>& singles, std::uint64_t hash)
    { return std::binary_search(singles.begin(), singles.end(), hash); };
    Buffer<unsigned char> candidates(this->Mesh->GetNumberOfPoints(), 0);
    this->ForEachLoop(
      [&](vtkIdType cell, int of, const vtkIdType* loop, vtkIdType size)
      {
        const bool isOpen = of == 1 || (of == 3 && isIn(faces, HashLoop(loop, size)));
        if (isOpen && of == 3)
        {
          this->OpenFaces.push_back({ cell, Loop(loop, loop + size), {} });
        }
        for (vtkIdType i = 0; i < size; ++i)
        {
          const vtkIdType edge[2] = { loop[i], loop[(i + 1) % size] };
          if (isOpen || (of == 2 && isIn(edges, HashLoop(edge, 2))))
          {
            candidates[edge[0]] = 1;
            candidates[edge[1]] = 1;
          }
        }
      });
    this->MakeTree(candidates);
  }

  /// The hashes of the faces of solids (dimension 3), or the edges of surfaces, that are there
  /// once.
  std::vector<std::uint64_t> ListSingles(int dimension) const
  {
    std::vector<std::uint64_t> all;
    this->ForEachLoop(
      [&](vtkIdType, int of, const vtkIdType* loop, vtkIdType size)
      {
        if (of == 3 && dimension == 3)
        {
          all.push_back(HashLoop(loop, size));
        }
        for (vtkIdType i = 0; of == 2 && dimension == 2 && i < size; ++i)
        {
          const vtkIdType edge[2] = { loop[i], loop[(i + 1) % size] };
          all.push_back(HashLoop(edge, 2));
        }
      });
    KeepSingles(all);
    return all;
  }
  void MakeTree(const Buffer<unsigned char>& candidates)
  {
    for (const vtkIdType i : InTurn(candidates.size()))
    {
      if (candidates[i])
      {
        this->Candidates.push_back(i);
        this->TreePoints.insert(
          this->TreePoints.end(), this->X.data() + 3 * i, this->X.data() + 3 * i + 3);
      }
    }
    this->TreeIds = Buffer<int>(static_cast<vtkIdType>(this->Candidates.size()));
    ForEach(this->TreeIds.size(), [this](vtkIdType i) { this->TreeIds[i] = static_cast<int>(i); });
    this->Tree = SimplexTree(this->TreePoints.data(), 1, this->TreeIds);
  }
  FlatPart MakePart(const vtkIdType* loop, vtkIdType size) const
  {
    std::vector<const double*> corners;
    std::transform(loop, loop + size, std::back_inserter(corners),
      [this](vtkIdType id) { return this->X.data() + 3 * id; });
    return FlatPart(corners.data(), static_cast<int>(size));
  }
  /// Finds the points on a loop, which are noted with its edges, or go to `inside`.
  bool FindOn(const vtkIdType* loop, vtkIdType size, Loop& inside)
  {
    const FlatPart part = this->MakePart(loop, size);
    std::vector<vtkIdType> found;
    this->Tree.ForEachWhere([&](const Box& box) { return part.Meets(box); },
      [&](vtkIdType i)
      {
        const vtkIdType point = this->Candidates[static_cast<std::size_t>(i)];
        if (std::find(loop, loop + size, point) == loop + size &&
          part.Find(this->X.data() + 3 * point) == FlatPart::Inside)
        {
          found.push_back(point);
        }
      });
    std::vector<unsigned char> isOnEdge(found.size(), 0);
    for (vtkIdType i = 0; !found.empty() && i < size && (size > 2 || i == 0); ++i)
    {
      const Edge edge = MakeEdge(loop[i], loop[(i + 1) % size]);
      const vtkIdType ends[2] = { edge.first, edge.second };
      const FlatPart line = this->MakePart(ends, 2);
      for (std::size_t f = 0; f < found.size(); ++f)
      {
        const double* x = this->X.data() + 3 * found[f];
        if (line.Find(x) == FlatPart::Inside)
        {
          isOnEdge[f] = 1;
          this->OnEdges[edge].emplace_back(line.GetParameter(x), found[f]);
        }
      }
    }
    for (std::size_t f = 0; f < found.size(); ++f)
    {
      if (!isOnEdge[f])
      {
        inside.push_back(found[f]);
      }
    }
    return !found.empty();
  }
  /// Finds the faces that cover each face together.
  void FindCovers()
  {
    std::vector<std::pair<vtkIdType, std::size_t>> facesAt; // of points
    for (const std::size_t f : InTurn(this->OpenFaces.size()))
    {
      for (const vtkIdType point : this->OpenFaces[f].Points)
      {
        facesAt.emplace_back(point, f);
      }
    }
    StableSort(facesAt, std::less<>());
    Loop ring;
    for (const OpenFace& face : InTurn(this->OpenFaces))
    {
      const auto size = static_cast<vtkIdType>(face.Points.size());
      if (!this->Expand(face.Points.data(), size, ring) && face.Inside.empty())
      {
        continue;
      }
      const FlatPart part = this->MakePart(face.Points.data(), size);
      std::set<std::size_t> others;
      const auto visit = [&](vtkIdType point)
      {
        for (auto at = std::lower_bound(
               facesAt.begin(), facesAt.end(), std::make_pair(point, std::size_t(0)));
          at != facesAt.end() && at->first == point; ++at)
        {
          const OpenFace& other = this->OpenFaces[at->second];
          if (other.Cell != face.Cell &&
            std::all_of(other.Points.begin(), other.Points.end(),
              [&](vtkIdType p) { return part.Find(this->X.data() + 3 * p) != FlatPart::Off; }))
          {
            others.insert(at->second);
          }
        }
      };
      std::for_each(ring.begin(), ring.end(), visit);
      std::for_each(face.Inside.begin(), face.Inside.end(), visit);
      std::vector<std::size_t> list(others.begin(), others.end());
      if (this->Covers(ring, list))
      {
        this->Covered[{ face.Cell, HashLoop(face.Points.data(), size) }] = std::move(list);
      }
      else if (!list.empty() || !face.Inside.empty())
      {
        this->Fail(face.Cell);
      }
    }
  }

  /// Whether these faces, which look the other way, have together the border `ring`.
  bool Covers(const Loop& ring, const std::vector<std::size_t>& others) const
  {
    std::set<Edge> left; // directed
    const auto add = [&left](vtkIdType a, vtkIdType b)
    {
      if (left.erase({ b, a }) == 0)
      {
        left.emplace(a, b);
      }
    };
    Loop expanded;
    for (const std::size_t f : others)
    {
      const Loop& points = this->OpenFaces[f].Points;
      this->Expand(points.data(), static_cast<vtkIdType>(points.size()), expanded);
      for (std::size_t i = 0; i < expanded.size(); ++i)
      {
        add(expanded[(i + 1) % expanded.size()], expanded[i]);
      }
    }
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      add(ring[(i + 1) % ring.size()], ring[i]);
    }
    return left.empty() && !others.empty();
  }

  /// The loop with the points on its edges. Returns whether there are any.
  bool Expand(const vtkIdType* loop, vtkIdType size, Loop& expanded) const
  {
    expanded.clear();
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType a = loop[i];
      const vtkIdType b = loop[(i + 1) % size];
      expanded.push_back(a);
      const auto found = this->HasEdge[a] && this->HasEdge[b] ? this->OnEdges.find(MakeEdge(a, b))
                                                              : this->OnEdges.end();
      if (found == this->OnEdges.end())
      {
        continue;
      }
      const std::size_t begin = expanded.size();
      for (const auto& [parameter, point] : found->second)
      {
        expanded.push_back(point);
      }
      if (b < a)
      {
        std::reverse(expanded.begin() + static_cast<std::ptrdiff_t>(begin), expanded.end());
      }
    }
    return static_cast<vtkIdType>(expanded.size()) > size;
  }
  /// The points of a cell that changes. Returns false for one that does not.
  bool WriteCell(vtkIdType cell, CellFaces& faces, const CellIds& ids, Loop& points) const
  {
    bool changes = false;
    const auto end = [&points](std::size_t first) { points.push_back(points[first]); };
    Loop expanded;
    points.clear();
    this->VisitCell(cell, faces, ids,
      [&](vtkIdType, int dimension, const vtkIdType* loop, vtkIdType size)
      {
        if (dimension == 1)
        {
          changes = this->Expand(loop, 2, expanded) || changes;
          expanded.resize(1 + (expanded.size() - 2) / 2); // the way there, not back
          points.insert(points.end(), expanded.begin(), expanded.end());
          return;
        }
        const auto covered =
          dimension == 3 ? this->Covered.find({ cell, HashLoop(loop, size) }) : this->Covered.end();
        std::size_t first = points.size();
        if (covered == this->Covered.end())
        {
          changes = this->Expand(loop, size, expanded) || changes;
          points.insert(points.end(), expanded.begin(), expanded.end());
          dimension == 3 ? end(first) : void();
          return;
        }
        changes = true;
        for (const std::size_t f : covered->second)
        {
          const Loop& other = this->OpenFaces[f].Points;
          this->Expand(other.data(), static_cast<vtkIdType>(other.size()), expanded);
          first = points.size();
          points.insert(points.end(), expanded.rbegin(), expanded.rend());
          end(first);
        }
      });
    if (GetDimensionOfType(this->Cells.GetCellType(cell)) == 1)
    {
      points.push_back(ids.Ids[ids.Size - 1]);
    }
    return changes;
  }

  void Fail(vtkIdType cell)
  {
    ++this->Failed;
    this->FirstFailed = std::min(this->FirstFailed, cell);
  }

  vtkPointSet* Mesh;
  const CellReader Cells;
  const CheckedCells Checked;
  Buffer<double> X; ///< from -1 to 1
  std::vector<OpenFace> OpenFaces;
  Buffer<int> TreeIds; ///< of the points of the tree
  std::vector<double> TreePoints;
  std::vector<vtkIdType> Candidates;
  SimplexTree Tree;
  std::map<Edge, std::vector<std::pair<double, vtkIdType>>> OnEdges;
  Buffer<unsigned char> HasEdge; ///< of each point: ends an edge that has points
  std::map<std::pair<vtkIdType, std::uint64_t>, std::vector<std::size_t>> Covered;
  vtkIdType Failed = 0;
  vtkIdType FirstFailed = VTK_ID_MAX;
};

}

vtkSmartPointer<vtkPointSet> CloseHangingNodes(
  vtkPointSet* mesh, std::vector<std::string>& warnings)
{
  if (mesh->GetNumberOfPoints() == 0 || mesh->GetNumberOfPoints() > VTK_INT_MAX)
  {
    return mesh;
  }
  Closing closing(mesh);
  vtkSmartPointer<vtkPointSet> closed = mesh;
  if (closing.Find())
  {
    closed = closing.Write();
  }
  const std::string warning = closing.Describe();
  if (!warning.empty())
  {
    warnings.push_back(warning);
  }
  return closed;
}

}
