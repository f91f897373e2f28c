// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UniformRun.h
 * One execution of a uniform subdivision: it reads, plans, and writes (UniformSubdivision.cxx); the
 * steps between (UniformSteps.cxx); data for the next one (UniformKept.cxx); meshes that are a part
 * of a whole (UniformParts.cxx), or of which only some cells go on (UniformSplits.cxx); the limit
 * at places (UniformPlaces.cxx); interpolation, and warnings of its result
 * (UniformInterpolation.cxx).
 */
#ifndef SubdivisionObjects_UniformRun_h
#define SubdivisionObjects_UniformRun_h

#include "Core/Solids/AllSchemes/LevelCut.h"
#include "Core/Solids/Limits/PlaceLimits.h"
#include "Core/Solids/Limits/RegularLimits.h"
#include "Private/Arrays/PointArrays.h"
#include "Private/Control/ControlComplex.h"
#include "Private/Partitions/SharedNumbers.h"
#include "Private/Uniform/Classification.h"
#include "Private/Uniform/UniformCells.h"
#include "Private/Uniform/UniformSubdivision.h"

#include <memory>
#include <string>
#include <variant>
#include <vector>

class vtkPolyData;

namespace subdivision
{

class UniformRun
{
public:
  UniformRun(vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output)
    : Input(input)
    , Options(options)
    , Output(output)
  {
  }
  bool Run();
  /// Finds the limit at places, without an output.
  bool FindPlaces(const PlaceRequest& request);
  /// The same for the operators alone. The output gets no more than points and cells.
  bool FindOperators(UniformOperators& operators);

private:
  bool Plan();
  void Read(bool trustStamp);
  void StartPoints();
  bool FindKeptOrBuild();
  TopologyKey MakeKey() const;
  KeptOperator* FindKept(const TopologyKey& key);
  bool Build();
  template <typename Id>
  bool BuildLevel();
  const SchemeTraits& GetScheme() const;
  bool ReadsRings(bool hasSolids) const;
  void DecideNormals();
  bool LooksSmooth();
  std::string CheckLevels() const;
  std::string CheckLevels(const LevelCounts& counts, double bytesPerId) const;
  /// How many steps there are from the cells that go on, or all.
  int GetLastSteps() const;

  // Interpolation (UniformInterpolation.cxx).
  bool Interpolates() const;
  double GetPointsWeight() const;
  void PlanInterpolation();
  void Interpolate(const PointOperator* limit);
  void StampInterpolation(StampedIds& ids) const;

  bool Execute();
  void UseKept(KeptOperator& kept);
  template <typename Id>
  bool ReadPlaces(const PlaceRequest& request, std::vector<LimitPlace<Id>>& places,
    std::vector<vtkIdType>& missing) const;
  template <typename Scheme>
  bool FindNearest(const PlaceRequest& request, const typename Scheme::Level& level,
    const SemiSharpStages<typename Scheme::Id>& creases,
    std::vector<LimitPlace<typename Scheme::Id>>& places, std::vector<vtkIdType>& missing,
    vtkPolyData* found);
  template <typename Scheme>
  bool FindPlaces(const PlaceRequest& request, const typename Scheme::Level& level);
  void Keep();
  void FindFactors() const;
  // The steps of a volume scheme (SolidScheme.h), with its type of ids.
  template <typename Scheme>
  bool Step(typename Scheme::Level& level, KeptOperator* keep);
  template <typename Scheme>
  using Kept = KeptStepsOf<typename Scheme::Id>;
  template <typename Scheme>
  void StepNever(typename Scheme::Level& level, Kept<Scheme>& kept, KeptOperator* keep);
  template <typename Scheme>
  void StepOnce(typename Scheme::Level& level, LimitKinds<typename Scheme::Id>& kinds, int step,
    Kept<Scheme>* kept);
  template <typename Scheme>
  void StepLast(typename Scheme::Level& level, const LimitKinds<typename Scheme::Id>& kinds,
    Kept<Scheme>& kept, bool keeps);
  template <typename Scheme>
  void StepLastInPieces(const typename Scheme::Level& level, Kept<Scheme>& kept);
  template <typename Scheme>
  void StepTwice(const typename Scheme::Level& level, Kept<Scheme>& kept);
  template <typename Scheme>
  void StepTwice(const typename Scheme::Level& level, const typename Scheme::ChildRows& last,
    const LevelCut<Scheme>* cut, Kept<Scheme>& kept);
  template <typename Scheme>
  Stencils<typename Scheme::Id> TakeOperator(
    typename Scheme::Level& level, int step, const LevelCut<Scheme>* cut = nullptr) const;
  template <typename Scheme>
  std::vector<ColourMask> FindColours(const typename Scheme::Level& level, int step) const;
  std::vector<ColourMask> FindControlColours() const;
  template <typename Rows>
  void AddClassificationOf(const Rows& last);
  template <typename Scheme>
  void PlanLimit(const typename Scheme::Level& level, Kept<Scheme>& kept);
  template <typename Scheme>
  void FindLimit(const typename Scheme::Level& level, Kept<Scheme>& kept) const;
  template <typename Scheme>
  void MakeCells(const typename Scheme::Level& level, int steps, vtkDataArray* points);
  template <typename Scheme>
  void GatherDerived(const typename Scheme::Level& level, int steps);
  void LowerSharpness();
  /// `limits`: rows that are not kept.
  template <typename Scheme>
  void FinishPoints(
    Kept<Scheme>& kept, bool ownsCells, const BlockOperator<typename Scheme::Id>* limits = nullptr);
  void FinishPoints(bool ownsCells);

