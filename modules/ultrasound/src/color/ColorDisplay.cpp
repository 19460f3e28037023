#include "color/ColorPlan.h"

#include <insonate/core/Hash.h>
#include <insonate/ultrasound/ColorDisplay.h>
#include <insonate/ultrasound/Display.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace insonate {
namespace {

/// Range of the power map above its threshold.
constexpr double kPowerRange_dB = 30;
/// The estimate is shown where it exceeds the power of the noise, with a gain of 0 dB.
constexpr double kThreshold = 1;
constexpr int kShades = 256;
constexpr std::uint8_t kOutline = 170;

struct Estimate {
  float re = 0, im = 0;
};

struct GaussianPair {
  float a, b;
};
/// Two independent Gaussian numbers of unit variance (Box and Muller) for a hash, from a table, since logarithm and
/// angle would take a third of the time of the display.
GaussianPair gaussianPair(std::uint32_t hash) {
  constexpr int kBits = 12, kEntries = 1 << kBits;
  static const std::vector<GaussianPair> table = [] {
    std::vector<GaussianPair> pairs(kEntries);
    for (int i = 0; i < kEntries; ++i) {
      const double radius = std::sqrt(-2 * std::log((i + 0.5) / kEntries));
      const double turn = 2 * std::numbers::pi * unitInterval(hash32(static_cast<std::uint32_t>(i) + 1));
      pairs[i] = {static_cast<float>(radius * std::cos(turn)), static_cast<float>(radius * std::sin(turn))};
    }
    return pairs;
  }();
  return table[hash >> (32 - kBits)];
}

/// Angle of a vector divided by pi, -1 to 1, within 1e-5. Polynomial of the arctangent: Abramowitz and Stegun 4.4.49.
float angleOverPi(float y, float x) {
  constexpr auto kPerPi = static_cast<float>(1 / std::numbers::pi);
  const float ay = std::abs(y), ax = std::abs(x), large = std::max(ax, ay);
  if (large == 0) return 0;
  const float t = std::min(ax, ay) / large, t2 = t * t;
  float angle = kPerPi * t * (0.999866F + t2 * (-0.3302995F + t2 * (0.180141F + t2 * (-0.085133F + t2 * 0.0208351F))));
  if (ay > ax) angle = 0.5F - angle;
  if (x < 0) angle = 1 - angle;
  return y < 0 ? -angle : angle;
}

Rgb mixed(const Rgb& a, const Rgb& b, double t) {
  Rgb color;
  for (int c = 0; c < 3; ++c) color[c] = static_cast<std::uint8_t>(std::lround(a[c] + t * (b[c] - a[c])));
  return color;
}

Rgb alongRamp(const std::array<Rgb, 3>& ramp, double share) {
  const double place = 2 * std::clamp(share, 0.0, 1.0);
  return place < 1 ? mixed(ramp[0], ramp[1], place) : mixed(ramp[1], ramp[2], place - 1);
}

}  // namespace

Rgb velocityColor(double share, bool invert) {
  static constexpr std::array<Rgb, 3> kRed{Rgb{80, 0, 0}, Rgb{215, 30, 10}, Rgb{255, 210, 70}};
  static constexpr std::array<Rgb, 3> kBlue{Rgb{0, 0, 90}, Rgb{10, 60, 225}, Rgb{90, 225, 255}};
  return alongRamp((share >= 0) != invert ? kRed : kBlue, std::abs(share));
}

Rgb powerColor(double share) {
  static constexpr std::array<Rgb, 3> kPower{Rgb{90, 20, 10}, Rgb{220, 100, 15}, Rgb{255, 230, 130}};
  return alongRamp(kPower, share);
}

std::array<Vec3, 4> colorBoxCorners(const Probe& probe, const ImagingSettings& settings, const ColorSettings& color) {
  const ColorPlan plan(probe, settings, color);
  const double left = plan.firstBeam - 0.5, right = plan.firstBeam + plan.lines - 0.5;
  return {plan.point_mm(left, color.near_mm), plan.point_mm(right, color.near_mm), plan.point_mm(right, color.far_mm),
          plan.point_mm(left, color.far_mm)};
}

struct ColorDisplay::Impl {
  Impl(const Probe& probe, const ImagingSettings& settings, const ColorSettings& color);

