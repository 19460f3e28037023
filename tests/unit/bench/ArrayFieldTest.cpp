#include "pointspread/ArrayField.h"
#include "pointspread/Spread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace insonate::bench {
namespace {

/// The array of the published figures: 192 elements of 0.2 mm pitch and 5 mm height, lens at 20 mm, Hann on receive.
Probe arrayOf(double receiveFNumber) {
  Probe probe = *loadProbe("linear");
  probe.width_mm = 38.4, probe.pitch_mm = 0.2, probe.elementHeight_mm = 5, probe.elevationFocus_mm = 20;
  probe.maxAperture_mm = 30, probe.transmitFNumber = 3, probe.receiveFNumber = receiveFNumber;
  probe.apodization = Apodization::Hann;
  probe.bandwidth = 0.5;  // 70 % of the transducer and a pulse of one cycle
  return probe;
}

struct Widths {
  double lateral_mm, lateral20dB_mm, slice_mm, axial_mm;
};

Widths widthsAt(const Probe& probe, double depth_mm) {
  ImagingSettings settings = settingsFor(probe);
  settings.frequency_MHz = 7.5, settings.focus_mm = 20;
  const ArrayField field(probe, settings, probe.width_mm / 2);
  Spread spread;
  spread.across = 81, spread.along = 2 * int(ArrayField::kReach_mm / ArrayField::kStep_mm + 0.5) + 1;
  const auto peak = [](const std::vector<std::complex<double>>& echo) {
    double top = 0;
    for (const auto& value : echo) top = std::max(top, std::abs(value));
    return top;
  };
  for (int x = -40; x <= 40; ++x) {
    const auto echo = field.echo({x * spread.x_mm, 0, depth_mm}, depth_mm);
    spread.echo.insert(spread.echo.end(), echo.begin(), echo.end());
    spread.slice.push_back(peak(field.echo({0, 2 * x * spread.y_mm, depth_mm}, depth_mm)));
  }
  spread.endAcross = spread.slice;
  spread.y_mm *= 2;
  const PointSpreadFigures f = figuresOf(spread);
  return {f.lateral_mm, f.lateral20dB_mm, f.slice_mm, f.axial_mm};
}

/// Widths by PFIELD (Garcia 2022) for the same array. How its transmit aperture was tapered is not stated; off the
/// transmit focus the skirt depends on that.
TEST(ArrayField, HasThePublishedProgramsWidths) {
  struct Row {
    double depth_mm, narrow_mm, narrow20dB_mm, wide_mm, slice_mm;
  };
  for (const Row& row : {Row{10, 0.68, 1.17, 1.23, 1.76}, Row{20, 0.55, 1.01, 0.78, 0.82},
                         Row{35, 0.64, 1.14, 1.15, 1.68}, Row{45, 0.67, 1.18, 1.24, 2.58}}) {
    const Widths narrow = widthsAt(arrayOf(1.5), row.depth_mm), wide = widthsAt(arrayOf(3), row.depth_mm);
    EXPECT_NEAR(narrow.lateral_mm / row.narrow_mm, 1, 0.12) << row.depth_mm;
    EXPECT_NEAR(narrow.lateral20dB_mm / row.narrow20dB_mm, 1, 0.15) << row.depth_mm;
    EXPECT_NEAR(wide.lateral_mm / row.wide_mm, 1, 0.12) << row.depth_mm;
    EXPECT_NEAR(narrow.slice_mm / row.slice_mm, 1, 0.12) << row.depth_mm;
    EXPECT_NEAR(narrow.axial_mm, 0.18, 0.02) << row.depth_mm;
  }
}

TEST(ArrayField, IsHighestOnTheAxisAndEvenAboutIt) {
  const Probe probe = arrayOf(1.5);
  const ArrayField field(probe, settingsFor(probe), probe.width_mm / 2);
  const auto echoAt = [&](double x_mm, double y_mm) { return field.echo({x_mm, y_mm, 25}, 25); };
  const auto middle = echoAt(0, 0), left = echoAt(-0.4, 0), right = echoAt(0.4, 0), above = echoAt(0, 0.7);
  for (std::size_t t = 0; t < middle.size(); ++t) EXPECT_NEAR(std::abs(left[t]), std::abs(right[t]), 1e-9);
  const auto top = [](const auto& echo) {
    double highest = 0;
    for (const auto& value : echo) highest = std::max(highest, std::abs(value));
    return highest;
  };
  EXPECT_GT(top(middle), top(left));
  EXPECT_GT(top(middle), top(above));
}

TEST(ArrayField, LosesApertureAtItsEnd) {
  const Probe probe = arrayOf(1.5);
  const auto widthWith = [&](double end_mm) {
    const ArrayField field(probe, settingsFor(probe), end_mm);
    double sum = 0, spread = 0;
    for (int x = -60; x <= 60; ++x) {
      double top = 0;
      for (const auto& value : field.echo({x * 0.05, 0, 35}, 35)) top = std::max(top, std::norm(value));
      sum += top, spread += top * x * x;
    }
    return std::sqrt(spread / sum);
  };
  EXPECT_GT(widthWith(1.2), 1.2 * widthWith(probe.width_mm / 2));
}

}  // namespace
}  // namespace insonate::bench
