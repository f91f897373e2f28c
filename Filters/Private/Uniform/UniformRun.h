// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UniformRun.h
 * One execution of a uniform subdivision: it reads and plans, makes the steps, and writes
 * (UniformSubdivision.cxx); and what it keeps for the next (UniformKept.cxx).
 */
#ifndef SubdivisionObjects_UniformRun_h
#define SubdivisionObjects_UniformRun_h

#include "Private/Arrays/PointArrays.h"
#include "Private/Control/ControlComplex.h"
#include "Private/Uniform/UniformCells.h"
#include "Private/Uniform/UniformSubdivision.h"

#include <memory>
#include <string>
#include <variant>
#include <vector>

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
  template <template <typename> class AnyLevel, typename Id>
  bool BuildLevel();
  bool HasMemoryFor(const LevelCounts& counts, double bytesPerId) const;

  bool Execute();
  void UseKept(KeptOperator& kept);
  void Keep();
  template <template <typename> class AnyLevel, typename Id>
  bool Step(AnyLevel<Id>& level, KeptOperator* keep);
  template <typename Id>
  void StepTwice(const Level<Id>& level);
  template <typename Id>
  void StepTwice(const TetOctLevel<Id>& level);
  template <typename Rows>
  void FinishTwoSteps(const Rows& last);
  template <template <typename> class AnyLevel, typename Id, typename Kept>
  void GoToLimit(const AnyLevel<Id>& level, Kept& kept);
  template <typename Id>
  void MakeCells(const Level<Id>& level, int steps);
  template <typename Id>
  void MakeCells(const TetOctLevel<Id>& level, int steps);
  template <typename Id>
  void MakeTurnedCells(const Level<Id>&, Stencils<Id>&)
  {
  }
  template <typename Id>
  void MakeTurnedCells(TetOctLevel<Id>& level, TetOctStencils<Id>& stencils);
  template <typename Id>
  void PartOctahedra(const Level<Id>&)
  {
  }
  template <typename Id>
  void PartOctahedra(const TetOctLevel<Id>& level);
  void FinishPoints(bool ownsCells);
  bool IsTetOct() const { return this->Options.Scheme == StampScheme::TetOct; }

  void Write();
  void CheckOrientation();
  void AddClassification(const Buffer<Stratum>& vertices, const Buffer<Stratum>& edges);
  bool IsStopped(double done) const
  {
    return this->Options.Progress && this->Options.Progress(done);
  }

  vtkPointSet* Input;
  const UniformOptions& Options;
  vtkUnstructuredGrid* Output;
  ControlMesh Mesh;
  std::unique_ptr<PointArrays> Points;
  TopologyKey Key;                      ///< for the cache
  KeptOperator* Found = nullptr;        ///< what an earlier execution kept, if it fits
  std::unique_ptr<KeptOperator> ToKeep; ///< what this one will keep; null: nothing
  /// The current level, if nothing kept fits.
  std::variant<Level<int>, Level<long long>, TetOctLevel<int>, TetOctLevel<long long>> Current;
  ControlTraits Control; ///< its runs are those of the current level
  SimplexTuples Derived; ///< derived singular simplices: points of the output
  std::vector<std::string> BuildWarnings;
  const KeptOperator* SameCells = nullptr; ///< kept, with the cells of the output
  UniformCells Cells;                      ///< of the output
  bool HasTurned = false;                  ///< octahedra are cut around their shortest diagonals
  /// For an input with octahedra: the cells whose values the children of its cells take
  /// (FindParents).
  std::vector<vtkIdType> Parents;
};

}

#endif
