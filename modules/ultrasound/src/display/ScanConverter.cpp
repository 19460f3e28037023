#include "ScanConverter.h"

#include "Plane.h"
#include "RowKernels.h"

#include <insonate/ultrasound/Display.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace insonate {
namespace display {
namespace {

constexpr int kRowsPerTask = 32;
constexpr std::size_t kTableRun = Plane::kVector;  ///< tables of each run are padded to whole vectors

/// Lower neighbor and the share of the upper one in 1/256, for a place among `count` samples.
std::pair<int, int> neighbour(double place, int count) {
  const double held = std::clamp(place, 0.0, double(count - 1));
  const int lower = std::min(static_cast<int>(held), count - 2);
  return {lower, std::min(static_cast<int>(std::lround((held - lower) * 256)), 255)};
}

/// Sets size and scale of the image: square pixels, centered, with the whole field of view as large as possible. No
/// gray values.
BModeImage pictureLayout(const BeamGrid& grid, const ImagingSettings& settings) {
  const double width_mm = grid.maxLateral_mm() - grid.minLateral_mm();
  const double height_mm = grid.maxAxial_mm() - grid.minAxial_mm();
  BModeImage image;
  image.width = settings.width, image.height = settings.height;
  image.pixel_mm = std::max(width_mm / settings.width, height_mm / settings.height);
  image.left_mm = 0.5 * (grid.minLateral_mm() + grid.maxLateral_mm()) - 0.5 * (settings.width - 1) * image.pixel_mm;
  image.top_mm = 0.5 * (grid.minAxial_mm() + grid.maxAxial_mm()) - 0.5 * (settings.height - 1) * image.pixel_mm;
  return image;
}

}  // namespace

ScanConverter::ScanConverter(const Probe& probe, const ImagingSettings& settings)
    : samples_(settings.samples),
      scanlines_(settings.scanlines),
      greyStride_(Plane::padded(scanlines_) + 2 * kMargin),
      columns_(2 * Plane::padded(scanlines_)),
      fineStride_(Plane::padded(scanlines_) + Plane::kVector),
      grey_(std::size_t(samples_) * greyStride_),
      fine_(std::size_t(samples_) * fineStride_),
      packed_(std::size_t(samples_ - 1) * columns_) {
  const BeamGrid grid(probe, settings);
  layout_ = pictureLayout(grid, settings);
  for (int row = 0; row < layout_.height; ++row) addRow(grid, row);
  firstRun_.push_back(runs_.size());
}

void ScanConverter::addRow(const BeamGrid& grid, int row) {
  firstRun_.push_back(runs_.size());
  const double axial_mm = layout_.top_mm + row * layout_.pixel_mm;
  bool wasInside = false;
  for (int column = 0; column < layout_.width; ++column) {
    const auto at = grid.locate(layout_.left_mm + column * layout_.pixel_mm, axial_mm);
    if (at.inside) {
      if (!wasInside) {
        index_.resize((index_.size() + kTableRun - 1) / kTableRun * kTableRun);
        weight_.resize(index_.size());
        runs_.push_back({column, 0, index_.size()});
      }
      ++runs_.back().count;
      addPixel(at);
    }
    wasInside = at.inside;
  }
  index_.resize((index_.size() + kTableRun - 1) / kTableRun * kTableRun);
  weight_.resize(index_.size());
}

void ScanConverter::addPixel(const BeamGrid::Location& at) {
  const auto [line, x] = neighbour(2 * at.scanline, 2 * scanlines_ - 1);
  const auto [sample, z] = neighbour(at.sample, samples_);
  index_.push_back(sample * columns_ + line);
  weight_.push_back(static_cast<std::uint16_t>(z << 8 | x));
}

void ScanConverter::convertRow(int row, std::uint8_t* out) const {
  std::memset(out, 0, static_cast<std::size_t>(layout_.width));
  for (std::size_t r = firstRun_[row]; r < firstRun_[row + 1]; ++r) {
    const Run& run = runs_[r];
    scanRow(packed_.data(), index_.data() + run.table, weight_.data() + run.table, run.count, out + run.column);
  }
}

void ScanConverter::refine(int sample) {
  std::uint8_t* const row = greyRow(sample);
  row[-1] = row[0];
  row[scanlines_] = row[scanlines_ + 1] = row[scanlines_ - 1];
  refineRow(row, scanlines_, fineRow(sample));
}

void ScanConverter::convert(BModeImage& image) {
  image.width = layout_.width, image.height = layout_.height;
  image.pixel_mm = layout_.pixel_mm, image.left_mm = layout_.left_mm, image.top_mm = layout_.top_mm;
  image.gray.resize(std::size_t(image.width) * image.height);
  using Rows = tbb::blocked_range<int>;
  tbb::parallel_for(Rows(0, samples_, kRowsPerTask), [this](const Rows& rows) {
    for (int k = rows.begin(); k < rows.end(); ++k) refine(k);
  });
  tbb::parallel_for(Rows(0, samples_ - 1, kRowsPerTask), [this](const Rows& rows) {
    for (int k = rows.begin(); k < rows.end(); ++k)
      packRow(fineBytes(k), fineBytes(k + 1), columns_, packed_.data() + std::size_t(k) * columns_);
  });
  tbb::parallel_for(Rows(0, image.height, kRowsPerTask), [&](const Rows& rows) {
    for (int row = rows.begin(); row < rows.end(); ++row)
      convertRow(row, image.gray.data() + std::size_t(row) * image.width);
  });
}

}  // namespace display

std::vector<std::uint8_t> fieldOfViewMask(const Probe& probe, const ImagingSettings& settings) {
  const BeamGrid grid(probe, settings);
  const BModeImage layout = display::pictureLayout(grid, settings);
  std::vector<std::uint8_t> mask;
  mask.reserve(std::size_t(layout.width) * layout.height);
  for (int row = 0; row < layout.height; ++row)
    for (int column = 0; column < layout.width; ++column)
      mask.push_back(
          grid.locate(layout.left_mm + column * layout.pixel_mm, layout.top_mm + row * layout.pixel_mm).inside);
  return mask;
}

}  // namespace insonate
