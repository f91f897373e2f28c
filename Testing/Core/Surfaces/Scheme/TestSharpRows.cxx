// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 12, Sharpness: rows near semi-sharp creases, against the definition.
#include "SchemeTools.h"

#include "Core/Surfaces/Scheme/SharpRows.h"

using namespace surfacetools;

namespace
{

/// A sheet with a third face at one of its edges, two triangles in one corner, and a free line.
Model MakeModel(bool triangles)
{
  Model model = MakeSheet(4, 3, triangles, { 1., 0., 0. }, { 0., 1., 0. });
  model.Points.resize(24);
  model.Points[20] = { 2.5, 1., 1. };
  model.Points[21] = { 2.5, 1., 2. };
  model.Points[22] = { 5., 5., 0. };
  model.Points[23] = { 6., 5., 0. };
  model.Faces.push_back(
    triangles ? std::vector<vtkIdType>{ 7, 8, 20 } : std::vector<vtkIdType>{ 7, 8, 20, 21 });
  model.Lines = { { 19, 22 }, { 22, 23 } };
  return model;
}

template <typename Tag>
Buffer<Tag> CopyTags(const Buffer<Tag>& tags)
{
  Buffer<Tag> copy(tags.size());
  std::copy(tags.begin(), tags.end(), copy.begin());
  return copy;
}

/// A level, with edges that are sharp for some steps more.
struct Sharp
{
  Sharp(bool triangles, SurfaceSchemeKind kind, unsigned seed)
    : Scheme(MakeSurfaceScheme<int>(kind, true))
  {
    const Model model = MakeModel(triangles);
    this->Points = model.Points;
    this->Level = MakeLevel(model.Points.size(), model.Faces, model.Lines);
    std::mt19937 random(seed);
    std::vector<SharpEdge<int>> edges;
    for (int e = 0; e < this->Level.Mesh.GetNumberOfEdges(); ++e)
    {
      const double choices[4] = { 0.25, 0.5, 1., 2.5 };
      if (random() % 6 == 0)
      {
        edges.push_back({ e, choices[random() % 4] });
      }
    }
    this->SetEdges(edges);
    this->Scheme->Prepare(this->Level);
  }

  void SetEdges(const std::vector<SharpEdge<int>>& edges)
  {
    this->Edges = edges;
    this->Left.assign(static_cast<std::size_t>(this->Level.Mesh.GetNumberOfEdges()), 0.);
    for (const SharpEdge<int>& edge : edges)
    {
      this->Left[static_cast<std::size_t>(edge.Edge)] = edge.Left;
    }
    const auto classify = [&](double least)
    {
      SurfaceFeatures features;
      for (const double left : this->Left)
      {
        features.SharpEdges.push_back(left >= least ? 1 : 0);
      }
      return ClassifySurface(
        this->Level.Mesh, *this->Scheme, features, this->Points.data()->data());
    };
    this->Level.Tags = classify(9.);
    this->Whole = classify(1.);
    this->All = classify(0.05);
  }

  SharpRows<int> MakeRows() const
  {
    return SharpRows<int>(this->Level, { Copy(this->Whole), Copy(this->All) }, this->Edges);
  }
  static SurfaceTags<int> Copy(const SurfaceTags<int>& tags)
  {
    return { CopyTags(tags.Edges), CopyTags(tags.Vertices), tags.Sectors };
  }
  Weights GetRow(const SurfaceTags<int>& tags, vtkIdType row) const
  {
    RowBlock<int> rows;
    this->Scheme->AppendRows(this->Level, tags, row, row + 1, rows);
    return ToWeights(rows);
  }

