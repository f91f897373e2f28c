// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPartsInHalves.cxx
 * Parts of cells one step deeper are those of a mesh that is split once more.
 */
#include "BezierTools.h"
#include "BoundTools.h"

#include "Private/Bounds/Deviations.h"
#include "Private/Bounds/PartsAsCells.h"

using namespace bound_tools;
using bezier_tools::MakeSheet;
using subdivision::Buffer;
using subdivision::NestedPieces;
using subdivision::PartsAsCells;
using subdivision::PieceLattice;
using subdivision::Sectors;

namespace
{

/// The levels of a filter from `first` on, and their values of array Two.
template <typename FilterClass>
class Levels
{
public:
  using Set = std::function<void(FilterClass*)>;

  Levels(vtkDataObject* input, int first, const Set& configure, bool isTetOct = false)
    : IsTetOct(isTetOct)
  {
    for (int level = first; level <= first + NestedPieces::Steps + 1; ++level)
    {
      vtkNew<FilterClass> filter;
      filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
      filter->SetNumberOfLevels(level);
      if (configure)
      {
        configure(filter);
      }
      using Output = typename Bounded<FilterClass>::Output;
      this->Meshes.push_back(UpdateWithoutErrors<Output>(filter.Get(), input));
      if (level == first + NestedPieces::Steps)
      {
        this->Factors = GetLastFactors(filter.Get(), 2);
      }
    }
  }

  NestedPieces MakePieces(int from) const
  {
    std::array<vtkIdType, NestedPieces::Steps + 1> points{};
    for (int step = 0; step <= NestedPieces::Steps; ++step)
    {
      points[step] = this->Meshes[from + step]->GetNumberOfPoints();
    }
    return NestedPieces(this->Meshes[from + NestedPieces::Steps], points,
      this->IsTetOct ? this->Meshes[from].Get() : nullptr);
  }

  Buffer<double> GetValues(int level) const
  {
    vtkDataArray* array = this->Meshes[level]->GetPointData()->GetArray("Two");
    Buffer<double> values(2 * array->GetNumberOfTuples());
    for (vtkIdType i = 0; i < values.size(); ++i)
    {
      values[i] = array->GetComponent(i / 2, static_cast<int>(i % 2));
    }
    return values;
  }

  Sectors::Step GetStep() const
  {
    // The operator of a surface is one matrix.
    const bool isOne =
      this->Factors[1].Columns.size() > 0 && this->GetLargestColumn(1) < this->GetPointsBefore();
    return isOne ? Sectors::Step{ &this->Factors[1] }
                 : Sectors::Step{ &this->Factors[0], &this->Factors[1] };
  }

private:
  long long GetLargestColumn(int factor) const
  {
    const Buffer<long long>& columns = this->Factors[factor].Columns;
    return *std::max_element(columns.begin(), columns.end());
  }
  long long GetPointsBefore() const
  {
    return this->Meshes[NestedPieces::Steps - 1]->GetNumberOfPoints();
  }

