// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Scheme/SurfaceTags.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Rules/Pi.h"
#include "Core/Rules/SectorMasks.h"
#include "Core/Surfaces/Scheme/FixedEdges.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <cmath>

namespace subdivision
{
namespace
{

template <typename Id>
class Classification
{
public:
  Classification(const PolygonMesh<Id>& mesh, const SurfaceScheme<Id>& scheme,
    const SurfaceFeatures& features, const Coordinates& points)
    : Mesh(mesh)
    , Scheme(scheme)
    , Features(features)
    , Points(points)
  {
  }

  SurfaceTags<Id> Run()
  {
    this->TagEdges();
    this->TagVertices();
    this->FindSectors();
    return std::move(this->Tags);
  }

private:
  bool IsFlagged(Id edge) const
  {
    return !this->Features.SharpEdges.empty() && this->Features.SharpEdges[edge];
  }
  bool Blends(JointRule rule) const
  {
    return rule == JointRule::Blend && this->Scheme.BlendsJoints();
  }

  void TagEdges()
  {
    const vtkIdType edges = this->Mesh.GetNumberOfEdges();
    this->Tags.Edges = Buffer<EdgeTag>(edges);
    ForEach(edges,
      [this](vtkIdType e)
      {
        const Id corner = this->Mesh.EdgeCorners[e];
        const bool isBoundary = corner < 0 || this->Mesh.Twins[corner] < 0;
        this->Tags.Edges[e] = this->IsFlagged(static_cast<Id>(e)) ? EdgeTag::Crease
          : isBoundary                                            ? EdgeTag::Sharp
                                                                  : EdgeTag::Smooth;
      });
    const EdgeTag joint = this->Blends(this->Features.Type2) ? EdgeTag::Blend : EdgeTag::Joint;
    for (const auto& sheaf : InTurn(this->Mesh.Sheaves))
    {
      EdgeTag& tag = this->Tags.Edges[sheaf.Edge];
      tag = tag == EdgeTag::Crease ? tag : joint;
    }
  }

  void TagVertices()
  {
    const vtkIdType vertices = this->Mesh.NumberOfVertices;
    this->Tags.Vertices = Buffer<VertexTag>(vertices);
    this->HasSharp = HasSharpEdges(this->Tags);
    ForRanges(vertices,
      [this](vtkIdType begin, vtkIdType end)
      {
        std::vector<Id> edges;
        for (vtkIdType v = begin; v < end; ++v)
        {
          this->Tags.Vertices[v] = this->FindTag(static_cast<Id>(v), edges);
        }
      });
  }

  VertexTag FindTag(Id vertex, std::vector<Id>& edges) const
  {
    const auto* joint = this->Mesh.FindJoint(vertex);
    if ((!this->Features.Corners.empty() && this->Features.Corners[vertex]) ||
      (!joint && this->Mesh.VertexCorners[vertex] < 0))
    {
      return VertexTag::Corner;
    }
    return joint ? this->FindTagOfJoint(*joint, edges) : this->FindTagOfFan(vertex, edges);
  }

  static VertexTag GetTagOfCurves(std::size_t edges)
  {
    return RuleOfCurves(edges) == Rule::Curve ? VertexTag::Curve : VertexTag::Corner;
  }

  /// A vertex of one fan, where boundaries and creases count alike (Mathematics 12).
  VertexTag FindTagOfFan(Id vertex, std::vector<Id>& edges) const
  {
    edges.clear();
    if (this->HasSharp)
    {
      CollectSharpEdges(this->Mesh, this->Tags, vertex, edges);
    }
    if (edges.empty() || (edges.size() == 1 && this->Features.DartEnds))
    {
      return VertexTag::Smooth;
    }
    const bool isLoneFace =
      edges.size() == 2 && this->HasOneFace(vertex) && this->Scheme.HasCornersOfOneFace();
    return isLoneFace ? VertexTag::Corner : GetTagOfCurves(edges.size());
  }

  /// The tag of a vertex in PolygonMesh::Joints. Creases count before joints (Mathematics 4), and
  /// boundaries count for neither (Mathematics 6).
  VertexTag FindTagOfJoint(
    const typename PolygonMesh<Id>::Joint& joint, std::vector<Id>& edges) const
  {
    auto isCrease = [this](Id e) { return this->Tags.Edges[e] == EdgeTag::Crease; };
    CollectEdges(this->Mesh, joint.Vertex, isCrease, edges);
    const std::size_t creases = edges.size();
    const bool isDart =
      creases == 1 && this->Features.DartEnds && !this->LiesOnBoundary(joint, edges);
    if (creases > 0 && !isDart)
    {
      return GetTagOfCurves(creases);
    }
    const std::size_t branches = joint.FreeEdges.size();
    if (joint.Fans.empty() && branches < 3)
    {
      return GetTagOfCurves(branches); // a vertex of one or two lines, and of nothing else
    }
    CollectEdges(
      this->Mesh, joint.Vertex, [this](Id e) { return this->Mesh.FindSheaf(e) != nullptr; }, edges);
    const bool meetsCurves = branches > 0 && !joint.Fans.empty();
    const bool hasBranches = branches > 0 || !edges.empty();
    const JointRule rule = meetsCurves ? this->Features.Type1
      : hasBranches                    ? this->Features.Type2
                                       : this->Features.Type3;
    auto isJoint = [this](Id e) { return this->Tags.Edges[e] == EdgeTag::Joint; };
    return this->Blends(rule) ? VertexTag::Blend
                              : GetTagOfCurves(std::count_if(edges.begin(), edges.end(), isJoint));
  }

