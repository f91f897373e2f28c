// SPDX-License-Identifier: BSD-3-Clause
// The singular vertices, edges and faces of a mesh of cells that are not cut, and its choices.
#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Private/Control/OpenPoints.h"
#include "Private/Uniform/HybridInput.h"
#include "Private/Uniform/HybridMarks.h"

#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace subdivision
{
namespace
{

template <typename Id>
class HybridFeatures
{
public:
  HybridFeatures(const CellComplex<Id>& complex, const std::vector<vtkIdType>& sources,
    const FeatureOptions& options, HybridChoices& choices)
    : Complex(complex)
    , Options(options)
    , Choices(choices)
  {
    for (const vtkIdType c : InTurn(complex.Cells.GetNumberOfCells()))
    {
      this->Cells.Simplices.Dimensions.push_back(
        static_cast<unsigned char>(complex.Cells.GetTable(c).Dimension));
    }
    this->Cells.ParentCells = sources;
    this->Flags[0] = &choices.Singular.Vertices;
    this->Flags[1] = &choices.Singular.Edges;
    this->Flags[2] = &choices.Singular.Faces;
  }

  void Read(vtkPointSet* input, const Coordinates& points,
    const std::function<void(const std::string&)>& warn)
  {
    this->Values = ReadFeatureValues(this->Options, this->Cells, warn);
    this->ReadSharpness(0);
    this->FlagCells();
    this->FlagMarks(input, warn);
    if (this->Options.Embedded != EmbeddedRule::Follow)
    {
      this->FlagEmbedded();
    }
    if (!this->Values.Material.empty())
    {
      this->FlagInterfaces();
    }
    if (this->Options.DetectFeatures)
    {
      this->FlagFeatures(points);
    }
    this->SharpenMarks();
    this->ReadOptions();
  }

  /// The same for a mesh of which an earlier filter made some levels.
  bool ReadAgain(const std::vector<DerivedPart>& derived, int made,
    const std::function<void(const std::string&)>& warn)
  {
    this->Values = ReadFeatureValues(this->Options, this->Cells, warn);
    this->ReadSharpness(made);
    this->FlagCells();
    for (const DerivedPart& part : InTurn(derived))
    {
      const Id item = this->FindItem(part);
      if (item < 0)
      {
        return false;
      }
      std::isinf(part.Sharpness)
        ? this->Derive(part.Dimension, item)
        : this->SemiSharpMarks.push_back({ part.Dimension, item, part.Sharpness + made });
    }
    this->SharpenMarks();
    this->ReadOptions();
    return true;
  }

private:
  void ReadOptions()
  {
    StrataOptions& strata = this->Choices.Options;
    strata.Type1 = this->Options.Type1;
    strata.Type2 = this->Options.Type2;
    strata.Type3 = this->Options.Type3;
    strata.DartEnds = this->Options.DartEnds;
    strata.Weights = this->Options.Weights;
    strata.ModifiedBoundary = this->Options.ModifiedBoundary;
    const std::vector<double> angles = ReadCornerAngles(this->Options);
    if (!angles.empty())
    {
      strata.CornerAngles = Buffer<double>(this->Complex.NumberOfVertices, -1.);
      std::copy(angles.begin(), angles.end(), strata.CornerAngles.begin());
    }
    if (!this->Values.Part.empty())
    {
      strata.EdgeParts = Buffer<int>(this->Complex.NumberOfEdges, -1);
      strata.FaceParts = Buffer<int>(this->Complex.NumberOfFaces, -1);
      this->ForCells(
        [&](vtkIdType cell, int dimension, Id item)
        {
          if (dimension == 1 || dimension == 2)
          {
            int& part = (dimension == 1 ? strata.EdgeParts : strata.FaceParts)[item];
            part = part < 0 ? this->Values.Part[static_cast<std::size_t>(cell)] : part;
          }
        });
    }
    if (!this->Values.Rules.empty())
    {
      this->SpreadRules(strata);
    }
  }

  /// act(cell, dimension, item): the vertex, edge or face that a cell is, or the cell itself.
  template <typename Act>
  void ForCells(const Act& act) const
  {
    for (const vtkIdType c : InTurn(this->Complex.Cells.GetNumberOfCells()))
    {
      const int dimension = this->Complex.Cells.GetTable(c).Dimension;
      act(c, dimension,
        dimension == 0     ? *this->Complex.Cells.GetCorners(c)
          : dimension == 1 ? *this->Complex.CellEdges[c].begin()
          : dimension == 2 ? *this->Complex.CellFaces[c].begin()
                           : static_cast<Id>(c));
    }
  }

  void Flag(int dimension, Id item)
  {
    Buffer<unsigned char>& flags = *this->Flags[dimension];
    if (flags.empty())
    {
      const vtkIdType sizes[3] = { this->Complex.NumberOfVertices, this->Complex.NumberOfEdges,
        this->Complex.NumberOfFaces };
      flags = Buffer<unsigned char>(sizes[dimension], static_cast<unsigned char>(0));
    }
    flags[item] = 1;
  }
  /// Flags a part that the next filter would not find by itself.
  void Derive(int dimension, Id item)
  {
    this->Flag(dimension, item);
    this->AddDerived(dimension, item, std::numeric_limits<double>::infinity());
  }
  void AddDerived(int dimension, Id item, double sharpness)
  {
    const Id* ends = this->Complex.EdgeVertices.data() + (dimension == 1 ? 2 * vtkIdType(item) : 0);
    const Row<Id> corners = dimension == 0 ? Row<Id>{ &item, &item + 1 }
      : dimension == 1                     ? Row<Id>{ ends, ends + 2 }
                                           : this->Complex.GetVertices(item);
    this->Choices.Derived.push_back({ dimension, { corners.begin(), corners.end() }, sharpness });
  }
  /// The vertex, edge or face with these corners, in cyclic order; -1: there is none.
  Id FindItem(const DerivedPart& part) const
  {
    const CellComplex<Id>& complex = this->Complex;
    const std::vector<vtkIdType>& corners = part.Corners;
    if (*std::min_element(corners.begin(), corners.end()) < 0 ||
      *std::max_element(corners.begin(), corners.end()) >= complex.NumberOfVertices)
    {
      return -1;
    }
    const Id edge = part.Dimension == 0
      ? static_cast<Id>(corners[0])
      : complex.FindEdge(static_cast<Id>(corners[0]), static_cast<Id>(corners[1]));
    if (part.Dimension < 2 || edge < 0)
    {
      return edge;
    }
    const Row<Id> faces = complex.EdgeFaces[edge];
    const Id* face = std::find_if(faces.begin(), faces.end(),
      [&](Id f)
      {
        const Row<Id> own = complex.GetVertices(f);
        const auto first = std::find(own.begin(), own.end(), corners[0]) - own.begin();
        return std::is_permutation(own.begin(), own.end(), corners.begin(), corners.end()) &&
          (own.size() == 3 || own.begin()[(first + 2) % 4] == corners[2]);
      });
    return face == faces.end() ? -1 : *face;
  }

  void FlagCells()
  {
    const auto isSelected = [this](vtkIdType cell)
    {
      vtkDataArray* selected = this->Options.Marks.SelectedCells;
      return selected &&
        selected->GetComponent(this->Cells.ParentCells[static_cast<std::size_t>(cell)], 0) != 0.;
    };
    this->ForCells(
      [&](vtkIdType cell, int dimension, Id item)
      {
        const bool isFlagged =
          !this->Values.Singular.empty() && this->Values.Singular[static_cast<std::size_t>(cell)];
        if (dimension < 3 && isSelected(cell))
        {
          this->Derive(dimension, item);
        }
        else if (dimension < 3 && isFlagged)
        {
          this->Flag(dimension, item);
        }
      });
  }

  /// The sharpness of lines and faces among the cells before `made` steps; the largest of equal
  /// ones.
  void ReadSharpness(int made)
  {
    this->ForCells(
      [&](vtkIdType cell, int dimension, Id item)
      {
        if (!this->Values.Sharpness.empty() && (dimension == 1 || dimension == 2))
        {
          const double left = this->Values.Sharpness[static_cast<std::size_t>(cell)];
          this->AddSharpness(dimension, item, left > 0. ? left + made : 0.);
        }
      });
  }
  void AddSharpness(int dimension, Id item, double sharpness)
  {
    SolidSharpness& sharp = this->Choices.Sharpness;
    std::vector<double>& all = dimension == 1 ? sharp.Edges : sharp.Faces;
    if (sharpness > 0.)
    {
      all.resize(static_cast<std::size_t>(
        dimension == 1 ? this->Complex.NumberOfEdges : this->Complex.NumberOfFaces));
      double& own = all[static_cast<std::size_t>(item)];
      own = std::max(own, sharpness);
    }
  }

  void FlagMarks(vtkPointSet* input, const std::function<void(const std::string&)>& warn)
  {
    ForHybridMarks<Id>(this->Complex, input, this->Options.Marks, warn,
      [&](int dimension, Id item, double sharpness)
      {
        if (std::isinf(sharpness))
        {
          this->Derive(dimension, item);
        }
        else
        {
          this->SemiSharpMarks.push_back({ dimension, item, sharpness });
        }
      });
  }
  /// Gives marks their sharpness; parts that are singular by something else stay so.
  void SharpenMarks()
  {
    for (const SemiSharpMark& mark : InTurn(this->SemiSharpMarks))
    {
      const Buffer<unsigned char>& flags = *this->Flags[mark.Dimension];
      if (flags.empty() || !flags[mark.Item])
      {
        this->AddSharpness(mark.Dimension, mark.Item, mark.Sharpness);
        this->AddDerived(mark.Dimension, mark.Item, mark.Sharpness);
      }
    }
  }
  /// Whether each face has a sharpness; empty: none has.
  std::vector<bool> FindSemiSharpFaces() const
  {
    std::vector<bool> found;
    for (const double sharpness : InTurn(this->Choices.Sharpness.Faces))
    {
      found.push_back(sharpness > 0.);
    }
    for (const SemiSharpMark& mark : InTurn(this->SemiSharpMarks))
    {
      if (mark.Dimension == 2)
      {
        found.resize(static_cast<std::size_t>(this->Complex.NumberOfFaces));
        found[static_cast<std::size_t>(mark.Item)] = true;
      }
    }
    return found;
  }

  /// Cells that are faces of others (Mathematics 7).
  void FlagEmbedded()
  {
    const Links<Id, CellComplex<Id>> links(this->Complex);
    const bool inside = this->Options.Embedded == EmbeddedRule::SingularInside;
    const auto isInside = [](unsigned char dimensions, const auto& place)
    {
      return dimensions == DimensionBit(1) ? place(1) == Place::Interior
        : dimensions == DimensionBit(2)
        ? place(2) == Place::Interior
        : dimensions == DimensionBit(3) && place(3) == Place::Interior;
    };
    this->ForCells(
      [&](vtkIdType, int dimension, Id item)
      {
        bool isSingular = false;
        if (dimension == 2)
        {
          const vtkIdType solids = this->Complex.FaceSolids[item].size();
          isSingular = inside ? solids == 2 : solids > 0;
        }
        else if (dimension == 1)
        {
          isSingular = links.EdgeFaces[item].size() > 0 &&
            (!inside ||
              isInside(
                links.EdgeDimensions(item), [&](int k) { return links.PlaceEdge(item, k); }));
        }
        else if (dimension == 0)
        {
          const unsigned char dimensions = links.VertexDimensions(item);
          isSingular = dimensions &&
            (!inside || isInside(dimensions, [&](int k) { return links.PlaceVertex(item, k); }));
        }
        if (isSingular)
        {
          this->Derive(dimension, item);
        }
      });
  }

  /// Faces of two solids, and edges of two maximal faces, of different materials. Faces with a
  /// sharpness are left out.
  void FlagInterfaces()
  {
    const std::vector<bool> leftOut = this->FindSemiSharpFaces();
    const auto materialOf = [this](Id cell)
    { return this->Values.Material[static_cast<std::size_t>(cell)]; };
    std::vector<int> ofFaces(static_cast<std::size_t>(this->Complex.NumberOfFaces), 0);
    std::vector<bool> isKnown(ofFaces.size(), false);
    this->ForCells(
      [&](vtkIdType cell, int dimension, Id item)
      {
        const auto face = static_cast<std::size_t>(item);
        if (dimension == 2 && !isKnown[face])
        {
          isKnown[face] = true;
          ofFaces[face] = materialOf(static_cast<Id>(cell));
        }
      });
    for (const Id f : InTurn(this->Complex.NumberOfFaces))
    {
      const Row<Id> sides = this->Complex.FaceSolids[f];
      const bool isLeftOut = !leftOut.empty() && leftOut[static_cast<std::size_t>(f)];
      if (!isLeftOut && sides.size() == 2 &&
        materialOf(sides.begin()[0]) != materialOf(sides.begin()[1]))
      {
        this->Derive(2, f);
      }
    }
    for (const Id e : InTurn(this->Complex.NumberOfEdges))
    {
      const Row<Id> faces = this->Complex.EdgeFaces[e];
      const bool areMaximal = std::all_of(faces.begin(), faces.end(),
        [this](Id f) { return this->Complex.FaceSolids[f].size() == 0; });
      if (areMaximal && faces.size() == 2 &&
        ofFaces[static_cast<std::size_t>(faces.begin()[0])] !=
          ofFaces[static_cast<std::size_t>(faces.begin()[1])])
      {
        this->Derive(1, e);
      }
    }
  }

  /// Edges where the half planes through the means of the other corners of two faces meet in a
  /// larger angle.
  void FlagFeatures(const Coordinates& points)
  {
    for (const Id e : InTurn(this->Complex.NumberOfEdges))
    {
      for (const vtkIdType solids : { 1, 0 }) // the boundary of C_3, C_2
      {
        double places[12] = {};
        const Id* ends = this->Complex.EdgeVertices.data() + 2 * vtkIdType(e);
        std::copy_n(points + 3 * vtkIdType(ends[0]), 3, places);
        std::copy_n(points + 3 * vtkIdType(ends[1]), 3, places + 3);
        int count = 0;
        for (const Id face : this->Complex.EdgeFaces[e])
        {
          if (this->Complex.FaceSolids[face].size() == solids && ++count <= 2)
          {
            this->AddOthers(face, ends, points, places + 3 + 3 * count);
          }
        }
        const FeatureCandidate candidate{ { 0, 1 }, { 2, 3 } };
        if (count == 2 &&
          IsFeature(candidate, Coordinates(places, points.Tie), this->Options.FeatureAngle))
        {
          this->Derive(1, e);
        }
      }
    }
  }
  void AddOthers(Id face, const Id* ends, const double* points, double* mean) const
  {
    for (const Id vertex : this->Complex.GetVertices(face))
    {
      for (int c = 0; vertex != ends[0] && vertex != ends[1] && c < 3; ++c)
      {
        mean[c] += points[3 * vtkIdType(vertex) + c] / (this->Complex.GetSize(face) - 2);
      }
    }
  }

  /// Gives each vertex, edge and face the choice of the first maximal cell at it that has one.
  void SpreadRules(StrataOptions& strata) const
  {
    const CellComplex<Id>& complex = this->Complex;
    constexpr unsigned char none = 0;
    strata.VertexChoices = Buffer<unsigned char>(complex.NumberOfVertices, none);
    strata.EdgeChoices = Buffer<unsigned char>(complex.NumberOfEdges, none);
    strata.FaceChoices = Buffer<unsigned char>(complex.NumberOfFaces, none);
    this->ForCells(
      [&](vtkIdType cell, int dimension, Id item)
      {
        const unsigned char rule = this->Values.Rules[static_cast<std::size_t>(cell)];
        const auto give = [rule](Buffer<unsigned char>& choices, Row<Id> items)
        {
          for (const Id i : items)
          {
            choices[i] = choices[i] ? choices[i] : rule;
          }
        };
        const bool isMaximal = dimension == 3 ||
          (dimension == 2 && complex.FaceSolids[item].size() == 0) ||
          (dimension == 1 && complex.EdgeFaces[item].size() == 0);
        if (rule && isMaximal && !complex.IsTwin(cell))
        {
          const Id* corners = complex.Cells.GetCorners(cell);
          give(strata.VertexChoices, { corners, corners + complex.Cells.GetTable(cell).Corners });
          give(strata.EdgeChoices, complex.CellEdges[cell]);
          give(strata.FaceChoices, dimension == 3 ? complex.CellFaces[cell] : Row<Id>());
        }
      });
  }

  const CellComplex<Id>& Complex;
  const FeatureOptions& Options;
  HybridChoices& Choices;
  SimplicesOfCells Cells; ///< only dimensions and sources
  FeatureValues Values;
  Buffer<unsigned char>* Flags[3];
  struct SemiSharpMark
  {
    int Dimension;
    Id Item;
    double Sharpness;
  };
  std::vector<SemiSharpMark> SemiSharpMarks;
};

}

bool HybridChoices::operator==(const HybridChoices& other) const
{
  const auto areEqual = [](const auto& a, const auto& b)
  { return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin()); };
  const StrataOptions& a = this->Options;
  const StrataOptions& b = other.Options;
  return areEqual(this->Singular.Vertices, other.Singular.Vertices) &&
    areEqual(this->Singular.Edges, other.Singular.Edges) &&
    areEqual(this->Singular.Faces, other.Singular.Faces) &&
    this->Sharpness.Edges == other.Sharpness.Edges &&
    this->Sharpness.Faces == other.Sharpness.Faces && a.Type1 == b.Type1 && a.Type2 == b.Type2 &&
    a.Type3 == b.Type3 && a.DartEnds == b.DartEnds && a.Weights == b.Weights &&
    a.ModifiedBoundary == b.ModifiedBoundary && areEqual(a.CornerAngles, b.CornerAngles) &&
    areEqual(a.EdgeParts, b.EdgeParts) && areEqual(a.FaceParts, b.FaceParts) &&
    areEqual(a.VertexChoices, b.VertexChoices) && areEqual(a.EdgeChoices, b.EdgeChoices) &&
    areEqual(a.FaceChoices, b.FaceChoices);
}

