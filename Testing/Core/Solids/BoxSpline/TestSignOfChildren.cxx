// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSignOfChildren.cxx
 * The sign of the volumes of the children of tetrahedra, and of their children, beside the
 * orientation of each of them.
 */
#include "Precompiled.h"

#include "Core/Solids/BoxSpline/SignOfChildren.h"
#include "Core/Solids/Location/TetFrame.h"

using namespace subdivision;

namespace
{

/// Some tetrahedra, each with points of its own.
template <int Parents>
struct Lattices
{
  static constexpr int Size = TetLattice<Parents>::Size;
  static constexpr int Tets = 7;

  /// Points are moved by up to `noise`, then made `thin` beside a plane across all axes.
  explicit Lattices(double noise = 0., double thin = 1., unsigned seed = 7)
    : Points(3 * Size * Tets)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> move(-noise, noise);
    for (int t = 0; t < Tets; ++t)
    {
      this->At(t, 1)[0] = this->At(t, 2)[1] = this->At(t, 3)[2] = 1.;
      this->FillMidpoints(t, TetLatticeOf<1>);
      this->FillMidpoints(t, TetLatticeOf<Parents>);
    }
    for (double& value : this->Points)
    {
      value += move(random);
    }
    this->Scale(1., 1., thin);
    for (std::size_t i = 0; i < this->Points.size() && thin != 1.; i += 3)
    {
      this->Points[i + 2] += 0.7 * this->Points[i] - 0.4 * this->Points[i + 1];
    }
  }
  template <int N>
  void FillMidpoints(int tet, const TetLattice<N>& lattice)
  {
    for (const auto& points : lattice.Points)
    {
      for (int k = 4; k < 10; ++k)
      {
        const auto& ends = tetrahedron::EdgeVertices[k - 4];
        for (int c = 0; c < 3; ++c)
        {
          this->At(tet, points[k])[c] =
            (this->At(tet, points[ends[0]])[c] + this->At(tet, points[ends[1]])[c]) / 2.;
        }
      }
    }
  }
  double* At(int tet, int point) { return this->Points.data() + 3 * (Size * tet + point); }
  void Scale(double x, double y, double z)
  {
    for (std::size_t i = 0; i < this->Points.size(); i += 3)
    {
      this->Points[i] *= x;
      this->Points[i + 1] *= y;
      this->Points[i + 2] *= z;
    }
  }
  std::vector<int> GetSigns(const StoredPoints& points) const
  {
    std::vector<signed char> signs(Tets);
    const SignOfChildren<Parents> sign(points);
    for (int t = 0; t < Tets; ++t)
    {
      int ids[Size];
      std::iota(ids, ids + Size, Size * t);
      signs[t] = sign.Find(ids);
    }
    return { signs.begin(), signs.end() };
  }
  std::vector<int> GetSigns() const { return this->GetSigns(this->Points.data()); }
  /// How many children of a tetrahedron have this orientation.
  int Count(int tet, int orientation)
  {
    int count = 0;
    for (const auto& points : TetLatticeOf<Parents>.Points)
    {
      for (const auto& child : tetrahedron::Children)
      {
        const double* corners[4];
        for (int k = 0; k < 4; ++k)
        {
          corners[k] = this->At(tet, points[child[k]]);
        }
        count += GetOrientationOfTet(corners) == orientation ? 1 : 0;
      }
    }
    return count;
  }
  /// No sign contradicts the orientation of a child.
  void ExpectNoWrongSign(const char* what)
  {
    const std::vector<int> signs = this->GetSigns();
    for (int t = 0; t < Tets; ++t)
    {
      EXPECT_TRUE(signs[t] == 0 || this->Count(t, -signs[t]) == 0) << what << ", " << t;
    }
  }

  std::vector<double> Points;
};

template <typename Parents>
struct SignOfChildrenTest : testing::Test
{
  using SomeTets = Lattices<Parents::value>;
  static std::vector<int> All(int sign) { return std::vector<int>(SomeTets::Tets, sign); }
};
using AllParents = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 8>>;
TYPED_TEST_SUITE(SignOfChildrenTest, AllParents, );

}

