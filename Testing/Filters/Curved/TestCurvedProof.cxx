// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestCurvedProof.cxx
 * Curved solids are proved to be valid, against determinants at random places, and repaired.
 */
#include "BezierTools.h"
#include "CurvedTools.h"
#include "FileTools.h"
#include "vtkSubdivisionModelSource.h"

#include "Private/Curved/CellJacobian.h"
#include "Private/Curved/CurvedMesh.h"
#include "Private/Distribution/PartitionsOfRank.h"

using namespace curved_tools;
using namespace subdivision;

namespace
{

/// The cell that is its own parameters, with its nodes moved.
Grid MakeOneCell(const CurvedShape& shape, double size, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-size, size);
  std::vector<Point> points;
  Cell cell{ shape.CellType, {} };
  for (const FrameNode& node : shape.Nodes)
  {
    Point p;
    for (int k = 0; k < 3; ++k)
    {
      p[k] = static_cast<double>(node[k]) / shape.Order + move(random);
    }
    cell.Points.push_back(static_cast<vtkIdType>(points.size()));
    points.push_back(p);
  }
  return MakeGrid(points, { cell });
}

std::vector<double> GetCoordinates(vtkUnstructuredGrid* grid)
{
  std::vector<double> all;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(grid, i);
    all.insert(all.end(), p.begin(), p.end());
  }
  return all;
}

std::vector<const CurvedShape*> ListSolidShapes()
{
  std::vector<const CurvedShape*> shapes;
  for (const CellShape shape :
    { CellShape::Tet, CellShape::Pyramid, CellShape::Wedge, CellShape::Hex })
  {
    shapes.push_back(CurvedShape::Get(shape, CurvedKind::Quadratic, 2));
    for (const int order : { 1, 2, 3, 4 })
    {
      if (const CurvedShape* made = CurvedShape::Get(shape, CurvedKind::Lagrange, order))
      {
        shapes.push_back(made);
      }
    }
  }
  return shapes;
}

/// The determinant without the factor that is 0 at the apex of a pyramid.
double FindDeterminantOf(const CurvedShape& shape, vtkCell* cell, const Point& at)
{
  const double size = shape.Shape == CellShape::Pyramid ? (1. - at[2]) * (1. - at[2]) : 1.;
  return FindDeterminant(cell, at) / size;
}

/// Small steps to ever smaller determinants.
template <typename Random>
double SearchLeast(const CurvedShape& shape, vtkCell* cell, Random& random)
{
  double least = 1e300;
  std::normal_distribution<double> step;
  for (int start = 0; start < 20; ++start)
  {
    Point best = DrawPlace(cell, random);
    double found = FindDeterminantOf(shape, cell, best);
    for (double size = 0.2; size > 1e-3; size *= 0.97)
    {
      Point at = best;
      for (double& x : at)
      {
        x = std::clamp(x + size * step(random), 0., 0.999);
      }
      const bool isTet = shape.Shape == CellShape::Tet;
      const bool isInside = shape.Shape == CellShape::Wedge || isTet
        ? at[0] + at[1] + (isTet ? at[2] : 0.) <= 1.
        : true;
      const double value = isInside ? FindDeterminantOf(shape, cell, at) : 1e300;
      best = value < found ? at : best;
      found = std::min(found, value);
    }
    least = std::min(least, found);
  }
  return least;
}

}

/// Cells that are their own parameters have the determinant 1 everywhere.
TEST(CurvedProof, StraightCellsHaveScaledJacobianOne)
{
  for (const CurvedShape* shape : ListSolidShapes())
  {
    const Grid grid = MakeOneCell(*shape, 0., 1);
    const auto bound = shape->Jacobian->Find(GetCoordinates(grid).data());
    EXPECT_TRUE(bound.IsValid) << shape->CellType;
    EXPECT_NEAR(bound.Scaled, 1., 1e-9) << shape->CellType << " " << shape->Order;
    auto turned = GetCoordinates(grid);
    for (std::size_t i = 2; i < turned.size(); i += 3)
    {
      turned[i] = -turned[i];
    }
    EXPECT_EQ(shape->Jacobian->Find(turned.data()).IsValid, shape->Shape == CellShape::Wedge);
  }
  EXPECT_EQ(CurvedShape::Get(CellShape::Quad, CurvedKind::Lagrange, 3)->Jacobian, nullptr);
}

