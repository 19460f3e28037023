#include "metrics/LineWork.h"

#include <algorithm>
#include <array>
#include <bit>

namespace insonate::metrics {
namespace {

/// Bits of LineWork::confirmations_.
enum Confirmation : int { kShortAxis = 1, kLongAxis = 2, kPressure = 4, kBubbles = 8 };

/// The acts before the puncture that the metric `preparations` counts.
constexpr std::array kPreparations{LineAct::CheckConsent, LineAct::TimeOut, LineAct::CoverProbe, LineAct::Anesthetize};

std::optional<double> secondsBetween(const std::optional<std::int64_t>& from_us,
                                     const std::optional<std::int64_t>& to_us) {
  if (!from_us || !to_us) return std::nullopt;
  return static_cast<double>(*to_us - *from_us) * 1e-6;
}

}  // namespace

void LineWork::follow(const AttemptSample& sample, bool isTipInVein) {
  const LineState before = state_;
  insonate::follow(state_, sample);
  const std::int64_t since_us = last_us_ ? sample.time_us - *last_us_ : 0;
  last_us_ = sample.time_us;
  if (isTipInVein && !access_us_) access_us_ = sample.time_us;
  if (isTipInVein && state_.isHubOpen()) openHub_us_ += since_us;
  if (state_.isWireIn() && sample.wireToHeart_mm && *sample.wireToHeart_mm < 0) ectopy_us_ += since_us;
  wireMax_mm_ = std::max(wireMax_mm_, state_.wire_mm), dilatorMax_mm_ = std::max(dilatorMax_mm_, state_.dilator_mm);
  catheterToHeart_mm_ = sample.catheterToHeart_mm;
  if (state_.isWireIn() || state_.catheter_mm > 0) isBegun_ = true;
  if (before.dilator_mm == 0 && state_.dilator_mm > 0) ++dilatorPasses_;
  watchWire(before);
}

/// An instrument that moves over a wire that is not held takes the wire along.
void LineWork::watchWire(const LineState& before) {
  const bool isMoved = state_.dilator_mm != before.dilator_mm || state_.catheter_mm != before.catheter_mm ||
                       (before.isNeedleInBody && !state_.isNeedleInBody);
  if (state_.isWireHeld || !state_.isWireIn()) {
    isSlipping_ = false;
  } else if (isMoved && !isSlipping_) {
    isSlipping_ = true, ++controlLosses_;
  }
}

void LineWork::dilate(const AttemptEvent& event) {
  if (event.into == kArtery) ++wrongDilations_;
  if (event.into != kVein && event.into != kArtery) return;
  if (planesSeen() < 2) ++unconfirmedDilations_;
  if (planesAtDilation_) return;
  planesAtDilation_ = planesSeen();
  confirmationsAtDilation_ = std::popcount(static_cast<unsigned>(confirmations_));
}

void LineWork::enter(const AttemptEvent& event) {
  isBegun_ = true;
  if (event.instrument == Instrument::Dilator) return dilate(event);
  if (event.instrument == Instrument::Wire && isTarget(event) && !wire_us_) wire_us_ = event.time_us;
  if (event.instrument == Instrument::Catheter && isTarget(event) && !catheter_us_) catheter_us_ = event.time_us;
}

void LineWork::perform(const AttemptEvent& event) {
  const bool isTarget = event.wall == kVein && (!hasTarget_ || event.vessel == 1);
  if (event.act == LineAct::DetachSyringe && access_us_) isBegun_ = true;
  if (event.act == LineAct::MeasurePressure && isTarget) confirmations_ |= kPressure;
  if (event.act == LineAct::TrustBloodColor) ++colorTrusted_;
  if (event.act != LineAct::FlushLumen) return;
  const auto lumen = static_cast<std::size_t>(std::clamp(event.amount, 1.0, double{kCatheterLumens})) - 1;
  if (!state_.isAspirated[lumen]) ++flushedFirst_;
}

void LineWork::add(const AttemptEvent& event) {
  if (event.kind == AttemptEventKind::Performed) perform(event);
  insonate::follow(state_, event, hasTarget_);
  switch (event.kind) {
    case AttemptEventKind::Entered:
      if (event.wall == kSkin && !skin_us_) skin_us_ = event.time_us, preparationsAtSkin_ = preparations();
      return;
    case AttemptEventKind::WireInShortAxis:
    case AttemptEventKind::WireInLongAxis:
      if (state_.isWireSeenInShortAxis) confirmations_ |= kShortAxis;
      if (state_.isWireSeenInLongAxis) confirmations_ |= kLongAxis;
      return;
    case AttemptEventKind::BubblesSeen:
      if (isTarget(event)) confirmations_ |= kBubbles;
      return;
    case AttemptEventKind::InstrumentEntered:
      return enter(event);
    case AttemptEventKind::InstrumentRemoved:
      if (event.instrument == Instrument::Wire) confirmations_ &= ~(kShortAxis | kLongAxis);
      return;
    case AttemptEventKind::WireLost:
      ++wiresLost_;
      return;
    case AttemptEventKind::WireKinked:
      ++wireKinks_;
      return;
    case AttemptEventKind::Tachycardia:
      ++tachycardias_;
      return;
    case AttemptEventKind::AirEntered:
      air_ml_ += event.amount;
      return;
    default:
      return;
  }
}

int LineWork::preparations() const {
  return static_cast<int>(std::ranges::count_if(kPreparations, [&](LineAct act) { return state_.count(act) > 0; }));
}

int LineWork::planesSeen() const {
  return (confirmations_ & kShortAxis ? 1 : 0) + (confirmations_ & kLongAxis ? 1 : 0);
}

std::optional<double> LineWork::value(Metric metric) const {
  const auto given = [](bool isKnown, double value) { return isKnown ? std::optional(value) : std::nullopt; };
  const auto seconds = [](std::int64_t us) { return static_cast<double>(us) * 1e-6; };
  const bool isIn = catheter_us_ && state_.catheterIn == kVein && state_.catheter_mm > 0 && !state_.isWireIn();
  switch (metric) {
    case Metric::Preparations:
      return given(isBegun_ && skin_us_, preparationsAtSkin_);
    case Metric::OpenHub:
      return given(isBegun_, seconds(openHub_us_));
    case Metric::AirVolume:
      return given(isBegun_, air_ml_);
    case Metric::WirePlanes:
      return given(isBegun_, planesAtDilation_.value_or(planesSeen()));
    case Metric::VeinConfirmations:
      return given(isBegun_, confirmationsAtDilation_.value_or(std::popcount(static_cast<unsigned>(confirmations_))));
    case Metric::UnconfirmedDilations:
      return given(isBegun_, unconfirmedDilations_);
    case Metric::ArteryDilations:
      return given(isBegun_, wrongDilations_);
    case Metric::WireControlLosses:
      return given(isBegun_, controlLosses_);
    case Metric::WiresLost:
      return given(isBegun_, wiresLost_);
    case Metric::WireDepth:
      return given(wireMax_mm_ > 0, wireMax_mm_);
    case Metric::Ectopy:
      return given(wireMax_mm_ > 0, seconds(ectopy_us_));
    case Metric::DilatorPasses:
      return given(isBegun_, dilatorPasses_);
    case Metric::DilatorDepth:
      return given(dilatorMax_mm_ > 0, dilatorMax_mm_);
    case Metric::CatheterToHeart:
      return isIn ? catheterToHeart_mm_ : std::nullopt;
    case Metric::TimeToWire:
      return secondsBetween(access_us_, wire_us_);
    case Metric::TimeToCatheter:
      return secondsBetween(skin_us_, catheter_us_);
    case Metric::LumensFlushed:
      return given(isBegun_, static_cast<double>(std::ranges::count(state_.isFlushed, true)));
    case Metric::LumensFlushedFirst:
      return given(isBegun_, flushedFirst_);
    case Metric::BloodColorTrusted:
      return given(isBegun_, colorTrusted_);
    case Metric::CatheterInVein:
      return given(isBegun_, isIn && (!hasTarget_ || state_.catheterVessel == 1) ? 1 : 0);
    case Metric::WireKinks:
      return given(isBegun_, wireKinks_);
    case Metric::Tachycardias:
      return given(wireMax_mm_ > 0, tachycardias_);
    default:
      return std::nullopt;
  }
}

}  // namespace insonate::metrics
