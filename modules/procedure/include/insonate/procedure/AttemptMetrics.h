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

/// Metrics of an attempt, in the order of metricTable(), which defines them. "Vein" alone means the target vein
/// (AttemptHeader::vessels). "Access" is the first puncture of that vein; a "pass" lasts from a puncture of the skin
/// until the needle is out again.
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
  std::string_view id;    ///< name of the metric in files and JSON: "vein_punctures"
  int version;            ///< version of the definition: raised with each change that may give other values
  std::string_view unit;  ///< unit of the values: "", "s", "mm", "%", "deg", "N"
  Better better;
  std::string_view definition;  ///< text that says what is counted or measured, with thresholds
  std::string_view evidence;    ///< study that showed the metric to be meaningful, or origin of the metric
};

std::span<const MetricDefinition, kMetricCount> metricTable();
inline const MetricDefinition& definitionOf(Metric metric) {
  return metricTable()[static_cast<std::size_t>(metric)];
}

/// One value for each metric. A value that the attempt does not determine is missing, not 0.
struct MetricValues {
  std::array<std::optional<double>, kMetricCount> values;

  std::optional<double> operator[](Metric metric) const { return values[static_cast<int>(metric)]; }
  std::optional<double>& operator[](Metric metric) { return values[static_cast<int>(metric)]; }
  bool operator==(const MetricValues&) const = default;
};

/// Place of the needle's tip. The thesis colors the needle by place, in this order: no color, no color, green, red,
/// yellow.
enum class NeedlePlace {
  Clean,     ///< new needle that has not been in the skin
  Underway,  ///< under the skin, but neither Vein nor WrongPlace
  Vein,
  WrongPlace,  ///< artery, another vein, lung or airway, behind the posterior wall of the vein, or on bone
  Used,        ///< withdrawn from the skin and not yet replaced
};

/// Computes the metrics of an attempt from its samples and events, passed once in the order of the recording. The same
/// sequence gives exactly the same values, live and replayed.
class AttemptMetrics {
 public:
  /// `hasTarget`: the target is the vein with AttemptEvent::vessel 1; otherwise each vein counts as the target.
  explicit AttemptMetrics(const ImageField& picture, bool hasTarget = false);
  ~AttemptMetrics();
  AttemptMetrics(AttemptMetrics&&) noexcept;
  AttemptMetrics& operator=(AttemptMetrics&&) noexcept;

  void take(const AttemptSample& sample);
  void take(const AttemptEvent& event);
  /// Returns all values so far; value() returns a single one, for callers that ask at each sample.
  MetricValues values() const;
  std::optional<double> value(Metric metric) const;
  NeedlePlace needle() const;
  /// Returns the time of the recording since which the syringe has aspirated venous blood with the tip in one place
  /// (see the definition of the metric tip_in_vein). Empty while no blood is aspirated.
  std::optional<std::int64_t> aspiratingBloodSince_us() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace insonate
