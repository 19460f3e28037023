#include "ultrasound/PlainLoop.h"

#include <insonate/core/Hash.h>
#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <cmath>

namespace insonate::bench {
namespace {

constexpr double kFwhmPerSd = 2.3548;
constexpr double kWhite_dB = 39.5;

/// `corner` is in voxels from the outer corner of the first voxel.
std::uint8_t labelAt(const LabelMap& labels, Vec3 corner) {
  const auto i = static_cast<int>(corner.x), j = static_cast<int>(corner.y), k = static_cast<int>(corner.z);
  return labels.geometry.contains(i, j, k) ? knownLabel(labels.at(i, j, k)) : kBackground;
}

std::vector<float> gaussian(double sd) {
  const int radius = std::max(1, static_cast<int>(std::ceil(3 * sd)));
  std::vector<float> kernel;
  float sum = 0;
  for (int o = -radius; o <= radius; ++o) {
    kernel.push_back(static_cast<float>(std::exp(-0.5 * o * o / (sd * sd))));
    sum += kernel.back();
  }
  for (float& w : kernel) w /= sum;
  return kernel;
}

}  // namespace

PlainLoop::PlainLoop(const PatientCase& patient, const ImagingSetup& setup)
    : patient_(patient), setup_(setup), grid_(setup.probe, setup.settings) {
  const ImagingSettings& s = setup.settings;
  const Probe& p = setup.probe;
  for (int label = 0; label < kLabelCount; ++label) {
    const AcousticTissue& tissue = setup.tissues.tissues[label];
    echo_[label] = static_cast<float>(std::pow(10, tissue.echogenicity_dB / 20));
    const double loss_dB = 2 * tissue.attenuation_dBpcmMHz * s.frequency_MHz * grid_.step_mm() / 10;
    loss_[label] = label == kBackground ? 1 : static_cast<float>(std::pow(10, -loss_dB / 20));
  }
  axialKernel_ = gaussian(axialFwhm_mm(p, s) / kFwhmPerSd / grid_.step_mm());
  for (int k = 0; k < s.samples; ++k) {
    const double range_mm = grid_.range_mm(k);
    lateralKernel_.push_back(
        gaussian(lateralFwhm_mm(p, s, range_mm) / kFwhmPerSd / grid_.scanlineSpacing_mm(range_mm)));
  }
  for (auto* plane : {&re_, &im_, &blurredRe_, &blurredIm_, &level_})
    plane->resize(std::size_t(s.scanlines) * s.samples);
  layOut();
}

void PlainLoop::layOut() {
  const ImagingSettings& s = setup_.settings;
  const double width_mm = grid_.maxLateral_mm() - grid_.minLateral_mm();
  const double height_mm = grid_.maxAxial_mm() - grid_.minAxial_mm();
  const double pixel_mm = std::max(width_mm / s.width, height_mm / s.height);
  for (int row = 0; row < s.height; ++row)
    for (int column = 0; column < s.width; ++column) {
      const double lateral_mm = (column - (s.width - 1) / 2.0) * pixel_mm;
      const auto at = grid_.locate(lateral_mm, grid_.minAxial_mm() + row * pixel_mm);
      if (!at.inside) continue;
      const double line = std::clamp(at.scanline, 0.0, s.scanlines - 1.001);
      const double sample = std::clamp(at.sample, 0.0, s.samples - 1.001);
      const int l = static_cast<int>(line), k = static_cast<int>(sample);
      pixels_.push_back({std::size_t(row) * s.width + column, std::size_t(k) * s.scanlines + l,
                         static_cast<float>(line - l), static_cast<float>(sample - k)});
    }
}

void PlainLoop::scatter(const Transform& patientFromProbe) {
  const ImagingSettings& s = setup_.settings;
  const Transform indexFromProbe = patient_.labels.geometry.indexFromPatient() * patientFromProbe;
  std::fill(re_.begin(), re_.end(), 0.0F);
  std::fill(im_.begin(), im_.end(), 0.0F);
  const double planeStep_mm = 0.87 * sliceLaw(setup_.probe, s.frequency_MHz).narrowest_mm / kFwhmPerSd;
  for (int plane = 0; plane < s.elevationPlanes; ++plane) {
    const double offset = plane - (s.elevationPlanes - 1) / 2.0;
    const auto weight = static_cast<float>(std::exp(-0.375 * offset * offset));
    for (int line = 0; line < s.scanlines; ++line) {
      const Vec3 origin =
          indexFromProbe * (grid_.origin(line) + Vec3{0, offset * planeStep_mm, 0}) + Vec3{0.5, 0.5, 0.5};
      const Vec3 direction = indexFromProbe.linear * grid_.direction(line);
      float level = weight;
      for (int k = 0; k < s.samples; ++k) {
        const std::uint8_t label = labelAt(patient_.labels, origin + direction * grid_.range_mm(k));
        level *= loss_[label];
        const std::uint32_t h = hash32(static_cast<std::uint32_t>(k + s.samples * (line + s.scanlines * plane)));
        const std::size_t i = std::size_t(k) * s.scanlines + line;
        re_[i] += level * echo_[label] * (static_cast<float>(h & 0xffffU) - 32767.5F) / 18918;
        im_[i] += level * echo_[label] * (static_cast<float>(h >> 16U) - 32767.5F) / 18918;
      }
    }
  }
}

void PlainLoop::blurAxially() {
  const int lines = setup_.settings.scanlines, samples = setup_.settings.samples;
  const int radius = static_cast<int>(axialKernel_.size()) / 2;
  for (int k = 0; k < samples; ++k)
    for (int line = 0; line < lines; ++line) {
      float re = 0, im = 0;
      for (int o = std::max(-radius, -k); o <= std::min(radius, samples - 1 - k); ++o) {
        const std::size_t i = std::size_t(k + o) * lines + line;
        re += axialKernel_[o + radius] * re_[i], im += axialKernel_[o + radius] * im_[i];
      }
      blurredRe_[std::size_t(k) * lines + line] = re, blurredIm_[std::size_t(k) * lines + line] = im;
    }
}

void PlainLoop::blurLaterally() {
  const ImagingSettings& s = setup_.settings;
  for (int k = 0; k < s.samples; ++k) {
    const std::vector<float>& kernel = lateralKernel_[k];
    const int radius = static_cast<int>(kernel.size()) / 2;
    const auto gain_dB = static_cast<float>(kTgc_dBpcmMHz * s.frequency_MHz * grid_.range_mm(k) / 10);
    for (int line = 0; line < s.scanlines; ++line) {
      float re = 0, im = 0;
      for (int o = std::max(-radius, -line); o <= std::min(radius, s.scanlines - 1 - line); ++o) {
        const std::size_t i = std::size_t(k) * s.scanlines + line + o;
        re += kernel[o + radius] * blurredRe_[i], im += kernel[o + radius] * blurredIm_[i];
      }
      const float power = re * re + im * im + 1e-20F;
      const float level_dB = 10 * std::log10(power) + gain_dB - static_cast<float>(kWhite_dB - s.dynamicRange_dB);
      level_[std::size_t(k) * s.scanlines + line] =
          std::clamp(level_dB / static_cast<float>(s.dynamicRange_dB), 0.0F, 1.0F) * 255;
    }
  }
}

void PlainLoop::convert(BModeImage& image) const {
  const ImagingSettings& s = setup_.settings;
  image.width = s.width, image.height = s.height;
  image.gray.assign(std::size_t(s.width) * s.height, 0);
  for (const Pixel& pixel : pixels_) {
    const float* p = level_.data() + pixel.level;
    const float* q = p + s.scanlines;
    const float upper = (1 - pixel.x) * p[0] + pixel.x * p[1], lower = (1 - pixel.x) * q[0] + pixel.x * q[1];
    image.gray[pixel.at] = static_cast<std::uint8_t>((1 - pixel.z) * upper + pixel.z * lower);
  }
}

void PlainLoop::render(const Transform& patientFromProbe, BModeImage& image) {
  scatter(patientFromProbe);
  blurAxially();
  blurLaterally();
  convert(image);
}

}  // namespace insonate::bench
