// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Samples/SampledImage.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Vectors.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Samples/Distances.h"
#include "Private/Samples/MixedVoxels.h"
#include "Private/Samples/ThickPieces.h"

#include "vtkCharArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <set>
#include <sstream>

namespace subdivision
{
namespace
{

/// 15 digits, for numbers of regions, and decimal fractions as they were written; 17 where these
/// are not enough, so that no two materials have one name.
std::string NameMaterial(double material)
{
  std::ostringstream name;
  name.precision(15);
  name << material;
  if (!std::isnan(material) && std::strtod(name.str().c_str(), nullptr) != material)
  {
    name.str("");
    name.precision(17);
    name << material;
  }
  return name.str();
}

/// The mesh whose arrays the image has: the first one that has points, or none of which has.
vtkPointSet* FindFirst(const std::vector<SampledMesh>& meshes)
{
  const auto first = std::find_if(meshes.begin(), meshes.end(),
    [](const SampledMesh& mesh) { return mesh.Mesh->GetNumberOfPoints() > 0; });
  if (first == meshes.end())
  {
    return meshes.empty() ? nullptr : meshes.front().Mesh;
  }
  return first->Mesh;
}

/// An array of the input, and the one of the image.
struct Channel
{
  vtkSmartPointer<vtkDataArray> From;
  vtkDataArray* To;
};

template <typename T>
void WriteValues(
  const Channel& channel, const vtkIdType* nodes, const double* shares, int size, vtkIdType sample)
{
  const int components = channel.From->GetNumberOfComponents();
  const T* const from = static_cast<const T*>(channel.From->GetVoidPointer(0));
  T* const to = static_cast<T*>(channel.To->GetVoidPointer(0)) + components * sample;
  for (int c = 0; c < components; ++c)
  {
    double sum = 0.;
    for (int n = 0; n < size; ++n)
    {
      sum += shares[n] * static_cast<double>(from[components * nodes[n] + c]);
    }
    to[c] = static_cast<T>(sum);
  }
}

class Sampler
{
public:
  Sampler(const std::vector<SampledMesh>& meshes, const std::vector<double>& materials,
    const SampleOptions& options, vtkImageData* image)
    : Meshes(meshes)
    , Options(options)
    , Grid(options.Grid)
    , Width(Grid.Extent[1] - Grid.Extent[0] + 1)
    , Height(Grid.Extent[3] - Grid.Extent[2] + 1)
    , Solids(ListPieces(meshes, 3))
    , Thick(options.HasThickness ? std::make_unique<ThickPieces>(meshes, options) : nullptr)
    , Mixed(
        options.HasCoverage ? std::make_unique<MixedVoxels>(meshes, materials, options) : nullptr)
    , Near(options.Outside ? std::make_unique<Distances>(meshes, options) : nullptr)
  {
    image->SetExtent(const_cast<int*>(this->Grid.Extent.data()));
    image->SetOrigin(this->Grid.Origin.data());
    image->SetSpacing(this->Grid.Spacing.data());
    this->MakeArrays(image, materials);
    if (options.Order)
    {
      options.Order->assign(image->GetNumberOfPoints(), NothingThere);
    }
    if (options.Others)
    {
      options.Others->resize(image->GetNumberOfPoints());
    }
  }

  void Run()
  {
    // Half a voxel more: places in voxels are around samples.
    const double part = this->Mixed ? 0.5 : 0.;
    const SlabLists lists(this->Grid, static_cast<vtkIdType>(this->Solids.size()),
      [&](vtkIdType i)
      {
        const TetrahedronSamples samples = this->Prepare(this->Solids[i]);
        return FindBox(std::array<Place, 2>{ samples.GetLow(), samples.GetHigh() }, 2,
          vectors::Scale(part, this->Grid.Spacing));
      });
    const vtkIdType slabs = CountSlabs(this->Grid);
    const vtkIdType atOnce = 2 * vtkSMPTools::GetEstimatedNumberOfThreads();
    for (vtkIdType first = 0; first < slabs; first += atOnce)
    {
      this->Options.Tell(static_cast<double>(first) / static_cast<double>(slabs));
      BetweenLoops::Act();
      ForRangesOfBlocks(std::min(slabs - first, atOnce),
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType slab = first + begin; slab < first + end; ++slab)
          {
            this->SampleSlab(slab, lists);
          }
        });
    }
  }

private:
  vtkIdType GetSample(int i, int j, int k) const
  {
    const auto& extent = this->Grid.Extent;
    return (i - extent[0]) + this->Width * ((j - extent[2]) + this->Height * (k - extent[4]));
  }

