// SPDX-License-Identifier: BSD-3-Clause
#include "Slices.h"
#include "CheckedFile.h"
#include "Files.h"
#include "Messages.h"
#include "Names.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#ifdef SUBDIVISIONOBJECTS_IOIMAGE
#include "vtkPNGWriter.h"
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <ostream>
#include <set>
#include <sstream>
#include <vector>

namespace subdivide
{
namespace
{

/// How much of a sample each material has, 0 to 1.
struct Layers
{
  std::vector<std::string> Materials; ///< one without a name where there are none
  std::function<double(vtkIdType, std::size_t)> Cover;
};

std::string ToText(double number, int digits = 15)
{
  std::ostringstream text;
  text << std::setprecision(digits) << number;
  return text.str();
}

/// 15 digits where they are enough, so that 0.1 is 0.1, and no two materials have one name.
std::string NameMaterial(double material)
{
  const std::string text = ToText(material);
  const bool isEnough = std::isnan(material) || std::strtod(text.c_str(), nullptr) == material;
  return isEnough ? text : ToText(material, 17);
}

/// The order of materials, of which those that are no number are one, and the last.
bool IsLess(double a, double b)
{
  return a < b || (std::isnan(b) && !std::isnan(a));
}

/// A material is written as the sampler names components of coverage.
Layers ReadLayers(vtkImageData* image)
{
  vtkPointData* const data = image->GetPointData();
  vtkDataArray* const coverage = data->GetArray("Coverage");
  vtkDataArray* const material = data->GetArray("Material");
  vtkDataArray* const mask = data->GetArray("vtkValidPointMask");
  Layers layers;
  if (!mask || image->GetNumberOfPoints() == 0)
  {
    throw Failure(
      "there is nothing to slice: slices are of the image that the filter sample makes");
  }
  if (coverage)
  {
    for (int c = 0; c < coverage->GetNumberOfComponents(); ++c)
    {
      const char* const name = coverage->GetComponentName(c);
      layers.Materials.emplace_back(name ? name : "");
    }
    layers.Cover = [coverage](vtkIdType sample, std::size_t layer)
    { return coverage->GetComponent(sample, static_cast<int>(layer)); };
    return layers;
  }
  std::set<double, bool (*)(double, double)> found(IsLess);
  for (vtkIdType s = 0; material && s < image->GetNumberOfPoints(); ++s)
  {
    if (mask->GetComponent(s, 0) != 0.)
    {
      found.insert(material->GetComponent(s, 0));
    }
  }
  const std::vector<double> materials(found.begin(), found.end());
  std::transform(
    materials.begin(), materials.end(), std::back_inserter(layers.Materials), NameMaterial);
  layers.Materials.resize(std::max<std::size_t>(materials.size(), 1));
  layers.Cover = [mask, material, materials](vtkIdType sample, std::size_t layer)
  {
    const double own = material && !materials.empty() ? material->GetComponent(sample, 0) : 0.;
    const bool isOfLayer =
      materials.empty() || !(IsLess(own, materials[layer]) || IsLess(materials[layer], own));
    return mask->GetComponent(sample, 0) != 0. && isOfLayer ? 1. : 0.;
  };
  return layers;
}

/// A number from 0 to 1 of a pixel: an additive sequence, which is spread evenly in each direction.
double GetThreshold(int i, int j, int k)
{
  constexpr double root = 1.2207440846057596; // of x^4 = x + 1
  const double at = 0.5 + i / root + j / (root * root) + k / (root * root * root);
  return at - std::floor(at);
}

/// The pixel of one material: white where the threshold lies in the part that the material has of
/// the parts of all, one after another.
unsigned char Dither(const Layers& layers, vtkIdType sample, std::size_t layer, double threshold)
{
  double begin = 0.;
  for (std::size_t m = 0; m < layer; ++m)
  {
    begin += layers.Cover(sample, m);
  }
  const double end = begin + layers.Cover(sample, layer);
  return threshold >= begin && threshold < end ? 255 : 0;
}

std::string NameLayer(int layer, const std::string& material)
{
  std::ostringstream name;
  name << "layer" << std::setw(5) << std::setfill('0') << layer
       << (material.empty() ? "" : "_material" + material) << ".png";
  return name.str();
}

#ifdef SUBDIVISIONOBJECTS_IOIMAGE
void WritePicture(vtkImageData* picture, const std::string& name)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(name.c_str());
  writer->SetInputData(picture);
  const int before = GetNumberOfErrors();
  writer->Write();
  std::error_code none;
  if (writer->GetErrorCode() != 0 || GetNumberOfErrors() > before ||
    std::filesystem::file_size(std::filesystem::u8path(name), none) < 57 || none) // without pixels
  {
    throw Failure("cannot write \"" + name + "\"");
  }
}
#else
void WritePicture(vtkImageData*, const std::string&)
{
}
#endif

/// What the pictures are, for whoever puts them together.
void Describe(vtkImageData* image, const Layers& layers, const std::string& name)
{
  CheckedFile file;
  if (!file.Open(name.c_str()))
  {
    throw Failure("cannot write \"" + name + "\"");
  }
  std::ostream out(&file);
  const double* const spacing = image->GetSpacing();
  const int* const extent = image->GetExtent();
  double first[3];
  image->GetPoint(0, first);
  const auto list = [](const double* numbers)
  {
    return "[" + ToText(numbers[0]) + ", " + ToText(numbers[1]) + ", " + ToText(numbers[2]) + "]";
  };
  out << "{\n  \"pixel_and_layer\": " << list(spacing)
      << ",\n  \"middle_of_first_pixel\": " << list(first)
      << ",\n  \"columns\": " << extent[1] - extent[0] + 1
      << ",\n  \"rows\": " << extent[3] - extent[2] + 1
      << ",\n  \"layers\": " << extent[5] - extent[4] + 1 << ",\n  \"materials\": [";
  for (std::size_t m = 0; m < layers.Materials.size(); ++m)
  {
    out << (m > 0 ? ", \"" : "\"") << layers.Materials[m] << "\"";
  }
  out << "]\n}\n" << std::flush;
  if (!file.Close())
  {
    throw Failure("cannot write \"" + name + "\": " + file.GetReason());
  }
}

}

