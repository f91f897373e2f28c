// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Sums.h
 * The sums of a row, one for each component.
 */
#ifndef SubdivisionObjects_Sums_h
#define SubdivisionObjects_Sums_h

#include "Core/Memory/Store.h"

#include "vtkType.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace subdivision
{

/// How many components are summed together. If their number N is 0, which means that it is known at
/// run time only, one after another: loops of unknown length are slow for few components.
template <int N>
constexpr int Width = N == 0 ? 1 : N;

template <typename In, typename Out>
Out* CopyValues(const In* from, vtkIdType size, Out* to)
{
  if constexpr (std::is_same<In, Out>::value)
  {
    return std::copy(from, from + size, to);
  }
  else
  {
    return std::transform(
      from, from + size, to, [](In value) { return Store<Out>(static_cast<double>(value)); });
  }
}

/// The sums of W components. They are an object outside of the loop over rows: compilers then add
/// two at a time, but not in an array inside of it.
template <int W>
class Sums
{
public:
  double& operator[](int c) { return this->Numbers[c]; }
  double operator[](int c) const { return this->Numbers[c]; }
  void Clear() { std::fill_n(this->Numbers, W, 0.); }
  template <typename In>
  void Set(const In* values)
  {
    std::transform(values, values + W, this->Numbers, [](In v) { return static_cast<double>(v); });
  }
  void Scale(double weight)
  {
    for (double& number : this->Numbers)
    {
      number *= weight;
    }
  }
  template <typename In>
  void Add(const In* values)
  {
    for (int c = 0; c < W; ++c)
    {
      this->Numbers[c] += static_cast<double>(values[c]);
    }
  }
  template <typename In>
  void Add(double weight, const In* values)
  {
    for (int c = 0; c < W; ++c)
    {
      this->Numbers[c] += weight * static_cast<double>(values[c]);
    }
  }
  void Add(double weight, const Sums& other)
  {
    for (int c = 0; c < W; ++c)
    {
      this->Numbers[c] += weight * other.Numbers[c];
    }
  }
  bool IsFinite() const
  {
    double zeros = 0.; // not a number otherwise; GCC would call a function for std::all_of
    for (const double number : this->Numbers)
    {
      zeros += number * 0.;
    }
    return zeros == 0.;
  }
  template <typename Out>
  void Write(Out* values) const
  {
    std::transform(this->Numbers, this->Numbers + W, values, Store<Out>);
  }

private:
  double Numbers[W];
};

#ifdef __GNUC__
/// Four components, two in a register.
template <>
class Sums<4>
{
public:
  double& operator[](int c) { return reinterpret_cast<double*>(&this->Numbers[c / 2])[c % 2]; }
  double operator[](int c) const { return this->Numbers[c / 2][c % 2]; }
  void Clear() { this->Numbers[0] = this->Numbers[1] = Two{}; }
  template <typename In>
  void Set(const In* values)
  {
    this->Numbers[0] = Read(values);
    this->Numbers[1] = Read(values + 2);
  }
  void Scale(double weight)
  {
    this->Numbers[0] *= weight;
    this->Numbers[1] *= weight;
  }
  template <typename In>
  void Add(const In* values)
  {
    this->Numbers[0] += Read(values);
    this->Numbers[1] += Read(values + 2);
  }
  template <typename In>
  void Add(double weight, const In* values)
  {
    this->Numbers[0] += weight * Read(values);
    this->Numbers[1] += weight * Read(values + 2);
  }
  void Add(double weight, const Sums& other)
  {
    this->Numbers[0] += weight * other.Numbers[0];
    this->Numbers[1] += weight * other.Numbers[1];
  }
  bool IsFinite() const
  {
    const Two zeros = this->Numbers[0] * 0. + this->Numbers[1] * 0.; // not numbers otherwise
    return zeros[0] + zeros[1] == 0.;
  }
  void Write(double* values) const { std::memcpy(values, this->Numbers, sizeof(this->Numbers)); }
  template <typename Out>
  void Write(Out* values) const
  {
    for (int c = 0; c < 4; ++c)
    {
      values[c] = Store<Out>((*this)[c]);
    }
  }

private:
  using Two = double __attribute__((vector_size(2 * sizeof(double)), may_alias));
  static Two Read(const double* values)
  {
    Two two;
    std::memcpy(&two, values, sizeof(two));
    return two;
  }
  template <typename In>
  static Two Read(const In* values)
  {
    return Two{ static_cast<double>(values[0]), static_cast<double>(values[1]) };
  }

  Two Numbers[2];
};
#endif

}

#endif
