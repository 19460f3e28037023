#pragma once

#include <insonate/haptics/SimulatedHand.h>
#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/tissue/NeedleTable.h>

#include <gtest/gtest.h>

#include <array>
#include <optional>

namespace insonate::test {

/// A wall bends before it gives: the tip is as many mm beyond the wall, along the needle, when it is punctured. That is
/// where k1 d + k2 d^2, going on straight at the steepest that the hand's device can show, reaches the wall's force.
inline double bend_mm(Label label) {
  const NeedleTissue wall = loadNeedleTable(needlePresetNames().front())->of(label);
  const double steepest = 0.6 * deviceProfiles().front().limits.maxStiffness_Npmm;
  const double straightFrom_mm = (steepest - wall.stiffness_Npmm) / (2 * wall.stiffening_Npmm2);
  const double there_N = (wall.stiffness_Npmm + wall.stiffening_Npmm2 * straightFrom_mm) * straightFrom_mm;
  return straightFrom_mm + (wall.puncture_N - there_N) / steepest;
}

/// A value and how far off it may be; none: missing.
struct MetricByHand {
  std::optional<double> is;
  double within = 1e-9;
};
inline const MetricByHand kMissing{};

/// In the order of Metric, up to Metric::ProbeForceMost: no other vein is punctured, the scan is counted apart, and
/// there is no line.
using AllByHand = std::array<MetricByHand, static_cast<std::size_t>(Metric::OtherVeinPunctures)>;

/// A lung that is punctured beside the trachea detaches; gas in the middle is the trachea.
struct CountsByHand {
  double veinChecks = 0;
  double pneumothoraces = 0;
};

inline void expectMetrics(const MetricValues& metrics, const AllByHand& byHand, const CountsByHand& counts = {}) {
  for (const MetricDefinition& metric : metricTable()) {
    SCOPED_TRACE(metric.id);
    if (metric.metric == Metric::OtherVeinPunctures || metric.metric == Metric::VeinChecks) {
      EXPECT_EQ(metrics[metric.metric], metric.metric == Metric::VeinChecks ? counts.veinChecks : 0);
      continue;
    }
    if (metric.metric == Metric::Pneumothoraces) {
      EXPECT_EQ(metrics[metric.metric], counts.pneumothoraces);
      continue;
    }
    // One vein is compressed at one place, without color.
    if (metric.metric >= Metric::VeinsSurveyed) {
      EXPECT_EQ(metrics[metric.metric], metric.metric == Metric::VeinsSurveyed && counts.veinChecks > 0 ? 1 : 0);
      continue;
    }
    if (metric.metric >= Metric::Preparations) {
      EXPECT_EQ(metrics[metric.metric], std::nullopt);
      continue;
    }
    const MetricByHand& expected = byHand[static_cast<std::size_t>(metric.metric)];
    const auto value = metrics[metric.metric];
    EXPECT_EQ(value.has_value(), expected.is.has_value());
    if (!value || !expected.is) continue;
    EXPECT_NEAR(*value, *expected.is, expected.within);
  }
}

}  // namespace insonate::test
