// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenRefinementTools.h
 * Ways to run vtkRedGreenRefinement, and a check of conformity that knows nothing of how it works.
 */
#ifndef SubdivisionObjects_RedGreenRefinementTools_h
#define SubdivisionObjects_RedGreenRefinementTools_h

#include "CoreZoo.h"
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkRedGreenRefinement.h"

namespace red_green_refinement_tools
{

using namespace multi_dimensional_subdivision_tools;

using Filter = vtkRedGreenRefinement;
using Configure = std::function<void(Filter*)>;

/// Runs the filter with no criterion but those that `configure` sets; without `messages` it may not
/// say anything.
Grid Refine(vtkDataObject* input, const Configure& configure, Messages* messages = nullptr);

/// All edges are halved so many times.
Grid HalveAll(
  vtkDataObject* input, int levels, const Configure& configure = {}, Messages* messages = nullptr);

/// The largest difference of points and of their array "V", cell by cell; infinite if cells differ.
/// `sort`: whatever the order of the points of a cell.
double GetDifference(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b, bool sort);

Grid MakeGrid(const coretest::Mesh& mesh);

/// A lattice of n^3 cubes of side 1, in 6 tetrahedra each.
inline Grid MakeBox(int n)
{
  return MakeGrid(coretest::MakeLattice("Box", n, 1., 7).Control);
}

/// The wanted level of each cell, by chance.
void AddWantedLevels(vtkUnstructuredGrid* grid, int most, unsigned seed, double part = 0.2);

/// For each point its weights over all points of this grid: refinement in the middle of edges keeps
/// them right.
void AddWeights(vtkUnstructuredGrid* grid);

/// The point of another grid that has the same weights as each point of this one; -1: none has.
Ids FindSamePoints(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* other);

/// Four numbers for each point instead, for large grids: a point between up to four points of a
/// cell shows by them how much it has of each.
inline void AddRandomNumbers(vtkUnstructuredGrid* grid)
{
  grid->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("Random", 4, grid->GetNumberOfPoints(), -1., 1., 17));
}

/// The corners of a cell that have a part in a point with these numbers; -1 is among them where the
/// cell does not have the point.
std::set<vtkIdType> FindParts(
  vtkDataArray* numbersOfCorners, const Ids& corners, const double* numbers);

/// The largest distance, in any coordinate or value named `V`, of a point of one mesh from the
/// nearest of another.
double GetFarthest(vtkUnstructuredGrid* from, vtkUnstructuredGrid* to);

double GetVolume(vtkUnstructuredGrid* grid, vtkIdType cell);

/// What a cell with its longest edge may have.
double GetLargestVolume(vtkUnstructuredGrid* grid, vtkIdType cell);

inline vtkIdType GetOrigin(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  return static_cast<vtkIdType>(
    grid->GetCellData()->GetArray("vtkOriginalCellIds")->GetComponent(cell, 0));
}

/// Compares an output with the input whose points its `Weights` are about: cells fit together where
/// those of the input do, and nowhere else.
class Conformity
{
public:
  Conformity(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
    : Input(input)
    , Output(output)
  {
  }

  /// The first fault; empty if there is none.
  std::string Check();

private:
  static std::string Say(const Ids& ids);
  static std::vector<Ids> GetFaces(Ids cell);
  void FindCarriers();
  void FindCarriersByNumbers();
  Ids GetCarrier(const Ids& points) const;
  void CountFaces(const Ids& cell);
  std::string CheckVolumes();

  vtkUnstructuredGrid* Input;
  vtkUnstructuredGrid* Output;
  std::vector<std::set<vtkIdType>> Carriers; ///< the input's simplex that each point lies inside
  std::map<Ids, int> CellsAt[4];             ///< cells of each dimension that have a face
  std::set<Ids> InLarger;                    ///< faces of cells of higher dimension
};

inline std::string CheckConformity(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  return Conformity(input, output).Check();
}

/// Runs on the wanted levels of the input.
Grid RefineToWanted(vtkUnstructuredGrid* input, int maximum = 3);

/// One step where chance wants it, in one cell of so many; green cells of one parent want the same,
/// as a filter needs it to undo them.
Grid RefineByChance(vtkUnstructuredGrid* current, unsigned round, vtkIdType oneIn);

vtkIdType CountKind(vtkUnstructuredGrid* grid, int kind);

/// The point array x^3 + y, whose changes differ from edge to edge.
void AddValues(vtkUnstructuredGrid* grid, const char* name = "V");

inline double GetLevel(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  return grid->GetCellData()->GetArray("RefinementLevel")->GetComponent(cell, 0);
}

int GetFinestLevel(vtkUnstructuredGrid* grid);

inline double GetKind(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  return grid->GetCellData()->GetArray("RefinementKind")->GetComponent(cell, 0);
}

/// act(point, point) for all edges of all cells.
template <typename Act>
void ForEdges(vtkUnstructuredGrid* grid, const Act& act)
{
  for (const Ids& cell : GetCells(grid))
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      for (std::size_t k = 0; k < i; ++k)
      {
        act(cell[i], cell[k]);
      }
    }
  }
}

}

#endif