  // By definition, 0: nothing is sharp in part.
  double GetPartOfVertex(int vertex) const
  {
    std::vector<double> parts;
    for (const SharpEdge<int>& edge : this->Edges)
    {
      const int* ends = &this->Level.Mesh.EdgeVertices[2 * edge.Edge];
      if (edge.Left < 1. && (ends[0] == vertex || ends[1] == vertex))
      {
        parts.push_back(edge.Left);
      }
    }
    return GetMean(parts);
  }
  double GetPartOf(const std::set<int>& vertices) const
  {
    std::vector<double> parts;
    for (const int vertex : vertices)
    {
      const double part = this->GetPartOfVertex(vertex);
      if (part > 0.)
      {
        parts.push_back(part);
      }
    }
    return GetMean(parts);
  }
  double GetPartOfEdge(int edge) const
  {
    const PolygonMesh<int>& mesh = this->Level.Mesh;
    const double left = this->Left[static_cast<std::size_t>(edge)];
    if (left > 0.)
    {
      return left < 1. ? left : 0.;
    }
    const double part =
      this->GetPartOf({ mesh.EdgeVertices[2 * edge], mesh.EdgeVertices[2 * edge + 1] });
    const int corner = mesh.EdgeCorners[edge];
    if (part > 0. || corner < 0)
    {
      return part;
    }
    std::set<int> across = this->GetCorners(mesh.GetFace(corner));
    if (mesh.Twins[corner] >= 0)
    {
      across.merge(this->GetCorners(mesh.GetFace(mesh.Twins[corner])));
    }
    return this->GetPartOf(across);
  }
  std::set<int> GetCorners(int face) const
  {
    const int* first = &this->Level.Mesh.Vertices[this->Level.Mesh.GetFirst(face)];
    return std::set<int>(first, first + this->Level.Mesh.GetSize(face));
  }
  double GetPartOfRow(int row) const
  {
    const int vertices = static_cast<int>(this->Level.Mesh.NumberOfVertices);
    const int edges = static_cast<int>(this->Level.Mesh.GetNumberOfEdges());
    return row < vertices      ? this->GetPartOfVertex(row)
      : row < vertices + edges ? this->GetPartOfEdge(row - vertices)
                               : this->GetPartOf(this->GetCorners(row - vertices - edges));
  }
  /// Whether a rule reads tags near sharp edges: that of an end of one, of an edge there or in a
  /// face there, of a face there.
  bool IsNear(int row) const
  {
    const PolygonMesh<int>& mesh = this->Level.Mesh;
    std::set<int> ends;
    for (const SharpEdge<int>& edge : this->Edges)
    {
      ends.insert({ mesh.EdgeVertices[2 * edge.Edge], mesh.EdgeVertices[2 * edge.Edge + 1] });
    }
    const auto hasEnd = [&](const std::set<int>& vertices)
    {
      return std::any_of(
        vertices.begin(), vertices.end(), [&](int vertex) { return ends.count(vertex) > 0; });
    };
    const int edge = row - static_cast<int>(mesh.NumberOfVertices);
    const int face = edge - static_cast<int>(mesh.GetNumberOfEdges());
    if (edge < 0)
    {
      return ends.count(row) > 0;
    }
    if (face >= 0)
    {
      return hasEnd(this->GetCorners(face));
    }
    bool isNear = hasEnd({ mesh.EdgeVertices[2 * edge], mesh.EdgeVertices[2 * edge + 1] });
    for (int f = 0; f < mesh.NumberOfFaces; ++f)
    {
      const int* first = &mesh.Edges[mesh.GetFirst(f)];
      isNear = isNear ||
        (hasEnd(this->GetCorners(f)) && std::count(first, first + mesh.GetSize(f), edge) > 0);
    }
    return isNear;
  }
  static double GetMean(const std::vector<double>& parts)
  {
    const double sum = std::accumulate(parts.begin(), parts.end(), 0.);
    return parts.empty() ? 0. : sum / static_cast<double>(parts.size());
  }