  /// A pixel within the box: its place among the estimates.
  struct Pixel {
    int at = -1;  ///< gate before the pixel on the scanline before it; -1: outside the box
    std::uint16_t alongLine = 0, acrossLines = 0;  ///< weights of the next gate and of the next scanline, in 1/1024
    bool outline = false;                          ///< on the border of the box
  };

  void placePixels();
  void markOutline();
  void estimate(const ColorFrame& frame, std::uint32_t seed);
  void smooth(const ColorFrame& frame);
  void persist();
  void drawRow(int row, const BModeImage& gray, ColorImage& image) const;
  void markEmptyCells(const ColorFrame& frame);
  void storeVelocities(const ColorFrame& frame);
  float threshold() const { return static_cast<float>(kThreshold * std::pow(10, -plan.color.gain_dB / 10)); }

  ColorPlan plan;
  BeamGrid field;  ///< field of view of the B-mode image
  BModeImage layout;
  ColorImage area;  ///< the rectangle of the box, without colors
  std::vector<Pixel> pixels;
  std::vector<Estimate> raw, alongLines, shown;
  std::vector<float> velocities;
  /// By gate: false if all four estimates around the pixels after it are below the threshold, as most are.
  std::vector<std::uint8_t> hasColor;
  bool hasPrevious = false;
  std::array<Rgb, kShades> map{};
};

ColorDisplay::Impl::Impl(const Probe& probe, const ImagingSettings& settings, const ColorSettings& color)
    : plan(probe, settings, color), field(probe, settings) {
  Display(probe, settings).process({}, layout);
  const std::size_t count = std::size_t(plan.lines) * plan.gates;
  raw.resize(count), alongLines.resize(count), shown.resize(count), velocities.resize(count), hasColor.resize(count);
  for (int i = 0; i < kShades; ++i)
    map[i] = color.mode == ColorMode::Power ? powerColor(i / (kShades - 1.0))
                                            : velocityColor(2 * (i + 0.5) / kShades - 1, color.invert);
  for (std::size_t i = 0; i < area.scale.size(); ++i) area.scale[i] = map[i * kShades / area.scale.size()];
  placePixels();
  markOutline();
}

void ColorDisplay::Impl::placePixels() {
  double left = 1e30, right = -1e30, top = 1e30, bottom = -1e30;
  // The corners, and the arcs between them of a fan.
  constexpr int kArc = 16;
  for (int i = 0; i <= kArc; ++i)
    for (const double range_mm : {plan.color.near_mm, plan.color.far_mm}) {
      const Vec3 p = plan.point_mm(plan.firstBeam - 0.5 + double(plan.lines) * i / kArc, range_mm);
      left = std::min(left, p.x), right = std::max(right, p.x), top = std::min(top, p.z),
      bottom = std::max(bottom, p.z);
    }
  const auto pixel = [&](double at_mm, double first_mm, int count) {
    return std::clamp(static_cast<int>(std::lround((at_mm - first_mm) / layout.pixel_mm)), 0, count - 1);
  };
  area.column = pixel(left, layout.left_mm, layout.width), area.row = pixel(top, layout.top_mm, layout.height);
  area.width = pixel(right, layout.left_mm, layout.width) - area.column + 1;
  area.height = pixel(bottom, layout.top_mm, layout.height) - area.row + 1;
  area.nyquist_mmps = plan.color.mode == ColorMode::Power ? 0 : plan.nyquist_mmps;
  pixels.resize(std::size_t(area.width) * area.height);
  for (int row = 0; row < area.height; ++row)
    for (int column = 0; column < area.width; ++column) {
      const double x = layout.left_mm + (area.column + column) * layout.pixel_mm;
      const double z = layout.top_mm + (area.row + row) * layout.pixel_mm;
      const BeamGrid::Location at = plan.beams.locate(x, z);
      const double line = at.scanline - plan.firstBeam;
      const double gate = (plan.beams.range_mm(at.sample) - plan.color.near_mm) / plan.gate_mm - 0.5;
      if (line < -0.5 || line > plan.lines - 0.5 || gate < -0.5 || gate > plan.gates - 0.5) continue;
      if (!field.locate(x, z).inside) continue;
      const int lowLine = std::clamp(static_cast<int>(std::floor(line)), 0, plan.lines - 2);
      const int lowGate = std::clamp(static_cast<int>(std::floor(gate)), 0, plan.gates - 2);
      const auto weight = [](double t) {
        return static_cast<std::uint16_t>(std::lround(1024 * std::clamp(t, 0.0, 1.0)));
      };
      pixels[std::size_t(row) * area.width + column] = {lowLine * plan.gates + lowGate, weight(gate - lowGate),
                                                        weight(line - lowLine)};
    }
}

