#include "session/NeedleReplay.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/procedure/AttemptScore.h>
#include <insonate/simulator/AttemptCase.h>
#include <insonate/simulator/AttemptSettings.h>
#include <insonate/simulator/EventCheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace insonate {
namespace {

/// Distance from a wall up to which the tip may be on either side of it: the deformation of live imaging differs by
/// less.
constexpr double kBorder_mm = 2;
/// Distance by which a needle pushes a far wall ahead before it punctures it.
constexpr double kMostPushed_mm = 10;
/// A recorded indentation of a wall that the needle has not punctured.
constexpr double kTented_mm = 0.2;
/// A hand that stops short of a puncture performs the same one later, a little deeper.
constexpr std::int64_t kSameTime_us = 1'000'000, kSamePlaceTime_us = 60'000'000;
constexpr double kSamePlace_mm = 4;
constexpr std::size_t kMostDifferences = 20;

/// Recorded distances matter to metrics up to here.
constexpr double kNear_mm = 20, kOtherDistance_mm = 3;
/// Live imaging is late while the probe moves, thus only a lasting difference counts.
constexpr int kLastingSamples = 1000;

int indexOf(Label wall) {
  return static_cast<int>(std::ranges::find(kNeedleWalls, wall) - kNeedleWalls.begin());
}

bool isAtWall(const AttemptEvent& event) {
  return event.kind == AttemptEventKind::Entered || event.kind == AttemptEventKind::Left ||
         event.kind == AttemptEventKind::Struck;
}

std::string textOf_mm(double mm) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.1f mm", mm);
  return text.data();
}

std::string textOf(const AttemptEvent& event, const std::vector<std::string>& vessels) {
  std::string wall = vesselName(event, vessels);
  if (wall.empty()) wall = labelName(event.wall);
  return std::string(nameOf(event.kind)) + ": " + wall;
}

/// An event of the recording, or of the needle that was moved as recorded.
struct WallEvent {
  AttemptEvent event;
  std::string text;
  /// Recorded event: distance of the tip outside the wall at the event, or infinity if there is no such wall. Computed
  /// event: greatest distance beyond the wall until the tip came back.
  double distance_mm = 0;
  bool isTented = false;  ///< computed event: the recording has a wall that is indented, instead of a puncture
  bool isOver = false;    ///< computed event: the tip has come back
  bool isMatched = false;
};

/// Plays a recording to a needle and keeps the events of both.
class Comparison {
 public:
  Comparison(NeedleReplay& needle, const AttemptRecording& recording, std::vector<std::string> vessels)
      : needle_(needle), recording_(recording), vessels_(std::move(vessels)) {}

  Result<void> play(const RecordingSegment& segment) {
    Result<void> played;
    segment.play(std::numeric_limits<std::int64_t>::max(), [&](const RecordingSegment::Entry& entry) {
      if (!played) return;
      if (const auto* sample = std::get_if<AttemptSample>(&entry)) played = add(*sample);
      if (const auto* event = std::get_if<AttemptEvent>(&entry)) add(*event);
    });
    return played;
  }

  std::vector<EventDifference> differences() {
    match();
    for (const WallEvent& one : recorded_)
      if (!one.isMatched && contradicts(one))
        differ(one.event.time_us, one.text,
               std::isfinite(one.distance_mm) ? "none, since the tip is " + textOf_mm(std::abs(one.distance_mm)) +
                                                    (one.distance_mm > 0 ? " outside" : " inside")
                                              : "none, since there is no such structure");
    for (const WallEvent& one : computed_)
      if (!one.isMatched && !one.isTented && one.distance_mm > kBorder_mm) differ(one.event.time_us, "none", one.text);
    std::ranges::stable_sort(differences_, {}, &EventDifference::time_us);
    if (differences_.size() > kMostDifferences) differences_.resize(kMostDifferences);
    return std::move(differences_);
  }

 private:
  struct Distance {
    const char* name;
    int otherSamples = 0;
    bool isReported = false;
  };

  Result<void> add(const AttemptSample& sample) {
    if (auto ok = useSettings(sample.time_us); !ok) return ok;
    const auto events = needle_.move(sample);
    if (!events) return tl::unexpected(events.error());
    const bool isTented = sample.tenting_mm > kTented_mm;
    for (const AttemptEvent& event : *events) {
      const int wall = indexOf(event.wall);
      for (WallEvent& before : computed_)
        if (before.event.wall == event.wall && !isAtWall(event)) before.isOver = true;
      if (isAtWall(event) && wall < kNeedleWallCount)
        computed_.push_back({.event = event, .text = textOf(event, vessels_), .isTented = isTented});
    }
    measure();
    compareDistances(sample);
    return {};
  }

