// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LatticeNormals.h
 * What the normal at the limit of a vertex of a lattice (SharpLattice.h) follows from, without
 * making a level: the tangents of its sectors (LimitNormals.h), or the star from which it takes a
 * normal for shading (ShadingStars.h).
 *
 * Vertices inside control solids have no normal, and those of the control mesh have the normals of
 * its level. All others lie inside a control edge or a control face. So in each control face they
 * have six neighbours around them, or four from one side to the other, and a sector has six
 * triangles, or three.
 */
#ifndef SubdivisionObjects_LatticeNormals_h
#define SubdivisionObjects_LatticeNormals_h

#include "Core/Memory/Ids.h"
#include "Core/Solids/Limits/LimitNormals.h"
#include "Core/Solids/Limits/SharpLattice.h"
#include "Core/Solids/Limits/SolidsAtFaces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace subdivision
{

/// What a vertex has of LimitTangents, over vertices of its level.
template <typename Id>
struct LatticeNormal
{
  struct Sector
  {
    LatticeRow<Id> First;
    std::vector<double> Second; ///< of the same vertices
    Id Triangle = -1;
    std::vector<vtkIdType> Sides; ///< one for each face
  };
  std::vector<Sector> Sectors;
  // Without sector:
  std::vector<LatticeRow<Id>> Rows; ///< of the star
  std::vector<typename ShadingStars<Id>::Corner> Corners;
  std::vector<Id> Lines;
};

/// Threads share it.
template <typename LevelType>
class LatticeNormals
{
public:
  using Id = typename LevelType::IdType;
  using Lattice = typename LevelLattices<LevelType>::Lattice;

  /// Both must outlive this. `control` is the level of the lattices.
  LatticeNormals(const LevelType& control, const ControlSolids& solids)
    : Complex(control.Complex)
    , Strata(control.Strata)
    , Steps(solids.Steps)
    , Solids(control, solids)
    , FacesAtEdges(ListByRow<Id>(
        control.Complex.NumberOfEdges, control.Complex.FaceEdges.size(), [&control](vtkIdType i)
        { return control.Complex.FaceEdges[i]; }, [](vtkIdType i) { return Id(i / 3); }))
    , Closed(FindSectorTangents(6, true, false))
    , Open(FindSectorTangents(4, false, control.Strata.ModifiedBoundary))
  {
  }

  /// Finds the normal of a vertex that is no control vertex. False: a rule is unknown.
  bool Read(const LatticeVertex<Id>& vertex, Lattice& lattice, LatticeNormal<Id>& normal) const
  {
    normal = LatticeNormal<Id>();
    if (vertex.Dimension == 3)
    {
      return true;
    }
    const Row<Id> faces = this->GetFaces(vertex);
    const bool isSharp = lattice.GetSharpnessLeft(vertex) > 0.;
    const bool isKnown = isSharp || this->AddSectors(vertex, faces, lattice, normal);
    return isKnown &&
      (!normal.Sectors.empty() || this->AddStar(vertex, faces, isSharp, lattice, normal));
  }

private:
  using Vertex = LatticeVertex<Id>;
  using Sector = typename LatticeNormal<Id>::Sector;
  using Neighbours = LatticeStar<Id>; ///< in cyclic order, and the vertices between

  /// The control faces at a vertex.
  Row<Id> GetFaces(const Vertex& vertex) const
  {
    return vertex.Dimension == 1 ? this->FacesAtEdges[vertex.Simplex]
                                 : Row<Id>{ &vertex.Simplex, &vertex.Simplex + 1 };
  }
  /// Whether a vertex may have a sector on a face.
  bool IsSmooth(Id face) const
  {
    return this->Strata.Faces[face].GetRule() == Rule::Surface && this->Solids.Count(face) < 2;
  }
  bool IsCell(Id face) const { return face < this->Complex.NumberOfTriangleCells; }
  const Id* GetCorners(Id face) const
  {
    return this->Complex.FaceVertices.data() + 3 * vtkIdType(face);
  }

  /// The neighbours on a face, in the order of its corners; those of a vertex on its edge from one
  /// side to the other.
  Neighbours FindNeighbours(const Vertex& vertex, Id face, const Lattice& lattice) const;
  bool AddSectors(const Vertex& vertex, const Row<Id>& faces, const Lattice& lattice,
    LatticeNormal<Id>& normal) const;
  Neighbours Close(const Vertex& vertex, const Row<Id>& pair, const Lattice& lattice,
    std::vector<vtkIdType>& sides, double& sign) const;
  void AddSides(Id face, bool isTurned, std::vector<vtkIdType>& sides) const;
  static bool WriteTangents(const Vertex& vertex, const Neighbours& around,
    const SectorTangents& tangents, double sign, const Lattice& lattice, Sector& sector);
  bool AddStar(const Vertex& vertex, const Row<Id>& faces, bool isSharp, Lattice& lattice,
    LatticeNormal<Id>& normal) const;
  Neighbours FindStar(const Vertex& vertex, const Row<Id>& faces, const Lattice& lattice,
    LatticeNormal<Id>& normal) const;

  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  const int Steps; ///< of the control level
  const SolidsAtFaces<SchemeOf<LevelType>> Solids;
  const Rows<Id> FacesAtEdges;
  const SectorTangents Closed;
  const SectorTangents Open;
};

}

#endif