void ColorDisplay::Impl::markOutline() {
  const auto inside = [&](int row, int column) {
    return row >= 0 && column >= 0 && row < area.height && column < area.width &&
           pixels[std::size_t(row) * area.width + column].at >= 0;
  };
  for (int row = 0; row < area.height; ++row)
    for (int column = 0; column < area.width; ++column)
      if (inside(row, column))
        pixels[std::size_t(row) * area.width + column].outline =
            !(inside(row - 1, column) && inside(row + 1, column) && inside(row, column - 1) && inside(row, column + 1));
}

/// Estimates from n pulses are Gaussian around the expected autocorrelation, with the variance
/// ((P + 1)^2 - |R|^2) / (n - 1), where P is the power of the signal and 1 that of the noise (Kasai et al., IEEE Trans
/// Sonics Ultrason 1985; 32:458). The power of speckle varies in addition.
void ColorDisplay::Impl::estimate(const ColorFrame& frame, std::uint32_t seed) {
  const bool noisy = plan.imaging.effects.noise;
  const float perPacket = 1.0F / static_cast<float>(plan.color.packet - 1);
  tbb::parallel_for(tbb::blocked_range<int>(0, frame.lines, 8), [&](const tbb::blocked_range<int>& lines) {
    for (int line = lines.begin(); line < lines.end(); ++line)
      for (int gate = 0; gate < frame.gates; ++gate) {
        const std::size_t at = frame.at(line, gate);
        float re = frame.lagOneRe[at], im = frame.lagOneIm[at];
        if (noisy) {
          const float total = frame.power[at] + 1, size2 = re * re + im * im;
          const float sd = std::sqrt(std::max(total * total - size2, 0.0F) * perPacket * 0.5F);
          const std::uint32_t hash = hashNode(line, gate, 0, seed);
          const GaussianPair noise = gaussianPair(hash), speckle = gaussianPair(hash32(hash ^ 0x51ed270bU));
          const float level = 0.5F * (speckle.a * speckle.a + speckle.b * speckle.b);
          // Half of the level is that of one speckle, half the mean of the scatterers that pass during the packet.
          re = re * (0.5F + 0.5F * level) + sd * noise.a, im = im * (0.5F + 0.5F * level) + sd * noise.b;
        }
        raw[at] = {re, im};
      }
  });
}

/// Binomial filter over three gates and three scanlines.
void ColorDisplay::Impl::smooth(const ColorFrame& frame) {
  if (!plan.imaging.effects.noise) return;
  const auto binomial = [](const Estimate& a, const Estimate& b, const Estimate& c) {
    return Estimate{0.25F * (a.re + c.re) + 0.5F * b.re, 0.25F * (a.im + c.im) + 0.5F * b.im};
  };
  for (int line = 0; line < frame.lines; ++line)
    for (int gate = 0; gate < frame.gates; ++gate)
      alongLines[frame.at(line, gate)] = binomial(raw[frame.at(line, std::max(gate - 1, 0))], raw[frame.at(line, gate)],
                                                  raw[frame.at(line, std::min(gate + 1, frame.gates - 1))]);
  for (int line = 0; line < frame.lines; ++line)
    for (int gate = 0; gate < frame.gates; ++gate)
      raw[frame.at(line, gate)] =
          binomial(alongLines[frame.at(std::max(line - 1, 0), gate)], alongLines[frame.at(line, gate)],
                   alongLines[frame.at(std::min(line + 1, frame.lines - 1), gate)]);
}

void ColorDisplay::Impl::persist() {
  const auto share = static_cast<float>(hasPrevious ? plan.color.persistence : 0);
  for (std::size_t i = 0; i < raw.size(); ++i) {
    shown[i].re = raw[i].re + share * (shown[i].re - raw[i].re);
    shown[i].im = raw[i].im + share * (shown[i].im - raw[i].im);
  }
  hasPrevious = true;
}