  void add(const AttemptEvent& event) {
    if (!isAtWall(event)) return;
    WallEvent one{.event = event, .text = textOf(event, recording_.header().vessels)};
    const auto& tissue = needle_.atTip();
    const int wall = indexOf(event.wall);
    one.distance_mm = tissue && wall < kNeedleWallCount ? tissue->distance_mm[static_cast<std::size_t>(wall)]
                                                        : std::numeric_limits<double>::infinity();
    recorded_.push_back(std::move(one));
  }

  /// Follows the tip beyond each computed puncture.
  void measure() {
    const auto& tissue = needle_.atTip();
    if (!tissue) return;
    for (WallEvent& one : computed_) {
      if (one.isOver) continue;
      const double outside_mm = tissue->distance_mm[static_cast<std::size_t>(indexOf(one.event.wall))];
      const double beyond_mm = one.event.kind == AttemptEventKind::Left ? outside_mm : -outside_mm;
      one.distance_mm = std::max(one.distance_mm, beyond_mm);
    }
  }

  void compareDistances(const AttemptSample& sample) {
    const auto& tissue = needle_.atTip();
    if (!tissue || !needle_.isInBody() || !sample.needleDepth_mm) return;
    const auto at = [&](Label wall) { return double(tissue->distance_mm[static_cast<std::size_t>(indexOf(wall))]); };
    compare(sample.time_us, toArtery_, sample.toArtery_mm, at(kArtery));
    compare(sample.time_us, toLung_, sample.toLung_mm, at(kAirway));
    compare(sample.time_us, toVeinCenter_, sample.toVeinCenter_mm, needle_.toVeinCenter_mm());
  }

  void compare(std::int64_t time_us, Distance& distance, const std::optional<double>& recorded,
               const std::optional<double>& computed) {
    const double is_mm = recorded.value_or(1e9), expected_mm = computed.value_or(1e9);
    const bool isOther = std::min(is_mm, expected_mm) < kNear_mm && std::abs(is_mm - expected_mm) > kOtherDistance_mm;
    distance.otherSamples = isOther ? distance.otherSamples + 1 : 0;
    if (distance.otherSamples < kLastingSamples || std::exchange(distance.isReported, true)) return;
    differences_.push_back({time_us, distance.name + at(time_us), recorded ? textOf_mm(is_mm) : "unknown",
                            computed ? textOf_mm(expected_mm) : "unknown"});
  }

  Result<void> useSettings(std::int64_t time_us) {
    if (time_us < settingsAt_us_) return {};
    auto text = recording_.settingsAt(time_us);
    if (!text) return tl::unexpected(text.error());
    const auto& changes = recording_.settingsChanges();
    const auto next = std::ranges::upper_bound(changes, time_us, {}, &SettingsChange::time_us);
    settingsAt_us_ = next == changes.end() ? std::numeric_limits<std::int64_t>::max() : next->time_us;
    if (*text == used_) return {};
    const auto settings = parseAttemptSettings(*text);
    if (!settings) return tl::unexpected(settings.error());
    used_ = std::move(*text);
    return needle_.use(*settings);
  }

  /// A computed event belongs to the recorded one of the same kind and wall that is nearest in time.
  void match() {
    for (WallEvent& one : computed_) {
      WallEvent* nearest = nullptr;
      for (WallEvent& other : recorded_)
        if (!other.isMatched && canBeSame(one.event, other.event) &&
            (!nearest || between_us(one, other) < between_us(one, *nearest)))
          nearest = &other;
      if (!nearest) continue;
      one.isMatched = nearest->isMatched = true;
      if (one.text != nearest->text) differ(one.event.time_us, nearest->text, one.text);
    }
  }
  static bool canBeSame(const AttemptEvent& a, const AttemptEvent& b) {
    if (a.kind != b.kind || a.wall != b.wall) return false;
    const std::int64_t between_us = std::abs(a.time_us - b.time_us);
    return between_us <= kSameTime_us ||
           (between_us <= kSamePlaceTime_us && norm(a.tip_mm - b.tip_mm) <= kSamePlace_mm);
  }
  static std::int64_t between_us(const WallEvent& a, const WallEvent& b) {
    return std::abs(a.event.time_us - b.event.time_us);
  }

  /// A wall gives way only to a tip that pushes it.
  static bool contradicts(const WallEvent& recorded) {
    if (recorded.event.kind == AttemptEventKind::Left)
      return recorded.distance_mm < -kBorder_mm || recorded.distance_mm > kMostPushed_mm;
    return recorded.distance_mm > kBorder_mm;
  }