void CheckSlices(const std::string& folder)
{
#ifndef SUBDIVISIONOBJECTS_IOIMAGE
  throw UsageError("--slices needs VTK's module IOImage, which this VTK was built without");
#endif
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::u8path(folder), error);
  if (!std::filesystem::is_directory(std::filesystem::u8path(folder)))
  {
    throw Failure("cannot make the folder \"" + folder + "\"");
  }
  CheckPlace(folder + "/slices.json");
}

void WriteSlices(vtkDataObject* data, const std::string& folder, bool dithers)
{
  auto* const image = vtkImageData::SafeDownCast(data);
  if (!image)
  {
    throw Failure("--slices is for an image: let sample be the last filter");
  }
  const Layers layers = ReadLayers(image);
  const int* const size = image->GetDimensions();
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(size[0], size[1], 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* const pixels = static_cast<unsigned char*>(picture->GetScalarPointer());
  const vtkIdType area = vtkIdType(size[0]) * size[1];
  for (int k = 0; k < size[2]; ++k)
  {
    for (std::size_t m = 0; m < layers.Materials.size(); ++m)
    {
      for (vtkIdType p = 0; p < area; ++p)
      {
        const vtkIdType sample = k * area + p;
        const double threshold =
          GetThreshold(static_cast<int>(p % size[0]), static_cast<int>(p / size[0]), k);
        pixels[p] = dithers
          ? Dither(layers, sample, m, threshold)
          : static_cast<unsigned char>(std::lround(255. * layers.Cover(sample, m)));
      }
      picture->Modified();
      WritePicture(picture, folder + "/" + NameLayer(k, layers.Materials[m]));
    }
  }
  Describe(image, layers, folder + "/slices.json");
}

}