TYPED_TEST(SignOfChildrenTest, IsThatOfEachChild)
{
  for (const int sign : { 1, -1 })
  {
    typename TestFixture::SomeTets some(0.02);
    some.Scale(sign, 1., 1.);
    EXPECT_EQ(some.Count(3, sign), 8 * TypeParam::value);
    EXPECT_EQ(some.GetSigns(), this->All(sign));
    const std::vector<float> single(some.Points.begin(), some.Points.end());
    EXPECT_EQ(some.GetSigns(single.data()), this->All(sign));
  }
}

TYPED_TEST(SignOfChildrenTest, OneChildOfManyIsSeen)
{
  using Some = typename TestFixture::SomeTets;
  for (int point = 0; point < Some::Size * Some::Tets; ++point)
  {
    // Moved far through a place in the tetrahedron, a point turns a child over.
    Some some;
    const int tet = point / Some::Size;
    for (int c = 0; c < 3; ++c)
    {
      constexpr double inside[3] = { 0.4, 0.1, 0.15 };
      some.Points[3 * point + c] += 3. * (inside[c] - some.Points[3 * point + c]);
    }
    EXPECT_GT(some.Count(tet, -1), 0) << point;
    std::vector<int> expected = this->All(1);
    expected[tet] = 0;
    EXPECT_EQ(some.GetSigns(), expected) << point;
  }
}

TYPED_TEST(SignOfChildrenTest, IsNotKnownWithoutNumbers)
{
  using Some = typename TestFixture::SomeTets;
  for (const double value : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), 1e200, -1e200 })
  {
    for (int point = 0; point < Some::Size * Some::Tets; ++point)
    {
      Some some;
      some.Points[3 * point + 1] = value;
      some.ExpectNoWrongSign("one value is none");
      const std::vector<int> signs = some.GetSigns();
      EXPECT_GE(std::count(signs.begin(), signs.end(), 1) + 1, Some::Tets) << value << point;
    }
  }
}

TYPED_TEST(SignOfChildrenTest, AnySizeAndPlaceIsKnown)
{
  using Some = typename TestFixture::SomeTets;
  for (const double size : { 1e-60, 1e-20, 1e-9, 1e9, 1e20, 1e60 })
  {
    Some some(0.02);
    some.Scale(size, size, size);
    EXPECT_EQ(some.GetSigns(), this->All(1)) << size;
  }
  Some far(0.02);
  for (double& value : far.Points)
  {
    value += 1e9;
  }
  EXPECT_EQ(far.GetSigns(), this->All(1));
}

TYPED_TEST(SignOfChildrenTest, ThinSolidsAreKnown)
{
  using Some = typename TestFixture::SomeTets;
  for (double thin = 1e-3; thin > 1e-9; thin /= 10.)
  {
    EXPECT_EQ(Some(0.02, thin).GetSigns(), this->All(1)) << thin;
    EXPECT_EQ(Some(0.02, -thin).GetSigns(), this->All(-1)) << thin;
    for (unsigned seed = 0; seed < 50; ++seed)
    {
      Some(0.08, thin, seed).ExpectNoWrongSign("children of any sign");
    }
  }
}

// Their edges at the diagonal are much longer than those at a corner.
TYPED_TEST(SignOfChildrenTest, NeedlesHaveNoWrongSign)
{
  using Some = typename TestFixture::SomeTets;
  int unknown = 0;
  for (unsigned seed = 0; seed < 2000; ++seed)
  {
    Some some(0.3, 1., seed);
    for (std::size_t i = 0; i < some.Points.size(); i += 3)
    {
      double* point = some.Points.data() + i;
      const double along = std::round(2. * point[2]) / 2.;
      for (int c = 0; c < 3; ++c)
      {
        point[c] = (c == 0 ? 0.07 : c == 1 ? -0.24 : 0.63) * along + 1e-8 * point[c];
      }
    }
    some.ExpectNoWrongSign("needles");
    const std::vector<int> signs = some.GetSigns();
    unknown += static_cast<int>(std::count(signs.begin(), signs.end(), 0));
  }
  EXPECT_GT(unknown, 0);
}
