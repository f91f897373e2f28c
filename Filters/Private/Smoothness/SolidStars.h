// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidStars.h
 * The stars of the vertices, edges and faces inside a solid, as meshes of their own.
 */
#ifndef SubdivisionObjects_SolidStars_h
#define SubdivisionObjects_SolidStars_h

#include "Core/Smoothness/SolidMaps.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"

#include <algorithm>
#include <map>
#include <memory>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace subdivision
{

/// How an edge lies in a tetrahedron of the box spline: it is marked, or the marked edges at its
/// first end go to the one or to the other vertex of the tetrahedron.
enum Mark
{
  OnEdge,
  ToFirst,
  ToSecond
};

/// The stars of the simplices of a level, as meshes of their own. Equal stars are examined once.
template <typename Scheme>
class StarReader
{
public:
  using Id = typename Scheme::Id;
  using Level = typename Scheme::Level;
  /// The same scheme with the ids of small meshes.
  using SmallScheme =
    std::conditional_t<Scheme::Traits.HasPieces, TetOctScheme<int>, BoxSplineScheme<int>>;

  StarReader(const Level& level, bool samples)
    : Here(level)
    , Complex(level.Complex)
    , Samples(samples)
  {
  }

  /// All tetrahedra at an inner vertex.
  template <typename Tets>
  SolidStar MakeVertexStar(Id vertex, const Tets& tets) const
  {
    SolidStar star;
    std::unordered_map<Id, int> numbers{ { vertex, 0 } };
    for (const Id tet : tets)
    {
      std::array<int, 4> made{};
      for (int k = 0; k < 4; ++k)
      {
        const Id corner = this->Complex.TetVertices[4 * vtkIdType(tet) + k];
        made[k] = numbers.emplace(corner, static_cast<int>(numbers.size())).first->second;
      }
      star.Tets.push_back(made);
    }
    return star;
  }
  template <typename Tets>
  const SmoothnessFacts& ExamineVertex(Id vertex, const Tets& tets)
  {
    const SolidStar star = OrderStar(this->MakeVertexStar(vertex, tets), Scheme::Traits.OrdersTets);
    const auto [known, isNew] = this->Vertices.try_emplace(star.Tets);
    if (isNew)
    {
      known->second = ExamineSolid<SmallScheme>(star, this->Samples);
    }
    return known->second;
  }

  SolidStar MakeEdgeStar(Id edge) const
  {
    std::vector<int> marks;
    return this->ReadMarks(edge, marks) ? MakeStarOfMarks(marks) : MakeStarInside();
  }
  SmoothnessFacts ExamineEdge(Id edge)
  {
    std::vector<int> marks;
    if (!this->ReadMarks(edge, marks))
    {
      return this->ExamineInside();
    }
    std::vector<int> least = marks;
    for (std::size_t i = 1; i < marks.size(); ++i) // where the walk begins does not matter
    {
      std::rotate(marks.begin(), marks.begin() + 1, marks.end());
      least = std::min(least, marks);
    }
    const auto known = this->Edges.find(least);
    return known != this->Edges.end()
      ? known->second
      : this->Edges.emplace(least, ExamineSolid<SmallScheme>(MakeStarOfMarks(least), this->Samples))
          .first->second;
  }

  SolidStar MakeFaceStar(Id face) const
  {
    SolidStar star;
    star.Corners = 3;
    star.Tets = { { { 0, 3, 1, 2 } }, { { 0, 4, 1, 2 } } };
    star.Tets[1] = this->IsMarkedAlike(face) ? star.Tets[1] : std::array<int, 4>{ { 0, 4, 2, 1 } };
    return star;
  }
  SmoothnessFacts ExamineFace(Id face)
  {
    std::unique_ptr<SmoothnessFacts>& known = this->Faces[this->IsMarkedAlike(face) ? 0 : 1];
    if (!known)
    {
      known = std::make_unique<SmoothnessFacts>(
        ExamineSolid<SmallScheme>(this->MakeFaceStar(face), this->Samples));
    }
    return *known;
  }

private:
  /// A face between two tetrahedra: whether these mark the same edge of it decides.
  bool IsMarkedAlike(Id face) const
  {
    const Row<Id> solids = this->Complex.FaceTets[face];
    const bool areTets = solids.begin()[0] < this->Complex.NumberOfTets &&
      solids.begin()[1] < this->Complex.NumberOfTets;
    return !Scheme::Traits.OrdersTets || !areTets ||
      this->FindMarked(solids.begin()[0], face) == this->FindMarked(solids.begin()[1], face);
  }

  /// Inside a tetrahedron, where the mesh is a lattice.
  static SolidStar MakeStarInside() { return { 4, { { { 0, 1, 2, 3 } } } }; }
  SmoothnessFacts ExamineInside()
  {
    if (!this->Inside)
    {
      this->Inside = std::make_unique<SmoothnessFacts>(
        ExamineSolid<SmallScheme>(MakeStarInside(), this->Samples));
    }
    return *this->Inside;
  }

  static SolidStar MakeStarOfMarks(const std::vector<int>& marks)
  {
    SolidStar star;
    star.Corners = 2;
    const int size = static_cast<int>(marks.size());
    for (int i = 0; i < size; ++i)
    {
      const int first = 2 + i;
      const int second = 2 + (i + 1) % size;
      const std::array<int, 4> orders[3] = { { { 0, first, 1, second } },
        { { 0, 1, first, second } }, { { 0, 1, second, first } } };
      star.Tets.push_back(orders[marks[i]]);
    }
    return star;
  }

  /// The mark of each tetrahedron around an edge. Returns false if there are octahedra at it.
  bool ReadMarks(Id edge, std::vector<int>& marks) const
  {
    const auto isTet = [this](Id solid) { return solid < this->Complex.NumberOfTets; };
    const Row<Id> faces = this->Here.Strata.EdgeRings.GetCarriers(edge);
    const Id first = faces.begin()[0];
    const Id firstTet = this->Complex.FaceTets[first].begin()[0];
    Id face = first;
    Id tet = firstTet;
    do
    {
      if (!isTet(tet))
      {
        return false;
      }
      const Id* tetFaces = this->Complex.TetFaces.data() + 4 * vtkIdType(tet);
      const int* ends = tetrahedron::EdgeVertices[this->Complex.EdgeInTet(tet, edge)];
      const Id* corners = this->Complex.TetVertices.data() + 4 * vtkIdType(tet);
      const int start =
        corners[ends[0]] == this->Complex.EdgeVertices[2 * vtkIdType(edge)] ? ends[0] : ends[1];
      const int end = start == ends[0] ? ends[1] : ends[0];
      const int beyond = this->Complex.FaceInTet(tet, face); // not on the face
      const int here = 6 - start - end - beyond;
      const int partner = start ^ 2; // marked edges are 02 and 13
      marks.push_back(!Scheme::Traits.OrdersTets || partner == end ? OnEdge
          : partner == here                                        ? ToFirst
                                                                   : ToSecond);
      face = tetFaces[here];
      const Row<Id> sides = this->Complex.FaceTets[face];
      if (sides.size() != 2)
      {
        return false;
      }
      tet = sides.begin()[0] == tet ? sides.begin()[1] : sides.begin()[0];
    } while (tet != firstTet && static_cast<vtkIdType>(marks.size()) < faces.size());
    return true;
  }

  /// The edge of a face that a tetrahedron of the box spline marks, as the vertex opposite to it.
  Id FindMarked(Id tet, Id face) const
  {
    const Id* corners = this->Complex.TetVertices.data() + 4 * vtkIdType(tet);
    return corners[this->Complex.FaceInTet(tet, face) ^ 2];
  }

  const Level& Here;
  const SimplicialComplex<Id>& Complex;
  const bool Samples;
  std::map<std::vector<std::array<int, 4>>, SmoothnessFacts> Vertices;
  std::map<std::vector<int>, SmoothnessFacts> Edges;
  std::unique_ptr<SmoothnessFacts> Faces[2];
  std::unique_ptr<SmoothnessFacts> Inside;
};

}

#endif