  void MakeArrays(vtkImageData* image, const std::vector<double>& materials)
  {
    const vtkIdType size = image->GetNumberOfPoints();
    vtkPointData* const data = image->GetPointData();
    const auto add = [&](vtkDataArray* array, int components, const char* name)
    {
      array->SetName(name);
      Allocate(array, components, size);
      std::fill_n(static_cast<char*>(array->GetVoidPointer(0)),
        size * components * array->GetDataTypeSize(), 0);
      data->AddArray(array);
    };
    vtkPointSet* const first = FindFirst(this->Meshes);
    this->Channels.resize(this->Meshes.size());
    for (int a = 0; first && a < first->GetPointData()->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* const like = first->GetPointData()->GetArray(a);
      if (IsSampled(like) &&
        !IsOwnName(this->Meshes, this->Options.HasCoverage, this->Near != nullptr, like->GetName()))
      {
        const auto to = MakeArray(like->GetDataType(), like->GetNumberOfComponents(), 0);
        add(to, like->GetNumberOfComponents(), like->GetName());
        CopyLooks(like, to);
        this->Connect(to);
        if (first->GetPointData()->GetScalars() == like)
        {
          data->SetActiveScalars(like->GetName());
        }
      }
    }
    const auto with = std::find_if(this->Meshes.begin(), this->Meshes.end(),
      [](const SampledMesh& mesh) { return mesh.Material != nullptr; });
    if (with != this->Meshes.end())
    {
      const auto to = MakeArray(with->Material->GetDataType(), 1, 0);
      add(to, 1, SampledMaterialName);
      to->FillComponent(0, this->Options.MaterialOutside);
      data->SetActiveScalars(SampledMaterialName);
      this->Material = to;
    }
    if (this->Options.HasCoverage)
    {
      vtkNew<vtkFloatArray> coverage;
      add(coverage, static_cast<int>(std::max<std::size_t>(materials.size(), 1)),
        SampledCoverageName);
      for (std::size_t m = 0; m < materials.size(); ++m)
      {
        coverage->SetComponentName(static_cast<vtkIdType>(m), NameMaterial(materials[m]).c_str());
      }
      this->Coverage = coverage->GetPointer(0);
    }
    if (this->Near)
    {
      vtkNew<vtkFloatArray> distances;
      add(distances, 1, SampledDistanceName);
      distances->FillValue(static_cast<float>(this->Options.Band));
      this->Distance = distances->GetPointer(0);
    }
    add(vtkNew<vtkCharArray>(), 1, SampledMaskName);
    this->Mask = static_cast<char*>(data->GetArray(SampledMaskName)->GetVoidPointer(0));
  }
  /// Finds the array of this name in all meshes; one that is not like it is left at 0.
  void Connect(vtkDataArray* to)
  {
    for (std::size_t m = 0; m < this->Meshes.size(); ++m)
    {
      vtkDataArray* const from = this->Meshes[m].Mesh->GetPointData()->GetArray(to->GetName());
      if (from && from->GetDataType() == to->GetDataType() &&
        from->GetNumberOfComponents() == to->GetNumberOfComponents())
      {
        this->Channels[m].push_back({ Contiguous(from), to });
      }
    }
  }

  TetrahedronSamples Prepare(const ListedPiece& listed) const
  {
    return TetrahedronSamples(GetNodes(this->Meshes[listed.Mesh].Mesh, *listed.Piece, 3));
  }

  void Write(const ListedPiece& listed, int dimension, const Place& weights, vtkIdType sample)
  {
    const auto shares = GetSharesOfPiece(dimension, weights);
    const int size = QuadraticPiece::CountNodes(dimension);
    for (const Channel& channel : this->Channels[listed.Mesh])
    {
      const auto write =
        channel.To->GetDataType() == VTK_FLOAT ? WriteValues<float> : WriteValues<double>;
      write(channel, listed.Piece->Nodes.data(), shares.data(), size, sample);
    }
    if (this->Material && this->Meshes[listed.Mesh].Material)
    {
      this->Material->SetTuple(sample, listed.Piece->Cell, this->Meshes[listed.Mesh].Material);
    }
    this->Mask[sample] = dimension == 3 ? InSolid : InOther;
    if (this->Options.Order)
    {
      (*this->Options.Order)[sample] = dimension;
    }
  }

