// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceTools.h"

#include "Core/Surfaces/Scheme/SurfaceTags.h"

#include "vtkDataArray.h"

#include <cstring>

namespace surfacetools
{

std::vector<Point> MakeRandomPoints(std::size_t count, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1., 1.);
  std::vector<Point> points(count);
  for (Point& point : points)
  {
    point = { coordinate(random), coordinate(random), coordinate(random) };
  }
  return points;
}

Model MakeFan(int n, bool open)
{
  Model model;
  const double turn = (open ? 1. : 2.) * std::acos(-1.) / n;
  model.Points.push_back({ 0., 0., 0. });
  for (int j = 0; j < n + (open ? 1 : 0); ++j)
  {
    model.Points.push_back({ std::cos(j * turn), std::sin(j * turn), 0. });
  }
  for (int j = 0; j < n; ++j)
  {
    model.Faces.push_back({ 0, 1 + j, open ? 2 + j : 1 + (j + 1) % n });
  }
  return model;
}

Model MakeSheet(int width, int height, bool triangles, Point a, Point b)
{
  Model model;
  for (int y = 0; y <= height; ++y)
  {
    for (int x = 0; x <= width; ++x)
    {
      model.Points.push_back({ x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2] });
    }
  }
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const vtkIdType p = y * (width + 1) + x;
      const vtkIdType q = p + width + 1;
      if (triangles)
      {
        model.Faces.push_back({ p, p + 1, q });
        model.Faces.push_back({ p + 1, q + 1, q });
      }
      else
      {
        model.Faces.push_back({ p, p + 1, q + 1, q });
      }
    }
  }
  const vtkIdType last = static_cast<vtkIdType>(model.Points.size()) - 1;
  model.Corners = { 0, width, last - width, last };
  return model;
}

std::map<std::string, Model> MakeZoo(bool triangles)
{
  std::map<std::string, Model> zoo;
  if (triangles)
  {
    zoo["triangle"].Faces = { { 0, 1, 2 } };
    zoo["two triangles"].Faces = { { 0, 1, 2 }, { 2, 1, 3 } };
    zoo["tetrahedron"].Faces = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } };
    zoo["moebius"].Faces = { { 0, 1, 2 }, { 1, 2, 3 }, { 2, 3, 4 }, { 3, 4, 0 }, { 4, 0, 1 } };
    zoo["flipped fan"].Faces = { { 0, 1, 2 }, { 0, 3, 2 }, { 0, 3, 4 }, { 0, 1, 4 } };
    zoo["book"].Faces = { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 0, 4 }, { 0, 4, 5 } };
    zoo["bow tie"].Faces = { { 0, 1, 2 }, { 0, 3, 4 } };
    zoo["touching tetrahedra"].Faces = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 },
      { 0, 4, 5 }, { 0, 5, 6 }, { 0, 6, 4 }, { 4, 6, 5 } };
    zoo["pillow"].Faces = { { 0, 1, 2 }, { 0, 2, 1 } };
  }
  else
  {
    zoo["quad"].Faces = { { 0, 1, 2, 3 } };
    zoo["pentagon and triangle"].Faces = { { 0, 1, 2, 3, 4 }, { 1, 0, 5 } };
    zoo["cube"].Faces = { { 0, 1, 2, 3 }, { 7, 6, 5, 4 }, { 0, 4, 5, 1 }, { 1, 5, 6, 2 },
      { 2, 6, 7, 3 }, { 3, 7, 4, 0 } };
    zoo["moebius"].Faces = { { 0, 2, 3, 1 }, { 2, 4, 5, 3 }, { 4, 1, 0, 5 } };
    zoo["flipped quads"].Faces = { { 0, 1, 2, 3 }, { 1, 2, 5, 4 }, { 3, 2, 5, 6 } };
    zoo["book"].Faces = { { 0, 1, 2, 3 }, { 0, 1, 4, 5 }, { 1, 0, 6, 7 }, { 0, 7, 8 } };
    zoo["bow tie"].Faces = { { 0, 1, 2, 3 }, { 0, 4, 5, 6 } };
  }
  zoo["crease"] = MakeSheet(3, 2, triangles, { 1., 0., 0. }, { 0., 1., 0. });
  zoo["crease"].Lines = { { 4, 5 }, { 6, 5 }, { 6, 7 }, { 5, 9 } };
  zoo["free line"].Faces = { { 0, 1, 2 } };
  zoo["free line"].Lines = { { 0, 3 }, { 4, 3 }, { 4, 5 }, { 3, 6 }, { 1, 2 } };
  unsigned seed = 0;
  for (auto& entry : zoo)
  {
    vtkIdType size = 1; // and one that is not used
    for (const Polygons* cells : { &entry.second.Faces, &entry.second.Lines })
    {
      for (const auto& cell : *cells)
      {
        size = std::max(size, 2 + *std::max_element(cell.begin(), cell.end()));
      }
    }
    entry.second.Points = MakeRandomPoints(static_cast<std::size_t>(size), ++seed);
  }
  return zoo;
}

