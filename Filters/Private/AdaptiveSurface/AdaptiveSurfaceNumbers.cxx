// SPDX-License-Identifier: BSD-3-Clause
#include "Private/AdaptiveSurface/AdaptiveSurfaceNumbers.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

/// Vertices of one level and origin, as keys, and their places among all vertices.
struct Collection
{
  SharedKeys Keys;
  Ids Places;

  void Add(vtkIdType place, bool isOwn, std::initializer_list<Ids> parts)
  {
    for (const Ids& part : parts)
    {
      this->Keys.Keys.insert(this->Keys.Keys.end(), part.begin(), part.end());
    }
    this->Keys.Own.push_back(isOwn);
    this->Places.push_back(place);
  }
};

/// Which thing of several of one kind on the control level.
Ids TakeKey(const SharedKeys& things, vtkIdType i)
{
  const auto first = things.Keys.begin() + things.Width * i;
  return { first, first + things.Width };
}

/// The paths from the control mesh by which keys name faces and segments.
template <typename Id>
class Paths
{
public:
  Paths(const AdaptiveSqrtThree<Id>& mesh, const SurfaceLevel<Id>& control, SharedKeys faces,
    SharedKeys edges)
    : Mesh(mesh)
    , Faces(std::move(faces))
    , Edges(std::move(edges))
    , EdgeOf(mesh.GetNumberOfSegments(), -1)
  {
    for (const Id edge : InTurn(control.Mesh.GetNumberOfEdges()))
    {
      if (mesh.GetSegmentOfEdge(edge) >= 0)
      {
        this->EdgeOf[mesh.GetSegmentOfEdge(edge)] = edge;
      }
    }
  }

  /// The control face, and which child of which child a face is: faces of a level have the order of
  /// these, and so have triangles.
  static constexpr int WidthOfFace = 5;
  void Add(Id face, vtkIdType place, bool isOwn, Collection& faces) const
  {
    constexpr int perId = 31;
    Ids path(3, 0); // two bits for each level
    const int levels = this->Mesh.GetLevel(face);
    for (int level = levels; level-- > 0;)
    {
      const Id parent = this->Mesh.GetParent(face);
      const vtkIdType child = face - this->Mesh.GetChild(3 * parent);
      path[level / perId] |= child << (2 * (perId - 1 - level % perId));
      face = parent;
    }
    faces.Add(place, isOwn, { TakeKey(this->Faces, face), path });
  }

  /// The group of a segment, its control edge, and its path: segments of a level are listed like
  /// that (AdaptiveSqrtThreeOutput), the middle thirds of all before the two outer ones of all.
  static constexpr int WidthOfSegment = 4;
  void AddThirds(Id segment, vtkIdType place, int third, bool isOwn, Collection& thirds) const
  {
    vtkIdType group = 0;
    vtkIdType path = third;
    for (int bit = 1;; ++bit)
    {
      const auto& piece = this->Mesh.GetSegmentAt(segment);
      if (piece.Parent < 0)
      {
        break;
      }
      const vtkIdType child = segment - this->Mesh.GetSegmentAt(piece.Parent).Children;
      group += child == 2 ? 0 : vtkIdType(1) << (piece.Level / 2 - 1);
      path |= (child == 1 ? vtkIdType(1) : 0) << bit;
      segment = piece.Parent;
    }
    thirds.Add(place, isOwn, { { group }, TakeKey(this->Edges, this->EdgeOf[segment]), { path } });
  }

private:
  const AdaptiveSqrtThree<Id>& Mesh;
  SharedKeys Faces;
  SharedKeys Edges;
  Ids EdgeOf; ///< of each control segment
};

/// Numbers the vertices that were added: on each level the centres of faces, then points on
/// segments.
template <typename Id>
void NumberAdded(const AdaptiveSqrtThree<Id>& mesh, const Paths<Id>& paths,
  const std::vector<char>& own, OtherPartitions& others, WholeIds& points)
{
  std::vector<std::array<Collection, 2>> levels;
  const auto atLevel = [&levels](int level) -> std::array<Collection, 2>&
  {
    levels.resize(std::max(levels.size(), static_cast<size_t>(level + 1)));
    return levels[level];
  };
  for (Id v = static_cast<Id>(mesh.GetNumberOfControlVertices()); v < mesh.GetNumberOfVertices();
    ++v)
  {
    const Id source = mesh.GetAdded(v).Source;
    if (source >= 0)
    {
      paths.Add(source, v, own[v], atLevel(mesh.GetLevel(source))[0]);
      continue;
    }
    const auto& segment = mesh.GetSegmentAt(-1 - source);
    paths.AddThirds(
      -1 - source, v, v == segment.Thirds ? 0 : 1, own[v], atLevel(segment.Level + 1)[1]);
  }
  const Ids all = others.Gather(static_cast<vtkIdType>(levels.size()));
  levels.resize(static_cast<size_t>(*std::max_element(all.begin(), all.end())));
  for (auto& level : levels)
  {
    level[0].Keys.Width = paths.WidthOfFace;
    level[1].Keys.Width = paths.WidthOfSegment;
    for (const Collection& vertices : level)
    {
      points.Add(vertices.Keys, others, vertices.Places);
    }
  }
}

}

template <typename Id>
WholeNumbers NumberAdaptiveSurface(vtkPolyData* input, const SurfaceCells& cells,
  const SurfaceLevel<Id>& control, const AdaptiveSqrtThree<Id>& mesh,
  const AdaptiveSqrtThreeOutput<Id>& plan, OtherPartitions& others, vtkPolyData* output)
{
  const Ids places = PlaceCells(input, others);
  const SharedKeys faces = MakeKeysOfPieces(cells.FaceCells, places, others);
  const SharedKeys lines = MakeKeysOfPieces(cells.SegmentCells, places, others);
  const SharedNumbers given = NumberTogether(MakeVertexKeys(input, others), others);
  const SharedKeys edges = MakeEdgeKeys(control, faces, lines, given);

  auto* originals =
    vtkIdTypeArray::SafeDownCast(output->GetCellData()->GetArray(OriginalCellIdsName));
  const vtkIdType* first = originals->GetPointer(0);
  const Ids sources(first, first + originals->GetNumberOfValues());
  WholeNumbers numbers;
  numbers.Points = { given.First, given.Totals[0] };
  numbers.Points.Ids.resize(static_cast<size_t>(mesh.GetNumberOfVertices()), -1);
  const Paths<Id> paths(mesh, control, faces, edges);
  NumberAdded(mesh, paths, FindOwnPoints(output, sources, others), others, numbers.Points);
  const Buffer<Id> triangles = plan.FindFaces();
  const auto firstTriangle = static_cast<vtkIdType>(sources.size()) - triangles.size();
  numbers.Cells = NumberCells(places, { sources.begin(), sources.begin() + firstTriangle }, others);
  Collection ofTriangles;
  ofTriangles.Keys.Width = paths.WidthOfFace;
  for (const vtkIdType i : InTurn(triangles.size()))
  {
    paths.Add(triangles[i], i, others.IsOwn(sources[firstTriangle + i]), ofTriangles);
  }
  numbers.Cells.Add(ofTriangles.Keys, others);
  return numbers;
}

SUBDIVISION_COMPILE_FUNCTION(NumberAdaptiveSurface);

}
