#include "ultrasound/Realism.h"

#include "ultrasound/LabelImage.h"
#include "ultrasound/RealismRanges.h"

#include <insonate/bench/ImageMeasures.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace insonate::bench {
namespace {

/// Median of the finite values; NaN without any.
double medianOf(std::vector<double> values) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.empty()) return NAN;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

/// Letters and digits, joined by single hyphens.
std::string fileName(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (plain)
      name += c;
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  return name;
}

/// Measures of one image on patches that the labels determine.
class PictureScore {
 public:
  PictureScore(const BModeImage& image, const LabelImage& labels, std::string variant, std::string view)
      : image_(image), labels_(labels), variant_(std::move(variant)), view_(std::move(view)) {}

  std::vector<RealismRow> rows() {
    measureGray();
    measureEvenPatch();
    measureMuscle();
    measureLumens();
    measureBone();
    measureAirShadow();
    return std::move(rows_);
  }

 private:
  static constexpr double kMinPatch_mm = 2.5;

  int pixels(double mm) const { return static_cast<int>(std::lround(mm / labels_.pixel_mm())); }

  void add(std::string_view measure, double value, const std::string& patch, const PixelBox& box = {}) {
    const auto range = std::find_if(std::begin(kRealismRanges), std::end(kRealismRanges),
                                    [&](const RealismRange& r) { return r.measure == measure; });
    if (!std::isfinite(value) || range == std::end(kRealismRanges)) return;
    rows_.push_back({variant_, view_, std::string(measure), patch, box, value, range->low, range->median, range->high,
                     value >= range->low && value <= range->high});
  }

  /// A box of at most this size, inside the labels with a margin; empty if there is no room.
  PixelBox patchIn(const std::vector<std::uint8_t>& labels, double margin_mm, double width_mm, double height_mm) const {
    const PixelMask inside = eroded(labels_.maskOf(labels), pixels(margin_mm));
    const PixelBox box = largestBox(inside, pixels(width_mm), pixels(height_mm));
    const int least = pixels(kMinPatch_mm);
    return box.width >= least && box.height >= least ? box : PixelBox{};
  }

  void measureGray() {
    const PixelBox box = labels_.fieldOfView();
    const GrayStatistics g = grayStatistics(image_, box);
    const std::string patch = "field of view";
    add("grey p25", g.p25, patch, box);
    add("grey p50", g.p50, patch, box);
    add("grey p75", g.p75, patch, box);
    add("grey p95", g.p95, patch, box);
    add("grey p99", g.p99, patch, box);
    add("grey mean", g.mean, patch, box);
    add("black share", g.black, patch, box);
    add("black share, upper 60 %", g.blackUpper60, patch, box);
    add("bright share", g.bright, patch, box);
    add("saturated share", g.saturated, patch, box);
    add("deep over shallow", g.deepOverShallow, patch, box);
  }

  void measureEvenPatch() {
    // The only sufficiently large tissues without structure of their own.
    std::string patch = "thyroid";
    PixelBox box = patchIn({kThyroid}, 0.8, 8, 6);
    if (box.width == 0) patch = "gland", box = patchIn({kGland}, 0.8, 8, 6);
    if (box.width == 0) return;
    const SpeckleStatistics grain = speckleStatistics(image_, box);
    if (patch == "thyroid") thyroidMean_ = grain.mean;
    add("grain axial FWHM, mm", grain.axial_mm, patch, box);
    add("grain lateral FWHM, mm", grain.lateral_mm, patch, box);
    add("even patch SD", grain.sd, patch, box);
    add("even patch SD over mean", grain.sd / std::max(grain.mean, 1.0), patch, box);
    add("even patch skewness", grain.skewness, patch, box);
  }

  void measureMuscle() {
    const PixelBox box = patchIn({kSternocleidomastoid}, 1.0, 12, 5);
    if (box.width == 0) return;
    const SpeckleStatistics grain = speckleStatistics(image_, box);
    add("muscle mean", grain.mean, "sternocleidomastoid", box);
    add("muscle SD over mean", grain.sd / std::max(grain.mean, 1.0), "sternocleidomastoid", box);
  }

