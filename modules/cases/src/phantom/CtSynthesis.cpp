#include "Noise.h"

#include <insonate/cases/CtSynthesis.h>
#include <insonate/image/GaussianBlur.h>
#include <insonate/tissue/Labels.h>

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

namespace insonate {
namespace {

constexpr double kAir_HU = -1000;
constexpr double kCompactBone_HU = 950, kTrabecularBone_HU = 260;
/// Bone blurred with this width separates the compact shell (share below kShell) from the inside (above kInside).
constexpr double kShellBlur_mm = 1.3, kShell = 0.80, kInside = 0.93;
/// Air that is wider than any airway is lung: blurred with this width, its middle is nearly all air (above kWide), and
/// the blurred middle reaches its rim (above kNearWide_permille).
constexpr double kWideBlur_mm = 9, kWide = 0.8, kNearWide_permille = 80, kCoarse_mm = 2;
constexpr double kFwhmPerSigma = 2.354820045;

/// CT number of a tissue: mean, and standard deviation and cell size of its smooth texture (in addition to scanner
/// noise). Means: usual values of native CT at 120 kV; iodine makes the thyroid bright without contrast agent.
struct TissueHu {
  double native, contrast, texture, cell_mm;
};
constexpr std::array<TissueHu, kLabelCount> kTissueHu{{
    {kAir_HU, kAir_HU, 0, 1},  // background
    {30, 35, 8, 3},            // skin
    {45, 250, 2, 8},           // artery
    {-100, -100, 10, 3.5},     // fat
    {kAir_HU, kAir_HU, 0, 1},  // airway
    {30, 35, 5, 2},            // nerve
    {42, 180, 2, 8},           // vein
    {40, 75, 6, 2.5},          // lymph node
    {110, 170, 9, 3},          // thyroid
    {40, 60, 7, 3},            // esophagus
    {57, 65, 8, 3},            // sternocleidomastoid
    {55, 63, 8, 3},            // muscle
    {kTrabecularBone_HU, kTrabecularBone_HU, 60, 2},
    {130, 135, 25, 3},  // cartilage, partly calcified
    {5, 15, 22, 3},     // soft tissue: connective tissue with some fat
    {25, 60, 12, 2.5},  // salivary gland
}};

constexpr TissueHu kLung{-830, -820, 25, 4};  // at full inspiration

Result<void> checkOptions(const LabelMap& labels, const CtSynthesisOptions& o) {
  if (auto valid = validate(labels.geometry); !valid) return valid;
  if (labels.voxels.size() != labels.geometry.voxelCount())
    return fail("The label map has " + std::to_string(labels.voxels.size()) + " voxels, its grid " +
                std::to_string(labels.geometry.voxelCount()) + ".");
  if (!(o.noise_HU >= 0 && o.noise_HU <= 200))
    return fail("The noise of the synthetic CT must be 0 to 200 HU, not " + std::to_string(o.noise_HU) + ".");
  if (!(o.resolution_FWHM_mm >= 0 && o.resolution_FWHM_mm <= 5))
    return fail("The resolution of the synthetic CT must be 0 to 5 mm, not " + std::to_string(o.resolution_FWHM_mm) +
                ".");
  return {};
}

/// Share of bone around each voxel.
Volume<float> boneShare(const LabelMap& labels) {
  Volume<float> share(labels.geometry);
  std::transform(labels.voxels.begin(), labels.voxels.end(), share.voxels.begin(),
                 [](std::uint8_t label) { return label == kBone ? 1.f : 0.f; });
  blurGaussian(share, kShellBlur_mm);
  return share;
}

/// Nearness of lung, if above kNearWide_permille. Computed on a coarse grid, since it changes slowly.
CtVolume lungNearness(const LabelMap& labels) {
  VolumeGeometry g = labels.geometry;
  std::array<int, 3> stride{};
  for (int a = 0; a < 3; ++a) {
    stride[a] = std::max(1, static_cast<int>(kCoarse_mm / g.spacing_mm[a]));
    g.size[a] = (g.size[a] - 1) / stride[a] + 1;
    g.spacing_mm[a] *= stride[a];
  }
  Volume<float> nearness(g);
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i)
        nearness.at(i, j, k) = labels.at(i * stride[0], j * stride[1], k * stride[2]) == kAirway ? 1.f : 0.f;
  blurGaussian(nearness, kWideBlur_mm);
  for (float& v : nearness.voxels) v = v > kWide ? 1.f : 0.f;
  blurGaussian(nearness, kWideBlur_mm);
  CtVolume permille(g);
  std::transform(nearness.voxels.begin(), nearness.voxels.end(), permille.voxels.begin(),
                 [](float v) { return static_cast<std::int16_t>(std::lround(1000 * v)); });
  return permille;
}

double boneHu(double share, double texture_HU) {
  const double t = std::clamp((share - kShell) / (kInside - kShell), 0.0, 1.0), inside = t * t * (3 - 2 * t);
  return kCompactBone_HU + (kTrabecularBone_HU - kCompactBone_HU) * inside + texture_HU * (0.6 + 0.4 * inside);
}

Volume<float> tissueHu(const LabelMap& labels, const CtSynthesisOptions& o) {
  Volume<float> hu = boneShare(labels);
  const CtVolume lung = lungNearness(labels);
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  const Transform lungFromPatient = lung.geometry.indexFromPatient();
  const auto& size = labels.geometry.size;
  tbb::parallel_for(0, size[2], [&](int k) {
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        const std::uint8_t label = labels.at(i, j, k);
        const bool isLung =
            label == kAirway &&
            sampleLinear(lung, lungFromPatient * (patientFromIndex * Vec3{double(i), double(j), double(k)})) >
                kNearWide_permille;
        const TissueHu& tissue = isLung ? kLung : kTissueHu[label < kLabelCount ? label : std::uint8_t(kSoftTissue)];
        double texture = 0;
        if (tissue.texture > 0) {
          const Vec3 p = patientFromIndex * Vec3{double(i), double(j), double(k)};
          texture = tissue.texture / phantom::kSmoothNoiseSd *
                    phantom::smoothNoise(p / tissue.cell_mm, hash32(o.seed + 0x7e47U + label));
        }
        float& value = hu.at(i, j, k);
        const double mean = o.contrast == CtContrast::kNative ? tissue.native : tissue.contrast;
        value = static_cast<float>(label == kBone ? boneHu(value, texture) : mean + texture);
      }
  });
  return hu;
}