SurfaceLevel<int> MakeLevel(std::size_t points, const Polygons& faces, const Polygons& lines)
{
  std::vector<vtkIdType> offsets{ 0 };
  std::vector<vtkIdType> corners;
  std::vector<vtkIdType> segments;
  for (const auto& face : faces)
  {
    corners.insert(corners.end(), face.begin(), face.end());
    offsets.push_back(static_cast<vtkIdType>(corners.size()));
  }
  for (const auto& line : lines)
  {
    segments.insert(segments.end(), line.begin(), line.end());
  }
  PolygonList<int> list;
  list.NumberOfVertices = static_cast<vtkIdType>(points);
  list.FaceOffsets = ToBuffer(offsets);
  list.Vertices = ToBuffer(corners);
  list.Segments = ToBuffer(segments);
  SurfaceLevel<int> level;
  level.Mesh = BuildPolygonMesh(std::move(list), level.Lines);
  return level;
}

Walk::Walk(const Model& model, SurfaceSchemeKind kind, bool modifiedBoundary)
  : Scheme(MakeSurfaceScheme<int>(kind, modifiedBoundary))
  , Points(model.Points)
  , Level(MakeLevel(model.Points.size(), model.Faces, model.Lines))
{
  SurfaceFeatures features;
  features.Corners.assign(model.Points.size(), 0);
  for (vtkIdType corner : model.Corners)
  {
    features.Corners[corner] = 1;
  }
  const bool isTurned = !this->Scheme->HalvesEdges() && !this->Scheme->IsDual();
  features.SharpEdges.assign(static_cast<std::size_t>(this->Level.Mesh.GetNumberOfEdges()), 0);
  for (const int line : this->Level.Lines)
  {
    features.SharpEdges[static_cast<std::size_t>(line / 2)] =
      isTurned ? 1 : 0; // as the filter does
  }
  this->Level.Tags =
    ClassifySurface(this->Level.Mesh, *this->Scheme, features, this->Points.data()->data());
  this->Scheme->RestrictTags(this->Level);
  this->Scheme->Prepare(this->Level);
}

RowBlock<int> Walk::GetRows() const
{
  RowBlock<int> rows;
  this->Scheme->AppendRows(
    this->Level, this->Level.Tags, 0, this->Scheme->GetNumberOfRows(this->Level), rows);
  return rows;
}

std::vector<Point> Walk::Apply(const RowBlock<int>& rows, const std::vector<Point>& in)
{
  std::vector<Point> out(rows.GetNumberOfRows());
  rows.Apply(in.data()->data(), out.data()->data(), 3);
  return out;
}

std::vector<Point> Walk::GetLimit(LimitKind kind) const
{
  RowBlock<int> rows;
  this->Scheme->AppendLimitRows(
    this->Level, this->Level.Tags, kind, 0, this->Level.Mesh.NumberOfVertices, rows);
  return Apply(rows, this->Points);
}

void Walk::Step()
{
  this->Points = Apply(this->GetRows(), this->Points);
  this->Level = this->Scheme->Refine(this->Level, Depth::ForRefinement);
  this->Scheme->Prepare(this->Level);
}

std::vector<Point> GetNormals(vtkPolyData* output, std::size_t count)
{
  vtkDataArray* array = output->GetPointData()->GetArray("LimitNormals");
  std::vector<Point> normals(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    array->GetTuple(static_cast<vtkIdType>(i), normals[i].data());
    EXPECT_NEAR(std::hypot(normals[i][0], normals[i][1], normals[i][2]), 1., 1e-12);
  }
  return normals;
}

std::vector<int> Walk::GetNeighbours(int vertex) const
{
  std::vector<int> ends;
  CollectEdges(this->Level.Mesh, vertex, [](int) { return true; }, ends);
  for (int& end : ends)
  {
    end = this->Level.Mesh.GetOtherEnd(end, vertex);
  }
  return ends;
}

