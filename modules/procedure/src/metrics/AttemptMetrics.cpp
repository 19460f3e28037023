#include "metrics/LineWork.h"
#include "metrics/NeedleWork.h"
#include "metrics/ProbeWork.h"
#include "metrics/Punctures.h"
#include "metrics/ScanWork.h"

#include <insonate/procedure/AttemptMetrics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

/// Distance from the hole outside the skin from which the needle counts as withdrawn; nearer, it trembles in the hole.
constexpr double kOut_mm = 2;
/// Duration of aspirated blood, and maximum motion of the tip meanwhile, that show that the tip stands in the vein
/// instead of passing it.
constexpr std::int64_t kDrawn_us = 1'000'000;
constexpr double kDrawn_mm = 1;
/// Distance from a contact at which the bone counts as left.
constexpr double kOffBone_mm = 1;
/// Maximum motion during this time for the tip to count as at rest.
constexpr double kRest_mm = 0.5;
constexpr std::int64_t kRest_us = 500'000;
constexpr double kDegrees = 180 / std::numbers::pi;

/// The share of a time in which the image shows the tip.
class TipSight {
 public:
  /// Adds a sample; the time since the previous sample counts if both samples count.
  void follow(std::int64_t time_us, bool counts, bool isShown) {
    if (counts && last_us_) {
      all_us_ += time_us - *last_us_;
      if (isShown) shown_us_ += time_us - *last_us_;
    }
    last_us_ = counts ? std::optional(time_us) : std::nullopt;
  }
  std::optional<double> percent() const {
    if (all_us_ == 0) return std::nullopt;
    return 100 * static_cast<double>(shown_us_) / static_cast<double>(all_us_);
  }

 private:
  std::optional<std::int64_t> last_us_;
  std::int64_t all_us_ = 0, shown_us_ = 0;
};

void keepMinimum(std::optional<double>& least, const std::optional<double>& value) {
  if (value) least = least ? std::min(*least, *value) : *value;
}

std::optional<double> secondsBetween(const std::optional<std::int64_t>& from_us,
                                     const std::optional<std::int64_t>& to_us) {
  if (!from_us || !to_us) return std::nullopt;
  return static_cast<double>(*to_us - *from_us) * 1e-6;
}

}  // namespace

struct AttemptMetrics::State {
  State(const ImageField& field, bool named) : picture(field), hasTarget(named), line(named), scan(named) {}

  void followNeedle(const AttemptSample& sample);
  void watchTip(const AttemptSample& sample);
  void cross(const AttemptEvent& event);
  void crossSkin(const AttemptEvent& event);
  void beginPass(const AttemptEvent& event);
  void endPass();
  void strike(const AttemptEvent& event);
  void followRest(const AttemptSample& sample);
  void drawBlood(const AttemptSample& sample);
  metrics::Punctures* structure(const AttemptEvent& event);
  std::optional<double> probeValue(Metric metric) const;
  std::array<metrics::Punctures*, 4> structures() { return {&vein, &otherVein, &artery, &lung}; }

  ImageField picture;
  bool hasTarget = false;
  metrics::Punctures vein, otherVein, artery, lung;
  metrics::NeedleWork needle;
  metrics::ProbeWork probe;
  metrics::LineWork line;
  metrics::ScanWork scan;
  TipSight sight;

  std::optional<std::int64_t> first_us, last_us;
  std::optional<std::int64_t> firstSkin_us, passSkin_us, access_us;
  std::optional<double> timeToVein_s;
  int passes = 0, usedInsertions = 0, boneContacts = 0, pneumothoraces = 0;
  bool inPass = false, used = false, frozen = false;
  struct Drawing {
    std::int64_t since_us = 0;
    Vec3 tip_mm;
  };
  std::optional<Drawing> drawing;  ///< aspirated blood, with the tip at one place of the vein
  bool drawn = false;              ///< blood of the vein was aspirated, and the tip has only been withdrawn since
  std::optional<Vec3> out_mm;      ///< where the tip left the skin, until it is clear of the hole
  std::optional<Vec3> rest_mm;     ///< the place that the tip in the vein has not left
  std::int64_t rest_us = 0;        ///< since this time
  bool rested = false;             ///< for long enough
  std::optional<Vec3> bone_mm;     ///< the contact with bone, until the tip is clear of it
  std::optional<double> angle_deg, nearestArtery_mm, nearestLung_mm, veinCenter_mm;
};

metrics::Punctures* AttemptMetrics::State::structure(const AttemptEvent& event) {
  const Label wall = event.wall;
  if (wall == kVein) return !hasTarget || event.vessel == 1 ? &vein : &otherVein;
  return wall == kArtery ? &artery : wall == kAirway ? &lung : nullptr;
}

