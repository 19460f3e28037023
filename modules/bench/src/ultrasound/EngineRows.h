#pragma once

#include "ultrasound/FrameTimer.h"

#include <insonate/bench/UltrasoundBench.h>

#include <span>

namespace insonate::bench {

/// Measures times and errors of every engine over the plan's settings.
class EngineRows {
 public:
  /// The scene must cover the path. Fails if the setup is out of range.
  static Result<EngineRows> make(const UltrasoundBenchPlan& plan, const AcousticScene& scene,
                                 std::span<const Transform> path);

  /// Settings to measure, the plan's own first.
  const std::vector<ImagingSettings>& settings() const { return settings_; }
  /// Appends the rows of one of these settings: every engine, with one thread and, if the engine uses several, with
  /// all.
  Result<void> measure(const ImagingSettings& settings, std::vector<UltrasoundBenchRow>& rows) const {
    return measure(settings, {}, rows);
  }
  /// Measures the plan's own settings with compressed tissue (measureDisplaced) and with a needle in the plane
  /// (measureNeedle).
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
