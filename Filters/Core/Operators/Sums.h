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

/// The sums of W components. They are an object outside of the loop over rows: compilers then keep
/// them in registers.
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
/// Two components in one register.
template <>
class Sums<2>
{
public:
  double& operator[](int c) { return reinterpret_cast<double*>(&this->Numbers)[c]; }
  double operator[](int c) const { return this->Numbers[c]; }
  void Clear() { this->Numbers = Two{}; }
  template <typename In>
  void Set(const In* values)
  {
    this->Numbers = Read(values);
  }
  void Scale(double weight) { this->Numbers *= weight; }
  template <typename In>
  void Add(const In* values)
  {
    this->Numbers += Read(values);
  }
  template <typename In>
  void Add(double weight, const In* values)
  {
    this->Numbers += weight * Read(values);
  }
  void Add(double weight, const Sums& other) { this->Numbers += weight * other.Numbers; }
  bool IsFinite() const
  {
    const Two zeros = this->Numbers * 0.; // not numbers otherwise
    return zeros[0] + zeros[1] == 0.;
  }
  template <typename Out>
  void Write(Out* values) const
  {
    values[0] = Store<Out>(this->Numbers[0]);
    values[1] = Store<Out>(this->Numbers[1]);
  }
  void Write(double* values) const { std::memcpy(values, &this->Numbers, sizeof(this->Numbers)); }

private:
  using Two = double __attribute__((vector_size(2 * sizeof(double)), may_alias));
  template <typename In>
  static Two Read(const In* values)
  {
    return Two{ static_cast<double>(values[0]), static_cast<double>(values[1]) };
  }
  static Two Read(const double* values)
  {
    Two two;
    std::memcpy(&two, values, sizeof(two));
    return two;
  }

  Two Numbers;
};

/// Two components and others.
template <int W>
class JoinedSums
{
public:
  double& operator[](int c) { return c < 2 ? this->First[c] : this->Others[c - 2]; }
  double operator[](int c) const { return c < 2 ? this->First[c] : this->Others[c - 2]; }
  void Clear()
  {
    this->First.Clear();
    this->Others.Clear();
  }
  template <typename In>
  void Set(const In* values)
  {
    this->First.Set(values);
    this->Others.Set(values + 2);
  }
  void Scale(double weight)
  {
    this->First.Scale(weight);
    this->Others.Scale(weight);
  }
  template <typename In>
  void Add(const In* values)
  {
    this->First.Add(values);
    this->Others.Add(values + 2);
  }
  template <typename In>
  void Add(double weight, const In* values)
  {
    this->First.Add(weight, values);
    this->Others.Add(weight, values + 2);
  }
  void Add(double weight, const JoinedSums& other)
  {
    this->First.Add(weight, other.First);
    this->Others.Add(weight, other.Others);
  }
  bool IsFinite() const { return this->First.IsFinite() && this->Others.IsFinite(); }
  template <typename Out>
  void Write(Out* values) const
  {
    this->First.Write(values);
    this->Others.Write(values + 2);
  }

private:
  Sums<2> First;
  Sums<W - 2> Others;
};

template <>
class Sums<3> : public JoinedSums<3>
{
};
template <>
class Sums<4> : public JoinedSums<4>
{
};
#endif

}

#endif
