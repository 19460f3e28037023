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
  int version;            ///< of the definition: grows whenever a value could come out otherwise
  std::string_view unit;  ///< "", "s", "mm", "%", "deg", "N"
  Better better;
  std::string_view definition;  ///< what is counted, with its thresholds
  std::string_view evidence;    ///< who showed that it tells something, or where it comes from
};

std::span<const MetricDefinition, kMetricCount> metricTable();
inline const MetricDefinition& definitionOf(Metric metric) {
  return metricTable()[static_cast<std::size_t>(metric)];
}

/// One value each; what an attempt does not tell is missing, not 0.
struct MetricValues {
  std::array<std::optional<double>, kMetricCount> values;

  std::optional<double> operator[](Metric metric) const { return values[static_cast<int>(metric)]; }
  std::optional<double>& operator[](Metric metric) { return values[static_cast<int>(metric)]; }
  bool operator==(const MetricValues&) const = default;
};

/// Place of the needle, with the color that the thesis gives it: none, none, green, red, yellow.
enum class NeedlePlace {
  Clean,     ///< new, and not in the skin
  Underway,  ///< under the skin
  Vein,
  WrongPlace,  ///< in an artery, another vein, lung or airway, behind the vein's back wall, on bone
  Used,        ///< out of the skin, until it is replaced
};

/// One pass over the samples and events of an attempt, in the order of its recording. Live and replayed, the same
/// stream gives the same values, to the last bit.
class AttemptMetrics {
 public:
  /// `hasTarget`: only vessel 1 of the events is the vein; else each vein is.
  explicit AttemptMetrics(const PictureField& picture, bool hasTarget = false);
  ~AttemptMetrics();
  AttemptMetrics(AttemptMetrics&&) noexcept;
  AttemptMetrics& operator=(AttemptMetrics&&) noexcept;

  void take(const AttemptSample& sample);
  void take(const AttemptEvent& event);
  /// Values at present; one of them, for callers that ask at each sample.
  MetricValues values() const;
  std::optional<double> value(Metric metric) const;
  NeedlePlace needle() const;
  /// Time since which the syringe has drawn venous blood with the tip in one place, as tip_in_vein counts it. None
  /// while it does not.
  std::optional<std::int64_t> drawingBlood_us() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace insonate