  /// Whether a surface or a curve ends at a vertex.
  bool LiesOnBoundary(const typename PolygonMesh<Id>::Joint& joint, std::vector<Id>& edges) const
  {
    CollectEdges(
      this->Mesh, joint.Vertex,
      [this](Id e)
      {
        const Id corner = this->Mesh.EdgeCorners[e];
        return corner >= 0 && this->Mesh.Twins[corner] < 0 && !this->Mesh.FindSheaf(e);
      },
      edges);
    return !edges.empty() || joint.FreeEdges.size() == 1;
  }

  bool HasOneFace(Id vertex) const
  {
    const Id corner = this->Mesh.VertexCorners[vertex];
    return this->Mesh.Twins[corner] < 0 && this->Mesh.Twins[this->Mesh.Previous(corner)] < 0;
  }

  void FindSectors()
  {
    std::vector<Id> edges;
    for (const vtkIdType v : InTurn(this->Mesh.NumberOfVertices))
    {
      if (this->Tags.Vertices[v] != VertexTag::Corner)
      {
        continue;
      }
      const std::size_t first = this->Tags.Sectors.size();
      VisitFans(this->Mesh, static_cast<Id>(v), [&](Id corner) { this->AddSectorsOfFan(corner); });
      const bool isOnly = this->Tags.Sectors.size() == first + 1;
      for (std::size_t s = first; s < this->Tags.Sectors.size(); ++s)
      {
        this->SetShape(this->Tags.Sectors[s], isOnly);
      }
    }
  }

  /// First the sector of the corner itself: the one that FindFirstSector finds on every level.
  void AddSectorsOfFan(Id corner)
  {
    this->AddSector(corner);
    VisitFan(this->Mesh, corner, [this](const FanStep<Id>& step) { this->AddSector(step.Corner); });
  }

  void AddSector(Id corner)
  {
    const SectorEnds<Id> ends = FindSectorEnds(this->Mesh, this->Tags, corner);
    const Id vertex = this->Mesh.Vertices[corner];
    if (ends.Size > 0 && !FindSector(this->Tags, vertex, ends))
    {
      this->Tags.Sectors.push_back(
        { vertex, ends.First.Corner, ends.Last.Corner, ends.Size, 0., 0. });
    }
  }

  double MeasureAngle(const Sector<Id>& sector) const
  {
    double sum = 0.;
    FanStep<Id> step = FindSectorEnds(this->Mesh, this->Tags, sector.First).First;
    for (int i = 0; i < sector.Size; ++i)
    {
      const double known =
        this->Features.FaceAngles.empty() ? -1. : this->Features.FaceAngles[step.Corner];
      sum += known >= 0. ? known : MeasureFaceAngle(this->Mesh, step.Corner, this->Points.Values);
      step.Advance(this->Mesh);
    }
    return sum;
  }

  void SetShape(Sector<Id>& sector, bool isOnly)
  {
    const double alpha =
      isOnly && !this->Features.Angles.empty() ? this->Features.Angles[sector.Vertex] : -1.;
    sector.Angle =
      ClampCornerAngle(alpha >= 0. ? alpha : this->MeasureAngle(sector), this->Points.Tie);
    const double given =
      this->Features.Flatness.empty() ? -1. : this->Features.Flatness[sector.Vertex];
    if (given >= 0.)
    {
      sector.Flatness = std::min(given, 1.);
    }
    else if (sector.Angle > Pi)
    {
      sector.Flatness = GetFlatness(this->Scheme.GetThirdEigenvalue(sector.Size, sector.Angle));
    }
  }

  const PolygonMesh<Id>& Mesh;
  const SurfaceScheme<Id>& Scheme;
  const SurfaceFeatures& Features;
  const Coordinates Points;
  SurfaceTags<Id> Tags;
  bool HasSharp = true; ///< edges
};

}

template <typename Id>
double MeasureFaceAngle(const PolygonMesh<Id>& mesh, Id corner, const double* points)
{
  const double* x = points + 3 * static_cast<vtkIdType>(mesh.Vertices[corner]);
  const double* a = points + 3 * static_cast<vtkIdType>(mesh.Vertices[mesh.Next(corner)]);
  const double* b = points + 3 * static_cast<vtkIdType>(mesh.Vertices[mesh.Previous(corner)]);
  double dot = 0.;
  double aa = 0.;
  double bb = 0.;
  for (int c = 0; c < 3; ++c)
  {
    dot += (a[c] - x[c]) * (b[c] - x[c]);
    aa += (a[c] - x[c]) * (a[c] - x[c]);
    bb += (b[c] - x[c]) * (b[c] - x[c]);
  }
  const double lengths = std::sqrt(aa) * std::sqrt(bb);
  return lengths > 0. && std::isfinite(dot / lengths)
    ? std::acos(std::max(-1., std::min(dot / lengths, 1.)))
    : 0.;
}

template <typename Id>
SurfaceTags<Id> ClassifySurface(const PolygonMesh<Id>& mesh, const SurfaceScheme<Id>& scheme,
  const SurfaceFeatures& features, const Coordinates& points)
{
  return Classification<Id>(mesh, scheme, features, points).Run();
}

SUBDIVISION_COMPILE_FUNCTION(MeasureFaceAngle);
SUBDIVISION_COMPILE_FUNCTION(ClassifySurface);

}
