#pragma once

#include "ultrasound/FrameTimer.h"

#include <insonate/bench/UltrasoundBench.h>

#include <span>

namespace insonate::bench {

/// Measures times and errors of every ultrasound engine, for all settings of a benchmark plan.
class EngineRows {
 public:
  /// Makes the measurement for a probe that moves along `path`, which `scene` must cover. Fails if the plan's setup is
  /// out of range.
  static Result<EngineRows> make(const UltrasoundBenchPlan& plan, const AcousticScene& scene,
                                 std::span<const Transform> path);

  /// Returns the settings to measure; the settings of UltrasoundBenchPlan::setup come first.
  const std::vector<ImagingSettings>& settings() const { return settings_; }
  /// Measures one of settings() with every engine, and appends a row for each measurement to `rows`. Each engine is
  /// measured with one thread and, if it uses several threads, also with all threads.
  Result<void> measure(const ImagingSettings& settings, std::vector<UltrasoundBenchRow>& rows) const {
    return measure(settings, {}, rows);
  }
  /// Measures the settings of UltrasoundBenchPlan::setup with compressed tissue; measureNeedle() measures them with a
  /// needle in the image plane.
  Result<void> measureDisplaced(std::vector<UltrasoundBenchRow>& rows) const;
  Result<void> measureNeedle(std::vector<UltrasoundBenchRow>& rows) const;

 private:
  EngineRows(const UltrasoundBenchPlan& plan, const AcousticScene& scene, std::span<const Transform> path);
  Result<void> measure(const ImagingSettings& settings, const PlaneContents& contents,
                       std::vector<UltrasoundBenchRow>& rows) const;
  Result<void> measureOwn(const PlaneContents& contents, const char* what, std::vector<UltrasoundBenchRow>& rows) const;
  Result<void> renderDenseReference();
  Result<void> addDiscretisation(const ImagingSettings& settings, const PlaneContents& contents,
                                 UltrasoundBenchRow& row) const;

  const UltrasoundBenchPlan* plan_;
  const AcousticScene* scene_;
  std::vector<Transform> path_;
  std::vector<ImagingSettings> settings_;
  ImagingSettings denseSettings_;
  ImagingFrame dense_;
};

}  // namespace insonate::bench
