// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoreZoo.h
 * A zoo of small complexes with names, lattices, and random pieces of lattices.
 */
#ifndef SubdivisionObjects_CoreZoo_h
#define SubdivisionObjects_CoreZoo_h

#include "CoreTools.h"

#include <ostream>

namespace coretest
{

inline void PrintTo(const Mesh& mesh, std::ostream* out)
{
  *out << mesh.Name;
}

/// Points on a curved arc, so that nothing is flat by accident.
Mesh MakeSpread(const std::string& name, int points);

Mesh MakeTet(const std::string& name);

/// A vertex 0 with n triangles around it, closed or not, and the rim 1..
Mesh MakeFan(const std::string& name, int triangles, bool closed);

Mesh MakeOctahedronSurface();

Mesh MakeIcosahedron();

/// Four tetrahedra around the segment 0 1; `marked` says whether their order marks that segment.
Mesh MakeOctahedron(const std::string& name, bool marked);

/// A tetrahedron cut into four by its centre 4: the valence that has no smooth rule.
Mesh MakeValence4();

/// A Kuhn lattice of n^3 cubes; `seed` shuffles vertex numbers and the order within each cell.
struct Lattice
{
  Mesh Control;
  std::vector<std::array<int, 3>> Positions; ///< of each vertex
};
Lattice MakeLattice(const std::string& name, int n, double spacing, unsigned int seed);

/// Cells of a lattice, their faces, loose cells, repetitions and singular simplices, by chance.
Mesh MakeRandom(unsigned int seed);

Mesh MakeSimple(const std::string& name, int points, std::initializer_list<Tuple> cells,
  std::initializer_list<Tuple> singular = {});

/// A mesh with further cells or singular simplices.
Mesh With(Mesh mesh, const std::string& name, std::initializer_list<Tuple> cells,
  std::initializer_list<Tuple> singular = {});

std::vector<Mesh> MakeZoo();

/// Made when it is first asked for: CTest starts a process for each test, most of which need no
/// zoo.
const std::vector<Mesh>& GetZoo();

/// A mesh of the zoo, or the one that MakeRandom makes of the seed in "Random<seed>".
Mesh FindInZoo(const std::string& name);

/// For parametrised tests: the names of the zoo's meshes and of so many random ones.
std::vector<std::string> GetNamesOfZoo(unsigned int randoms);

std::vector<Mesh> MakeZooAndRandom();

/// A test of each mesh of the zoo and of the random ones.
template <typename Test>
void ForEachMesh(const Test& test)
{
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    SCOPED_TRACE(mesh.Name);
    test(mesh);
  }
}

}

#endif
