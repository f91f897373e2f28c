// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Bytes.h
 * The bytes of a fuzzer, read as choices and numbers. When they are used up all choices are the
 * first, so that short inputs are simple ones.
 */
#ifndef SubdivisionObjects_Bytes_h
#define SubdivisionObjects_Bytes_h

#include <cstddef>
#include <cstdint>
#include <iterator>

namespace fuzz
{

class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size)
    : Next(data)
    , End(data + size)
  {
  }

  bool IsEmpty() const { return this->Next == this->End; }
  std::uint8_t Byte() { return this->IsEmpty() ? std::uint8_t(0) : *this->Next++; }
  /// A number from 0 to n - 1, n at most 256.
  int Choose(int n) { return this->Byte() % n; }
  bool Chance(int n) { return this->Choose(n) == n - 1; }
  template <typename T, std::size_t N>
  const T& OneOf(const T (&values)[N])
  {
    return values[this->Choose(static_cast<int>(N))];
  }
  /// A coordinate or value: mostly small, in steps of 1/8.
  double Number() { return (this->Byte() - 128) / 8.; }

private:
  const std::uint8_t* Next;
  const std::uint8_t* End;
};

}

#endif
