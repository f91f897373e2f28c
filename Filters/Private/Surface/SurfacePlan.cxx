// SPDX-License-Identifier: BSD-3-Clause
// A subdivision of a surface before its output: whether the stamp is true, where creases are, and
// the levels.
#include "Private/Surface/SurfaceRun.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Rules/Pi.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Control/OpenPoints.h"
#include "Private/Partitions/OtherPartitions.h"

#include <algorithm>
#include <limits>

namespace subdivision
{

/// Decides whether the stamp is true, and makes or finds the levels. Returns false if Progress asks
/// to stop.
template <typename Id>
bool SurfaceRun<Id>::Plan()
{
  this->Marked = FindMarkedEdges(this->Input, this->Options.Features.Marks, this->Options.Warn);
  OtherPartitions* others = this->Options.Others;
  const bool isMarked =
    others ? others->Sum(this->Marked.Points.empty() ? 0 : 1) > 0 : !this->Marked.Points.empty();
  const bool isStamped = !isMarked && this->ReadStamp();
  if (!isMarked)
  {
    this->WarnOfPartsAfresh();
  }
  bool isDone = this->Build();
  const bool isFalse = isStamped && (this->ExceedsStamp || (isDone && !this->IsDescendant()));
  if (isFalse)
  {
    if (this->Stamp.IsOfPart())
    {
      this->Options.Warn("The cells of the input are not those that an earlier filter made: this "
                         "filter takes them as any other mesh.");
    }
    this->ForgetStamp();
    isDone = this->Build();
  }
  Tell(this->Warnings, this->Options);
  return isDone;
}

/// Finds the control mesh of an earlier filter. Returns false if there is none.
template <typename Id>
bool SurfaceRun<Id>::ReadStamp()
{
  const bool isStamped = this->IsWhole() &&
    (ReadSurfaceStamp(this->Input, this->Stamp) ||
      ReadStampOfPart(this->Input, this->Cells, this->Stamp)) &&
    this->Stamp.Scheme == static_cast<int>(this->Options.Scheme) && this->FitsStamp() &&
    LiftSurfaceCells(
      this->Cells, this->Stamp,
      [this](vtkIdType a, vtkIdType b) { return this->HasSameFlags(a, b); }, this->Lifted);
  if (!isStamped)
  {
    this->Stamp = SurfaceStamp();
  }
  this->MadeLevels = this->Stamp.Levels;
  return isStamped;
}

template <typename Id>
void SurfaceRun<Id>::ForgetStamp()
{
  this->Stamp = SurfaceStamp();
  this->ExceedsStamp = false;
  this->MadeLevels = 0;
  this->Warnings.clear();
  this->Own.clear();
  this->Steps = nullptr;
  this->Joined = nullptr;
  this->JoinedControl = nullptr;
  this->Kept = nullptr;
  this->Creases = SharpPairs();
}

template <typename Id>
void SurfaceRun<Id>::StartPoints()
{
  this->GlobalIds = this->Stamp.GlobalIds.empty()
    ? ReadIdsOf(this->Input->GetPointData(), this->Input->GetNumberOfPoints())
    : this->Stamp.GlobalIds;
  this->NoCentres.Simplices.NumberOfPoints = this->Input->GetNumberOfPoints();
  this->Points = StartPointArrays(this->Options, this->Input, this->NoCentres, this->GlobalIds,
    this->Stamp.Levels > 0,
    [this](const std::string& warning) { this->Warnings.push_back(warning); });
}

template <typename Id>
SurfaceTags<Id> SurfaceRun<Id>::Classify(
  const SurfaceLevel<Id>& control, const SurfaceFeatures& features)
{
  SurfaceFeatures all = features;
  if (!this->Scheme->HalvesEdges() && !this->Scheme->IsDual() && !control.Lines.empty())
  {
    // RestrictTags makes all lines sharp: corners between them have sectors, too.
    all.SharpEdges.resize(static_cast<std::size_t>(control.Mesh.GetNumberOfEdges()), 0);
    for (const Id line : InTurn(control.Lines))
    {
      all.SharpEdges[static_cast<std::size_t>(line / 2)] = 1;
    }
  }
  SurfaceTags<Id> tags =
    ClassifySurface(control.Mesh, *this->Scheme, all, this->GetControlCoordinates());
  // Angles of the first input stay.
  const std::size_t size = tags.Sectors.size();
  if (this->MadeLevels > 0 && this->Stamp.Angles.size() == 2 * size)
  {
    for (std::size_t s = 0; s < size; ++s)
    {
      tags.Sectors[s].Angle = this->Stamp.Angles[s];
      tags.Sectors[s].Flatness = this->Stamp.Angles[size + s];
    }
  }
  return tags;
}

/// The warnings of cells that come apart, in a level that is not joined by seams.
template <typename Id>
std::vector<std::string> SurfaceRun<Id>::DescribeOpen(
  const SurfaceCells& cells, const SurfaceLevel<Id>& level)
{
  if (this->MadeLevels > 0 || this->Joined)
  {
    return {};
  }
  const FeatureOptions& features = this->Options.Features;
  OpenPointOptions options{ features.MergesPoints, features.ClosesNodes, "", {} };
  if (!features.JoiningCure.empty())
  {
    options.Cure = std::string(this->Scheme->HalvesEdges()
                       ? "switch JoinSeams on"
                       : "use a scheme that has JoinSeams: Loop, ModifiedButterfly, CatmullClark "
                         "or Linear") +
      ", which keeps the texture coordinates of both sides. MergePoints leaves them out.";
  }
  options.FindCell = [&](int dimension, vtkIdType index)
  {
    for (std::size_t i = 0; dimension == 1 && i < cells.SegmentCells.size(); ++i)
    {
      if (level.Lines[static_cast<vtkIdType>(i)] / 2 == index)
      {
        return cells.SegmentCells[i];
      }
    }
    return dimension == 2 ? cells.FaceCells[static_cast<std::size_t>(index)] : vtkIdType(-1);
  };
  return DescribeOpenPointsOfSurface(level.Mesh, this->Points->GetCoordinates(), options);
}

/// The first level that can be cut to the cells that go on by Options.Splits; 0: there is none.
template <typename Id>
int SurfaceRun<Id>::FindFirstLeft(const SurfaceCells& cells, const EdgeSharpness& sharpness) const
{
  const double children = static_cast<double>(cells.VertexCells.size()) +
    2. * static_cast<double>(cells.SegmentCells.size()) +
    this->Scheme->CountFaces(
      static_cast<double>(cells.GetNumberOfFaces()), static_cast<double>(cells.Corners.size()), 1);
  if (!this->Options.Splits || this->MadeLevels > 0 || this->MakesFrames() ||
    this->Options.Factors || this->Options.HasMaterialFields || this->Joined ||
    &cells == &this->JoinedMesh.Cells || this->Options.Others ||
    children != static_cast<double>(this->Options.Splits->Flags[0].size()))
  {
    return 0;
  }
  int level = 1;
  while (level < this->GetAllLevels() && IsSharpAfter(sharpness, level))
  {
    ++level;
  }
  return level;
}

/// Whether normals make no picture worse: all cells are faces, no edge between them is sharp, no
/// vertex has several fans, and the surface has two sides.
template <typename Id>
bool SurfaceRun<Id>::LooksSmooth(
  const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, const EdgeSharpness& sharpness) const
{
  if (!this->Cells.SegmentCells.empty() || !this->Cells.VertexCells.empty())
  {
    return false;
  }
  if (this->Options.SplitSharpEdges) // each side has normals of its own then
  {
    return IsOrientable(mesh);
  }
  return !IsSharpAfter(sharpness, this->MadeLevels) &&
    std::none_of(tags.Edges.begin(), tags.Edges.end(),
      [](EdgeTag tag) { return tag == EdgeTag::Joint || tag == EdgeTag::Crease; }) &&
    std::none_of(tags.Vertices.begin(), tags.Vertices.end(),
      [](VertexTag tag) { return tag == VertexTag::Blend; }) &&
    std::adjacent_find(tags.Sectors.begin(), tags.Sectors.end(),
      [](const auto& a, const auto& b) { return a.Vertex == b.Vertex; }) == tags.Sectors.end() &&
    IsOrientable(mesh);
}

template <typename Id>
LastLevel SurfaceRun<Id>::GetLastLevel() const
{
  // Who asks for no output, or for places, reads the level itself; sides of a part, too.
  const bool isWhole =
    !this->Output || this->Options.Places || this->Options.Others || this->SplitsSides();
  return !this->MakesFrames() && !this->Options.ProjectToLimit ? LastLevel::ForCells
    : isWhole                                                  ? LastLevel::Whole
    : this->MakesFrames()                                      ? LastLevel::ForTangents
                                                               : LastLevel::ForPositions;
}

/// Makes the levels and rules of `control`, or finds kept ones that fit. Null if Progress asks to
/// stop.
template <typename Id>
SurfaceSteps<Id>* SurfaceRun<Id>::MakeSteps(
  const SurfaceCells& cells, const SurfaceCells& control, KeptSurface<Id>*& found)
{
  // The first levels decide whether there are normals: joined ones, if there are seams.
  const bool decides = this->Options.NormalsWhereSmooth && !this->Joined;
  this->MakesNormals = this->Joined ? this->MakesNormals : this->Options.GenerateLimitNormals;
  SurfaceKey key{ this->Options.Scheme, this->Options.Features.ModifiedBoundary,
    this->Options.Features.Weights, this->Options.Levels, this->GetLastLevel(),
    this->Options.Use32BitIds, this->MadeLevels, SurfaceCells() };
  if (this->Options.Cache)
  {
    key.Cells = cells;
  }
  const auto find = [&]() -> KeptSurface<Id>*
  {
    return this->Options.Cache
      ? this->Options.Cache->template FindUnused<KeptSurface<Id>>(
          [&key](const KeptSurface<Id>& entry) { return entry.Key == key; })
      : nullptr;
  };
  KeptSurface<Id>* kept = find();
  if (!kept && decides)
  {
    this->MakesNormals = false;
    key.Last = this->GetLastLevel();
    kept = find();
  }
  SurfaceLevel<Id> fresh;
  if (!kept)
  {
    fresh = this->MakeFirstLevel(control);
  }
  const SurfaceLevel<Id>& first = kept ? kept->Steps->GetLevel(0) : fresh;
  SurfaceCreases creases = this->ReadCreases(control, first);
  if (this->Joined)
  {
    AddSeamCorners(first.Mesh, this->JoinedMesh, this->Joined->GetLevel(0).Tags, creases.Features);
  }
  SurfaceTags<Id> tags = this->Classify(first, creases.Features);
  this->ControlSectors = tags.Sectors;
  if (decides)
  {
    this->MakesNormals = this->LooksSmooth(first.Mesh, tags, creases.Sharpness);
    key.Last = this->GetLastLevel();
    if (kept && kept->Key.Last != key.Last)
    {
      kept = find();
      fresh = kept ? SurfaceLevel<Id>() : this->MakeFirstLevel(control);
    }
  }
  const std::vector<std::string> open =
    kept ? kept->Warnings : this->DescribeOpen(control, kept ? kept->Steps->GetLevel(0) : fresh);
  this->Warnings.insert(this->Warnings.end(), open.begin(), open.end());
  SurfaceSteps<Id>* steps = nullptr;
  if (kept && kept->Steps->ReplaceSectors(tags))
  {
    kept->Used = true;
    steps = kept->Steps.get();
  }
  else
  {
    if (kept)
    {
      kept = nullptr;
      fresh = this->MakeFirstLevel(control);
    }
    fresh.Tags = std::move(tags);
    const ClaimedLevel claimed = this->GetClaimedLevel();
    const int firstLeft = this->FindFirstLeft(cells, creases.Sharpness);
    auto own = std::make_unique<SurfaceSteps<Id>>(std::move(fresh), this->Scheme,
      this->GetAllLevels(), this->GetLastLevel(), this->Options.Progress, claimed,
      firstLeft > 0 ? this->Options.Splits : nullptr, firstLeft);
    steps = own.get();
    const int made = steps->GetNumberOfSteps();
    if (made < this->GetAllLevels())
    {
      this->ExceedsStamp = claimed.IsExceededBy(steps->GetLevel(made), made);
      return nullptr;
    }
    if (this->Options.Cache)
    {
      auto keep = std::make_unique<KeptSurface<Id>>();
      keep->Key = std::move(key);
      keep->Warnings = open;
      keep->Steps = std::move(own);
      kept = keep.get();
      this->Options.Cache->Add(std::move(keep));
      ++this->Options.Cache->NumberOfBuilds;
    }
    else
    {
      this->Own.push_back(std::move(own));
    }
  }
  this->SetSharpness(*steps, creases);
  this->MakeControl(control, creases, kept);
  found = kept;
  return steps;
}

/// Sets the semi-sharp creases of levels that begin with the control level.
template <typename Id>
void SurfaceRun<Id>::SetSharpness(SurfaceSteps<Id>& steps, const SurfaceCreases& creases)
{
  const bool useSharpness = this->Scheme->HalvesEdges();
  steps.SetSharpness(useSharpness ? creases.Sharpness : EdgeSharpness(),
    [&](const std::vector<bool>& sharp)
    {
      SurfaceFeatures sharper = creases.Features;
      sharper.SharpEdges.resize(sharp.size(), 0);
      for (std::size_t e = 0; e < sharp.size(); ++e)
      {
        sharper.SharpEdges[e] |= sharp[e];
      }
      const SurfaceLevel<Id>& made = steps.GetLevel(0);
      SurfaceTags<Id> more =
        ClassifySurface(made.Mesh, *this->Scheme, sharper, this->GetControlCoordinates());
      for (Sector<Id>& sector : more.Sectors) // corners that were corners before
      {
        const Sector<Id>* known = FindEqualSector(made.Tags, sector);
        sector.Angle = known ? known->Angle : sector.Angle;
        sector.Flatness = known ? known->Flatness : sector.Flatness;
      }
      return more;
    });
}

/// Sets the creases that no cell array has: from the stamp, or features and marks.
template <typename Id>
void SurfaceRun<Id>::FindCreases(const PolygonMesh<Id>& mesh, const SurfaceCells& cells)
{
  const bool isJoined = &cells == &this->JoinedMesh.Cells;
  this->Creases = this->Stamp.Creases; // none on a control mesh
  if (this->MadeLevels == 0)
  {
    this->Creases.Points = FindDerivedEdges(
      mesh, cells.FaceCells, this->Points->GetCoordinates(), this->Options.Features);
  }
  if (!this->Marked.Sharpness.empty())
  {
    this->Creases.Sharpness.assign(
      this->Creases.Points.size() / 2, std::numeric_limits<double>::infinity());
    this->Creases.Sharpness.insert(
      this->Creases.Sharpness.end(), this->Marked.Sharpness.begin(), this->Marked.Sharpness.end());
  }
  for (const vtkIdType point : InTurn(this->Marked.Points))
  {
    this->Creases.Points.push_back(isJoined ? this->JoinedMesh.FirstPoints[point] : point);
  }
}

/// Collects creases and corners of a control level from arrays, angles and the stamp.
template <typename Id>
SurfaceCreases SurfaceRun<Id>::ReadCreases(const SurfaceCells& cells, const SurfaceLevel<Id>& level)
{
  FeatureOptions features = this->Options.Features;
  if (this->MadeLevels > 0 && !this->Scheme->HalvesEdges())
  {
    // The stamp has the creases; lifted faces have no cell data to read them from.
    features.Singular = nullptr;
    features.Sharpness = nullptr;
  }
  SurfaceCreases creases = ReadSurfaceCreases(features, cells, level);
  for (double& sharpness : InTurn(creases.Sharpness))
  {
    sharpness += sharpness > 0. ? this->MadeLevels : 0.;
  }
  const vtkIdType points = this->GetControl().NumberOfPoints;
  creases.Features.Angles = ReadPointValues(this->Options.Features.CornerAngles, points, Pi / 180.);
  creases.Features.Flatness = ReadPointValues(this->Options.Flatness, points, 1.);
  if (this->Stamp.IsOfPart())
  {
    TakeGivenOfPart(this->Stamp, creases.Features);
  }
  this->Given = { creases.Features.Angles, creases.Features.Flatness };
  this->FindCreases(level.Mesh, cells);
  AddSharpEdges(level.Mesh, this->Creases, creases);
  if (!this->FindsRules())
  {
    ReadSharpCorners(this->Stamp, level.Mesh, creases.Features);
  }
  else
  {
    WriteSharpCorners(level.Mesh, creases, this->GetControlCoordinates(), this->Stamp);
  }
  if (!this->Scheme->HalvesEdges())
  {
    this->Creases = { ListSharpEdges(level.Mesh, creases.Features), {} };
  }
  return creases;
}

template <typename Id>
bool SurfaceRun<Id>::Build()
{
  this->StartPoints();
  this->KeepControlCoordinates();
  if (this->MadeLevels == 0 && this->FindSeams())
  {
    KeptSurface<Id>* kept = nullptr;
    this->Joined = this->MakeSteps(this->JoinedMesh.Cells, this->JoinedMesh.Cells, kept);
    if (!this->Joined)
    {
      return false;
    }
    this->JoinedControl = this->Control;
  }
  this->Steps = this->MakeSteps(this->Cells, this->GetControl(), this->Kept);
  return this->Steps != nullptr;
}

/// The turned faces of the last level of `steps`; of a part, as in the whole surface.
template <typename Id>
Buffer<unsigned char> SurfaceRun<Id>::FindTurned(const SurfaceSteps<Id>& steps) const
{
  const PolygonMesh<Id>& mesh = steps.GetLevel(0).Mesh;
  OtherPartitions* others = this->Options.Others;
  return SpreadTurned(
    steps, others ? this->FindTurnedOfPart(mesh, *others) : FindTurnedFaces(mesh));
}

/// Computes the points of the output on the joined mesh, and their normals and tangents.
/// `turned`: faces of its last level.
template <typename Id>
vtkSmartPointer<vtkDataArray> SurfaceRun<Id>::FollowPoints(const Buffer<unsigned char>& turned)
{
  vtkSmartPointer<vtkDataArray> points = this->Points->GetPoints();
  auto apply = [this, &points](const BlockOperator<Id>& rows)
  {
    this->AppendFactors(rows);
    const auto next = MakeArray(points->GetDataType(), 3, rows.GetNumberOfRows());
    if (points->GetDataType() == VTK_FLOAT)
    {
      rows.Apply(static_cast<const float*>(points->GetVoidPointer(0)),
        static_cast<float*>(next->GetVoidPointer(0)), 3);
    }
    else
    {
      rows.Apply(static_cast<const double*>(points->GetVoidPointer(0)),
        static_cast<double*>(next->GetVoidPointer(0)), 3);
    }
    points = next;
  };
  for (int step = 0; step < this->Options.Levels; ++step)
  {
    apply(this->Joined->GetStep(step));
  }
  const Buffer<vtkIdType> sources =
    FindJoinedVertices(*this->Steps, *this->Joined, this->Cells.NumberOfPoints);
  if (this->MakesFrames())
  {
    LimitFrames frames = this->FindFrames(*this->Joined, turned, points);
    for (Buffer<double>& values : frames.Tangents)
    {
      Buffer<double> taken(values.empty() ? 0 : 3 * sources.size());
      ForEach(taken.size(), [&](vtkIdType i) { taken[i] = values[3 * sources[i / 3] + i % 3]; });
      values = std::move(taken);
    }
    if (frames.Normals)
    {
      frames.Normals =
        vtkDataArray::SafeDownCast(Gather(frames.Normals, { sources.begin(), sources.end() }));
      frames.Normals->SetName(LimitNormalsName);
    }
    this->SetFrames(frames);
  }
  if (this->Options.ProjectToLimit)
  {
    apply(this->Joined->GetLimit(LimitKind::Position));
  }
  if (this->Options.Factors)
  {
    this->Options.Factors->Append(BlockOperator<Id>(points->GetNumberOfTuples(), sources.size(),
      [&sources](vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
      {
        for (; begin < end; ++begin)
        {
          rows.Add(sources[begin], 1.);
          rows.EndRow();
        }
      }));
  }
  return vtkDataArray::SafeDownCast(Gather(points, { sources.begin(), sources.end() }));
}

/// Whether the input is the mesh that the steps made of the control mesh.
template <typename Id>
bool SurfaceRun<Id>::IsDescendant() const
{
  const SurfaceLevel<Id>& level = this->Steps->GetLevel(this->MadeLevels);
  const PolygonMesh<Id>& mesh = level.Mesh;
  const SurfaceCells& cells = this->Cells;
  Buffer<vtkIdType> corners(this->Steps->GetNumberOfCorners(this->MadeLevels));
  if (mesh.NumberOfVertices != cells.NumberOfPoints ||
    mesh.NumberOfFaces != cells.GetNumberOfFaces() ||
    corners.size() != static_cast<vtkIdType>(cells.Corners.size()) ||
    2 * level.Lines.size() != static_cast<vtkIdType>(cells.Segments.size()))
  {
    return false;
  }
  for (const vtkIdType i : InTurn(2 * level.Lines.size()))
  {
    const Id line = level.Lines[i / 2];
    if (mesh.EdgeVertices[2 * (line / 2) + (line % 2 + i % 2) % 2] != cells.Segments[i])
    {
      return false;
    }
  }
  this->Steps->WriteFaces(this->MadeLevels, corners.data());
  return std::equal(corners.begin(), corners.end(), cells.Corners.begin());
}

SUBDIVISION_COMPILE(class SurfaceRun);

}
