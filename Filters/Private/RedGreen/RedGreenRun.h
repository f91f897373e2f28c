// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenRun.h
 * One execution of a red-green refinement: it reads, plans, and writes (RedGreenRefinement.cxx);
 * the rounds between (RedGreenRounds.cxx).
 */
#ifndef SubdivisionObjects_RedGreenRun_h
#define SubdivisionObjects_RedGreenRun_h

#include "Private/Arrays/PointArrays.h"
#include "Private/RedGreen/RedGreenErrors.h"
#include "Private/RedGreen/RedGreenLimit.h"
#include "Private/RedGreen/RedGreenMesh.h"
#include "Private/RedGreen/RedGreenRefinement.h"
#include "Private/RedGreen/RefinementMarks.h"
#include "Private/RedGreen/SharedSplits.h"

#include <memory>
#include <string>
#include <vector>

namespace subdivision
{

class RedGreenRun
{
public:
  RedGreenRun(vtkPointSet* input, RedGreenOptions& options, vtkUnstructuredGrid* output)
    : Input(input)
    , Options(options)
    , Others(options.Others)
    , Output(output)
  {
  }
  bool Run();

private:
  template <typename Id>
  using Marks = std::vector<RefinementMark<Id>>;

  void Read(bool trustStamp);
  void StartPoints();
  void FindLimit();
  template <typename Id>
  bool Refine();
  template <typename Id>
  bool Plan(SharedState<Id>& shared, RedGreenLimit<Id>& limit);
  template <typename Id>
  bool BuildLimit(RedGreenLimit<Id>& limit);
  template <typename Id>
  void Interpolate(RedGreenLimit<Id>& limit);
  template <typename Id>
  bool FindCells(SharedState<Id>& shared, const RedGreenLimit<Id>& limit);
  template <typename Id>
  SharedState<Id> StartState();
  template <typename Id>
  bool RunRounds(SharedState<Id>& shared, const RedGreenLimit<Id>& limit);
  template <typename Id, typename Cells>
  Marks<Id> FindMarksOf(const Cells& cells, const RedGreen<Id>& state, RedGreenErrors<Id>* errors,
    MarkNotes& notes) const;
  template <typename Id>
  void StopAtLimit(std::vector<Marks<Id>>& rounds, SharedState<Id>& shared);
  bool IsTooLarge(vtkIdType ownCells);
  bool AllAgree(bool own) const { return this->Others ? this->Others->Sum(own ? 0 : 1) == 0 : own; }
  void WarnOfNotes(MarkNotes& notes);

  template <typename Id>
  void MakePoints(Id given, const std::vector<std::array<Id, 2>>& midpoints,
    const std::vector<WeightedVertices>& means, const RedGreenLimit<Id>& limit);
  Coordinates GetGivenCoordinates()
  {
    return this->GivenCoordinates.empty()
      ? this->Points->GetCoordinates()
      : Coordinates(this->GivenCoordinates.data(), this->Points->GetTie());
  }
  bool ReadsLimit() const
  {
    return this->Options.LimitPlacement || this->Options.Criteria.ReadsLimit();
  }
  /// Adds a warning. Warnings are told when it is known that the stamp is true.
  void Warn(const std::string& warning) { this->Mesh.Control.Warnings.push_back(warning); }
  bool IsStopped(double done) const
  {
    return this->Options.Progress && this->Options.Progress(done);
  }

  vtkPointSet* Input;
  RedGreenOptions& Options;
  OtherPartitions* Others; ///< null: the input is the whole mesh
  vtkUnstructuredGrid* Output;
  RedGreenMesh Mesh;
  std::unique_ptr<PointArrays> Points;
  std::vector<double> GivenCoordinates; ///< where Points has others, which interpolate them
  std::unique_ptr<RefinementCriteria> Criteria;
  double MostCells = 0.;       ///< that the output may have
  vtkIdType NumberOfCells = 0; ///< of all partitions, when IsTooLarge was called
  bool MemoryIsLimit = false;
};

}

#endif