  const bool IsTetOct;
  std::vector<vtkSmartPointer<vtkPointSet>> Meshes;
  std::vector<subdivision::MatrixFactors::Matrix> Factors;
};

/// Compares all parts, or each one alone. Returns how many values were compared.
template <typename FilterClass>
vtkIdType Compare(vtkDataObject* input, int first, bool isAlone,
  const std::function<void(FilterClass*)>& configure = {})
{
  const Levels<FilterClass> levels(input, first, configure);
  const NestedPieces pieces = levels.MakePieces(0);
  const NestedPieces expected = levels.MakePieces(1);
  const Sectors sectors(pieces, levels.GetStep());
  const Buffer<double> finest = levels.GetValues(NestedPieces::Steps + 1);
  std::vector<PartsAsCells::Part> parts;
  for (vtkIdType c = 0; c < pieces.GetNumberOfCells(); ++c)
  {
    for (int child = 0; child < static_cast<int>(pieces.GetLattice(c).Children.size()); ++child)
    {
      parts.push_back({ c, child });
    }
  }
  EXPECT_EQ(static_cast<vtkIdType>(parts.size()), expected.GetNumberOfCells());
  vtkIdType compared = 0;
  const auto compare = [&](const std::vector<PartsAsCells::Part>& wanted, vtkIdType cell)
  {
    const auto deeper = subdivision::SplitIntoHalves({ pieces, sectors, levels.GetStep() }, wanted);
    const auto made = deeper->Get();
    const Buffer<double> second = deeper->Take(2, levels.GetValues(NestedPieces::Steps), 2);
    Buffer<double> third(2 * made.Pieces.GetNumberOfPoints(NestedPieces::Steps));
    made.Last[0]->Apply(second.data(), third.data(), 2);
    for (std::size_t c = 0; c < wanted.size(); ++c)
    {
      const vtkIdType own = made.Pieces.GetFirstPlace(static_cast<vtkIdType>(c));
      const vtkIdType other = expected.GetFirstPlace(cell + static_cast<vtkIdType>(c));
      const PieceLattice& lattice = made.Pieces.GetLattice(static_cast<vtkIdType>(c));
      for (std::size_t i = 0; i < lattice.Places.size(); ++i)
      {
        for (int x = 0; x < 2; ++x)
        {
          const auto at = static_cast<vtkIdType>(i);
          ASSERT_NEAR(third[2 * made.Pieces.GetPoint(own + at) + x],
            finest[2 * expected.GetPoint(other + at) + x], 1e-10)
            << "cell " << cell + static_cast<vtkIdType>(c) << " point " << i;
          ++compared;
        }
      }
    }
  };
  if (!isAlone)
  {
    compare(parts, 0);
    return compared;
  }
  for (std::size_t p = 0; p < parts.size(); p += 7)
  {
    compare({ parts[p] }, static_cast<vtkIdType>(p));
  }
  return compared;
}

}

TEST(PartsInHalves, AreThoseOfAMeshThatIsSplitOnceMore)
{
  vtkIdType compared = 0;
  for (unsigned seed = 1; seed < 25; ++seed)
  {
    SCOPED_TRACE(seed);
    const bool withSolids = seed % 4 == 0;
    const Configure configure = [&](Filter* filter)
    {
      filter->SetDetectFeatures(seed % 2 == 0);
      filter->SetEmbeddedCells(static_cast<int>(seed % 3));
      filter->SetModifiedBoundary(seed % 3 == 1);
      filter->SetCreaseEnd(static_cast<int>(seed / 2 % 2));
    };
    compared += Compare<Filter>(WithValues(MakeRandomComplex(seed, withSolids)),
      withSolids ? 0 : static_cast<int>(seed % 2), seed % 3 == 0, configure);
  }
  EXPECT_GT(compared, 100000);
}

TEST(PartsInHalves, OfQuads)
{
  for (const bool isAlone : { false, true })
  {
    for (const bool modified : { false, true })
    {
      EXPECT_GT(Compare<vtkSurfaceSubdivision>(WithValues(MakeSheet(3, false, 0.2)), 0, isAlone,
                  [&](vtkSurfaceSubdivision* filter)
                  {
                    filter->SetSchemeToCatmullClark();
                    filter->SetModifiedBoundary(modified);
                  }),
        100);
    }
  }
}