  // A mesh that has copies of cells of other partitions.
  void FindWanted();
  std::vector<CellRun> CountWanted() const;
  void NumberControl();
  SharedKeys MakeTriangleKeys(vtkIdType triangles) const;
  void FindTurned();
  template <typename Scheme>
  LevelCut<Scheme> MakeCut(const typename Scheme::Level& level, int further);
  template <typename Scheme>
  std::unique_ptr<LevelCut<Scheme>> CutOff(typename Scheme::Level& level, Kept<Scheme>& kept);
  void LeaveWanted();
  // Levels of which only some cells go on.
  bool FindSplit();
  bool IsLocal() const;
  template <typename Scheme>
  void Narrow(typename Scheme::Level& level, int step);
  void CountInWhole(Stamp& stamp, StampedIds& ids);

  void Write();
  void WriteStamps();
  void CheckOrientation();
  void AddClassification(const Buffer<Stratum>& vertices, const Buffer<Stratum>& edges);
  bool IsStopped(double done) const
  {
    return this->Options.Progress && this->Options.Progress(done);
  }

  vtkPointSet* Input;
  UniformOptions Options;
  vtkUnstructuredGrid* Output;
  ControlMesh Mesh;
  std::unique_ptr<PointArrays> Points;
  TopologyKey Key;                      ///< for the cache
  KeptOperator* Found = nullptr;        ///< an earlier execution kept it, and it fits
  std::unique_ptr<KeptOperator> ToKeep; ///< this execution will keep it; null: nothing
  /// The current level, if nothing kept fits.
  VolumeLevel Current;
  ControlTraits Control; ///< its runs belong to the current level
  SharpTuples Derived;   ///< derived singular simplices: points of the output
  std::vector<std::string> BuildWarnings;
  const KeptOperator* SameCells = nullptr; ///< kept, with the cells of the output
  UniformCells Cells;                      ///< of the output
  bool HasFrames = false;                  ///< normals and tangents do not need the last level
  bool HasRings = false;                   ///< nor do limits (RegularLimits.h)
  bool MakesLast = false;                  ///< the last level is made, not its cells alone
  bool HasTurned = false;                  ///< octahedra are cut around their shortest diagonals
  OtherPartitions* Others = nullptr;       ///< null: the mesh is the whole
  WantedSimplices Wanted;
  ControlNumbers Numbers; ///< if there are others
  FaceSides Sides;        ///< of the current level
  /// Control triangles that are turned, in the whole mesh; empty: none, or there are no normals.
  Buffer<unsigned char> Turned;
  bool IsNarrow = false;     ///< only cells go on that Options.Splits say
  SimplicesOfCells Split;    ///< then: of the last level that these know
  bool Solves = false;       ///< all partitions interpolate
  bool ReusesPoints = false; ///< the points of the output were kept
  /// For an input with octahedra: the cells whose values the children of its cells take
  /// (FindParents).
  std::vector<vtkIdType> Parents;
};

}

#endif