template <typename Id>
bool ReadHybridChoices(const CellComplex<Id>& complex, const std::vector<vtkIdType>& sources,
  vtkPointSet* input, const FeatureOptions& options, const Coordinates& points, int made,
  const std::vector<DerivedPart>& derived, const std::function<void(const std::string&)>& warn,
  HybridChoices& choices)
{
  HybridFeatures<Id> features(complex, sources, options, choices);
  if (made > 0)
  {
    return features.ReadAgain(derived, made, warn);
  }
  features.Read(input, points, warn);
  return true;
}

template <typename Id>
void TellOpenPoints(const CellComplex<Id>& complex, const std::vector<vtkIdType>& sources,
  const FeatureOptions& features, const Coordinates& points,
  const std::function<void(const std::string&)>& warn)
{
  OpenPointOptions options{ features.MergesPoints, features.ClosesNodes, features.JoiningCure, {} };
  options.FindCell = [&](int dimension, vtkIdType index)
  {
    const Rows<Id>& rows = dimension == 2 ? complex.CellFaces : complex.CellEdges;
    const Buffer<Id>& firsts = dimension == 2 ? complex.FaceFirsts : complex.EdgeFirsts;
    const auto cell = dimension == 3
      ? static_cast<std::ptrdiff_t>(index)
      : std::upper_bound(rows.Offsets.begin(), rows.Offsets.end(), firsts[index]) -
        rows.Offsets.begin() - 1;
    return sources[static_cast<std::size_t>(cell)];
  };
  for (const std::string& warning : DescribeOpenPoints(complex, points, options))
  {
    warn(warning);
  }
}

template <typename Id>
void DecideStrata(HybridLevel<Id>& level, HybridChoices& choices)
{
  level.Strata = DecideHybridStrata(level.Complex, choices.Singular, choices.Options);
  level.Sharpness =
    DecideHybridSharpness(level.Complex, choices.Singular, choices.Options, choices.Sharpness);
}

SUBDIVISION_COMPILE_FUNCTION(ReadHybridChoices);
SUBDIVISION_COMPILE_FUNCTION(TellOpenPoints);
SUBDIVISION_COMPILE_FUNCTION(DecideStrata);

}
