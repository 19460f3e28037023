#pragma once

#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/procedure/LineState.h>

#include <cstdint>
#include <optional>

namespace insonate::metrics {

/// Computes the metrics of everything after the puncture: open hub, wire, dilator and catheter. The definitions are in
/// MetricTable.cpp.
class LineWork {
 public:
  explicit LineWork(bool hasTarget) : hasTarget_(hasTarget) {}

  /// Adds a sample. `isTipInVein`: the needle's tip is in the target vein.
  void follow(const AttemptSample& sample, bool isTipInVein);
  void add(const AttemptEvent& event);

  const LineState& state() const { return state_; }
  /// Returns the value of a metric of the line. Empty if the attempt does not determine it.
  std::optional<double> value(Metric metric) const;

 private:
  bool isTarget(const AttemptEvent& event) const { return event.into == kVein && (!hasTarget_ || event.vessel == 1); }
  void enter(const AttemptEvent& event);
  void dilate(const AttemptEvent& event);
  void perform(const AttemptEvent& event);
  void watchWire(const LineState& before);
  int preparations() const;
  int planesSeen() const;

  bool hasTarget_;
  LineState state_;
  bool isBegun_ = false;  ///< the syringe was taken off, or an instrument followed the needle
  std::optional<std::int64_t> last_us_, skin_us_, access_us_, wire_us_, catheter_us_;
  std::int64_t openHub_us_ = 0, ectopy_us_ = 0;
  double air_ml_ = 0, wireMax_mm_ = 0, dilatorMax_mm_ = 0;
  std::optional<double> catheterToHeart_mm_;
  int confirmations_ = 0;  ///< bits: short axis, long axis, pressure, bubbles
  std::optional<int> planesAtDilation_, confirmationsAtDilation_;
  int unconfirmedDilations_ = 0, wrongDilations_ = 0, dilatorPasses_ = 0;
  int wireKinks_ = 0, tachycardias_ = 0;
  int controlLosses_ = 0, wiresLost_ = 0, colorTrusted_ = 0, flushedFirst_ = 0;
  int preparationsAtSkin_ = 0;
  bool isSlipping_ = false;  ///< the present motion over a wire that is not held is already counted
};

}  // namespace insonate::metrics
