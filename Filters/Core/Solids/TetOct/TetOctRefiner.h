// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctRefiner.h
 * The parts of one uniform step: cells and incidences (TetOctComplex.cxx), rings (TetOctRings.cxx).
 */
#ifndef SubdivisionObjects_TetOctRefiner_h
#define SubdivisionObjects_TetOctRefiner_h

#include "Core/Solids/TetOct/TetOctChildren.h"
#include "Core/Solids/TetOct/TetOctRingEmitter.h"

namespace subdivision
{

template <typename Id>
class TetOctRefiner
{
public:
  TetOctRefiner(const TetOctLevel<Id>& parent, Depth depth)
    : Level(parent)
    , Parent(parent.Complex)
    , Strata(parent.Strata)
    , Ids(parent)
    , Emitter(parent)
    , Full(depth == Depth::ForRefinement)
  {
  }

  TetOctLevel<Id> Run();

private:
  void Count();
  void MakeEdges();
  void MakeFaces();
  void MakeFaceCells();
  void MakeCells();
  template <typename Shape>
  void MakeChildren(Id cell, Id firstTet, Id firstOct);
  void MakeEqualCells();
  void MakeEqualSolids();
  void CountRings();
  void MakeRings();

  const TetOctLevel<Id>& Level;
  const SimplicialComplex<Id>& Parent;
  const subdivision::Strata<Id>& Strata;
  const TetOctIds<Id> Ids;
  const TetOctRingEmitter<Id> Emitter;
  const bool Full;
  TetOctLevel<Id> Child;
};

}

#endif