namespace
{

void SetTetOct(Filter* filter)
{
  filter->SetVolumeSchemeToTetOct();
}

/// The same with octahedra, which the next mesh has around other diagonals: new points are known by
/// those in whose middle they are. Returns how many were found.
vtkIdType CompareTetOct(const Levels<Filter>& levels, const std::vector<PartsAsCells::Part>& wanted)
{
  const NestedPieces pieces = levels.MakePieces(0);
  const NestedPieces expected = levels.MakePieces(1);
  const Sectors sectors(pieces, levels.GetStep());
  const Buffer<double> finest = levels.GetValues(NestedPieces::Steps + 1);
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> middles;
  for (vtkIdType i = expected.GetNumberOfPoints(2); i < expected.GetNumberOfPoints(3); ++i)
  {
    const vtkIdType* parents = expected.GetParents(3, i);
    middles[{ parents[0], parents[1] }] = i;
  }
  const auto deeper = subdivision::SplitIntoHalves({ pieces, sectors, levels.GetStep() }, wanted);
  const auto made = deeper->Get();
  const Buffer<double> second = deeper->Take(2, levels.GetValues(NestedPieces::Steps), 2);
  Buffer<double> third(2 * made.Pieces.GetNumberOfPoints(NestedPieces::Steps));
  made.Last[0]->Apply(second.data(), third.data(), 2);
  Buffer<double> ids(pieces.GetNumberOfPoints(NestedPieces::Steps));
  std::iota(ids.begin(), ids.end(), 0.);
  const Buffer<double> olds = deeper->Take(2, ids, 1);
  vtkIdType found = 0;
  for (const vtkIdType cell : deeper->GetWanted())
  {
    const vtkIdType first = made.Pieces.GetFirstPlace(cell);
    for (vtkIdType place = first; place < made.Pieces.GetFirstPlace(cell + 1); ++place)
    {
      const vtkIdType point = made.Pieces.GetPoint(place);
      vtkIdType same = -1;
      if (point < made.Pieces.GetNumberOfPoints(2))
      {
        same = static_cast<vtkIdType>(olds[point]);
      }
      else
      {
        const vtkIdType* parents = made.Pieces.GetParents(3, point);
        const auto a = static_cast<vtkIdType>(olds[parents[0]]);
        const auto b = static_cast<vtkIdType>(olds[parents[1]]);
        const auto at = middles.find({ std::min(a, b), std::max(a, b) });
        same = at == middles.end() ? -1 : at->second;
      }
      for (int x = 0; x < 2; ++x)
      {
        EXPECT_TRUE(std::isfinite(third[2 * point + x])) << "cell " << cell;
        if (same >= 0)
        {
          EXPECT_NEAR(third[2 * point + x], finest[2 * same + x], 1e-10) << "cell " << cell;
          ++found;
        }
      }
    }
  }
  return found;
}

}

TEST(PartsInHalves, OfTetrahedraAndOctahedra)
{
  vtkIdType found = 0;
  for (const unsigned seed : { 4, 8, 12, 16, 5, 6 })
  {
    SCOPED_TRACE(seed);
    const int first = seed % 2 == 0 ? 0 : 1;
    const Levels<Filter> levels(
      WithValues(seed < 8 ? MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1.2, 0. },
                                       { 0.1, 0., 1. }, { 0., 0.3, -1.1 } },
                              { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 2, 1, 4 } } })
                          : MakeRandomComplex(seed)),
      first, SetTetOct, true);
    const NestedPieces pieces = levels.MakePieces(0);
    std::vector<PartsAsCells::Part> parts;
    for (vtkIdType c = 0; c < pieces.GetNumberOfCells(); ++c)
    {
      for (int child = 0; child < static_cast<int>(pieces.GetLattice(c).Children.size()); ++child)
      {
        parts.push_back({ c, child });
      }
    }
    found += CompareTetOct(levels, parts);
    for (std::size_t p = 0; p < parts.size(); p += 13)
    {
      found += CompareTetOct(levels, { parts[p] });
    }
  }
  EXPECT_GT(found, 80000);
}