void AttemptMetrics::State::watchTip(const AttemptSample& sample) {
  const bool counts = inPass && !access_us && !frozen && sample.patientFromNeedle && sample.needleDepth_mm > 0.0;
  const bool isLive = sample.patientFromProbe && sample.imageDepth_mm > 0;
  sight.follow(sample.time_us, counts,
               counts && isLive &&
                   isTipInView(picture, sample.imageDepth_mm,
                               inverted(*sample.patientFromProbe) * sample.patientFromNeedle->offset));
}

void AttemptMetrics::State::followNeedle(const AttemptSample& sample) {
  const Vec3 tip_mm = sample.patientFromNeedle->offset;
  if (bone_mm && norm(tip_mm - *bone_mm) > kOffBone_mm) bone_mm.reset();
  if (out_mm && norm(tip_mm - *out_mm) > kOut_mm) endPass();
  if (!inPass || !sample.needleDepth_mm) return;
  const double depth_mm = *sample.needleDepth_mm;
  for (metrics::Punctures* each : structures()) each->follow(depth_mm);
  needle.follow(tip_mm, depth_mm, sample.aspirating);
  keepMinimum(nearestArtery_mm, sample.toArtery_mm);
  keepMinimum(nearestLung_mm, sample.toLung_mm);
  followRest(sample);
  drawBlood(sample);
}

/// Only the place of the resting tip counts: during withdrawal the tip passes the wall once more.
void AttemptMetrics::State::followRest(const AttemptSample& sample) {
  if (!vein.inside()) return rest_mm.reset();
  const Vec3 tip_mm = sample.patientFromNeedle->offset;
  if (!rest_mm || norm(tip_mm - *rest_mm) > kRest_mm) rest_mm = tip_mm, rest_us = sample.time_us, rested = false;
  const bool rests = sample.time_us - rest_us >= kRest_us;
  if (!veinCenter_mm || (rests && !rested)) veinCenter_mm = sample.toVeinCenter_mm;
  rested = rests;
}

void AttemptMetrics::State::drawBlood(const AttemptSample& sample) {
  if (!sample.aspirating || !vein.inside()) return drawing.reset();
  const Vec3 tip_mm = sample.patientFromNeedle->offset;
  if (!drawing || norm(tip_mm - drawing->tip_mm) > kDrawn_mm) drawing = {sample.time_us, tip_mm};
  drawn |= sample.time_us - drawing->since_us >= kDrawn_us;
}

void AttemptMetrics::State::beginPass(const AttemptEvent& event) {
  inPass = true;
  drawn = false, drawing.reset();
  ++passes;
  if (used) ++usedInsertions;
  passSkin_us = event.time_us;
  if (!firstSkin_us) firstSkin_us = event.time_us;
  for (metrics::Punctures* each : structures()) each->beginPass();
  needle.beginPass(event.tip_mm);
  if (access_us) return;
  angle_deg.reset();
  if (event.outward) angle_deg = std::asin(std::clamp(-dot(event.axis, *event.outward), -1.0, 1.0)) * kDegrees;
}

void AttemptMetrics::State::endPass() {
  inPass = false, used = true;
  out_mm.reset();
}

void AttemptMetrics::State::crossSkin(const AttemptEvent& event) {
  if (event.kind == AttemptEventKind::Entered) {
    if (!inPass) beginPass(event);
    out_mm.reset();
  } else if (inPass) {
    out_mm = event.tip_mm;
    needle.endPass(event.tip_mm);
    for (metrics::Punctures* each : structures()) each->withdraw(false);
  }
}

void AttemptMetrics::State::cross(const AttemptEvent& event) {
  if (event.wall == kSkin) return crossSkin(event);
  if (event.kind != AttemptEventKind::Withdrawn) drawn = false;
  metrics::Punctures* crossed = structure(event);
  if (!crossed || !inPass) return;
  if (event.kind == AttemptEventKind::Left) return crossed->leave(event.depth_mm);
  if (event.kind == AttemptEventKind::Withdrawn) return crossed->withdraw(event.into == event.wall);
  if (!crossed->enter(event.depth_mm) || crossed != &vein || access_us) return;
  access_us = event.time_us;
  timeToVein_s = secondsBetween(passSkin_us, access_us);
  needle.endAtVein(event.tip_mm);
}

void AttemptMetrics::State::strike(const AttemptEvent& event) {
  if (!bone_mm) ++boneContacts;
  drawn = false;
  bone_mm = event.tip_mm;
}

AttemptMetrics::AttemptMetrics(const ImageField& imageField, bool hasTarget)
    : state_(std::make_unique<State>(imageField, hasTarget)) {}
AttemptMetrics::~AttemptMetrics() = default;
AttemptMetrics::AttemptMetrics(AttemptMetrics&&) noexcept = default;
AttemptMetrics& AttemptMetrics::operator=(AttemptMetrics&&) noexcept = default;

