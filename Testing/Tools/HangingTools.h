// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HangingTools.h
 * Meshes whose points lie inside edges and faces of other cells, and what a filter says of them.
 */
#ifndef SubdivisionObjects_HangingTools_h
#define SubdivisionObjects_HangingTools_h

#include "FeatureTools.h"

namespace hanging_tools
{

using namespace feature_tools;

inline const Configure Close = [](Filter* filter) { filter->CloseHangingNodesOn(); };

/// Collects cells by the places of their corners.
class Builder
{
public:
  vtkIdType Find(const Point& place);
  void Add(int type, const std::vector<Point>& places);
  /// An axis-parallel square or cube.
  void AddBox(int type, const Point& low, double side);
  Grid Make() const { return MakeGrid(this->Places, this->Cells); }

private:
  std::map<Point, vtkIdType> Ids;
  std::vector<Point> Places;
  std::vector<Cell> Cells;
};

/// Cubes (or squares) of a quadtree or octree that is refined towards the origin, `depth` times; as
/// a whole the cube from 0 to 2.
Grid MakeTree(int type, int depth);

/// Two triangles beside an edge that has `size` points, and cells on the other side of it.
Grid MakeTJunction(int size);

std::vector<std::string> Tell(
  vtkDataObject* input, int levels = 1, const Configure& configure = {});

bool Has(const std::vector<std::string>& warnings, const std::string& part);

}

#endif