/// What is one point's own counts in all pieces that have a solid at their corners with a solid at
/// it (Mathematics 14).
TEST(FindBounds, LimitsOfTetOctDependOnTwoLayersOfSolids)
{
  const Grid tet =
    WithValues(MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 0., 0., 1. } },
      { { VTK_TETRA, { 0, 1, 2, 3 } } }));
  const Levels<Filter> levels(tet, 0, SetTetOct, true);
  const NestedPieces pieces = levels.MakePieces(0);
  const Sectors sectors(pieces, levels.GetStep());
  const PieceLattice& lattice = pieces.GetLattice(0);
  const auto zeros = [&](int step) { return Buffer<double>(pieces.GetNumberOfPoints(step), 0.); };
  const Buffer<double> shown = zeros(0);
  const Buffer<double> next = zeros(1);
  const Buffer<double> second = zeros(2);
  for (const int point : { 0, 7, 50, 100, 164 })
  {
    std::set<int> near{ point };
    for (int layer = 0; layer < 2; ++layer)
    {
      const std::set<int> before = near;
      for (const int p : before)
      {
        near.insert(lattice.Neighbours[p].begin(), lattice.Neighbours[p].end());
      }
    }
    Buffer<double> third = zeros(3);
    third[pieces.GetPoint(point)] = 1.;
    const subdivision::BoundedValues values{ 1, shown.data(), next, second, third,
      [&](const Buffer<double>&) { return zeros(3); }, 0. };
    const auto bounds = subdivision::FindBounds(pieces, sectors, values, { 0 });
    int outside = 0;
    for (int piece = 0; piece < lattice.GetNumberOfPieces(); ++piece)
    {
      const auto corner = lattice.Pieces.begin() + 4 * piece;
      const bool isNear = std::any_of(corner, corner + 4, [&](int k) { return near.count(k) > 0; });
      EXPECT_EQ(bounds[0].OfPieces[piece], isNear ? 1. : 0.) << point << " " << piece;
      outside += isNear ? 0 : 1;
    }
    EXPECT_GT(outside, 50) << point;
  }
}

/// Of few cells only the points are looked at on which their limits depend.
TEST(FindBounds, OneCellHasTheBoundThatItHasAmongAll)
{
  for (const bool isTetOct : { false, true })
  {
    const Levels<Filter> levels(WithValues(MakeRandomComplex(3)), 0,
      isTetOct ? Levels<Filter>::Set(SetTetOct) : Levels<Filter>::Set(), isTetOct);
    const NestedPieces pieces = levels.MakePieces(0);
    const Sectors sectors(pieces, levels.GetStep());
    std::mt19937 random(2);
    const auto draw = [&](int step)
    {
      Buffer<double> values(pieces.GetNumberOfPoints(step));
      std::generate(values.begin(), values.end(), [&] { return random() / 4294967296.; });
      return values;
    };
    const Buffer<double> shown = draw(0);
    const Buffer<double> next = draw(1);
    const Buffer<double> second = draw(2);
    const Buffer<double> third = draw(3);
    const Buffer<double> last = draw(3);
    const auto copyLast = [&](const Buffer<double>&)
    {
      Buffer<double> copy(last.size());
      std::copy(last.begin(), last.end(), copy.begin());
      return copy;
    };
    const subdivision::BoundedValues values{ 1, shown.data(), next, second, third, copyLast, 0. };
    std::vector<vtkIdType> all(static_cast<std::size_t>(pieces.GetNumberOfCells()));
    std::iota(all.begin(), all.end(), vtkIdType(0));
    const auto expected = subdivision::FindBounds(pieces, sectors, values, all);
    ASSERT_GT(all.size(), 3u);
    for (const vtkIdType cell : all)
    {
      const auto found = subdivision::FindBounds(pieces, sectors, values, { cell });
      EXPECT_EQ(found[0].Largest, expected[cell].Largest) << cell;
      EXPECT_EQ(found[0].Least, expected[cell].Least) << cell;
      EXPECT_EQ(found[0].OfPieces, expected[cell].OfPieces) << cell;
    }
  }
}

TEST(PartsInHalves, HaveWhatMeetsThem)
{
  // Two triangles with a common edge.
  const Grid grid =
    WithValues(MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 1., 1., 0. } },
      { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 3, 2, 1 } } }));
  const Levels<Filter> levels(grid, 0, {});
  const NestedPieces pieces = levels.MakePieces(0);
  const Sectors sectors(pieces, levels.GetStep());
  const auto deeper =
    subdivision::SplitIntoHalves({ pieces, sectors, levels.GetStep() }, { { 0, 1 } });
  const auto made = deeper->Get();
  // All children of its triangle, and three beyond the edge at whose end it lies.
  EXPECT_EQ(made.Pieces.GetNumberOfCells(), 7);
  EXPECT_EQ(made.Pieces.GetNumberOfPoints(0), 8);
  EXPECT_EQ(deeper->GetCorners().size(), 8U);
}
