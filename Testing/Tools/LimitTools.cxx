// SPDX-License-Identifier: BSD-3-Clause
#include "LimitTools.h"

namespace coretest
{

SemiSharpMesh::SemiSharpMesh(const Mesh& mesh, std::string options, unsigned int seed)
  : Control(mesh)
  , Options(std::move(options))
{
  std::vector<CellRun> runs;
  std::mt19937 random(seed);
  const SimplicialComplex<int> complex = BuildComplex<int>(mesh.Cells, runs);
  this->Sharpness.Edges.resize(complex.NumberOfEdges);
  for (double& s : this->Sharpness.Edges)
  {
    s = random() % 2 ? 0. : 0.25 * (random() % 15);
  }
  this->Sharpness.Faces.resize(complex.NumberOfFaces);
  for (double& s : this->Sharpness.Faces)
  {
    s = random() % 3 ? 0. : 0.25 * (random() % 15);
  }
}

Level<int> SemiSharpMesh::MakeLevel(int steps, double sharpness, Depth depth) const
{
  std::vector<CellRun> runs;
  Level<int> level;
  level.Complex = BuildComplex<int>(this->Control.Cells, runs);
  SingularSimplices singular = FlagSingular(level.Complex, this->Control.Singular);
  const auto flag = [sharpness](const std::vector<double>& values, Buffer<unsigned char>& flags)
  {
    if (flags.empty())
    {
      flags = Buffer<unsigned char>(static_cast<vtkIdType>(values.size()), 0);
    }
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      flags[i] |= values[i] > sharpness ? 1 : 0;
    }
  };
  flag(this->Sharpness.Edges, singular.Edges);
  flag(this->Sharpness.Faces, singular.Faces);
  level.Strata = BuildStrata(level.Complex, singular, MakeOptions(this->Options, level.Complex));
  for (int i = 0; i < steps; ++i)
  {
    level = Refine(level, i + 1 == steps ? depth : Depth::ForRefinement);
  }
  return level;
}

SemiSharpStages<int> SemiSharpMesh::GiveSharpness(
  int steps, const SimplicialComplex<int>& complex) const
{
  SemiSharpStages<int> stages;
  const auto give = [steps](const std::vector<double>& values, int shift, Buffer<double>& pieces)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      for (std::size_t piece = i << shift; piece < (i + 1) << shift; ++piece)
      {
        pieces[piece] = std::max(0., values[i] - steps);
      }
    }
  };
  stages.Sharpness = Buffer<double>(complex.NumberOfEdges, 0.);
  stages.FaceSharpness = Buffer<double>(complex.NumberOfFaces, 0.);
  give(this->Sharpness.Edges, steps, stages.Sharpness);
  give(this->Sharpness.Faces, 2 * steps, stages.FaceSharpness);
  return stages;
}

double SemiSharpMesh::GetMostSharpness() const
{
  double most = 0.;
  for (const auto* values : { &this->Sharpness.Edges, &this->Sharpness.Faces })
  {
    most = std::accumulate(
      values->begin(), values->end(), most, [](double a, double b) { return std::max(a, b); });
  }
  return most;
}

SemiSharpStages<int> SemiSharpMesh::MakeStages(int steps) const
{
  SemiSharpStages<int> stages = this->GiveSharpness(steps, this->MakeSmoothLevel(steps).Complex);
  for (int step = steps; step < this->GetMostSharpness(); ++step)
  {
    stages.Stages.push_back({ step + 1 - steps, this->MakeLevel(steps, step).Strata });
  }
  return stages;
}

Stencils<int> SemiSharpMesh::MakeStencils(int steps) const
{
  Level<int> smooth = this->MakeSmoothLevel(steps);
  Level<int> sharp = this->MakeLevel(steps, steps);
  Stencils<int> stencils = TakeStencils(smooth);
  const auto rows = FindSharpRows(this->Sharpness, steps, steps, sharp.Complex);
  BlendSemiSharp(rows, TakeStencils(sharp), stencils);
  return stencils;
}

std::vector<double> MakeValues(vtkIdType size, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1., 1.);
  std::vector<double> values(size);
  std::generate(values.begin(), values.end(), [&] { return value(random); });
  return values;
}

}
