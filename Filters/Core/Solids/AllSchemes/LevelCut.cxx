// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/AllSchemes/LevelCut.h"

#include "Core/Memory/Loops.h"

#include <algorithm>

namespace subdivision
{

template <typename Scheme>
LevelCut<Scheme>::LevelCut(const Level& level, const ControlParts& parts, int steps, int further)
  : Steps(steps)
  , Further(further)
{
  const auto& complex = level.Complex;
  const std::vector<IdSegment> vertices = Scheme::Traits.ListVertices(steps);
  // The vertices of the next level are the vertices of this one and the midpoints of its edges.
  std::vector<IdSegment> edges = Scheme::Traits.ListVertices(steps + 1);
  edges.erase(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(vertices.size()));
  this->Vertices = this->SelectParts(parts, complex.NumberOfVertices, vertices);
  this->Edges = this->SelectParts(parts, complex.NumberOfEdges, std::move(edges));
  const auto select = [](vtkIdType size, const auto& isKept)
  {
    Buffer<unsigned char> flags(size);
    ForEach(size, [&](vtkIdType i) { flags[i] = isKept(i) ? 1 : 0; });
    return Selection<Id>(flags);
  };
  const typename Scheme::ControlTets tets(level, steps);
  const auto isKept = [&](vtkIdType solid)
  { return parts.Kept[3][tets.Find(static_cast<Id>(solid))] != 0; };
  const vtkIdType firstOct = complex.NumberOfTets;
  this->Tets = select(firstOct, isKept);
  this->Octs =
    select(Scheme::CountCentres(level), [&](vtkIdType oct) { return isKept(firstOct + oct); });
  this->VertexCells = select(complex.VertexCells.size(),
    [&](vtkIdType i) { return this->Vertices.New[complex.VertexCells[i]] >= 0; });
  this->SelectFaces(level, parts);
  this->EqualLines = this->SelectEqual(complex.EqualLines, this->Edges);
  this->EqualTriangles = this->SelectEqual(complex.EqualTriangles, this->Faces);
  this->EqualTets = this->SelectEqual(complex.EqualTets, this->Tets);
  if (further == 1)
  {
    this->MakeColumns();
  }
}

/// Selects faces that lie in control faces, and, before two steps, faces inside control tetrahedra.
template <typename Scheme>
void LevelCut<Scheme>::SelectFaces(const Level& level, const ControlParts& parts)
{
  const auto& complex = level.Complex;
  const vtkIdType size = this->Further > 1 ? complex.NumberOfFaces : complex.NumberOfTriangleCells;
  const vtkIdType inFaces = static_cast<vtkIdType>(parts.Kept[2].size()) << (2 * this->Steps);
  Buffer<unsigned char> flags(size);
  ForEach(size,
    [&](vtkIdType f) { flags[f] = f < inFaces && parts.Kept[2][f >> (2 * this->Steps)] ? 1 : 0; });
  if (size > inFaces)
  {
    const auto add = [&](const Buffer<Id>& solids, const Buffer<Id>& faces, int ofEach)
    {
      for (const Id solid : solids)
      {
        for (int k = 0; k < ofEach; ++k)
        {
          flags[faces[ofEach * vtkIdType(solid) + k]] = 1;
        }
      }
    };
    add(this->Tets.Old, complex.TetFaces, 4);
    if constexpr (Scheme::Traits.HasPieces)
    {
      add(this->Octs.Old, level.OctFaces, 8);
    }
  }
  this->Faces = Selection<Id>(flags);
}

/// Selects the descendants of kept control simplices, the first `size` ids of the segments.
template <typename Scheme>
Selection<typename Scheme::Id> LevelCut<Scheme>::SelectParts(
  const ControlParts& parts, vtkIdType size, std::vector<IdSegment> segments) const
{
  Buffer<unsigned char> flags(size);
  vtkIdType first = 0;
  for (auto segment = segments.begin(); first < size; ++segment)
  {
    const std::vector<char>& kept = parts.Kept[segment->Kind];
    const vtkIdType ofEach = segment->OfEach;
    ForEach(static_cast<vtkIdType>(kept.size()), [&](vtkIdType i)
      { std::fill_n(flags.data() + first + ofEach * i, ofEach, kept[i] ? 1 : 0); });
    first += ofEach * static_cast<vtkIdType>(kept.size());
  }
  return Selection<Id>(flags);
}

/// Cells that equal another are kept with it.
template <typename Scheme>
Selection<typename Scheme::Id> LevelCut<Scheme>::SelectEqual(
  const EqualCells<Id>& equal, const Selection<Id>& twins) const
{
  Buffer<unsigned char> flags(equal.Twins.size());
  ForEach(flags.size(), [&](vtkIdType i) { flags[i] = twins.New[equal.Twins[i]] >= 0 ? 1 : 0; });
  return Selection<Id>(flags);
}

/// Vertices that are kept come first; the others follow.
template <typename Scheme>
void LevelCut<Scheme>::MakeColumns()
{
  const vtkIdType size = this->Vertices.New.size();
  auto next = static_cast<Id>(this->Vertices.Old.size());
  this->ColumnOf = Buffer<Id>(size);
  this->Columns.NumberOfColumns = size;
  this->Columns.Offsets = Buffer<Id>(size + 1);
  this->Columns.Columns = Buffer<Id>(size);
  this->Columns.Weights = Buffer<double>(size, 1.);
  for (const vtkIdType v : InTurn(size))
  {
    this->ColumnOf[v] = this->Vertices.New[v] >= 0 ? this->Vertices.New[v] : next++;
  }
  ForEach(
    size, [&](vtkIdType v) { this->Columns.Columns[this->ColumnOf[v]] = static_cast<Id>(v); });
  ForEach(size + 1, [&](vtkIdType i) { this->Columns.Offsets[i] = static_cast<Id>(i); });
}

template <typename Scheme>
Rings<typename Scheme::Id> LevelCut<Scheme>::CutRings(
  const Rings<Id>& rings, const Selection<Id>& owners) const
{
  const vtkIdType size = owners.Old.size();
  Rings<Id> part;
  part.Offsets = Buffer<Id>(size + 1);
  ForEach(
    size, [&](vtkIdType i) { part.Offsets[i] = static_cast<Id>(rings.GetSize(owners.Old[i])); });
  CountsToOffsets(part.Offsets);
  part.Members = Buffer<Id>(part.Offsets[size]);
  ForEach(size,
    [&](vtkIdType i)
    {
      const Row<Id> ring = rings.GetMembers(owners.Old[i]);
      std::transform(ring.begin(), ring.end(), part.Members.data() + part.Offsets[i],
        [&](Id member) { return this->ColumnOf[member]; });
    });
  return part;
}

template <typename Scheme>
EqualCells<typename Scheme::Id> LevelCut<Scheme>::CutEqual(const EqualCells<Id>& equal, int size,
  const Selection<Id>& selected, const Selection<Id>& twins) const
{
  return { selected.Pick(equal.Vertices, size, this->Vertices.New),
    selected.Pick(equal.Twins, 1, twins.New) };
}

template <typename Scheme>
typename Scheme::Level LevelCut<Scheme>::Cut(const Level& level) const
{
  const auto& whole = level.Complex;
  Level part;
  auto& complex = part.Complex;
  complex.NumberOfVertices = static_cast<Id>(this->Vertices.Old.size());
  complex.NumberOfEdges = static_cast<Id>(this->Edges.Old.size());
  complex.NumberOfFaces = static_cast<Id>(this->Faces.Old.size());
  complex.NumberOfTets = static_cast<Id>(this->Tets.Old.size());
  const auto countFirst = [](const Selection<Id>& selected, Id end)
  {
    return static_cast<Id>(
      std::lower_bound(selected.Old.begin(), selected.Old.end(), end) - selected.Old.begin());
  };
  complex.NumberOfLineCells = countFirst(this->Edges, whole.NumberOfLineCells);
  complex.NumberOfTriangleCells = countFirst(this->Faces, whole.NumberOfTriangleCells);
  complex.VertexCells = this->VertexCells.Pick(whole.VertexCells, 1, this->Vertices.New);
  complex.EdgeVertices = this->Edges.Pick(whole.EdgeVertices, 2, this->Vertices.New);
  complex.FaceVertices = this->Faces.Pick(whole.FaceVertices, 3, this->Vertices.New);
  complex.FaceEdges = this->Faces.Pick(whole.FaceEdges, 3, this->Edges.New);
  complex.TetVertices = this->Tets.Pick(whole.TetVertices, 4, this->Vertices.New);
  complex.TetEdges = this->Tets.Pick(whole.TetEdges, 6, this->Edges.New);
  complex.EqualLines = this->CutEqual(whole.EqualLines, 2, this->EqualLines, this->Edges);
  complex.EqualTriangles =
    this->CutEqual(whole.EqualTriangles, 3, this->EqualTriangles, this->Faces);
  complex.EqualTets = this->CutEqual(whole.EqualTets, 4, this->EqualTets, this->Tets);
  if (this->Further > 1)
  {
    complex.TetFaces = this->Tets.Pick(whole.TetFaces, 4, this->Faces.New);
  }
  this->CutSolids(level, part);
  if (this->Further == 1)
  {
    this->CutRings(level, part);
  }
  return part;
}

template <typename Scheme>
void LevelCut<Scheme>::CutRings(const Level& level, Level& part) const
{
  part.Strata.TakeChoices(level.Strata);
  part.Strata.Sectors = CutSectorEdges(
    level.Strata.Sectors, [this](Id edge) { return this->Edges.New[edge]; },
    [this](Id vertex) { return this->ColumnOf[vertex]; });
  part.Strata.Vertices = this->Vertices.Pick(level.Strata.Vertices);
  part.Strata.Edges = this->Edges.Pick(level.Strata.Edges);
  part.Strata.VertexRings = this->CutRings(level.Strata.VertexRings, this->Vertices);
  part.Strata.EdgeRings = this->CutRings(level.Strata.EdgeRings, this->Edges);
  this->CutCounts(level, part);
}

template <typename Scheme>
typename LevelCut<Scheme>::ChildRows::Selected LevelCut<Scheme>::SelectChildren(
  const Level& part) const
{
  typename ChildRows::Selected selected{ this->Vertices.Old, this->Edges.Old, this->Faces.Old,
    { &this->Tets.Old }, typename ChildRows::Ids(part) };
  if constexpr (Scheme::Traits.HasPieces)
  {
    selected.Solids[1] = &this->Octs.Old;
  }
  return selected;
}

template <typename Scheme>
void LevelCut<Scheme>::CutSolids(const TetOctLevel<Id>& level, TetOctLevel<Id>& part) const
{
  part.NumberOfOctahedra = static_cast<Id>(this->Octs.Old.size());
  part.OctVertices = this->Octs.Pick(level.OctVertices, 6, this->Vertices.New);
  part.OctEdges = this->Octs.Pick(level.OctEdges, 12, this->Edges.New);
  part.EqualOcts =
    this->CutEqual(level.EqualOcts, 6, this->SelectEqual(level.EqualOcts, this->Octs), this->Octs);
  part.Steps = level.Steps;
  if (this->Further > 1)
  {
    part.OctFaces = this->Octs.Pick(level.OctFaces, 8, this->Faces.New);
  }
}

/// Control vertices have the counts of their rings.
template <typename Scheme>
void LevelCut<Scheme>::CutCounts(const TetOctLevel<Id>& level, TetOctLevel<Id>& part) const
{
  // Control vertices are the first.
  const Buffer<Id>& old = this->Vertices.Old;
  const Rings<Id>& rings = part.Strata.VertexRings;
  part.NumberOfControlVertices = static_cast<Id>(
    std::lower_bound(old.begin(), old.end(), level.NumberOfControlVertices) - old.begin());
  auto counts = std::make_shared<Buffer<Id>>(rings.Offsets[part.NumberOfControlVertices]);
  ForEach(part.NumberOfControlVertices,
    [&](vtkIdType v)
    {
      std::copy_n(level.TetsAtSpokes->data() + level.Strata.VertexRings.Offsets[old[v]],
        rings.GetSize(v), counts->data() + rings.Offsets[v]);
    });
  part.TetsAtSpokes = counts;
}

/// The number in the part of control simplex i, as `run` counts them; -1: it is not kept.
template <typename Scheme>
typename Scheme::Id LevelCut<Scheme>::GetNewNumber(const CellRun& run, vtkIdType i) const
{
  // In a scheme with octahedra only the descendants of a tetrahedron at the vertices of tetrahedra
  // count here.
  const int shift =
    Scheme::Traits.HasPieces && run.Dimension == 3 ? 2 * this->Steps : run.Dimension * this->Steps;
  const Selection<Id>* selections[4][2] = { { &this->VertexCells, nullptr },
    { &this->Edges, &this->EqualLines }, { &this->Faces, &this->EqualTriangles },
    { &this->Tets, &this->EqualTets } };
  const Id number = selections[run.Dimension][run.Equal]->New[i << shift];
  return number < 0 ? number : number >> shift;
}

template <typename Scheme>
std::vector<CellRun> LevelCut<Scheme>::Cut(
  const std::vector<CellRun>& runs, const std::vector<char>& wanted) const
{
  std::vector<CellRun> cut;
  std::size_t simplex = 0;
  for (const CellRun& run : runs)
  {
    const int shift = run.Dimension * this->Steps;
    bool isOpen = false;
    for (vtkIdType i = run.First; i < run.First + run.Count; i += vtkIdType(1) << shift)
    {
      const vtkIdType number = this->GetNewNumber(run, i >> shift);
      const bool isKept = number >= 0 && (wanted.empty() || wanted[simplex]);
      ++simplex;
      if (isKept && !isOpen)
      {
        cut.push_back({ run.Dimension, run.Equal, number << shift });
      }
      if (isKept)
      {
        cut.back().Count += vtkIdType(1) << shift;
      }
      isOpen = isKept;
    }
  }
  return RefineRuns(cut, 0);
}

template <typename Scheme>
std::vector<SharpRow> LevelCut<Scheme>::Cut(const std::vector<SharpRow>& rows) const
{
  const vtkIdType vertices = this->Vertices.New.size();
  std::vector<SharpRow> cut;
  for (SharpRow row : rows)
  {
    const bool isOfEdge = row.Row >= vertices;
    row.Row = isOfEdge ? this->Edges.New[row.Row - vertices] : this->Vertices.New[row.Row];
    if (row.Row >= 0)
    {
      row.Row += isOfEdge ? this->Vertices.Old.size() : 0;
      cut.push_back(row);
    }
  }
  return cut;
}

#define SUBDIVISION_CUT(Scheme) template class LevelCut<Scheme>
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_CUT);

}