  std::shared_ptr<const SurfaceScheme<int>> Scheme;
  std::vector<Point> Points;
  SurfaceLevel<int> Level;
  SurfaceTags<int> Whole;
  SurfaceTags<int> All;
  std::vector<SharpEdge<int>> Edges;
  std::vector<double> Left; ///< of each edge; 0: it is not sharp
};

/// A scheme whose rows tell how many vertices their tags have, and nothing else.
class TagsScheme : public SurfaceScheme<int>
{
public:
  bool NeedsTriangles() const override { return false; }
  FaceMemory GetFaceMemory() const override { return {}; }
  vtkIdType GetNumberOfRows(const SurfaceLevel<int>& level) const override
  {
    return level.Mesh.NumberOfVertices + level.Mesh.GetNumberOfEdges() + level.Mesh.NumberOfFaces;
  }
  void AppendRows(const SurfaceLevel<int>& /*level*/, const SurfaceTags<int>& tags, vtkIdType begin,
    vtkIdType end, RowBlock<int>& rows) const override
  {
    for (vtkIdType row = begin; row < end; ++row)
    {
      rows.Add(row, static_cast<double>(tags.Vertices.size()));
      rows.EndRow();
    }
  }
  void GetParents(
    const SurfaceLevel<int>& /*level*/, vtkIdType /*row*/, std::vector<vtkIdType>&) const override
  {
  }
  SurfaceLevel<int> Refine(const SurfaceLevel<int>& /*level*/, Depth /*depth*/) const override
  {
    return {};
  }
  void ListChildren(const SurfaceLevel<int>& /*level*/, const SurfaceSegments& /*segments*/,
    SurfaceSegments& /*children*/) const override
  {
  }
  void WriteFaces(const SurfaceLevel<int>& /*level*/, IdsOut /*ids*/) const override {}
  SurfaceTags<int> RefineTags(
    const SurfaceLevel<int>& /*level*/, const SurfaceTags<int>& /*tags*/) const override
  {
    return {};
  }
  void CarryFaces(const SurfaceLevel<int>& /*level*/, const Buffer<Carrier<int>>& /*faces*/,
    bool /*areWhole*/, Buffer<Carrier<int>>& /*children*/) const override
  {
  }
  void AppendLimitRows(const SurfaceLevel<int>& /*level*/, const SurfaceTags<int>& /*tags*/,
    LimitKind /*kind*/, vtkIdType /*begin*/, vtkIdType /*end*/,
    RowBlock<int>& /*rows*/) const override
  {
  }
};

SurfaceTags<int> MakeTags(vtkIdType size)
{
  SurfaceTags<int> tags;
  tags.Vertices = Buffer<VertexTag>(size, VertexTag::Smooth);
  return tags;
}

void CheckRows(const Sharp& sharp, int* partly)
{
  const SharpRows<int> made = sharp.MakeRows();
  const int size = static_cast<int>(sharp.Scheme->GetNumberOfRows(sharp.Level));
  for (const int step : { size, 7, 1 })
  {
    RowBlock<int> rows;
    for (int begin = 0; begin < size; begin += step)
    {
      made.Append(*sharp.Scheme, sharp.Level, begin, std::min(begin + step, size), rows);
    }
    ASSERT_EQ(static_cast<int>(rows.GetNumberOfRows()), size);
    for (int row = 0; row < size; ++row)
    {
      Weights found;
      const auto at = static_cast<std::size_t>(row);
      for (std::size_t i = rows.GetBegin(at); i < rows.GetEnd(at); ++i)
      {
        found[rows.GetColumns()[i]] += rows.GetWeights()[i];
      }
      const double part = sharp.GetPartOfRow(row);
      Weights expected;
      for (const auto& [column, weight] : sharp.GetRow(sharp.Whole, row))
      {
        expected[column] += (1. - part) * weight;
      }
      for (const auto& [column, weight] : sharp.GetRow(sharp.All, row))
      {
        expected[column] += part * weight;
      }
      ExpectRow(found, expected, "row " + std::to_string(row));
      *partly += part > 0.;
    }
  }
}

}

TEST(SharpRows, AreThoseOfTheDefinition)
{
  const std::pair<SurfaceSchemeKind, bool> cases[] = { { SurfaceSchemeKind::Loop, true },
    { SurfaceSchemeKind::ModifiedButterfly, true }, { SurfaceSchemeKind::CatmullClark, false },
    { SurfaceSchemeKind::CatmullClark, true } };
  int partly = 0;
  for (const auto& [kind, triangles] : cases)
  {
    for (unsigned seed = 1; seed <= 12; ++seed)
    {
      SCOPED_TRACE(
        "scheme " + std::to_string(static_cast<int>(kind)) + " seed " + std::to_string(seed));
      const Sharp sharp(triangles, kind, seed);
      ASSERT_FALSE(sharp.Edges.empty());
      CheckRows(sharp, &partly);
    }
  }
  EXPECT_GT(partly, 1000);
}

// Which rows are read with other tags, and how much of each. Rows far away have the level's tags.
TEST(SharpRows, WhichTagsARowHas)
{
  const TagsScheme scheme;
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    SCOPED_TRACE(seed);
    const bool triangles = seed % 2 == 0;
    Sharp sharp(triangles, SurfaceSchemeKind::CatmullClark, seed);
    std::mt19937 random(seed);
    const int size = static_cast<int>(sharp.Level.Mesh.GetNumberOfEdges());
    std::vector<SharpEdge<int>> edges;
    for (int e = static_cast<int>(random() % 9); e < size; e += 1 + static_cast<int>(random() % 30))
    {
      edges.push_back({ e, 0.125 * static_cast<double>(1 + random() % 12) });
    }
    sharp.SetEdges(edges);
    sharp.Level.Tags = MakeTags(1);
    const SharpRows<int> made(sharp.Level, { MakeTags(2), MakeTags(3) }, sharp.Edges);
    const int rows = static_cast<int>(scheme.GetNumberOfRows(sharp.Level));
    for (const int step : { rows, 5 })
    {
      for (int begin = 0; begin < rows; begin += step)
      {
        RowBlock<int> block;
        const int end = std::min(begin + step, rows);
        made.Append(scheme, sharp.Level, begin, end, block);
        ASSERT_EQ(static_cast<int>(block.GetNumberOfRows()), end - begin);
        for (int row = begin; row < end; ++row)
        {
          const auto at = static_cast<std::size_t>(row - begin);
          double sum = 0.;
          for (std::size_t i = block.GetBegin(at); i < block.GetEnd(at); ++i)
          {
            ASSERT_EQ(block.GetColumns()[i], row);
            sum += block.GetWeights()[i];
          }
          const double part = sharp.GetPartOfRow(row);
          EXPECT_NEAR(sum, sharp.IsNear(row) ? 2. + part : 1., 1e-14) << row;
          EXPECT_EQ(block.GetEnd(at) - block.GetBegin(at), part > 0. ? 2u : 1u) << row;
        }
      }
    }
  }
}

