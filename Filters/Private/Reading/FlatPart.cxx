// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/FlatPart.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

using namespace vectors;

double GetLength(const Vector& a)
{
  return std::hypot(a[0], a[1], a[2]);
}

Vector Normalize(Vector a)
{
  const double length = GetLength(a);
  for (double& x : a)
  {
    x = length > 0. ? x / length : 0.;
  }
  return a;
}

}

FlatPart::FlatPart(const double* const* corners, int size)
{
  for (int i = 0; i < size; ++i)
  {
    this->Corners.push_back({ corners[i][0], corners[i][1], corners[i][2] });
    for (int k = 0; k < 3; ++k)
    {
      this->Middle[k] += corners[i][k] / size;
    }
    this->Length = std::max(this->Length, GetLength(Subtract(corners[(i + 1) % size], corners[i])));
    this->Around.Add(corners[i]);
  }
  if (size == 2)
  {
    this->Direction = Normalize(Subtract(corners[1], corners[0]));
  }
  for (int i = 0; size > 2 && i < size; ++i)
  {
    const Vector c = Cross(Subtract(corners[i], this->Middle.data()),
      Subtract(corners[(i + 1) % size], this->Middle.data()));
    for (int k = 0; k < 3; ++k)
    {
      this->Direction[k] += c[k];
    }
  }
  constexpr double leastArea = 1e-6; // of a face, beside the square of its longest edge
  const bool isThin =
    size > 2 && GetLength(this->Direction) <= leastArea * this->Length * this->Length;
  this->Direction = isThin ? Vector{} : Normalize(this->Direction);
  this->Height = Tolerance * this->Length;
  double warp = 0.;
  for (int i = 0; size > 2 && i < size; ++i)
  {
    warp =
      std::max(warp, std::abs(Dot(Subtract(corners[i], this->Middle.data()), this->Direction)));
    this->Outwards.push_back(
      Normalize(Cross(Subtract(corners[(i + 1) % size], corners[i]), this->Direction)));
  }
  this->Height += warp;
  for (int k = 0; k < 3; ++k)
  {
    this->Around.Low[k] -= this->Height;
    this->Around.High[k] += this->Height;
  }
}

double FlatPart::GetParameter(const double* x) const
{
  return this->Length > 0.
    ? Dot(Subtract(x, this->Corners[0].data()), this->Direction) / this->Length
    : 0.;
}

FlatPart::Where FlatPart::Find(const double* x) const
{
  const double most = Tolerance * this->Length;
  const Vector fromMiddle = Subtract(x, this->Middle.data());
  const double along = Dot(fromMiddle, this->Direction);
  const bool isEdge = this->Corners.size() == 2;
  bool isOn = isEdge ? std::abs(along) <= 0.5 * this->Length + most &&
      GetLength(Cross(fromMiddle, this->Direction)) <= most
                     : std::abs(along) <= this->Height;
  for (std::size_t i = 0; isOn && i < this->Outwards.size(); ++i)
  {
    isOn = Dot(Subtract(x, this->Corners[i].data()), this->Outwards[i]) <= most;
  }
  if (!isOn || !(Dot(this->Direction, this->Direction) > 0.5)) // without a size
  {
    return Off;
  }
  const bool isAtCorner = std::any_of(this->Corners.begin(), this->Corners.end(),
    [&](const Vector& corner) { return GetLength(Subtract(x, corner.data())) <= most; });
  return isAtCorner ? AtCorner : Inside;
}

bool FlatPart::Meets(const Box& box) const
{
  if (!this->Around.Meets(box))
  {
    return false;
  }
  double middle[3];
  Vector half;
  for (int k = 0; k < 3; ++k)
  {
    middle[k] = 0.5 * (box.Low[k] + box.High[k]);
    half[k] = box.High[k] - middle[k];
  }
  const Vector fromMiddle = Subtract(middle, this->Middle.data());
  if (this->Corners.size() == 2)
  {
    return GetLength(Cross(fromMiddle, this->Direction)) <= GetLength(half) + this->Height;
  }
  const Vector normal = { std::abs(this->Direction[0]), std::abs(this->Direction[1]),
    std::abs(this->Direction[2]) };
  return std::abs(Dot(fromMiddle, this->Direction)) <= Dot(half, normal) + this->Height;
}

}