void ColorDisplay::Impl::markEmptyCells(const ColorFrame& frame) {
  const float least = threshold(), least2 = least * least;
  const auto isStrong = [&](int line, int gate) {
    const Estimate& e = shown[frame.at(std::min(line, frame.lines - 1), std::min(gate, frame.gates - 1))];
    return e.re * e.re + e.im * e.im > least2;
  };
  for (int line = 0; line < frame.lines; ++line)
    for (int gate = 0; gate < frame.gates; ++gate)
      hasColor[frame.at(line, gate)] =
          isStrong(line, gate) || isStrong(line, gate + 1) || isStrong(line + 1, gate) || isStrong(line + 1, gate + 1);
}

void ColorDisplay::Impl::drawRow(int row, const BModeImage& gray, ColorImage& image) const {
  const float least = threshold(), least2 = least * least;
  const bool power = plan.color.mode == ColorMode::Power;
  const auto brightest = static_cast<int>(std::lround(255 * plan.color.priority));
  const auto perShade = static_cast<float>(5 / kPowerRange_dB);
  const std::uint8_t* const tissue = gray.gray.data() + std::size_t(area.row + row) * gray.width + area.column;
  std::uint8_t* out = image.rgba.data() + std::size_t(row) * area.width * 4;
  for (int column = 0; column < area.width; ++column, out += 4) {
    out[3] = 0;
    const Pixel& p = pixels[std::size_t(row) * area.width + column];
    if (p.outline) out[0] = out[1] = out[2] = kOutline, out[3] = 255;
    if (p.at < 0 || p.outline || !hasColor[p.at] || tissue[column] > brightest) continue;
    const Estimate *a = shown.data() + p.at, *b = a + plan.gates;
    const float g = p.alongLine * (1.0F / 1024), l = p.acrossLines * (1.0F / 1024);
    const float re = (1 - l) * (a[0].re + g * (a[1].re - a[0].re)) + l * (b[0].re + g * (b[1].re - b[0].re));
    const float im = (1 - l) * (a[0].im + g * (a[1].im - a[0].im)) + l * (b[0].im + g * (b[1].im - b[0].im));
    const float size2 = re * re + im * im;
    if (size2 <= least2) continue;
    const float share = power ? perShade * std::log10(size2 / least2) : 0.5F + 0.5F * angleOverPi(im, re);
    const Rgb& color = map[std::clamp(static_cast<int>(share * kShades), 0, kShades - 1)];
    out[0] = color[0], out[1] = color[1], out[2] = color[2], out[3] = 255;
  }
}

void ColorDisplay::Impl::storeVelocities(const ColorFrame& frame) {
  const float least = threshold(), least2 = least * least;
  const auto nyquist = static_cast<float>(plan.nyquist_mmps);
  for (std::size_t i = 0; i < frame.power.size(); ++i) {
    const Estimate& e = shown[i];
    velocities[i] = e.re * e.re + e.im * e.im > least2 ? nyquist * angleOverPi(e.im, e.re)
                                                       : std::numeric_limits<float>::quiet_NaN();
  }
}

ColorDisplay::ColorDisplay(const Probe& probe, const ImagingSettings& settings, const ColorSettings& color)
    : impl_(std::make_unique<Impl>(probe, settings, color)) {}
ColorDisplay::~ColorDisplay() = default;
ColorDisplay::ColorDisplay(ColorDisplay&&) noexcept = default;
ColorDisplay& ColorDisplay::operator=(ColorDisplay&&) noexcept = default;

void ColorDisplay::process(const ColorFrame& frame, const BModeImage& gray, ColorImage& image,
                           std::uint32_t noiseSeed) {
  Impl& impl = *impl_;
  const ColorImage& area = impl.area;
  image.column = area.column, image.row = area.row, image.width = area.width, image.height = area.height;
  image.nyquist_mmps = area.nyquist_mmps, image.scale = area.scale;
  image.rgba.resize(std::size_t(area.width) * area.height * 4);
  impl.estimate(frame, noiseSeed);
  impl.smooth(frame);
  impl.persist();
  impl.markEmptyCells(frame);
  impl.storeVelocities(frame);
  tbb::parallel_for(tbb::blocked_range<int>(0, area.height, 16), [&](const tbb::blocked_range<int>& rows) {
    for (int row = rows.begin(); row < rows.end(); ++row) impl.drawRow(row, gray, image);
  });
}

void ColorDisplay::reset() {
  impl_->hasPrevious = false;
}

const std::vector<float>& ColorDisplay::velocities_mmps() const {
  return impl_->velocities;
}

}  // namespace insonate