/// Noise of one slice: white, then smoothed 1-2-1 along rows and columns, scaled back to standard deviation 1.
class SliceNoise {
 public:
  SliceNoise(int width, int height, int k, std::uint32_t seed) : width_(width), white_((width + 2) * (height + 2)) {
    std::size_t n = 0;
    for (int j = -1; j <= height; ++j)
      for (int i = -1; i <= width; ++i) {
        // Two uniform numbers of one hash, each with variance 1/12: their sum approximates a normal distribution.
        const std::uint32_t h = hashNode(i, j, k, seed);
        white_[n++] = static_cast<float>(((h & 0xffffU) + (h >> 16)) / 65536.0 - 1) * 2.4494897f;
      }
  }
  double at(int i, int j) const {
    const auto row = [&](int r) {
      const float* w = &white_[std::size_t(r) * (width_ + 2) + i];
      return w[0] + 2 * w[1] + w[2];
    };
    return (row(j) + 2 * row(j + 1) + row(j + 2)) / 6.0;  // root of the summed squared weights: 6
  }

 private:
  int width_;
  std::vector<float> white_;
};

}  // namespace

Result<CtVolume> synthesizeCt(const LabelMap& labels, const CtSynthesisOptions& options, const Progress& progress) {
  if (auto valid = checkOptions(labels, options); !valid) return tl::unexpected(valid.error());
  constexpr std::string_view kDoing = "Synthesizing the CT";
  if (!report(progress, kDoing, 0)) return fail(std::string(kCancelled));
  Volume<float> hu = tissueHu(labels, options);
  if (!report(progress, kDoing, 0.5)) return fail(std::string(kCancelled));
  if (options.resolution_FWHM_mm > 0) blurGaussian(hu, options.resolution_FWHM_mm / kFwhmPerSigma);
  if (!report(progress, kDoing, 0.8)) return fail(std::string(kCancelled));

  CtVolume ct(labels.geometry);
  const auto& size = ct.geometry.size;
  tbb::parallel_for(0, size[2], [&](int k) {
    const SliceNoise noise(size[0], size[1], k, hash32(options.seed + 0x5ca2U));
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        const double value = hu.at(i, j, k) + options.noise_HU * noise.at(i, j);
        ct.at(i, j, k) = static_cast<std::int16_t>(std::lround(std::clamp(value, -1024.0, 3071.0)));
      }
  });
  if (!report(progress, kDoing, 1)) return fail(std::string(kCancelled));
  return ct;
}

}  // namespace insonate