  void measureLumens() {
    std::vector<Lumen> lumens;
    for (const std::uint8_t label : {kVein, kArtery})
      for (const PixelMask& part : parts(labels_.maskOf({label}), pixels(3) * pixels(3))) {
        const PixelBox box = largestBox(eroded(part, pixels(0.5)), pixels(30), pixels(10));
        if (std::min(box.width, box.height) >= pixels(1.5)) lumens.push_back(lumenOf(image_, box));
      }
    const auto addMedian = [&](std::string_view measure, double Lumen::*field) {
      std::vector<double> values;
      values.reserve(lumens.size());
      for (const Lumen& lumen : lumens) values.push_back(lumen.*field);
      add(measure, medianOf(values), std::to_string(lumens.size()) + (lumens.size() == 1 ? " vessel" : " vessels"));
    };
    addMedian("lumen mean", &Lumen::mean);
    addMedian("lumen SD", &Lumen::sd);
    addMedian("lumen over surroundings", &Lumen::overSurroundings);
    addMedian("lumen near minus far wall", &Lumen::nearMinusFar);
    addMedian("below a vessel over its sides", &Lumen::belowOverSides);
  }

  /// First bone of each column from the face down, or -1.
  std::vector<int> boneSurface() const {
    const PixelMask bone = labels_.maskOf({kBone});
    std::vector<int> surface(image_.width, -1);
    for (int column = 0; column < image_.width; ++column)
      for (int row = 0; row < image_.height && surface[column] < 0; ++row)
        if (bone.at(column, row)) surface[column] = row;
    return surface;
  }

  /// The widest piece of bone surface that stays within 2 mm of depth, as its bounding box.
  PixelBox flatBone() const {
    const std::vector<int> surface = boneSurface();
    PixelBox best;
    for (int first = 0; first < image_.width; ++first) {
      if (surface[first] < 0) continue;
      int top = surface[first], bottom = top;
      for (int end = first; end < image_.width && surface[end] >= 0; ++end) {
        top = std::min(top, surface[end]), bottom = std::max(bottom, surface[end]);
        if (bottom - top > pixels(2)) break;
        if (end - first + 1 > best.width) best = {first, top, end - first + 1, bottom - top + 1};
      }
    }
    return best;
  }

  void measureBone() {
    const PixelBox bone = flatBone();
    const int bottom = labels_.fieldOfView().row + labels_.fieldOfView().height;
    const int shadowTop = bone.row + bone.height + pixels(1.5);
    if (bone.width < pixels(4) || bone.row < pixels(5) || bottom - shadowTop < pixels(2)) return;
    const double line = lineGray(image_, {bone.column, bone.row - pixels(0.5), bone.width, bone.height + pixels(1.2)});
    const double above = meanGray(image_, {bone.column, bone.row - pixels(3.5), bone.width, pixels(2)});
    const double shadow =
        meanGray(image_, {bone.column, shadowTop, bone.width, std::min(pixels(4), bottom - shadowTop)});
    add("bone or pleura line grey", line, "bone", bone);
    add("line over tissue above", line / std::max(above, 1.0), "bone", bone);
    add("shadow over tissue above", shadow / std::max(above, 1.0), "bone", bone);
  }

  void measureAirShadow() {
    if (!(thyroidMean_ > 0)) return;
    // Behind the dirty shadow at the front of the airway.
    PixelMask airway = labels_.maskOf({kAirway});
    const PixelMask all = airway;
    for (int row = 0; row < airway.height; ++row)
      for (int column = 0; column < airway.width; ++column) {
        const int above = row - pixels(4);
        airway.chosen[std::size_t(row) * airway.width + column] &= above >= 0 && all.at(column, above);
      }
    const PixelBox box = largestBox(eroded(airway, pixels(0.4)), pixels(8), pixels(8));
    if (std::min(box.width, box.height) < pixels(1.5)) return;
    add("air shadow over thyroid", meanGray(image_, box) / thyroidMean_, "airway", box);
  }

  const BModeImage& image_;
  const LabelImage& labels_;
  std::string variant_, view_;
  double thyroidMean_ = 0;
  std::vector<RealismRow> rows_;
};

}  // namespace

void measureRealism(const AcousticScene& scene, const ImagingSetup& setup, const Transform& patientFromProbe,
                    const std::string& variant, const std::string& view, UltrasoundBench& bench) {
  auto imager = Imager::make(setup);
  if (!imager) return;
  ImagingFrame frame;
  imager->render(scene, patientFromProbe, frame);
  const LabelImage labels(scene, setup, patientFromProbe);
  if (labels.fieldOfView().width == 0) return;
  for (RealismRow& row : PictureScore(frame.image, labels, variant, view).rows())
    bench.realism.push_back(std::move(row));
  bench.pictures.push_back({fileName(variant + " " + view), std::move(frame.image)});
}

}  // namespace insonate::bench