// Each of the rules alone: one edge that is sharp in part, one that is sharp for a whole step.
TEST(SharpRows, OneEdgeThatIsSharp)
{
  for (int edge = 0; edge < 36; ++edge)
  {
    for (const double left : { 0.3, 1., 2. })
    {
      Sharp sharp(edge % 2 == 0, SurfaceSchemeKind::CatmullClark, 1);
      ASSERT_LT(edge, sharp.Level.Mesh.GetNumberOfEdges());
      sharp.SetEdges({ { edge, left } });
      int partly = 0;
      SCOPED_TRACE("edge " + std::to_string(edge));
      CheckRows(sharp, &partly);
      EXPECT_EQ(partly > 0, left < 1.);
    }
  }
}

// The parts of edges are added in the order of the edges: the same bits in each run.
TEST(SharpRows, PartsInTheOrderOfEdges)
{
  const int vertex = 6; // inside the sheet
  Sharp sharp(false, SurfaceSchemeKind::CatmullClark, 1);
  std::vector<SharpEdge<int>> edges;
  for (int e = 0; e < sharp.Level.Mesh.GetNumberOfEdges() && edges.size() < 3; ++e)
  {
    const int* ends = &sharp.Level.Mesh.EdgeVertices[2 * e];
    if (ends[0] == vertex || ends[1] == vertex)
    {
      edges.push_back({ e, 0.1 * static_cast<double>(1 + edges.size()) });
    }
  }
  edges[2].Left = 0.3;
  sharp.SetEdges(edges);
  const double part = (0.1 + 0.2 + 0.3) / 3.;
  ASSERT_NE(part, (0.3 + 0.2 + 0.1) / 3.);
  RowBlock<int> rows;
  sharp.MakeRows().Append(*sharp.Scheme, sharp.Level, vertex, vertex + 1, rows);
  std::vector<double> expected;
  for (const bool all : { false, true })
  {
    RowBlock<int> one;
    sharp.Scheme->AppendRows(sharp.Level, all ? sharp.All : sharp.Whole, vertex, vertex + 1, one);
    for (std::size_t i = 0; i < one.GetNumberOfEntries(); ++i)
    {
      expected.push_back((all ? part : 1. - part) * one.GetWeights()[i]);
    }
  }
  EXPECT_EQ(std::vector<double>(rows.GetWeights(), rows.GetWeights() + rows.GetNumberOfEntries()),
    expected);
}

TEST(SharpRows, VerticesWithTheirNeighbours)
{
  for (const bool triangles : { false, true })
  {
    const Model model = MakeModel(triangles);
    const PolygonMesh<int> mesh = MakeLevel(model.Points.size(), model.Faces, model.Lines).Mesh;
    for (const std::vector<int>& chosen :
      { std::vector<int>{}, { 6 }, { 7 }, { 19 }, { 22 }, { 23 }, { 3, 8, 15 }, { 0, 1, 20 } })
    {
      std::set<int> expected(chosen.begin(), chosen.end());
      for (const Polygons* cells : { &model.Faces, &model.Lines })
      {
        for (const auto& cell : *cells)
        {
          const bool isNear = std::any_of(cell.begin(), cell.end(), [&](vtkIdType v)
            { return std::count(chosen.begin(), chosen.end(), static_cast<int>(v)) > 0; });
          for (const vtkIdType v : cell)
          {
            isNear ? void(expected.insert(static_cast<int>(v))) : void();
          }
        }
      }
      EXPECT_EQ(
        CollectWithNeighbours(mesh, chosen), std::vector<int>(expected.begin(), expected.end()));
    }
  }
}
