#include "CoarseImage.h"

#include <insonate/image/GaussianBlur.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <cmath>

namespace insonate::segmentation {
namespace {

constexpr double kFat_HU = -120, kMuscle_HU = 60;
constexpr int kPadding_HU = -1500;

/// Gray value of each label: mean HU between fat and muscle.
constexpr std::array<double, kLabelCount> kLabel_HU{-1000, 30, 60, -100, -1000, 30, 45, 40,
                                                    60,    40, 57, 55,   60,    60, 5,  30};

float gray(double hu) {
  return static_cast<float>((std::clamp(hu, kFat_HU, kMuscle_HU) - kFat_HU) / (kMuscle_HU - kFat_HU));
}

void addTissue(TissueValues& to, std::uint8_t label, double hu) {
  to[0] += gray(hu);
  to[1] += label == kBone ? 1.f : 0.f;
  to[2] += label == kAirway ? 1.f : 0.f;
  to[3] += label == kBackground ? 1.f : 0.f;
}

VolumeGeometry gridBetween(Vec3 low_mm, Vec3 high_mm, double spacing_mm) {
  VolumeGeometry g;
  for (int axis = 0; axis < 3; ++axis)
    g.size[axis] = std::max(1, static_cast<int>(std::ceil((high_mm[axis] - low_mm[axis]) / spacing_mm)));
  g.spacing_mm = {spacing_mm, spacing_mm, spacing_mm};
  g.origin_mm = low_mm + Vec3{spacing_mm, spacing_mm, spacing_mm} / 2;
  return g;
}

}  // namespace

TissueValues CoarseImage::at(Vec3 index, bool& isKnown) const {
  const auto& n = geometry.size;
  int low[3], high[3];
  float part[3];
  isKnown = true;
  for (int axis = 0; axis < 3; ++axis) {
    const double at = index[axis];
    if (!(at >= -0.5 && at <= n[axis] - 0.5)) {
      isKnown = false;
      return {};
    }
    const double inside = std::clamp(at, 0.0, double(n[axis] - 1));
    low[axis] = static_cast<int>(inside);
    high[axis] = std::min(low[axis] + 1, n[axis] - 1);
    part[axis] = static_cast<float>(inside - low[axis]);
  }
  TissueValues sum{};
  for (int c = 0; c < 8; ++c) {
    const float weight =
        ((c & 1) ? part[0] : 1 - part[0]) * ((c & 2) ? part[1] : 1 - part[1]) * ((c & 4) ? part[2] : 1 - part[2]);
    const std::size_t v =
        geometry.offset((c & 1) ? high[0] : low[0], (c & 2) ? high[1] : low[1], (c & 4) ? high[2] : low[2]);
    if (!known[v]) isKnown = false;
    for (std::size_t m = 0; m < sum.size(); ++m) sum[m] += weight * values[v][m];
  }
  return sum;
}

CoarseImage coarseImage(const CtVolume& ct, const LabelMap& automatic, Vec3 low_mm, Vec3 high_mm, double spacing_mm,
                        Work& work) {
  CoarseImage image;
  image.geometry = gridBetween(low_mm, high_mm, spacing_mm);
  image.values.resize(image.geometry.voxelCount());
  image.known.assign(image.geometry.voxelCount(), 1);
  const Transform indexFromPatient = ct.geometry.indexFromPatient() * image.geometry.patientFromIndex();
  constexpr std::array kParts{-0.25, 0.25};
  work.slices(image.geometry.size[2], [&](int k) {
    for (int j = 0; j < image.geometry.size[1]; ++j)
      for (int i = 0; i < image.geometry.size[0]; ++i) {
        const std::size_t v = image.geometry.offset(i, j, k);
        for (const double z : kParts)
          for (const double y : kParts)
            for (const double x : kParts) {
              const Vec3 index = indexFromPatient * Vec3{i + x, j + y, k + z};
              const auto [a, b, c] = nearestVoxel(index);
              if (!ct.geometry.contains(a, b, c) || ct.at(a, b, c) < kPadding_HU) {
                image.known[v] = 0;
                continue;
              }
              addTissue(image.values[v], automatic.at(a, b, c), sampleLinear(ct, index));
            }
        for (float& value : image.values[v]) value /= 8;
      }
  });
  return image;
}

CoarseImage coarseImage(const LabelMap& labels, double spacing_mm) {
  const VolumeGeometry& fine = labels.geometry;
  const Vec3 low_mm = fine.origin_mm - fine.spacing_mm / 2;
  Vec3 high_mm = low_mm;
  for (int axis = 0; axis < 3; ++axis) high_mm[axis] += fine.size[axis] * fine.spacing_mm[axis];
  CoarseImage image;
  image.geometry = gridBetween(low_mm, high_mm, spacing_mm);
  image.values.resize(image.geometry.voxelCount());
  image.known.assign(image.geometry.voxelCount(), 1);
  std::vector<float> count(image.geometry.voxelCount());
  const Transform coarseFromFine = image.geometry.indexFromPatient() * fine.patientFromIndex();
  for (int k = 0; k < fine.size[2]; ++k)
    for (int j = 0; j < fine.size[1]; ++j)
      for (int i = 0; i < fine.size[0]; ++i) {
        const auto [a, b, c] = nearestVoxel(coarseFromFine * Vec3{double(i), double(j), double(k)});
        if (!image.geometry.contains(a, b, c)) continue;
        const std::size_t v = image.geometry.offset(a, b, c);
        const std::uint8_t label = labels.at(i, j, k);
        addTissue(image.values[v], label, kLabel_HU[knownLabel(label)]);
        count[v] += 1;
      }
  for (std::size_t v = 0; v < count.size(); ++v)
    for (float& value : image.values[v]) value /= std::max(count[v], 1.f);
  return image;
}

CoarseImage halved(const CoarseImage& image) {
  CoarseImage half;
  const VolumeGeometry& fine = image.geometry;
  half.geometry = fine;
  for (int axis = 0; axis < 3; ++axis) half.geometry.size[axis] = std::max(1, fine.size[axis] / 2);
  half.geometry.spacing_mm = fine.spacing_mm * 2;
  half.geometry.origin_mm = fine.origin_mm + fine.spacing_mm / 2;
  half.values.resize(half.geometry.voxelCount());
  half.known.assign(half.geometry.voxelCount(), 1);
  for (int k = 0; k < half.geometry.size[2]; ++k)
    for (int j = 0; j < half.geometry.size[1]; ++j)
      for (int i = 0; i < half.geometry.size[0]; ++i) {
        const std::size_t v = half.geometry.offset(i, j, k);
        for (int c = 0; c < 8; ++c) {
          const std::size_t w = fine.offset(std::min(2 * i + (c & 1), fine.size[0] - 1),
                                            std::min(2 * j + ((c >> 1) & 1), fine.size[1] - 1),
                                            std::min(2 * k + ((c >> 2) & 1), fine.size[2] - 1));
          half.known[v] &= image.known[w];
          for (std::size_t m = 0; m < image.values[w].size(); ++m) half.values[v][m] += image.values[w][m] / 8;
        }
      }
  return half;
}

CoarseImage blurred(const CoarseImage& image, double sigma_mm) {
  CoarseImage smooth = image;
  Volume<float> one(image.geometry);
  for (std::size_t m = 0; m < TissueValues().size(); ++m) {
    for (std::size_t v = 0; v < one.voxels.size(); ++v) one.voxels[v] = image.values[v][m];
    blurGaussian(one, sigma_mm);
    for (std::size_t v = 0; v < one.voxels.size(); ++v) smooth.values[v][m] = one.voxels[v];
  }
  return smooth;
}

}  // namespace insonate::segmentation