  static std::string at(std::int64_t time_us) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), " at %.1f s", static_cast<double>(time_us) * 1e-6);
    return text.data();
  }
  void differ(std::int64_t time_us, const std::string& recorded, const std::string& expected) {
    differences_.push_back({time_us, "needle event" + at(time_us), recorded, expected});
  }

  NeedleReplay& needle_;
  const AttemptRecording& recording_;
  std::vector<std::string> vessels_;  ///< names of the vessels of computed events
  std::string used_;
  std::int64_t settingsAt_us_ = 0;
  std::vector<WallEvent> recorded_, computed_;
  Distance toArtery_{"distance to the artery"}, toLung_{"distance to the lung"},
      toVeinCenter_{"distance to the middle of the vein"};
  std::vector<EventDifference> differences_;
};

/// Place of the probe, or else of the needle, when the attempt begins; the target of the attempt is near it.
Result<Vec3> beginningOf(const AttemptRecording& recording) {
  for (std::size_t i = 0; i < recording.segmentCount(); ++i) {
    const auto segment = recording.segment(i);
    if (!segment) return tl::unexpected(segment.error());
    for (const QuantizedSample& quantized : segment->samples) {
      const AttemptSample sample = dequantize(quantized);
      if (sample.patientFromProbe) return sample.patientFromProbe->offset;
      if (sample.patientFromNeedle) return sample.patientFromNeedle->offset;
    }
  }
  return Vec3{};
}

/// Number of the recorded target among the case's vessels. In a level, the attempt begins beside another vein.
std::uint8_t targetOf(const AttemptHeader& header, const std::vector<std::string>& vessels) {
  if (header.vessels.empty()) return 1;
  const auto found = std::ranges::find(vessels, header.vessels.front());
  return found == vessels.end() ? 1 : static_cast<std::uint8_t>(found - vessels.begin() + 1);
}

}  // namespace

struct EventCheck::Case {
  Case(std::string of, std::shared_ptr<const PatientCase> its, NeedleReplay replay)
      : hash(std::move(of)), patient(std::move(its)), needle(std::move(replay)) {}

  std::string hash;
  std::shared_ptr<const PatientCase> patient;
  NeedleReplay needle;
};

EventCheck::EventCheck(std::vector<std::filesystem::path> libraries) : libraries_(std::move(libraries)) {}
EventCheck::EventCheck(EventCheck&&) noexcept = default;
EventCheck& EventCheck::operator=(EventCheck&&) noexcept = default;
EventCheck::~EventCheck() = default;

Result<void> EventCheck::take(const AttemptHeader& header, const Progress& progress) {
  if (case_ && case_->hash == header.caseHash) return {};
  case_.reset();
  auto found = caseOfAttempt(header, libraries_, progress);
  if (!found) return tl::unexpected(found.error());
  auto patient = std::make_shared<const PatientCase>(std::move(*found));
  auto needle = NeedleReplay::make(patient, progress);
  if (!needle) return tl::unexpected(needle.error());
  case_ = std::make_unique<Case>(header.caseHash, std::move(patient), std::move(*needle));
  return {};
}

Result<std::vector<EventDifference>> EventCheck::compare(const AttemptRecording& recording, const Progress& progress) {
  const AttemptHeader& header = recording.header();
  if (header.settings.empty()) return fail("The recording has no settings, so that its events cannot be computed.");
  if (header.caseHash.empty()) return fail("The recording does not state its case.");
  const auto procedure = loadProcedure(header.procedure);
  if (!procedure) return tl::unexpected(procedure.error());
  const auto place_mm = beginningOf(recording);
  if (!place_mm) return tl::unexpected(place_mm.error());
  if (auto ok = take(header, progress); !ok) return tl::unexpected(ok.error());
  VesselLocator vessels(case_->patient->manifest, *procedure, *place_mm);
  Comparison comparison(case_->needle, recording, vessels.names());
  const std::uint8_t target = targetOf(header, vessels.names());
  case_->needle.restart(std::move(vessels), target);
  const std::size_t count = recording.segmentCount();
  for (std::size_t i = 0; i < count; ++i) {
    if (!report(progress, "computing needle events", static_cast<double>(i) / static_cast<double>(count)))
      return fail(std::string(kCancelled));
    const auto segment = recording.segment(i);
    if (!segment) return tl::unexpected(segment.error());
    if (auto ok = comparison.play(*segment); !ok) return tl::unexpected(ok.error());
  }
  return comparison.differences();
}

}  // namespace insonate
