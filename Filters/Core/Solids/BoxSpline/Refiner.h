// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Refiner.h
 * The parts of one uniform step: cells and incidences (Refinement.cxx), rings (RefinedRings.cxx).
 */
#ifndef SubdivisionObjects_Refiner_h
#define SubdivisionObjects_Refiner_h

#include "Core/Solids/BoxSpline/RingEmitter.h"

namespace subdivision
{

template <typename Id>
class Refiner
{
public:
  Refiner(const Level<Id>& parent, Depth depth)
    : Parent(parent.Complex)
    , Strata(parent.Strata)
    , Ids(parent.Complex)
    , Emitter(parent)
    , Full(depth == Depth::ForRefinement)
  {
  }

  Level<Id> Run();

private:
  void Count();
  void MakeEdges();
  void MakeFaces();
  void MakeInteriorFaces();
  void MakeTets();
  void MakeEqualCells();
  void MakeEqualTets();
  void CountRings();
  void MakeRings();

  const SimplicialComplex<Id>& Parent;
  const subdivision::Strata<Id>& Strata;
  const ChildIds<Id> Ids;
  const RingEmitter<Id> Emitter;
  const bool Full;
  Level<Id> Child;
};

}

#endif
