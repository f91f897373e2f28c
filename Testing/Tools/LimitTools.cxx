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
  this->Sharpness.resize(BuildComplex<int>(mesh.Cells, runs).NumberOfEdges);
  for (double& s : this->Sharpness)
  {
    s = random() % 2 ? 0. : 0.25 * (random() % 15);
  }
}

Level<int> SemiSharpMesh::MakeLevel(int steps, double sharpness, Depth depth) const
{
  std::vector<CellRun> runs;
  Level<int> level;
  level.Complex = BuildComplex<int>(this->Control.Cells, runs);
  SingularSimplices singular = FlagSingular(level.Complex, this->Control.Singular);
  if (singular.Edges.empty())
  {
    singular.Edges = Buffer<unsigned char>(level.Complex.NumberOfEdges, 0);
  }
  for (std::size_t e = 0; e < this->Sharpness.size(); ++e)
  {
    singular.Edges[e] |= this->Sharpness[e] > sharpness ? 1 : 0;
  }
  level.Strata = BuildStrata(level.Complex, singular, MakeOptions(this->Options, level.Complex));
  for (int i = 0; i < steps; ++i)
  {
    level = Refine(level, i + 1 == steps ? depth : Depth::ForRefinement);
  }
  return level;
}

SemiSharpStages<int> SemiSharpMesh::MakeStages(int steps) const
{
  SemiSharpStages<int> stages;
  const Level<int> level = this->MakeSmoothLevel(steps);
  stages.Sharpness = Buffer<double>(level.Complex.NumberOfEdges, 0.);
  double most = 0.;
  for (std::size_t e = 0; e < this->Sharpness.size(); ++e)
  {
    most = std::max(most, this->Sharpness[e]);
    for (std::size_t piece = e << steps; piece < (e + 1) << steps; ++piece)
    {
      stages.Sharpness[piece] = std::max(0., this->Sharpness[e] - steps);
    }
  }
  for (int step = steps; step < most; ++step)
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
