#pragma once

#include <insonate/procedure/AttemptEvent.h>
#include <insonate/procedure/AttemptHeader.h>
#include <insonate/procedure/AttemptSample.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace insonate {

/// Metrics, in the order of metricTable(). "The vein" is the target (AttemptHeader::vessels). "Access" is the first
/// puncture of the vein in an attempt; a "pass" lasts from a puncture of the skin until the needle is out again.
enum class Metric {
  VeinPunctures,
  ArteryPunctures,
  DoublePunctures,
  TimeToVein,
  UsedNeedleInsertions,
  TimeToAccess,
  AttemptTime,
  Passes,
  Redirections,
  LungPunctures,
  BoneContacts,
  NeedlePath,
  NeedleInefficiency,
  PathDeviation,
  InsertionAngle,
  TipInPicture,
  AspirationWhileAdvancing,
  VeinCentreDistance,
  TipInVein,
  NearestArtery,
  NearestLung,
  ProbePath,
  ProbeTranslations,
  ProbeRotations,
  ProbeForceMean,
  ProbeForceMost,
  OtherVeinPunctures,
  VeinChecks,
};
inline constexpr int kMetricCount = 28;

enum class Better { Lower, Higher, Neither };

struct MetricDefinition {
  Metric metric;
  std::string_view id;    ///< as in files and JSON: "vein_punctures"
  int version;            ///< version of the definition: raised whenever the definition may give another value
  std::string_view unit;  ///< "", "s", "mm", "%", "deg", "N"
  Better better;
  std::string_view definition;  ///< quantity that is counted or measured, with its thresholds
  std::string_view evidence;    ///< study that showed the metric to be meaningful, or origin of the metric
};

std::span<const MetricDefinition, kMetricCount> metricTable();
inline const MetricDefinition& definitionOf(Metric metric) {
  return metricTable()[static_cast<std::size_t>(metric)];
}

/// One value for each metric. A value that does not follow from the attempt is missing, not 0.
struct MetricValues {
  std::array<std::optional<double>, kMetricCount> values;

  std::optional<double> operator[](Metric metric) const { return values[static_cast<int>(metric)]; }
  std::optional<double>& operator[](Metric metric) { return values[static_cast<int>(metric)]; }
  bool operator==(const MetricValues&) const = default;
};

/// Place of the needle. The thesis shows these places in color: no color, no color, green, red, yellow.
enum class NeedlePlace {
  Clean,     ///< new needle that has not been in the skin
  Underway,  ///< under the skin
  Vein,
  WrongPlace,  ///< artery, another vein, lung or airway, behind the posterior wall of the vein, or on bone
  Used,        ///< withdrawn from the skin and not yet replaced
};

/// Computes the metrics while it receives the samples and events of an attempt once, in the order of the recording. The
/// same sequence gives exactly the same values, live and replayed.
class AttemptMetrics {
 public:
  /// `hasTarget`: only vessel 1 of the events is the vein; otherwise each vein is.
  explicit AttemptMetrics(const PictureField& picture, bool hasTarget = false);
  ~AttemptMetrics();
  AttemptMetrics(AttemptMetrics&&) noexcept;
  AttemptMetrics& operator=(AttemptMetrics&&) noexcept;

  void take(const AttemptSample& sample);
  void take(const AttemptEvent& event);
  /// values() returns all present values; value() returns one, for callers that ask at each sample.
  MetricValues values() const;
  std::optional<double> value(Metric metric) const;
  NeedlePlace needle() const;
  /// Time since which the syringe has drawn venous blood with the tip in one place, as tip_in_vein defines it. Empty
  /// while it draws none.
  std::optional<std::int64_t> drawingBlood_us() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace insonate
