// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Scheme/SemiSharp.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/Scheme/SharpSectors.h"

#include <algorithm>
#include <tuple>

namespace subdivision
{

template <typename Id>
void SharpParts::AddEdge(const SimplicialComplex<Id>& complex, vtkIdType edge, double sharpness)
{
  this->Parts.push_back({ complex.NumberOfVertices + edge, false, sharpness });
  for (int i = 0; i < 2; ++i)
  {
    this->Parts.push_back({ complex.EdgeVertices[2 * edge + i], false, sharpness });
  }
}

template <typename Id>
void SharpParts::AddFace(const SimplicialComplex<Id>& complex, vtkIdType face, double sharpness)
{
  for (vtkIdType i = 3 * face; i < 3 * face + 3; ++i)
  {
    this->Parts.push_back(
      { vtkIdType(complex.NumberOfVertices) + complex.FaceEdges[i], true, sharpness });
    this->Parts.push_back({ complex.FaceVertices[i], true, sharpness });
  }
}

void SharpParts::Sort()
{
  // The sum of triangles must not depend on their numbers, which differ between partitions.
  std::stable_sort(this->Parts.begin(), this->Parts.end(),
    [](const Part& a, const Part& b)
    {
      return std::make_tuple(a.Row, a.IsFace, a.IsFace ? a.Sharpness : 0.) <
        std::make_tuple(b.Row, b.IsFace, b.IsFace ? b.Sharpness : 0.);
    });
}

std::vector<SharpRow> SharpParts::GetRows() const
{
  std::vector<SharpRow> rows;
  for (auto first = this->Parts.begin(); first != this->Parts.end();)
  {
    const auto end = this->FindEnd(first);
    rows.push_back({ first->Row, GetMean(first, end, 0.) });
    first = end;
  }
  return rows;
}

SharpParts::Iterator SharpParts::FindRow(vtkIdType row) const
{
  return std::lower_bound(this->Parts.begin(), this->Parts.end(), row,
    [](const Part& part, vtkIdType wanted) { return part.Row < wanted; });
}

SharpParts::Iterator SharpParts::FindEnd(Iterator first) const
{
  return std::find_if(
    first, this->Parts.end(), [first](const Part& part) { return part.Row != first->Row; });
}

double SharpParts::GetMean(Iterator first, Iterator end, double steps)
{
  double sums[2] = { 0., 0. };
  int counts[2] = { 0, 0 };
  for (auto part = first; part != end; ++part)
  {
    const double left = part->Sharpness - steps;
    sums[part->IsFace] += std::max(left, 0.);
    counts[part->IsFace] += left > 0. ? 1 : 0;
  }
  const int kind = counts[0] > 0 ? 0 : 1;
  return counts[kind] > 0 ? sums[kind] / counts[kind] : 0.;
}

double SharpParts::GetSharpness(vtkIdType row, double steps) const
{
  const auto first = this->FindRow(row);
  return first == this->Parts.end() || first->Row != row
    ? 0.
    : GetMean(first, this->FindEnd(first), steps);
}

double SharpParts::GetMostSharpness(vtkIdType row) const
{
  double most = 0.;
  for (auto part = this->FindRow(row); part != this->Parts.end() && part->Row == row; ++part)
  {
    most = std::max(most, part->Sharpness);
  }
  return most;
}

template <typename Id>
std::vector<SharpRow> FindSharpRows(
  const SolidSharpness& sharpness, int steps, int depth, const SimplicialComplex<Id>& complex)
{
  SharpParts parts;
  // Calls add(piece, sharpness that is left) for the descendants of each simplex that is still
  // sharp, which follow each other.
  const auto forPieces = [steps, depth](const std::vector<double>& values, int dimension, auto add)
  {
    const int shift = dimension * depth;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const vtkIdType first = static_cast<vtkIdType>(i) << shift;
      const vtkIdType size = values[i] - steps > 0. ? vtkIdType(1) << shift : 0;
      for (vtkIdType piece = first; piece < first + size; ++piece)
      {
        add(piece, values[i] - steps);
      }
    }
  };
  forPieces(
    sharpness.Edges, 1, [&](vtkIdType piece, double left) { parts.AddEdge(complex, piece, left); });
  forPieces(
    sharpness.Faces, 2, [&](vtkIdType piece, double left) { parts.AddFace(complex, piece, left); });
  parts.Sort();
  return parts.GetRows();
}

template <typename Id>
void BlendSemiSharp(
  const std::vector<SharpRow>& rows, const Stencils<Id>& sharp, Stencils<Id>& smooth)
{
  std::vector<SharpRow> all = rows;
  AddSharpSectors(
    smooth.Explicit.Rows, sharp.Explicit.Rows, smooth.EdgeVertices, smooth.Vertices.size(), all);
  const auto appendOf = [](const Stencils<Id>& stencils)
  {
    return [&stencils](Id row, double factor, ExplicitRows<Id>& out)
    { stencils.AppendRow(row, factor, out); };
  };
  smooth.Explicit = BlendRows(all, smooth.Explicit, appendOf(smooth), appendOf(sharp));
}

#define SUBDIVISION_PARTS(Id)                                                                      \
  template void SharpParts::AddEdge(const SimplicialComplex<Id>&, vtkIdType, double);              \
  template void SharpParts::AddFace(const SimplicialComplex<Id>&, vtkIdType, double)
SUBDIVISION_PARTS(int);
SUBDIVISION_PARTS(long long);
SUBDIVISION_COMPILE_FUNCTION(FindSharpRows);
SUBDIVISION_COMPILE_FUNCTION(BlendSemiSharp);

}