/// Valid cells have no negative determinant anywhere, others have one, and the bound is below all,
/// but not far.
TEST(CurvedProof, BoundsHoldAtRandomPlaces)
{
  std::mt19937 random(7);
  int valid = 0;
  int invalid = 0;
  for (const CurvedShape* shape : ListSolidShapes())
  {
    for (unsigned seed = 0; seed < 12; ++seed)
    {
      const double size = (0.03 + 0.06 * seed) / shape->Order;
      const Grid grid = MakeOneCell(*shape, size, seed);
      vtkNew<vtkGenericCell> cell;
      grid->GetCell(0, cell);
      const auto bound = shape->Jacobian->Find(GetCoordinates(grid).data());
      double least = 1e300;
      double sum = 0.;
      constexpr int places = 3000;
      for (int i = 0; i < places; ++i)
      {
        const double found = FindDeterminantOf(*shape, cell, DrawPlace(cell, random));
        least = std::min(least, found);
        sum += found;
      }
      // Most determinants are least at corners; the apex of a pyramid has none.
      const int corners =
        shape->Shape == CellShape::Pyramid ? 4 : GetCellTable(shape->Shape).Corners;
      for (int i = 0; i < corners; ++i)
      {
        const double* at = cell->GetParametricCoords() + 3 * i;
        least = std::min(least, FindDeterminantOf(*shape, cell, { at[0], at[1], at[2] }));
      }
      ++(bound.IsValid ? valid : invalid);
      least = bound.IsValid ? least : std::min(least, SearchLeast(*shape, cell, random));
      SCOPED_TRACE(testing::Message() << shape->CellType << " " << shape->Order << " " << seed);
      if (bound.IsValid)
      {
        EXPECT_GT(least, 0.);
        // The mean is that of few places.
        EXPECT_LT(bound.Scaled, least / (sum / places) * 1.2 + 0.02);
        EXPECT_GT(bound.Scaled, 0.5 * least / (sum / places) - 0.15);
      }
      else
      {
        EXPECT_LT(least, 0.01);
      }
    }
  }
  EXPECT_GT(valid, 50);
  EXPECT_GT(invalid, 20);
}

namespace
{

/// Two tetrahedra on a common face, and a triangle: `node` of an edge is moved.
struct TwoTets
{
  explicit TwoTets(const Point& move, vtkIdType node)
  {
    const auto& tet = *CurvedShape::Get(CellShape::Tet, CurvedKind::Quadratic, 2);
    const auto& triangle = *CurvedShape::Get(CellShape::Triangle, CurvedKind::Quadratic, 2);
    // Corners 0 to 4, then middles of edges.
    const std::vector<Point> corners{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
      { 1, 1, 1 } };
    std::map<Ids, vtkIdType> middles;
    this->Points->SetNumberOfComponents(3);
    for (const Point& p : corners)
    {
      this->Points->InsertNextTuple(p.data());
    }
    const auto add = [&](const CurvedShape& shape, const Ids& of)
    {
      this->Mesh.Shapes.push_back(&shape);
      Ids ids = of;
      for (std::size_t n = of.size(); n < shape.Nodes.size(); ++n)
      {
        Ids ends;
        const FrameNode& at = shape.Nodes[n];
        const int weights[4] = { 2 - at[0] - at[1] - at[2], at[0], at[1], at[2] };
        for (std::size_t k = 0; k < of.size(); ++k)
        {
          if (weights[k] == 1)
          {
            ends.push_back(of[k]);
          }
        }
        std::sort(ends.begin(), ends.end());
        const auto entry = middles.emplace(ends, this->Points->GetNumberOfTuples());
        if (entry.second)
        {
          Point p;
          for (int k = 0; k < 3; ++k)
          {
            p[k] = 0.5 * (corners[ends[0]][k] + corners[ends[1]][k]);
          }
          this->Points->InsertNextTuple(p.data());
        }
        ids.push_back(entry.first->second);
      }
      this->Nodes.insert(this->Nodes.end(), ids.begin(), ids.end());
      this->Offsets.push_back(static_cast<vtkIdType>(this->Nodes.size()));
    };
    add(tet, { 0, 1, 2, 3 });
    add(tet, { 1, 4, 2, 3 });
    add(triangle, { 0, 2, 1 });
    double p[3];
    this->Points->GetTuple(node, p);
    for (int k = 0; k < 3; ++k)
    {
      p[k] += move[k];
    }
    this->Points->SetTuple(node, p);
  }
  CurvedProof Prove()
  {
    PartitionsOfRank rank;
    ExchangeOfAll exchange(rank);
    CurvedPart part = this->MakePart();
    this->Prove({ &part }, exchange);
    this->Points = part.Points;
    return part.Proof;
  }
  CurvedPart MakePart()
  {
    this->Mesh.Offsets = this->Offsets.data();
    this->Mesh.Nodes = this->Nodes.data();
    return { this->Mesh, this->Points, 0, {} };
  }
  void Prove(const std::vector<CurvedPart*>& parts, Exchange& exchange)
  {
    ProveAndRepair(
      parts, exchange, [this](const std::string& text) { this->Warnings.push_back(text); },
      [this](const std::string& text) { this->Errors.push_back(text); });
  }
  /// Some of the cells, with a copy of the points that they use, in another order.
  TwoTets Take(const std::set<vtkIdType>& cells) const
  {
    TwoTets taken(*this);
    taken.Mesh.Shapes.clear();
    taken.Offsets = { 0 };
    taken.Nodes.clear();
    taken.Points = vtkSmartPointer<vtkDoubleArray>::New();
    taken.Points->SetNumberOfComponents(3);
    std::map<vtkIdType, vtkIdType> numbers;
    for (auto cell = cells.rbegin(); cell != cells.rend(); ++cell)
    {
      taken.Mesh.Shapes.push_back(this->Mesh.Shapes[*cell]);
      for (vtkIdType k = this->Offsets[*cell]; k < this->Offsets[*cell + 1]; ++k)
      {
        const auto entry = numbers.emplace(this->Nodes[k], taken.Points->GetNumberOfTuples());
        entry.second ? taken.Points->InsertNextTuple(this->Get(this->Nodes[k]).data()) : -1;
        taken.Nodes.push_back(entry.first->second);
      }
      taken.Offsets.push_back(static_cast<vtkIdType>(taken.Nodes.size()));
    }
    return taken;
  }
  Point Get(vtkIdType i) const
  {
    Point p;
    this->Points->GetTuple(i, p.data());
    return p;
  }

