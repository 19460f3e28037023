#include "metrics/ScanWork.h"

#include <algorithm>

namespace insonate::metrics {

void ScanWork::addCompression(const AttemptEvent& event) {
  if (event.vessel == 0 || event.vessel == kUnnamedVessel) return;
  compressed_.set(event.vessel);
  if (event.vessel != 1) return;
  ++targetCompressions_;
  for (const Vec3& other_mm : targetAt_mm_) length_mm_ = std::max(length_mm_, norm(event.tip_mm - other_mm));
  targetAt_mm_.push_back(event.tip_mm);
}

void ScanWork::add(const AttemptEvent& event) {
  if (isPunctured_ || !hasTarget_) return;
  switch (event.kind) {
    case AttemptEventKind::Entered:
      isPunctured_ = event.wall == kSkin;
      return;
    case AttemptEventKind::Compressed:
      return addCompression(event);
    case AttemptEventKind::ColorShown:
      if (event.vessel == 1) ++colorChecks_;
      return;
    default:
      return;
  }
}

std::optional<double> ScanWork::value(Metric metric) const {
  if (!hasTarget_) return std::nullopt;
  switch (metric) {
    case Metric::VeinChecks:
      return targetCompressions_;
    case Metric::VeinsSurveyed:
      return static_cast<double>(compressed_.count());
    case Metric::VeinLengthChecked:
      return length_mm_;
    case Metric::ColorChecks:
      return colorChecks_;
    default:
      return std::nullopt;
  }
}

}  // namespace insonate::metrics