void CheckIncidences(const SurfaceLevel<int>& level)
{
  const PolygonMesh<int>& mesh = level.Mesh;
  Polygons faces;
  for (int f = 0; f < mesh.NumberOfFaces; ++f)
  {
    const int* first = mesh.Vertices.data() + mesh.GetFirst(f);
    faces.emplace_back(first, first + mesh.GetSize(f));
    const std::set<vtkIdType> different(faces.back().begin(), faces.back().end());
    ASSERT_EQ(different.size(), faces.back().size());
  }
  Polygons lines;
  for (int e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    lines.push_back({ mesh.EdgeVertices[2 * e], mesh.EdgeVertices[2 * e + 1] });
  }
  const SurfaceLevel<int> found =
    MakeLevel(static_cast<std::size_t>(mesh.NumberOfVertices), faces, lines);
  ASSERT_EQ(found.Mesh.GetNumberOfEdges(), mesh.GetNumberOfEdges());
  EXPECT_EQ(found.Mesh.Joints.size(), mesh.Joints.size());
  EXPECT_EQ(found.Mesh.Sheaves.size(), mesh.Sheaves.size());
  for (int c = 0; c < mesh.GetNumberOfCorners(); ++c)
  {
    ASSERT_EQ(found.Mesh.Twins[c], mesh.Twins[c]) << "corner " << c;
    const std::set<int> ends{ mesh.Vertices[c], mesh.Vertices[mesh.Next(c)] };
    const int edge = mesh.Edges[c];
    EXPECT_EQ(
      ends, (std::set<int>{ mesh.EdgeVertices[2 * edge], mesh.EdgeVertices[2 * edge + 1] }));
    ASSERT_GE(mesh.EdgeCorners[edge], 0);
    EXPECT_EQ(mesh.Edges[mesh.EdgeCorners[edge]], edge);
  }
  for (std::size_t s = 0; s < mesh.Sheaves.size(); ++s)
  {
    EXPECT_TRUE(s == 0 || mesh.Sheaves[s].Edge > mesh.Sheaves[s - 1].Edge);
    EXPECT_GE(mesh.Sheaves[s].Corners.size(), 3u);
    for (int corner : mesh.Sheaves[s].Corners)
    {
      EXPECT_EQ(mesh.Edges[corner], mesh.Sheaves[s].Edge);
    }
  }
  for (int v = 0; v < mesh.NumberOfVertices; ++v)
  {
    const auto* joint = mesh.FindJoint(v);
    ASSERT_EQ(found.Mesh.FindJoint(v) != nullptr, joint != nullptr) << "vertex " << v;
    if (joint)
    {
      EXPECT_EQ(joint->Vertex, v);
      EXPECT_EQ(found.Mesh.FindJoint(v)->Fans.size(), joint->Fans.size());
      EXPECT_EQ(found.Mesh.FindJoint(v)->FreeEdges.size(), joint->FreeEdges.size());
    }
    VisitFans(mesh, v, [&](int corner) { EXPECT_EQ(mesh.Vertices[corner], v); });
    std::vector<int> own;
    std::vector<int> others;
    CollectEdges(mesh, v, [](int) { return true; }, own);
    CollectEdges(found.Mesh, v, [](int) { return true; }, others);
    EXPECT_EQ(own.size(), others.size());
  }
}

void CheckRows(const Walk& walk)
{
  const RowBlock<int> rows = walk.GetRows();
  ASSERT_EQ(
    static_cast<vtkIdType>(rows.GetNumberOfRows()), walk.Scheme->GetNumberOfRows(walk.Level));
  for (std::size_t row = 0; row < rows.GetNumberOfRows(); ++row)
  {
    double sum = 0.;
    for (std::size_t k = rows.GetBegin(row); k < rows.GetEnd(row); ++k)
    {
      sum += rows.GetWeights()[k];
      ASSERT_LT(rows.GetColumns()[k], walk.Level.Mesh.NumberOfVertices);
    }
    EXPECT_NEAR(sum, 1., 1e-14) << "row " << row;
    std::vector<vtkIdType> parents;
    walk.Scheme->GetParents(walk.Level, static_cast<vtkIdType>(row), parents);
    ASSERT_FALSE(parents.empty());
    for (vtkIdType parent : parents)
    {
      const int* begin = rows.GetColumns() + rows.GetBegin(row);
      const int* end = rows.GetColumns() + rows.GetEnd(row);
      EXPECT_NE(std::find(begin, end, parent), end) << "row " << row;
    }
  }
  auto map = [](const Point& p)
  { return Point{ 2. * p[0] - p[2] + 3., p[1] + p[0], 0.5 * p[2] - 1. + p[1] }; };
  std::vector<Point> moved = walk.Points;
  std::transform(moved.begin(), moved.end(), moved.begin(), map);
  const std::vector<Point> a = Walk::Apply(rows, moved);
  const std::vector<Point> b = Walk::Apply(rows, walk.Points);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_LT(GetDistance(a[i], map(b[i])), 1e-13);
  }
}

vtkSmartPointer<vtkPolyData> MakeInput(const Model& model)
{
  auto input = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& point : model.Points)
  {
    points->InsertNextPoint(point.data());
  }
  input->SetPoints(points);
  vtkNew<vtkCellArray> faces;
  vtkNew<vtkCellArray> lines;
  for (const auto& face : model.Faces)
  {
    faces->InsertNextCell(static_cast<vtkIdType>(face.size()), face.data());
  }
  for (const auto& line : model.Lines)
  {
    lines->InsertNextCell(static_cast<vtkIdType>(line.size()), line.data());
  }
  input->SetPolys(faces);
  input->SetLines(lines);
  return input;
}

vtkSmartPointer<vtkPolyData> RunFilter(vtkPolyData* input, int scheme, int levels, bool limit,
  const std::function<void(vtkSurfaceSubdivision*)>& configure)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(input);
  filter->SetScheme(scheme);
  filter->SetNumberOfLevels(levels);
  filter->SetProjectToLimit(limit);
  filter->SetGenerateLimitNormals(limit);
  if (configure)
  {
    configure(filter);
  }
  filter->Update();
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(filter->GetOutput());
  return output;
}

}
