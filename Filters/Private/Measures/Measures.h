// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Measures.h
 * Does the work of vtkSubdivisionMeasures: measures the levels of an object, and goes on to the
 * limit.
 */
#ifndef SubdivisionObjects_Measures_h
#define SubdivisionObjects_Measures_h

#include "Private/Measures/CellMoments.h"

#include "vtkDoubleArray.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkDataObject;
class vtkMultiProcessController;
class vtkPointData;
class vtkTable;

namespace subdivision
{

/// Which measures are wanted, and how exact.
struct MeasureOptions
{
  /// Finds the cell array of materials and the point array of densities of a mesh, which may be
  /// null. Returns false after an error.
  std::function<bool(vtkUnstructuredGrid*, vtkDataArray*&, vtkDataArray*&)> FindArrays;
  std::function<void(const std::string&)> Fail;
  double Tolerance = 0.;
  vtkMultiProcessController* Controller = nullptr; ///< of ranks that share the mesh; or null
};

/// A number and how far it may be away from the truth.
struct Estimate
{
  double Value = 0.;
  double Remainder = 0.;
  double Scale = 0.; ///< the size of the numbers that it is a sum of
};

/// The limit of the measures of levels, the coarsest first. Their errors have powers of 1/4 where
/// the object is smooth. The remainder is at least `precision` times `scale`.
Estimate Extrapolate(const std::vector<double>& levels, double scale, double precision);

/// The derivatives of the measures of cells of a dimension, and of a material unless all are meant.
struct MeasureGradients
{
  int Dimension = 0;
  bool OfAllMaterials = true;
  double Material = 0.;
  /// A tuple for each point, as FindMomentGradients lists it; of a level, then of the control mesh.
  vtkSmartPointer<vtkDoubleArray> OfLevel, Sum;
};

/// The measures of one object.
class MeasuredLevels
{
public:
  explicit MeasuredLevels(MeasureOptions options)
    : Options(std::move(options))
  {
  }
  /// Reads the cells of the control mesh, not smoothed: arrays, size, and which solids are
  /// inverted.
  bool AddControl(vtkDataObject* made);
  /// Measures the next level, from 0 on, whose points lie on the limit. All ranks call both.
  bool AddLevel(vtkDataObject* made);
  bool HasControl() const { return this->IsRead; }
  int GetNumberOfLevels() const { return static_cast<int>(this->Levels.size()); }
  /// How many cells the next level has.
  double CountNextCells() const;
  /// Whether all remainders are within the tolerance.
  bool IsEnough() const;
  void Write(vtkTable* table) const;

  /// Finds the derivatives by the points of a level, which is one mesh.
  bool FindGradients(vtkDataObject* made, MeasureGradients& gradients) const;
  /// Makes the arrays of their sum.
  void WriteGradients(const MeasureGradients& gradients, vtkPointData* data) const;

private:
  struct Array
  {
    std::string Name;
    int Components;
  };
  using Key = std::pair<int, double>;

  void ReadArrays(const std::vector<vtkUnstructuredGrid*>& meshes);
  bool FindInput(vtkUnstructuredGrid* mesh, MomentInput& input) const;
  void FindSize(const std::vector<vtkUnstructuredGrid*>& meshes);
  bool ShareRows(MomentRows& rows) const;
  /// The measures of some cells on a level: measure, mass, centroid, inertia, integrals, means.
  std::vector<double> MakeFigures(const MomentRow& row) const;
  /// Their limits, and the limits of extremes: least and largest values of all components.
  std::vector<Estimate> FindLimits(const Key& key, bool ofAllMaterials) const;
  /// The sizes of figures and of extremes, in this order.
  std::vector<double> FindScales(const MomentRow& row) const;
  MomentRow TakeRow(int level, const Key& key, bool ofAllMaterials) const;

  MeasureOptions Options;
  bool IsRead = false;
  bool HasMaterial = false;
  bool HasDensity = false;
  std::vector<Array> Arrays;
  int Components = 0;
  double Precision = 1e-14; ///< of values
  std::array<double, 3> Origin = {};
  double Size = 0.;                            ///< half of the diagonal
  std::vector<std::vector<signed char>> Signs; ///< of the meshes
  std::vector<vtkIdType> NumbersOfPoints;      ///< of the meshes on the last level
  std::vector<MomentRows> Levels;
};

}

#endif