  void SampleSlab(vtkIdType number, const SlabLists& lists)
  {
    if (this->Thick)
    {
      this->Thick->ForSlab(number,
        [this](int i, int j, int k, const ListedPiece& listed, int dimension, const Place& weights,
          double square)
        {
          const vtkIdType sample = this->GetSample(i, j, k);
          this->Write(listed, dimension, weights, sample);
          if (this->Options.Order)
          {
            const double steps = std::sqrt(square) / this->Grid.Spacing[0];
            (*this->Options.Order)[sample] = dimension + steps / (1. + steps);
          }
        });
    }
    const SampleGrid slab = GetSlab(this->Grid, number);
    lists.ForNumbers(number, [&](vtkIdType i) { this->SampleSolid(this->Solids[i], slab); });
    if (this->Mixed)
    {
      this->Mixed->CoverSlab(
        number, this->Solids, lists, this->Mask, [this](vtkIdType sample)
        { return this->Material ? this->Material->GetComponent(sample, 0) : 0.; }, this->Coverage);
    }
    char* const begin = this->Mask + GetBegin(this->Grid, slab);
    std::replace(begin, begin + CountSamplesOf(slab), InOther, InSolid);
    if (this->Near)
    {
      this->Near->WriteSlab(number, this->Distance);
    }
  }
  void SampleSolid(const ListedPiece& listed, const SampleGrid& slab)
  {
    const TetrahedronSamples samples = this->Prepare(listed);
    const int lastK = slab.GetLast(2, samples.GetHigh()[2]);
    const int lastJ = slab.GetLast(1, samples.GetHigh()[1]);
    for (int k = slab.GetFirst(2, samples.GetLow()[2]); k <= lastK; ++k)
    {
      for (int j = slab.GetFirst(1, samples.GetLow()[1]); j <= lastJ; ++j)
      {
        const vtkIdType row = this->GetSample(0, j, k);
        samples.ForRow(
          this->Grid, j, k, [&](int i)
          { return this->Mask[row + i] == 0 || (this->Distance && this->Distance[row + i] > 0.F); },
          [&](int i, const Place& weights)
          {
            if (this->Mask[row + i] == 0)
            {
              this->Write(listed, 3, weights, row + i);
            }
            if (this->Distance) // negative in solids, also where a surface has the sample
            {
              this->Distance[row + i] = -std::abs(this->Distance[row + i]);
            }
          });
      }
    }
  }

  const std::vector<SampledMesh>& Meshes;
  const SampleOptions& Options;
  const SampleGrid& Grid;
  const vtkIdType Width;
  const vtkIdType Height;
  std::vector<std::vector<Channel>> Channels; ///< of each mesh
  vtkSmartPointer<vtkDataArray> Material;
  char* Mask = nullptr;
  float* Coverage = nullptr;
  float* Distance = nullptr;
  const std::vector<ListedPiece> Solids;
  const std::unique_ptr<ThickPieces> Thick;
  const std::unique_ptr<MixedVoxels> Mixed;
  const std::unique_ptr<Distances> Near;
};

}

std::vector<double> ListMaterials(const std::vector<SampledMesh>& meshes, int dimension)
{
  std::set<double, bool (*)(double, double)> materials(IsBeforeMaterial);
  for (const SampledMesh& mesh : meshes)
  {
    const auto& pieces = mesh.Pieces.Pieces[dimension];
    for (const QuadraticPiece& piece : InTurn(pieces))
    {
      if (mesh.Material)
      {
        materials.insert(mesh.Material->GetComponent(piece.Cell, 0));
      }
    }
  }
  return { materials.begin(), materials.end() };
}

void SamplePieces(const std::vector<SampledMesh>& meshes, const std::vector<double>& materials,
  const SampleOptions& options, vtkImageData* image)
{
  Sampler(meshes, materials, options, image).Run();
}

bool IsSampled(vtkDataArray* values)
{
  return values && values->GetName() &&
    (values->GetDataType() == VTK_FLOAT || values->GetDataType() == VTK_DOUBLE);
}

bool IsOwnName(
  const std::vector<SampledMesh>& meshes, bool hasCoverage, bool hasDistance, const char* name)
{
  const std::string own = name ? name : "";
  const bool hasMaterial = std::any_of(
    meshes.begin(), meshes.end(), [](const SampledMesh& mesh) { return mesh.Material != nullptr; });
  return own == SampledMaskName || (hasMaterial && own == SampledMaterialName) ||
    (hasCoverage && own == SampledCoverageName) || (hasDistance && own == SampledDistanceName);
}

vtkIdType CountBytesOfSample(
  const std::vector<SampledMesh>& meshes, std::size_t materials, const SampleOptions& options)
{
  vtkIdType bytes = 1; // the mask
  bytes += options.Outside ? vtkIdType(sizeof(float)) : 0;
  vtkPointSet* const first = FindFirst(meshes);
  for (int a = 0; first && a < first->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* const like = first->GetPointData()->GetArray(a);
    bytes += IsSampled(like) ? like->GetDataTypeSize() * like->GetNumberOfComponents() : 0;
  }
  for (const SampledMesh& mesh : meshes)
  {
    if (mesh.Material)
    {
      bytes += mesh.Material->GetDataTypeSize();
      break;
    }
  }
  const auto covered = static_cast<vtkIdType>(std::max<std::size_t>(materials, 1));
  return bytes + (options.HasCoverage ? covered * vtkIdType(sizeof(float)) : 0);
}

}
