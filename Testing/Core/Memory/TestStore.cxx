// SPDX-License-Identifier: BSD-3-Clause
// Store: integers are rounded and stay in range, and a finite number never becomes infinite.
#include "Precompiled.h"

#include "Core/Memory/Store.h"

namespace
{

using subdivision::Store;

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Of a value that the compiler does not know: it may compute another result than the machine where
/// a cast is out of range.
template <typename T>
T StoreUnknown(double value)
{
  volatile double unknown = value;
  return Store<T>(unknown);
}

/// Both ends of the range of an integer type, and what lies beyond them.
template <typename T>
void CheckRange()
{
  constexpr T low = std::numeric_limits<T>::lowest();
  constexpr T high = std::numeric_limits<T>::max();
  const double least = static_cast<double>(low);
  const double most = static_cast<double>(high);
  EXPECT_EQ(StoreUnknown<T>(least), low);
  EXPECT_EQ(StoreUnknown<T>(most), high);
  EXPECT_EQ(StoreUnknown<T>(least - 0.75), low);
  EXPECT_EQ(StoreUnknown<T>(most + 0.75), high);
  EXPECT_EQ(StoreUnknown<T>(least * 3. - 3.), low);
  EXPECT_EQ(StoreUnknown<T>(most * 3.), high);
  EXPECT_EQ(StoreUnknown<T>(-1e300), low);
  EXPECT_EQ(StoreUnknown<T>(1e300), high);
  EXPECT_EQ(StoreUnknown<T>(-Infinity), low);
  EXPECT_EQ(StoreUnknown<T>(Infinity), high);
  EXPECT_EQ(StoreUnknown<T>(100.), T(100));
}

}

TEST(CoreStore, IntegersAreRoundedToTheNearest)
{
  EXPECT_EQ(Store<int>(0.), 0);
  EXPECT_EQ(Store<int>(2.4999), 2);
  EXPECT_EQ(Store<int>(2.5001), 3);
  EXPECT_EQ(Store<int>(-2.4999), -2);
  EXPECT_EQ(Store<int>(-2.5001), -3);
  EXPECT_EQ(Store<int>(-0.1), 0);
  EXPECT_EQ(Store<unsigned char>(254.4), 254);
  EXPECT_EQ(Store<unsigned char>(254.6), 255);
  EXPECT_EQ(Store<signed char>(-127.4), -127);
  EXPECT_EQ(Store<signed char>(-127.6), -128);
  // A sum of weights that is 1 but for rounding gives the same integer again.
  EXPECT_EQ(Store<int>(7. * (1. - 1e-15)), 7);
  EXPECT_EQ(Store<int>(-7. * (1. - 1e-15)), -7);
}

// One direction everywhere: then adding an integer to all values adds it to all results.
TEST(CoreStore, HalvesAreRoundedUp)
{
  EXPECT_EQ(Store<int>(0.5), 1);
  EXPECT_EQ(Store<int>(1.5), 2);
  EXPECT_EQ(Store<int>(2.5), 3);
  EXPECT_EQ(Store<int>(-0.5), 0);
  EXPECT_EQ(Store<int>(-1.5), -1);
  EXPECT_EQ(Store<int>(-2.5), -2);
}

TEST(CoreStore, IntegersStayInRange)
{
  CheckRange<char>();
  CheckRange<signed char>();
  CheckRange<unsigned char>();
  CheckRange<short>();
  CheckRange<unsigned short>();
  CheckRange<int>();
  CheckRange<unsigned int>();
  CheckRange<long>();
  CheckRange<unsigned long>();
  CheckRange<long long>();
  CheckRange<unsigned long long>();
  EXPECT_EQ(StoreUnknown<unsigned char>(-0.4), 0);
  EXPECT_EQ(StoreUnknown<unsigned long long>(-5.), 0u);
}

// Doubles next to the ends of 64 bits: the end itself is no double.
TEST(CoreStore, LargeIntegersAreExact)
{
  EXPECT_EQ(StoreUnknown<long long>(9223372036854774784.), 9223372036854774784ll);
  EXPECT_EQ(StoreUnknown<long long>(-9223372036854774784.), -9223372036854774784ll);
  EXPECT_EQ(StoreUnknown<unsigned long long>(18446744073709549568.), 18446744073709549568ull);
  EXPECT_EQ(StoreUnknown<long long>(9007199254740992.), 9007199254740992ll);
  EXPECT_EQ(StoreUnknown<long long>(4503599627370495.), 4503599627370495ll);
}

/// What is added to round a number is not to be rounded itself.
TEST(CoreStore, RoundingIsExact)
{
  const long long odd = (1LL << 52) + 1;
  EXPECT_EQ(Store<long long>(static_cast<double>(odd)), odd);
  EXPECT_EQ(Store<long long>(static_cast<double>(-odd)), -odd);
  EXPECT_EQ(Store<int>(std::nextafter(0.5, 0.)), 0);
  EXPECT_EQ(Store<int>(std::nextafter(-0.5, -1.)), -1);
}

/// No integer stands for what is not a number: 0, on any machine.
TEST(CoreStore, NotANumberIsZero)
{
  EXPECT_EQ(StoreUnknown<int>(std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_EQ(StoreUnknown<unsigned char>(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(CoreStore, FiniteStaysFinite)
{
  constexpr float most = std::numeric_limits<float>::max();
  EXPECT_EQ(StoreUnknown<float>(1e300), most);
  EXPECT_EQ(StoreUnknown<float>(-1e300), -most);
  EXPECT_EQ(StoreUnknown<float>(std::numeric_limits<double>::max()), most);
  EXPECT_EQ(StoreUnknown<float>(std::numeric_limits<double>::lowest()), -most);
  // Half a unit above the largest float, which a cast rounds to infinity.
  EXPECT_EQ(StoreUnknown<float>(3.4028235677973366e38), most);
  EXPECT_EQ(StoreUnknown<float>(static_cast<double>(most)), most);
  EXPECT_EQ(
    StoreUnknown<double>(std::numeric_limits<double>::max()), std::numeric_limits<double>::max());
}

TEST(CoreStore, WhatIsNotFiniteStaysSo)
{
  EXPECT_EQ(StoreUnknown<float>(Infinity), std::numeric_limits<float>::infinity());
  EXPECT_EQ(StoreUnknown<float>(-Infinity), -std::numeric_limits<float>::infinity());
  EXPECT_TRUE(std::isnan(StoreUnknown<float>(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_EQ(StoreUnknown<double>(Infinity), Infinity);
  EXPECT_TRUE(std::isnan(StoreUnknown<double>(std::numeric_limits<double>::quiet_NaN())));
}

TEST(CoreStore, FloatsAreTheNearestOnes)
{
  EXPECT_EQ(Store<float>(0.1), 0.1f);
  EXPECT_EQ(Store<float>(-2.75), -2.75f);
  EXPECT_EQ(Store<float>(1. + 1e-9), 1.f);
  EXPECT_EQ(Store<double>(0.1), 0.1);
}