  CurvedMesh Mesh; ///< of these
  std::vector<vtkIdType> Offsets{ 0 };
  std::vector<vtkIdType> Nodes;
  vtkSmartPointer<vtkDataArray> Points = vtkSmartPointer<vtkDoubleArray>::New();
  std::vector<std::string> Warnings;
  std::vector<std::string> Errors;
};

}

/// The node at the middle of the edge of points 1 and 2 lies in both tetrahedra.
TEST(CurvedProof, AnInvalidCellIsMended)
{
  const TwoTets straight({ 0, 0, 0 }, 5);
  vtkIdType node = -1;
  for (vtkIdType i = 5; i < straight.Points->GetNumberOfTuples(); ++i)
  {
    const Point p = straight.Get(i);
    node = p == Point{ 0.5, 0.5, 0. } ? i : node;
  }
  ASSERT_GE(node, 0);
  for (const double move : { 0.05, -0.5, -0.9 })
  {
    TwoTets moved({ move, move, 0 }, node);
    const CurvedProof proof = moved.Prove();
    EXPECT_TRUE(moved.Errors.empty());
    EXPECT_EQ(proof.Valid, std::vector<unsigned char>(3, 1));
    EXPECT_EQ(proof.Scaled[2], 1.);
    EXPECT_GT(proof.Scaled[0], 0.);
    EXPECT_GT(proof.Scaled[1], 0.);
    const double kept = (moved.Get(node)[0] - 0.5) / move;
    if (std::abs(move) < 0.1)
    {
      EXPECT_NEAR(kept, 1., 1e-12);
      EXPECT_TRUE(moved.Warnings.empty());
      continue;
    }
    // The largest step: a quarter of an edge is where the determinant gets 0 at its end.
    EXPECT_GT(kept, 0.);
    EXPECT_LT(kept, 1.);
    TwoTets farther({ move * (kept + 1.1 / 16.), move * (kept + 1.1 / 16.), 0 }, node);
    EXPECT_FALSE(farther.Prove().Valid.empty());
    EXPECT_EQ(farther.Warnings.size(), 1u) << "a larger step would be valid";
    ASSERT_EQ(moved.Warnings.size(), 1u);
    EXPECT_NE(moved.Warnings[0].find("of 2 curved solids were not valid"), std::string::npos);
    for (vtkIdType i = 0; i < moved.Points->GetNumberOfTuples(); ++i)
    {
      if (i != node)
      {
        EXPECT_EQ(moved.Get(i), straight.Get(i)) << i;
      }
    }
  }
}

