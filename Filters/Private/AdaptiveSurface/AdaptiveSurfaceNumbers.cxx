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

/// Collects things of all partitions for NumberTogether.
class Collection
{
public:
  explicit Collection(int width) { this->Keys.Width = width; }
  /// `place`: in the list that gets the number.
  void Add(vtkIdType place, bool isOwn, std::initializer_list<Ids> parts)
  {
    for (const Ids& part : parts)
    {
      this->Keys.Keys.insert(this->Keys.Keys.end(), part.begin(), part.end());
    }
    this->Keys.Own.push_back(isOwn);
    this->Places.push_back(place);
  }
  /// Numbers them from the total of the list on.
  void Number(Partners& partners, WholeIds& list) const
  {
    const SharedNumbers numbers = NumberTogether(this->Keys, partners);
    for (const size_t i : InTurn(this->Places.size()))
    {
      list.Ids[this->Places[i]] = numbers.First[i] < 0 ? -1 : list.Total + numbers.First[i];
    }
    list.Total += numbers.Totals[0];
  }

private:
  SharedKeys Keys;
  Ids Places;
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
  const std::vector<char>& own, Partners& partners, WholeIds& points)
{
  std::vector<std::array<Collection, 2>> levels;
  for (Id v = static_cast<Id>(mesh.GetNumberOfControlVertices()); v < mesh.GetNumberOfVertices();
    ++v)
  {
    const Id source = mesh.GetAdded(v).Source;
    const int level =
      source >= 0 ? mesh.GetLevel(source) : mesh.GetSegmentAt(-1 - source).Level + 1;
    while (static_cast<int>(levels.size()) <= level)
    {
      levels.push_back({ Collection(paths.WidthOfFace), Collection(paths.WidthOfSegment) });
    }
    if (source >= 0)
    {
      paths.Add(source, v, own[v], levels[level][0]);
      continue;
    }
    const Id segment = -1 - source;
    paths.AddThirds(
      segment, v, v == mesh.GetSegmentAt(segment).Thirds ? 0 : 1, own[v], levels[level][1]);
  }
  const Ids all = partners.Gather(static_cast<vtkIdType>(levels.size()));
  const auto most = static_cast<size_t>(*std::max_element(all.begin(), all.end()));
  while (levels.size() < most)
  {
    levels.push_back({ Collection(paths.WidthOfFace), Collection(paths.WidthOfSegment) });
  }
  for (const auto& level : levels)
  {
    level[0].Number(partners, points);
    level[1].Number(partners, points);
  }
}

}

template <typename Id>
SurfaceNumbers NumberAdaptiveSurface(vtkPolyData* input, const SurfaceCells& cells,
  const SurfaceLevel<Id>& control, const AdaptiveSqrtThree<Id>& mesh,
  const AdaptiveSqrtThreeOutput<Id>& plan, Partners& partners, vtkPolyData* output)
{
  const Ids places = PlaceCells(input, partners);
  const SharedKeys faces = MakeKeysOfPieces(cells.FaceCells, places, partners);
  const SharedKeys lines = MakeKeysOfPieces(cells.SegmentCells, places, partners);
  const SharedNumbers given = NumberTogether(MakeVertexKeys(input, partners), partners);
  const SharedKeys edges = MakeEdgeKeys(control, faces, lines, given);
  const Paths<Id> paths(mesh, control, faces, edges);

  auto* originals =
    vtkIdTypeArray::SafeDownCast(output->GetCellData()->GetArray(OriginalCellIdsName));
  const vtkIdType* firstOriginal = originals->GetPointer(0);
  const Ids inputCells(firstOriginal, firstOriginal + originals->GetNumberOfValues());
  const std::vector<char> own = FindOwnPoints(output, inputCells, partners);
  SurfaceNumbers numbers;
  numbers.Points = { given.First, given.Totals[0] };
  numbers.Points.Ids.resize(static_cast<size_t>(mesh.GetNumberOfVertices()), -1);
  NumberAdded(mesh, paths, own, partners, numbers.Points);

  numbers.Cells.Ids.resize(inputCells.size(), -1);
  const auto isOwn = [&](vtkIdType cell) { return partners.IsOwn(inputCells[cell]); };
  Collection ofVertices(2);
  vtkIdType next = 0;
  const SharedKeys vertices = MakeKeysOfPieces(cells.VertexCells, places, partners);
  for (size_t i = 0; i < vertices.Own.size(); ++i, ++next)
  {
    ofVertices.Add(next, isOwn(next), { TakeKey(vertices, static_cast<vtkIdType>(i)) });
  }
  ofVertices.Number(partners, numbers.Cells);
  Collection ofLines(3);
  std::vector<typename AdaptiveSqrtThreeOutput<Id>::Piece> pieces;
  for (const vtkIdType line : InTurn(control.Lines.size()))
  {
    pieces.clear();
    plan.AppendPieces(control.Lines[line], pieces);
    for (size_t i = 0; i < pieces.size(); ++i, ++next)
    {
      ofLines.Add(next, isOwn(next), { TakeKey(lines, line), { static_cast<vtkIdType>(i) } });
    }
  }
  ofLines.Number(partners, numbers.Cells);
  Collection ofFaces(paths.WidthOfFace);
  for (const Id face : plan.FindFaces())
  {
    paths.Add(face, next, isOwn(next), ofFaces);
    ++next;
  }
  ofFaces.Number(partners, numbers.Cells);
  return numbers;
}

SUBDIVISION_COMPILE_FUNCTION(NumberAdaptiveSurface);

}
