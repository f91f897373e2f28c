// SPDX-License-Identifier: BSD-3-Clause
#include "TetOctTools.h"

namespace tetoct_tools
{

std::vector<Tuple> Normal(const Solid& solid)
{
  if (solid.size() == 4)
  {
    return { Sorted(solid) };
  }
  std::vector<Tuple> pairs;
  for (int pair = 0; pair < 3; ++pair)
  {
    pairs.push_back(Sorted({ solid[2 * pair], solid[2 * pair + 1] }));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

void SlowStep::SplitTet(const Solid& t)
{
  for (vtkIdType a : t)
  {
    Solid child = { a };
    for (vtkIdType b : t)
    {
      if (a != b)
      {
        child.push_back(this->Middle(a, b));
      }
    }
    this->Children.push_back(child);
  }
  this->Children.push_back(
    { this->Middle(t[0], t[1]), this->Middle(t[2], t[3]), this->Middle(t[0], t[2]),
      this->Middle(t[1], t[3]), this->Middle(t[0], t[3]), this->Middle(t[1], t[2]) });
}

void SlowStep::SplitOct(const Solid& o)
{
  const vtkIdType centre = static_cast<vtkIdType>(this->Linear.size());
  WeightedRow mean;
  for (vtkIdType v : o)
  {
    mean[v] = 1. / 6.;
  }
  this->Linear.push_back(mean);
  for (int v = 0; v < 6; ++v)
  {
    Solid child = { o[v], centre };
    for (int w = 0; w < 6; ++w)
    {
      if (w / 2 != v / 2)
      {
        child.push_back(this->Middle(o[v], o[w]));
      }
    }
    this->Children.push_back(child);
  }
  for (int k = 0; k < 8; ++k)
  {
    const vtkIdType a = o[k % 2];
    const vtkIdType b = o[2 + k / 2 % 2];
    const vtkIdType c = o[4 + k / 4];
    this->Children.push_back(
      { centre, this->Middle(a, b), this->Middle(b, c), this->Middle(c, a) });
  }
}

void SlowStep::Smooth()
{
  std::vector<WeightedRow> sums(this->Linear.size());
  std::vector<double> cells(this->Linear.size(), 0.);
  for (const Solid& child : this->Children)
  {
    for (std::size_t i = 0; i < child.size(); ++i)
    {
      cells[child[i]] += 1.;
      for (std::size_t j = 0; j < child.size(); ++j)
      {
        const double weight = child.size() == 4 ? (i == j ? -1. / 16 : 17. / 48)
          : i == j                              ? 3. / 8
          : i / 2 == j / 2                      ? 7. / 24
                                                : 1. / 12;
        sums[child[i]][child[j]] += weight;
      }
    }
  }
  this->Smoothed.resize(sums.size());
  for (std::size_t v = 0; v < sums.size(); ++v)
  {
    for (const auto& term : sums[v])
    {
      for (const auto& part : this->Linear[term.first])
      {
        this->Smoothed[v][part.first] += term.second / cells[v] * part.second;
      }
    }
  }
}

std::vector<double> GetSpectrum(const Matrix& matrix)
{
  const std::size_t n = matrix.size();
  Matrix q(n, std::vector<double>(n, 0.)); // columns as rows
  std::mt19937 random(1);
  for (auto& column : q)
  {
    std::generate(column.begin(), column.end(), [&random] { return random() / 4294967296. - 0.5; });
  }
  std::vector<double> sizes(n);
  for (int iteration = 0; iteration < 3000; ++iteration)
  {
    for (std::size_t k = 0; k < n; ++k)
    {
      std::vector<double> image(n, 0.);
      for (std::size_t i = 0; i < n; ++i)
      {
        image[i] = std::inner_product(matrix[i].begin(), matrix[i].end(), q[k].begin(), 0.);
      }
      for (int twice = 0; twice < 2; ++twice)
      {
        for (std::size_t j = 0; j < k; ++j)
        {
          const double dot = std::inner_product(image.begin(), image.end(), q[j].begin(), 0.);
          for (std::size_t i = 0; i < n; ++i)
          {
            image[i] -= dot * q[j][i];
          }
        }
      }
      sizes[k] = std::sqrt(std::inner_product(image.begin(), image.end(), image.begin(), 0.));
      for (std::size_t i = 0; i < n; ++i)
      {
        q[k][i] = image[i] / std::max(sizes[k], 1e-300);
      }
    }
  }
  std::sort(sizes.begin(), sizes.end(), std::greater<double>());
  return sizes;
}

Mesh MakeTetsAroundEdge(int n)
{
  Mesh mesh("TetsAroundEdge" + std::to_string(n));
  mesh.AddPoints({ { 0, 0, 1 }, { 0, 0, -1 } });
  for (int i = 0; i < n; ++i)
  {
    const double t = 6.283185307179586 * i / n;
    mesh.AddPoint(std::cos(t), std::sin(t), 0.);
  }
  for (int i = 0; i < n; ++i)
  {
    mesh.AddCell({ 0, 1, 2 + i, 2 + (i + 1) % n });
  }
  return mesh;
}

}
