// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Fingerprint.h
 * Fingerprints of arrays. Two of them tell whether an array changed without a copy of the old one.
 */
#ifndef SubdivisionObjects_Fingerprint_h
#define SubdivisionObjects_Fingerprint_h

#include "Core/Memory/Ahead.h"
#include "Core/Memory/Loops.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace subdivision
{

/// 8 hashes of 64 bits for every half megabyte of values, then the bytes that are left, the size
/// and the type.
using Fingerprint = std::vector<std::uint64_t>;

/// The hashes of a block. Each step is invertible, so that blocks that differ in one word always
/// have different hashes. One product serves two words, because a product for each word would take
/// longer than reading them.
class FingerprintHashes
{
public:
  static constexpr int Lanes = 8;
  /// Words that are read at a time: 16 points in double precision, 32 in single precision.
  static constexpr vtkIdType Stretch = 48;
  static constexpr vtkIdType Block = 1365 * Stretch; ///< words

  void AddStretch(const char* words)
  {
    for (vtkIdType word = 0; word < Stretch; word += 2 * Lanes)
    {
      for (int lane = 0; lane < Lanes; ++lane)
      {
        this->Add(lane, Read(words + 8 * (word + lane)), Read(words + 8 * (word + Lanes + lane)));
      }
    }
  }
  void AddWord(const char* word) { this->Add(0, Read(word), 0); }
  const std::uint64_t* begin() const { return this->Hashes; }
  const std::uint64_t* end() const { return this->Hashes + Lanes; }

private:
  static std::uint64_t Read(const char* word)
  {
    std::uint64_t value;
    std::memcpy(&value, word, 8);
    return value;
  }
  void Add(int lane, std::uint64_t one, std::uint64_t other)
  {
    const std::uint64_t mixed = (this->Hashes[lane] ^ one) * 0x9e3779b97f4a7c15ULL + other;
    this->Hashes[lane] = mixed << 29 | mixed >> 35;
  }

  std::uint64_t Hashes[Lanes] = { 1, 2, 3, 4, 5, 6, 7, 8 };
};

/// The hashes of the words [begin, end). After each stretch meanwhile(a, b) is called for its
/// words; that hides the time in which the next ones are on their way.
template <typename Meanwhile>
FingerprintHashes ComputeHashes(
  const char* values, vtkIdType begin, vtkIdType end, const Meanwhile& meanwhile)
{
  constexpr vtkIdType ahead = 8 * FingerprintHashes::Stretch; // words
  FingerprintHashes hashes;
  vtkIdType word = begin;
  for (; word + FingerprintHashes::Stretch <= end; word += FingerprintHashes::Stretch)
  {
    for (vtkIdType line = 0; line < FingerprintHashes::Stretch; line += 8)
    {
      AskFor(values, 8 * (word + ahead + line));
    }
    hashes.AddStretch(values + 8 * word);
    meanwhile(word, word + FingerprintHashes::Stretch);
  }
  for (vtkIdType rest = word; rest < end; ++rest)
  {
    hashes.AddWord(values + 8 * rest);
  }
  meanwhile(word, end);
  return hashes;
}

/// The fingerprint of a contiguous array. Other work is done meanwhile: work(first, last) for the
/// tuples of the array, each once, in threads. Then stretches hold whole tuples.
template <typename Work>
Fingerprint ComputeFingerprint(vtkDataArray* array, const Work& work)
{
  const vtkIdType tuple =
    std::max(1, array->GetNumberOfComponents() * array->GetDataTypeSize()); // bytes
  const vtkIdType tuples = array->GetNumberOfTuples();
  const vtkIdType bytes = array->GetNumberOfValues() * array->GetDataTypeSize(); // 0 of bits
  const vtkIdType words = bytes / 8;
  constexpr vtkIdType block = FingerprintHashes::Block;
  const vtkIdType blocks = (words + block - 1) / block;
  Fingerprint print(FingerprintHashes::Lanes * blocks + 3);
  if (bytes > 0)
  {
    const auto* values = static_cast<const char*>(array->GetVoidPointer(0));
    std::uint64_t* last = print.data() + FingerprintHashes::Lanes * blocks;
    std::memcpy(last, values + 8 * words, static_cast<std::size_t>(bytes - 8 * words));
    last[1] = static_cast<std::uint64_t>(bytes);
    last[2] = static_cast<std::uint64_t>(array->GetDataType());
    if (blocks == 0)
    {
      work(vtkIdType(0), tuples);
    }
    ForRangesOfBlocks(blocks,
      [&](vtkIdType first, vtkIdType end)
      {
        for (vtkIdType b = first; b < end; ++b)
        {
          const FingerprintHashes hashes = ComputeHashes(values, b * block,
            std::min(words, (b + 1) * block), [&](vtkIdType from, vtkIdType to)
            { work(8 * from / tuple, to == words ? tuples : 8 * to / tuple); });
          std::copy(hashes.begin(), hashes.end(), print.begin() + FingerprintHashes::Lanes * b);
        }
      });
  }
  return print;
}

Fingerprint ComputeFingerprint(vtkDataArray* array);

/// Whether an array has the size and type of one with this fingerprint, and begins like it. That
/// takes hardly any time, and hardly ever is an array that changed taken for the old one.
bool BeginsAs(vtkDataArray* array, const Fingerprint& print);

}

#endif