void AttemptMetrics::add(const AttemptSample& sample) {
  State& s = *state_;
  if (!s.first_us) s.first_us = sample.time_us;
  s.last_us = sample.time_us;
  s.probe.follow(sample.time_us, sample.patientFromProbe, sample.probeForce_N, s.firstSkin_us && !s.access_us);
  if (sample.patientFromNeedle) s.followNeedle(sample);
  s.watchTip(sample);
  s.line.follow(sample, s.vein.inside());
}

void AttemptMetrics::add(const AttemptEvent& event) {
  State& s = *state_;
  s.line.add(event);
  s.scan.add(event);
  switch (event.kind) {
    case AttemptEventKind::Entered:
    case AttemptEventKind::Left:
    case AttemptEventKind::Withdrawn:
      return s.cross(event);
    case AttemptEventKind::Struck:
      return s.strike(event);
    case AttemptEventKind::Pneumothorax:
      ++s.pneumothoraces;
      return;
    case AttemptEventKind::NeedleReplaced:
      if (s.inPass && s.out_mm) s.endPass();
      if (!s.inPass) s.used = false;
      return;
    case AttemptEventKind::Frozen:
    case AttemptEventKind::Released:
      s.frozen = event.kind == AttemptEventKind::Frozen;
      return;
    default:
      return;
  }
}

NeedlePlace AttemptMetrics::needle() const {
  const State& s = *state_;
  if (!s.inPass || s.out_mm) return s.inPass || s.used ? NeedlePlace::Used : NeedlePlace::Clean;
  if (s.artery.inside() || s.otherVein.inside() || s.lung.inside() || s.vein.beyond() || s.bone_mm)
    return NeedlePlace::WrongPlace;
  return s.vein.inside() ? NeedlePlace::Vein : NeedlePlace::UnderSkin;
}

const LineState& AttemptMetrics::line() const {
  return state_->line.state();
}

std::optional<std::int64_t> AttemptMetrics::aspiratingBloodSince_us() const {
  return state_->drawing ? std::optional(state_->drawing->since_us) : std::nullopt;
}

std::optional<double> AttemptMetrics::State::probeValue(Metric metric) const {
  switch (metric) {
    case Metric::ProbePath:
      return probe.path_mm();
    case Metric::ProbeTranslations:
      return probe.translations();
    case Metric::ProbeRotations:
      return probe.rotations();
    case Metric::ProbeForceMean:
      return probe.forceMean_N();
    case Metric::ProbeForceMost:
      return probe.forceMax_N();
    default:
      return std::nullopt;
  }
}

std::optional<double> AttemptMetrics::value(Metric metric) const {
  const State& s = *state_;
  const auto given = [](bool known, double value) { return known ? std::optional(value) : std::nullopt; };
  const bool pierced = s.passes > 0;
  switch (metric) {
    case Metric::VeinPunctures:
      return s.vein.count();
    case Metric::ArteryPunctures:
      return s.artery.count();
    case Metric::PosteriorWallPunctures:
      return s.vein.through();
    case Metric::TimeToVein:
      return s.timeToVein_s;
    case Metric::UsedNeedleInsertions:
      return s.usedInsertions;
    case Metric::TimeToAccess:
      return secondsBetween(s.firstSkin_us, s.access_us);
    case Metric::AttemptTime:
      return secondsBetween(s.first_us, s.last_us);
    case Metric::Passes:
      return s.passes;
    case Metric::Redirections:
      return s.needle.redirections();
    case Metric::LungPunctures:
      return s.lung.count();
    case Metric::BoneContacts:
      return s.boneContacts;
    case Metric::NeedlePath:
      return given(pierced, s.needle.path_mm());
    case Metric::NeedleInefficiency:
      return s.needle.inefficiency_percent();
    case Metric::PathDeviation:
      return s.needle.deviation_mm();
    case Metric::InsertionAngle:
      return s.angle_deg;
    case Metric::TipInImage:
      return s.picture.sliceHalf_mm > 0 ? s.sight.percent() : std::nullopt;
    case Metric::AspirationWhileAdvancing:
      return s.needle.aspirating_percent();
    case Metric::VeinCenterDistance:
      return s.veinCenter_mm;
    case Metric::TipInVein:
      return given(pierced, s.vein.inside() || s.drawn ? 1 : 0);
    case Metric::NearestArtery:
      return s.nearestArtery_mm;
    case Metric::NearestLung:
      return s.nearestLung_mm;
    case Metric::Pneumothoraces:
      return s.pneumothoraces;
    case Metric::OtherVeinPunctures:
      return s.otherVein.count();
    default:
      break;
  }
  if (const auto ofProbe = s.probeValue(metric)) return ofProbe;
  const auto ofScan = s.scan.value(metric);
  return ofScan ? ofScan : s.line.value(metric);
}

MetricValues AttemptMetrics::values() const {
  MetricValues all;
  for (const MetricDefinition& one : metricTable()) all[one.metric] = value(one.metric);
  return all;
}

}  // namespace insonate
