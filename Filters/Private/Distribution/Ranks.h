// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Ranks.h
 * The messages of the ranks of a run to each other besides the mesh: texts, sizes, and which arrays
 * there are.
 */
#ifndef SubdivisionObjects_Ranks_h
#define SubdivisionObjects_Ranks_h

#include "Private/Distribution/JoinedMesh.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Run/RunOptions.h"

namespace subdivision
{

/// How the work of a rank ended. All together ended like the rank whose end comes last here.
enum class RunEnd
{
  Done,
  NotDone, ///< it has no output, and said nothing
  Stopped, ///< by the user
  Failed
};

/// Collects the messages of all ranks. Rank 0 gives them, each text once.
class RankMessages
{
public:
  /// Takes the place of options.Warn and options.Fail, which get the messages later.
  explicit RankMessages(RunOptions& options);

  /// Called by all ranks: gives the warnings of all and, if there are errors, the error of the
  /// first rank that has one. Other ranks that failed give no message. Returns whether one failed;
  /// if there is no output although nobody failed or stopped, that is an error too.
  bool Tell(Exchange& ranks, RunEnd end);

private:
  std::function<void(const std::string&)> Warn;
  std::function<void(const std::string&)> Fail;
  std::vector<std::string> Warnings;
  std::string Error;
  bool Failed = false;
};

/// How many ranks, this one included, run on this machine.
int CountRanksOfMachine(Exchange& ranks);

/// An error message if this rank has not enough memory for the meshes of the input twice, in the
/// joined mesh and in messages, and as many cells of others; else empty.
std::string CheckMemoryForJoining(const std::vector<MeshPart>& parts);

/// A warning if a partition has more than three times the mean number of cells; else empty. The
/// same in all partitions.
std::string CheckLoad(const std::vector<MeshPart>& parts, Exchange& exchange);

/// The type of the points of all joined meshes: single precision where all have it.
int FindPointType(const std::vector<MeshPart>& parts, Exchange& exchange);

/// Adds an empty part that has the arrays which only other partitions have: so that a filter finds
/// an array that is named in all partitions or in none. Its values are 0 here.
void ShareArrays(std::vector<MeshPart>& parts, Exchange& exchange);

}

#endif
