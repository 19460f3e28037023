#pragma once

#include <insonate/procedure/AttemptEvent.h>
#include <insonate/procedure/AttemptMetrics.h>

#include <bitset>
#include <optional>
#include <vector>

namespace insonate::metrics {

/// Computes the metrics of the scan before the first puncture of the skin. The definitions are in MetricTable.cpp.
class ScanWork {
 public:
  explicit ScanWork(bool hasTarget) : hasTarget_(hasTarget) {}

  void add(const AttemptEvent& event);
  /// Returns the value of a metric of the scan. Empty if the case has no target.
  std::optional<double> value(Metric metric) const;

 private:
  void addCompression(const AttemptEvent& event);

  bool hasTarget_;
  bool isPunctured_ = false;  ///< the skin was punctured, so that the scan is over
  int targetCompressions_ = 0, colorChecks_ = 0;
  std::bitset<256> compressed_;    ///< numbers of the veins that were compressed: AttemptEvent::vessel
  std::vector<Vec3> targetAt_mm_;  ///< places at which the target was compressed
  double length_mm_ = 0;
};

}  // namespace insonate::metrics