/// Blocks and ranks that share nodes move them alike, to where they go in the whole mesh.
TEST(CurvedProof, PartsAreRepairedAsTheWhole)
{
  const TwoTets straight({ 0, 0, 0 }, 5);
  for (vtkIdType node = 5; node < straight.Points->GetNumberOfTuples(); ++node)
  {
    for (const Point& move : { Point{ -0.9, -0.8, 0.1 }, Point{ 0.7, 0.1, 0.9 } })
    {
      const TwoTets given(move, node);
      TwoTets whole = given.Take({ 0, 1, 2 });
      whole.Prove();
      std::set<Point> expected;
      for (vtkIdType i = 0; i < whole.Points->GetNumberOfTuples(); ++i)
      {
        expected.insert(whole.Get(i));
      }
      const std::vector<TwoTets> taken{ given.Take({ 0 }), given.Take({ 1 }), given.Take({ 2 }) };
      for (const int ranks : { 1, 2, 3 })
      {
        SCOPED_TRACE(testing::Message() << node << " " << ranks);
        std::vector<TwoTets> parts = taken;
        std::vector<CurvedPart> made;
        for (TwoTets& part : parts)
        {
          made.push_back(part.MakePart());
          made.back().Block = 4 + static_cast<unsigned int>(made.size());
        }
        PartitionsOfRank partitions(nullptr, ranks);
        partitions.Run(
          [&](int i)
          {
            std::vector<CurvedPart*> own;
            for (std::size_t k = static_cast<std::size_t>(i); k < 3;
              k += static_cast<std::size_t>(ranks))
            {
              own.push_back(&made[k]);
            }
            ExchangeOfAll exchange(partitions, i);
            parts[static_cast<std::size_t>(i)].Prove(own, exchange);
          },
          [](int) {});
        std::set<Point> found;
        for (std::size_t k = 0; k < 3; ++k)
        {
          EXPECT_EQ(made[k].Proof.Valid[0], 1);
          parts[k].Points = made[k].Points;
          for (vtkIdType i = 0; i < parts[k].Points->GetNumberOfTuples(); ++i)
          {
            found.insert(parts[k].Get(i));
          }
        }
        EXPECT_EQ(found, expected);
        ASSERT_EQ(parts[0].Warnings.size(), whole.Warnings.size());
        for (std::size_t k = 1; k < 3; ++k)
        {
          EXPECT_TRUE(parts[k].Warnings.empty() && parts[k].Errors.empty());
        }
        const std::string text = whole.Warnings.empty() ? "" : parts[0].Warnings[0];
        EXPECT_EQ(text.find(" of block ") != std::string::npos, !text.empty());
        EXPECT_EQ(text.find(" of rank ") != std::string::npos, !text.empty() && ranks > 1);
      }
    }
  }
}

TEST(CurvedProof, ACellThatIsTurnedInsideOutIsAnError)
{
  TwoTets turned({ 0, 0, 0 }, 5);
  std::swap(turned.Nodes[0], turned.Nodes[1]);
  const CurvedProof proof = turned.Prove();
  EXPECT_EQ(proof.Valid, (std::vector<unsigned char>{ 0, 1, 1 }));
  ASSERT_EQ(turned.Errors.size(), 1u);
  EXPECT_NE(turned.Errors[0].find(
              "1 of 2 curved solids are inside out even with straight edges, the first is cell 0"),
    std::string::npos);
}

/// All models: valid cells have positive determinants by VTK.
TEST(CurvedProof, AllModels)
{
  std::mt19937 random(3);
  for (int model = 0; model < vtkSubdivisionModelSource::NUMBER_OF_MODELS; ++model)
  {
    const Grid input = LoadModel(model);
    for (const int order : { 0, 4 })
    {
      for (int levels = 0; levels <= (order == 0 ? 2 : 0); ++levels)
      {
        SCOPED_TRACE(testing::Message() << model << " " << order << " " << levels);
        vtkNew<Filter> filter;
        vtkNew<Messages> messages;
        messages->Watch(filter);
        filter->SetInputData(input);
        filter->SetNumberOfLevels(levels);
        SetOrder(filter, order);
        filter->Update();
        for (const std::string& text : messages->Errors)
        {
          ADD_FAILURE() << text;
        }
        for (const std::string& text : messages->Warnings)
        {
          std::cout << text << "\n";
        }
        vtkUnstructuredGrid* grid = filter->GetOutput();
        ASSERT_GT(grid->GetNumberOfCells(), 0);
        vtkDataArray* valid = grid->GetCellData()->GetArray("Valid");
        vtkNew<vtkGenericCell> cell;
        const vtkIdType step = std::max<vtkIdType>(1, grid->GetNumberOfCells() / 500);
        for (vtkIdType c = 0; c < grid->GetNumberOfCells(); c += step)
        {
          EXPECT_EQ(valid->GetComponent(c, 0), 1.) << c;
          grid->GetCell(c, cell);
          for (int i = 0; cell->GetCellDimension() == 3 && i < 20; ++i)
          {
            ASSERT_GT(FindDeterminant(cell, DrawPlace(cell, random)), 0.) << c;
          }
        }
      }
    }
  }
}
