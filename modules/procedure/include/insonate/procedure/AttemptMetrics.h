#pragma once

#include <insonate/procedure/AttemptEvent.h>
#include <insonate/procedure/AttemptHeader.h>
#include <insonate/procedure/AttemptSample.h>
#include <insonate/procedure/LineState.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace insonate {

/// Metrics of an attempt. metricTable() defines them, in the same order. "Vein" without "other" means the target vein
/// (AttemptHeader::vessels). "Access" is the first puncture of that vein. A "pass" begins with a puncture of the skin
/// and ends when the needle is out of the skin.
enum class Metric {
  VeinPunctures,
  ArteryPunctures,
  PosteriorWallPunctures,
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
  TipInImage,
  AspirationWhileAdvancing,
  VeinCenterDistance,
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
  // From here on: the line after the puncture. These metrics have values only in attempts that go on after it.
  Preparations,
  OpenHub,
  AirVolume,
  WirePlanes,
  VeinConfirmations,
  UnconfirmedDilations,
  ArteryDilations,
  WireControlLosses,
  WiresLost,
  WireDepth,
  Ectopy,
  DilatorPasses,
  DilatorDepth,
  CatheterToHeart,
  TimeToWire,
  TimeToCatheter,
  LumensFlushed,
  LumensFlushedFirst,
  BloodColorTrusted,
  CatheterInVein,
  WireKinks,
  Tachycardias,
  // The scan before the puncture.
  VeinsSurveyed,
  VeinLengthChecked,
  ColorChecks,
  // Harm beside the vessels.
  Pneumothoraces,
};
inline constexpr int kMetricCount = 54;

/// Tells whether a metric concerns the line after the puncture.
constexpr bool isOfLine(Metric metric) {
  return metric >= Metric::Preparations && metric < Metric::VeinsSurveyed;
}

enum class Better { Lower, Higher, Neither };

struct MetricDefinition {
  Metric metric;
  std::string_view id;    ///< name of the metric in files and JSON: "vein_punctures"
  int version;            ///< version of the definition; the version increases with each change that may give other
                          ///< values
  std::string_view unit;  ///< unit of the values: "", "s", "mm", "%", "deg", "N", "ml"
  Better better;
  std::string_view definition;  ///< description of the counted or measured quantity, with thresholds
  std::string_view evidence;    ///< study that showed the metric to be meaningful, or origin of the metric
};

std::span<const MetricDefinition, kMetricCount> metricTable();
inline const MetricDefinition& definitionOf(Metric metric) {
  return metricTable()[static_cast<std::size_t>(metric)];
}

/// One value for each metric. If the attempt does not determine a metric, its value is empty, not 0.
struct MetricValues {
  std::array<std::optional<double>, kMetricCount> values;

  std::optional<double> operator[](Metric metric) const { return values[static_cast<int>(metric)]; }
  std::optional<double>& operator[](Metric metric) { return values[static_cast<int>(metric)]; }
  bool operator==(const MetricValues&) const = default;
};

/// Place of the needle's tip in the patient. The program draws the needle in the color of the place.
enum class NeedlePlace {
  Clean,      ///< outside the skin; the needle is new and has not punctured the skin
  UnderSkin,  ///< under the skin, but in neither Vein nor WrongPlace
  Vein,
  WrongPlace,  ///< artery, another vein, lung or airway, behind the posterior wall of the vein, or on bone
  Used,        ///< outside the skin; the needle was withdrawn from the skin and is not yet replaced
};

/// Computes the metrics of an attempt from its samples and events, which add() receives in the order of the recording.
/// The same sequence gives exactly the same values, live and replayed.
class AttemptMetrics {
 public:
  /// `imageField`: region that the live image shows. `hasTarget`, true: the target is the vein with
  /// AttemptEvent::vessel 1; false: every vein counts as the target.
  explicit AttemptMetrics(const ImageField& imageField, bool hasTarget = false);
  ~AttemptMetrics();
  AttemptMetrics(AttemptMetrics&&) noexcept;
  AttemptMetrics& operator=(AttemptMetrics&&) noexcept;

  void add(const AttemptSample& sample);
  void add(const AttemptEvent& event);
  /// Returns the values of all metrics so far. value() returns the value of a single metric, for callers that need it
  /// at each sample.
  MetricValues values() const;
  std::optional<double> value(Metric metric) const;
  /// Returns the present place of the needle's tip.
  NeedlePlace needle() const;
  /// Returns the present state of the instruments of the line.
  const LineState& line() const;
  /// Returns the time since the recording began at which the syringe began to aspirate blood with the tip at one place
  /// in the target vein (see the definition of the metric tip_in_vein). Empty while the syringe aspirates no such
  /// blood.
  std::optional<std::int64_t> aspiratingBloodSince_us() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace insonate
