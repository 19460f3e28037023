#include "ultrasound/LabelImage.h"

#include "ultrasound/Realism.h"

#include <algorithm>
#include <cmath>

namespace insonate::bench {
namespace {

constexpr double kMark_dB = 0.002;  ///< per label

/// The central plane, with uniform scattering only.
ImagingSettings markedSettings(ImagingSettings settings) {
  settings.elevationPlanes = 1;
  settings.looks = 1;
  settings.effects = Effects::none();
  settings.effects.scattering = true;
  return settings;
}

std::uint8_t labelOf(const AcousticTable& marked, float amplitude) {
  if (!(amplitude > 0)) return LabelImage::kUnknown;
  const double level_dB = 20 * std::log10(double(amplitude));
  for (std::uint8_t label = 0; label < kLabelCount; ++label)
    if (std::abs(level_dB - marked.of(label).echogenicity_dB) < kMark_dB / 3) return label;
  return LabelImage::kUnknown;
}

}  // namespace

AcousticTable withMarks(AcousticTable table) {
  for (int label = 0; label < kLabelCount; ++label) table.tissues[label].echogenicity_dB += kMark_dB * label;
  return table;
}

LabelImage::LabelImage(const AcousticScene& scene, const ImagingSetup& setup, const Transform& patientFromProbe)
    : width_(setup.settings.width), height_(setup.settings.height), label_(std::size_t(width_) * height_, kUnknown) {
  ImagingSetup marked = setup;
  marked.settings = markedSettings(setup.settings);
  auto imager = Imager::make(marked);
  if (!imager) return;
  ImagingFrame frame;
  imager->render(scene, patientFromProbe, frame);
  pixel_mm_ = frame.image.pixel_mm;
  const AcousticTable& table = scene.tissues();
  std::vector<std::uint8_t> byBeam;
  for (const float amplitude : frame.envelope.amplitude) byBeam.push_back(labelOf(table, amplitude));

  const BeamGrid grid(marked.probe, marked.settings);
  int left = width_, right = -1, top = height_, bottom = -1;
  for (int row = 0; row < height_; ++row)
    for (int column = 0; column < width_; ++column) {
      const auto at = grid.locate(frame.image.left_mm + column * pixel_mm_, frame.image.top_mm + row * pixel_mm_);
      if (!at.inside) continue;
      left = std::min(left, column), right = std::max(right, column);
      top = std::min(top, row), bottom = std::max(bottom, row);
      const int line = std::clamp(static_cast<int>(std::lround(at.scanline)), 0, grid.scanlines() - 1);
      const int sample = std::clamp(static_cast<int>(std::lround(at.sample)), 0, grid.samples() - 1);
      label_[std::size_t(row) * width_ + column] = byBeam[std::size_t(sample) * grid.scanlines() + line];
    }
  if (right >= 0) fieldOfView_ = {left, top, right - left + 1, bottom - top + 1};
}

PixelMask LabelImage::maskOf(const std::vector<std::uint8_t>& labels) const {
  PixelMask mask{width_, height_, std::vector<std::uint8_t>(label_.size())};
  for (std::size_t i = 0; i < label_.size(); ++i)
    mask.chosen[i] = std::find(labels.begin(), labels.end(), label_[i]) != labels.end();
  return mask;
}

PixelMask eroded(const PixelMask& mask, int pixels) {
  // Erodes by a square in two passes: a pixel stays if the nearest unchosen pixel of its row, then of its column, is
  // farther away.
  const auto pass = [&](const PixelMask& in, bool rows) {
    PixelMask out{in.width, in.height, std::vector<std::uint8_t>(in.chosen.size())};
    const int lanes = rows ? in.height : in.width, length = rows ? in.width : in.height;
    const auto index = [&](int lane, int i) {
      return rows ? std::size_t(lane) * in.width + i : std::size_t(i) * in.width + lane;
    };
    for (int lane = 0; lane < lanes; ++lane)
      for (int i = 0, run = 0; i < length; ++i) {
        run = in.chosen[index(lane, i)] ? run + 1 : 0;
        if (run > 2 * pixels) out.chosen[index(lane, i - pixels)] = 1;
      }
    return out;
  };
  return pass(pass(mask, true), false);
}

std::vector<PixelMask> parts(const PixelMask& mask, int minPixels) {
  std::vector<std::pair<std::size_t, PixelMask>> found;
  PixelMask left = mask;
  std::vector<std::size_t> stack;
  for (std::size_t seed = 0; seed < left.chosen.size(); ++seed) {
    if (!left.chosen[seed]) continue;
    PixelMask part{mask.width, mask.height, std::vector<std::uint8_t>(mask.chosen.size())};
    std::size_t count = 0;
    const auto take = [&](std::size_t i) {
      if (!left.chosen[i]) return;
      left.chosen[i] = 0, part.chosen[i] = 1, ++count;
      stack.push_back(i);
    };
    take(seed);
    while (!stack.empty()) {
      const std::size_t i = stack.back();
      stack.pop_back();
      const auto column = static_cast<int>(i % mask.width), row = static_cast<int>(i / mask.width);
      if (column > 0) take(i - 1);
      if (column + 1 < mask.width) take(i + 1);
      if (row > 0) take(i - mask.width);
      if (row + 1 < mask.height) take(i + mask.width);
    }
    if (count >= std::size_t(minPixels)) found.emplace_back(count, std::move(part));
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<PixelMask> sorted;
  sorted.reserve(found.size());
  for (auto& [count, part] : found) sorted.push_back(std::move(part));
  return sorted;
}

PixelBox largestBox(const PixelMask& mask, int maxWidth, int maxHeight) {
  PixelBox best;
  std::vector<int> tall(mask.width, 0);  // chosen pixels from this row upward, at most maxHeight
  for (int row = 0; row < mask.height; ++row) {
    for (int column = 0; column < mask.width; ++column)
      tall[column] = mask.at(column, row) ? std::min(tall[column] + 1, maxHeight) : 0;
    for (int column = 0; column < mask.width; ++column) {
      int height = tall[column];
      for (int end = column; end < std::min(column + maxWidth, mask.width) && height > 0; ++end) {
        height = std::min(height, tall[end]);
        if (const int width = end - column + 1; width * height > best.width * best.height)
          best = {column, row - height + 1, width, height};
      }
    }
  }
  return best;
}

}  // namespace insonate::bench
