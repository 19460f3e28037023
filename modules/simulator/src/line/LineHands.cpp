#include "line/LineHands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace insonate {
namespace {

/// Lengths that hub and extension tube add to an instrument outside the body; our choice. The wire must be longer than
/// all of it, so that a hand can hold its end.
constexpr double kDilatorHub_mm = 20, kCatheterHub_mm = 100;
constexpr double kGrip_mm = 20;
/// Motion of the needle's tip after which a wire that has not left the needle starts at the new place.
constexpr double kNeedleMoved_mm = 0.5;
/// Smaller motions of the needle, as by tremor, do not drag a wire.
constexpr double kTremor_mm = 0.5;
/// Without a nick, the skin holds a dilator back after this length; our choice.
constexpr double kTaper_mm = 5;
/// Time for which the image has to show the wire before the view counts.
constexpr std::int64_t kSeen_us = 500'000;
/// Number of bubbles, and time for which the image has to show as many, before the flush is seen; our choice.
constexpr int kBubblesSeen = 5;
constexpr std::int64_t kBubblesSeen_us = 300'000;
/// Width of the pleura in the image, and time for which the image has to show it, before sliding can be judged; our
/// choice.
constexpr double kPleura_mm = 8;
constexpr std::int64_t kPleuraSeen_us = 2'000'000;
/// Value of a time since which something is seen, after it was reported.
constexpr std::int64_t kTold_us = std::numeric_limits<std::int64_t>::max();
/// Largest advance of a wire between two equilibria that are reported.
constexpr double kFeed_mm = 2;
/// Air through the open hub of an 18 G needle with an inner diameter of 0.84 mm: Q = C A sqrt(2 dp / rho), as through
/// an orifice; C = 0.7 is our choice. By this law a 14 G needle at 5 cm H2O lets 40 ml/s pass; 100 ml/s were measured
/// (Flanagan et al., N Engl J Med 1969, 281:488), so that our values are rather low.
constexpr double kHubArea_m2 = 5.5e-7, kAirDensity_kgPm3 = 1.2, kOrifice = 0.7;
/// Distance that a wire is pushed on against a stop until it kinks; our choice.
constexpr double kForced_mm = 10;
constexpr double kReportedAir_ml = 5, kLeastAir_ml = 1;
constexpr double kBloodColumn_mmHgPmm = 0.078;

bool isVessel(Label label) {
  return label == kVein || label == kArtery;
}

}  // namespace

Result<LineHands> LineHands::make(std::span<const NamedVessel> vessels, VesselLocator locator) {
  auto tree = VesselTree::make(vessels);
  if (!tree) return tl::unexpected(tree.error());
  auto wire = loadWire("j-tip"), dilator = loadWire("dilator"), catheter = loadWire("triple-lumen");
  for (const auto* one : {&wire, &dilator, &catheter})
    if (!*one) return tl::unexpected(one->error());
  return LineHands(std::move(*tree), SalineBubbles(vessels), std::move(*wire), std::move(*dilator),
                   std::move(*catheter), std::move(locator));
}

LineHands::LineHands(VesselTree tree, SalineBubbles bubbles, Wire wire, Wire dilator, Wire catheter,
                     VesselLocator locator)
    : tree_(tree),
      solver_(std::move(tree), std::move(wire)),
      dilator_(std::move(dilator)),
      catheter_(std::move(catheter)),
      locator_(std::move(locator)),
      bubbles_(std::move(bubbles)) {
  const std::vector<std::string> names = locator_.names();
  if (!names.empty()) side_ = parsedVesselName(names.front()).side;
}

std::uint8_t LineHands::vesselAt(Label label, Vec3 rest_mm) const {
  return locator_.vesselAt(label, rest_mm, veins_ ? std::span(*veins_) : std::span<const CenterLine>{});
}

void LineHands::report(AttemptEvent event) {
  event.time_us = time_us_;
  insonate::follow(state_, event, !locator_.names().empty());
  events_.push_back(event);
}

void LineHands::add(const AttemptEvent& event) {
  insonate::follow(state_, event, !locator_.names().empty());
  if (event.kind == AttemptEventKind::Entered && isVessel(event.wall)) {
    entries_.push_back({event.wall, event.depth_mm});
  } else if (event.kind == AttemptEventKind::Withdrawn && event.wall == kSkin) {
    entries_.clear();
  } else if (event.kind == AttemptEventKind::Withdrawn && isVessel(event.wall) && event.into != event.wall) {
    while (!entries_.empty() && entries_.back().depth_mm >= event.depth_mm - kNeedleMoved_mm) entries_.pop_back();
  }
}

void LineHands::follow(std::int64_t time_us, const LineNeedle& needle, const Physiology& physiology,
                       double bloodTime_s) {
  const double seconds = static_cast<double>(time_us - std::exchange(followed_us_, time_us)) * 1e-6;
  time_us_ = time_us;
  physiology_ = physiology, bloodTime_s_ = bloodTime_s;
  const LineNeedle before = std::exchange(needle_, needle);
  if (before.isInBody != needle.isInBody) haveRodsMoved_ = true;
  dragByNeedle(before);
  syncState();
  breatheAir(seconds);
}

/// A needle that moves over a wire that no hand holds takes the wire along.
void LineHands::dragByNeedle(const LineNeedle& before) {
  if (!hasWire_ || !state_.isWireInNeedle || state_.isWireHeld || !before.isInBody) {
    draggedAt_mm_ = needle_.depth_mm;
    return;
  }
  const double by_mm = (needle_.isInBody ? needle_.depth_mm : 0) - draggedAt_mm_;
  if (std::abs(by_mm) < kTremor_mm) return;
  draggedAt_mm_ += by_mm;
  feedWire(by_mm);
}

/// Makes the state that decides about the next act that of this moment, and not of the last sample.
void LineHands::syncState() {
  AttemptSample sample;
  if (needle_.isInBody) sample.needleDepth_mm = needle_.depth_mm;
  fill(sample);
  insonate::follow(state_, sample);
}

void LineHands::breatheAir(double seconds) {
  double flow_mlPs = 0;
  if (state_.isHubOpen() && needle_.in == kVein) {
    const Transform& needle = needle_.patientFromNeedle;
    // The patient lies on the back: anterior, toward -y, is up.
    const double height_mm = needle.linear.column[2].y * needle_.length_mm;
    const double atHub_mmHg = venousPressure_mmHg(physiology_, bloodTime_s_) - kBloodColumn_mmHgPmm * height_mm;
    const double suction_Pa = std::max(0.0, -atHub_mmHg) * kPascalPermmHg;
    flow_mlPs = kOrifice * kHubArea_m2 * std::sqrt(2 * suction_Pa / kAirDensity_kgPm3) * 1e6;
  }
  air_ml_ += flow_mlPs * seconds;
  const bool hasStopped = std::exchange(isBreathing_, flow_mlPs > 0) && flow_mlPs == 0;
  if (air_ml_ < (hasStopped ? kLeastAir_ml : kReportedAir_ml)) return;
  report({.kind = AttemptEventKind::AirEntered, .amount = std::exchange(air_ml_, 0)});
}

Result<double> LineHands::perform(std::int64_t time_us, LineAct act, int lumen) {
  time_us_ = time_us;
  if (std::string refusal = refusalOf(state_, act, lumen); !refusal.empty()) return fail(std::move(refusal));
  AttemptEvent event{.kind = AttemptEventKind::Performed, .act = act};
  if (act == LineAct::CheckLungSliding) {
    if (std::string refusal = lungRefusal(); !refusal.empty()) return fail(std::move(refusal));
    event.amount = isLungStill_ ? 1 : 0;
  }
  if (act == LineAct::MeasurePressure || act == LineAct::FlushForBubbles) {
    const bool isAtCatheter = catheter_mm_ > 0;
    event.wall = isAtCatheter ? state_.catheterIn : needle_.in;
    if (!isVessel(event.wall)) return fail("The tip is in no vessel: neither pressure nor bubbles can be seen.");
    if (act == LineAct::FlushForBubbles && !hasImage_)
      return fail("There is no live image in which bubbles can be seen. Put the probe on the skin first.");
    const Vec3 tip_mm = isAtCatheter ? pointAt(Instrument::Catheter, catheter_mm_)
                                     : needle_.restFromPatient * needle_.patientFromNeedle.offset;
    event.vessel = isAtCatheter ? state_.catheterVessel : vesselAt(event.wall, tip_mm);
    if (act == LineAct::FlushForBubbles) flushSaline(event, tip_mm);
    const BloodPressure mean = meanBloodPressure(physiology_);
    if (act == LineAct::MeasurePressure)
      event.amount = (event.wall == kArtery ? mean.artery_kPa : mean.vein_kPa) * 1000 / kPascalPermmHg;
  }
  if (act == LineAct::AspirateLumen || act == LineAct::FlushLumen) event.amount = lumen;
  report(event);
  return event.amount;
}

std::string LineHands::move(std::int64_t time_us, Instrument instrument, double by_mm) {
  time_us_ = time_us;
  if (std::string refusal = refusalOf(state_, instrument, by_mm > 0); !refusal.empty()) return refusal;
  std::string why = instrument == Instrument::Wire ? moveWire(by_mm) : moveOverWire(instrument, by_mm);
  syncState();
  return why;
}

double LineHands::wireBelowSkin_mm() const {
  return hasWire_ ? tract_mm_ + solver_.state().inserted_mm : 0;
}

double LineHands::freeWire_mm(Instrument over, double in_mm) const {
  const double length_mm =
      over == Instrument::Dilator ? lengthOf_mm(dilator_) + kDilatorHub_mm : lengthOf_mm(catheter_) + kCatheterHub_mm;
  return lengthOf_mm(solver_.wire()) - wireBelowSkin_mm() - (length_mm - in_mm);
}

void LineHands::startWire() {
  const Transform& needle = needle_.patientFromNeedle;
  const Transform& rest = needle_.restFromPatient;
  entry_mm_ = rest * needle.offset;
  const Vec3 direction = normalized(rest.linear * needle.linear.column[2]);
  tract_mm_ = vesselAt_mm_ = needle_.depth_mm;
  for (const Entry& entry : entries_)
    if (entry.wall == needle_.in) vesselAt_mm_ = std::min(entry.depth_mm, tract_mm_);
  skin_mm_ = entry_mm_ - direction * tract_mm_;
  solver_.start({.tip_mm = entry_mm_,
                 .direction = direction,
                 .bevelNormal = rest.linear * -needle.linear.column[1],
                 .roll_deg = 0});
  hasWire_ = true, forced_mm_ = 0, isStopTold_[std::size_t(Instrument::Wire)] = false;
  draggedAt_mm_ = needle_.depth_mm;
}

/// The reason why the wire has not gone by this distance, of which the hand had `left_mm` outside.
std::string LineHands::wireRefusal(double by_mm, double left_mm) const {
  if (by_mm > left_mm) return "The end of the wire is in your hand: it cannot go deeper without getting lost.";
  const WireRefusal refusal = solver_.state().refusal;
  if (by_mm <= 0 || refusal == WireRefusal::None) return {};
  return "The wire does not go on: " + std::string(nameOf(refusal)) +
         ". Withdraw it, correct the position of the needle, and try again.";
}

std::string LineHands::moveWire(double by_mm) {
  const bool hasNotEntered = solver_.state().tip != WireTip::Lumen && state_.isNeedleInBody;
  const Vec3 tip_mm = needle_.restFromPatient * needle_.patientFromNeedle.offset;
  if (!hasWire_ || (by_mm > 0 && hasNotEntered && norm(tip_mm - entry_mm_) > kNeedleMoved_mm)) startWire();
  if (!state_.isWireHeld)
    report({.kind = AttemptEventKind::Performed, .act = LineAct::HoldWire});  // the hand that moves it holds it
  const double left_mm = std::max(lengthOf_mm(solver_.wire()) - kGrip_mm - wireBelowSkin_mm(), 0.0);
  feedWire(std::min(by_mm, left_mm));
  if (by_mm > 0 && state_.isWireKinked) return refusalOf(state_, Instrument::Wire, true);
  return wireRefusal(by_mm, left_mm);
}

/// Kinks a wire that is pushed on against a stop.
void LineHands::strainWire(double by_mm, double moved_mm) {
  const WireRefusal refusal = solver_.state().refusal;
  const bool isStopped = by_mm > 0 && refusal != WireRefusal::None && refusal != WireRefusal::EndOfWire;
  forced_mm_ = isStopped ? forced_mm_ + by_mm - moved_mm : 0;
  if (!isStopped || state_.isWireKinked || (refusal != WireRefusal::Kinked && forced_mm_ < kForced_mm)) return;
  report({.kind = AttemptEventKind::WireKinked,
          .tip_mm = solver_.nodes_mm().empty() ? entry_mm_ : solver_.nodes_mm().back(),
          .depth_mm = wireBelowSkin_mm(),
          .instrument = Instrument::Wire});
}

void LineHands::feedWire(double by_mm) {
  if (!hasWire_) return;
  if (by_mm < 0 && wireBelowSkin_mm() + by_mm <= tract_mm_) return removeWire();
  const double before_mm = wireBelowSkin_mm();
  for (double left_mm = by_mm; std::abs(left_mm) > 1e-9;) {
    const double step_mm = std::clamp(left_mm, -kFeed_mm, kFeed_mm);
    left_mm -= step_mm;
    const WireTip before = solver_.state().tip;
    solver_.advance(step_mm);
    reportWire(before);
    if (step_mm > 0 && solver_.state().refusal != WireRefusal::None) break;
    isStopTold_[std::size_t(Instrument::Wire)] = false;
  }
  strainWire(by_mm, wireBelowSkin_mm() - before_mm);
  updatePath();
}

void LineHands::reportWire(WireTip before) {
  const WireState& wire = solver_.state();
  const Vec3 tip_mm = solver_.nodes_mm().empty() ? entry_mm_ : solver_.nodes_mm().back();
  AttemptEvent event{.tip_mm = tip_mm, .depth_mm = wireBelowSkin_mm(), .instrument = Instrument::Wire};
  if (wire.tip != before && wire.tip != WireTip::InNeedle) {
    const auto system = static_cast<Label>(wire.system);
    event.kind = AttemptEventKind::InstrumentEntered;
    event.wall = event.into = wire.tip == WireTip::Lumen ? system : kSoftTissue;
    event.vessel = wire.tip == WireTip::Lumen ? vesselAt(system, entry_mm_) : std::uint8_t{0};
    report(event);
  }
  if (wire.refusal != WireRefusal::None) reportStop(Instrument::Wire, tip_mm, wireBelowSkin_mm());
  const bool isInHeart = wire.tip == WireTip::Lumen && wire.system == kVein && wire.at.toHeart_mm < 0;
  if (isInHeart && !std::exchange(isInHeart_, isInHeart)) {
    event.kind = AttemptEventKind::Ectopy;
    report(event);
  }
  isInHeart_ = isInHeart;
  const bool isThrough = isInHeart && wire.at.toHeart_mm < -kTachycardiaFrom_mm;
  if (isThrough && !isThroughAtrium_) {
    event.kind = AttemptEventKind::Tachycardia;
    report(event);
  }
  isThroughAtrium_ = isThrough;
}

/// Reports a stop once, until the instrument moves on.
void LineHands::reportStop(Instrument instrument, Vec3 tip_mm, double depth_mm) {
  if (std::exchange(isStopTold_[std::size_t(instrument)], true)) return;
  report(
      {.kind = AttemptEventKind::InstrumentStopped, .tip_mm = tip_mm, .depth_mm = depth_mm, .instrument = instrument});
}

void LineHands::removeWire() {
  hasWire_ = false, isInHeart_ = isThroughAtrium_ = false, forced_mm_ = 0;
  wirePath_.clear(), haveRodsMoved_ = true;
  report({.kind = AttemptEventKind::InstrumentRemoved, .instrument = Instrument::Wire});
}

void LineHands::updatePath() {
  haveRodsMoved_ = true;
  wirePath_.assign(1, skin_mm_);
  wirePath_.insert(wirePath_.end(), solver_.nodes_mm().begin(), solver_.nodes_mm().end());
  if (solver_.nodes_mm().empty()) wirePath_.push_back(entry_mm_);
}

/// An instrument that moves over a wire that no hand holds takes the wire along.
void LineHands::dragWire(double by_mm) {
  if (state_.isWireLost) return;
  feedWire(by_mm);
  if (!hasWire_ || wireBelowSkin_mm() < lengthOf_mm(solver_.wire()) - kGrip_mm) return;
  report({.kind = AttemptEventKind::WireLost, .depth_mm = wireBelowSkin_mm(), .instrument = Instrument::Wire});
}

std::string LineHands::enterOverWire(Instrument instrument, double& in_mm, double by_mm) {
  const bool isDilator = instrument == Instrument::Dilator;
  const double to_mm = in_mm + by_mm;
  if (to_mm > lengthOf_mm(isDilator ? dilator_ : catheter_))
    return "The " + std::string(nameOf(instrument)) + " is in up to its hub.";
  const char* held = nullptr;
  if (to_mm > kTaper_mm && isDilator && !state_.isNicked)
    held = "The skin holds the dilator back. Nick the skin beside the wire.";
  if (to_mm > kTaper_mm && !isDilator && state_.dilations == 0 && !isCatheterIn_)
    held = "The tissue holds the catheter back. Dilate first.";
  if (!isDilator && hasWire_ && to_mm > std::max(wireBelowSkin_mm(), catheter_mm_))
    held = "The catheter has reached the end of the wire.";
  if (held) {
    reportStop(instrument, pointAt(instrument, in_mm), in_mm);
    return held;
  }
  in_mm = to_mm;
  return {};
}

std::string LineHands::moveOverWire(Instrument instrument, double by_mm) {
  const bool isDilator = instrument == Instrument::Dilator;
  double& in_mm = isDilator ? dilator_mm_ : catheter_mm_;
  bool& isIn = isDilator ? isDilatorIn_ : isCatheterIn_;
  std::vector<Vec3>& path = isDilator ? dilatorPath_ : catheterPath_;
  const double before_mm = in_mm;
  if (hasWire_ && state_.isWireHeld && freeWire_mm(instrument, in_mm) < kGrip_mm)
    report({.kind = AttemptEventKind::Performed, .act = LineAct::ReleaseWire});  // its end is inside the instrument
  const bool isDragged = hasWire_ && !state_.isWireHeld;
  if (by_mm > 0) {
    if (std::string why = enterOverWire(instrument, in_mm, by_mm); !why.empty()) return why;
  } else {
    in_mm = std::max(0.0, in_mm + by_mm);
  }
  isStopTold_[std::size_t(instrument)] = false, haveRodsMoved_ = true;
  if (isDragged) dragWire(in_mm - before_mm);
  // A shorter wire does not change the course of the instrument that is already deeper.
  if (hasWire_ && (wireBelowSkin_mm() >= in_mm || path.empty())) path = wirePath_;
  AttemptEvent event{.tip_mm = pointAt(instrument, in_mm), .depth_mm = in_mm, .instrument = instrument};
  if (!isIn && in_mm >= vesselAt_mm_ && hasWire_) {
    isIn = true;
    event.kind = AttemptEventKind::InstrumentEntered;
    event.wall = event.into = state_.wireIn, event.vessel = state_.wireVessel;
    report(event);
  }
  if (in_mm > 0) return {};
  isIn = false;
  path.clear();
  event.kind = AttemptEventKind::InstrumentRemoved;
  report(event);
  return {};
}

/// A point of the path of dilator or catheter, at a length below the skin.
Vec3 LineHands::pointAt(Instrument instrument, double below_mm) const {
  const std::vector<Vec3>& path = instrument == Instrument::Dilator ? dilatorPath_ : catheterPath_;
  if (path.empty()) return skin_mm_;
  double left_mm = below_mm;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double length_mm = norm(path[i] - path[i - 1]);
    if (left_mm <= length_mm && length_mm > 0) return path[i - 1] + (path[i] - path[i - 1]) * (left_mm / length_mm);
    left_mm -= length_mm;
  }
  return path.back();
}

void LineHands::look(const std::optional<Sight>& sight) {
  hasImage_ = sight.has_value();
  const auto watch = [&](std::optional<std::int64_t>& since_us, bool isSeen, AttemptEventKind kind) {
    if (!isSeen || !hasWire_ || solver_.state().tip != WireTip::Lumen) return since_us.reset();
    if (!since_us) since_us = time_us_;
    if (time_us_ - *since_us < kSeen_us) return;
    since_us = kTold_us;  // reported once for each view
    const auto system = static_cast<Label>(solver_.state().system);
    report({.kind = kind,
            .wall = system,
            .into = system,
            // A wire that has entered the target proves the vein also where the vein goes on under another name.
            .vessel = state_.wireVessel,
            .tip_mm = sight->at_mm,
            .depth_mm = wireBelowSkin_mm()});
  };
  watch(shortSince_us_, sight && sight->isInShortAxis, AttemptEventKind::WireInShortAxis);
  watch(longSince_us_, sight && sight->isInLongAxis, AttemptEventKind::WireInLongAxis);
  lookForBubbles(sight ? sight->bubbles : 0);
  lookAtLung(sight.value_or(Sight{}));
}

void LineHands::lookAtLung(const Sight& sight) {
  const bool isLineIn = catheter_mm_ > 0 && isVessel(state_.catheterIn);
  isLungSeen_ = isLungSeen_ && isLineIn;
  if (!isLineIn || sight.pleura_mm < kPleura_mm) return lungSince_us_.reset();
  if (!lungSince_us_) lungSince_us_ = time_us_;
  if (time_us_ - *lungSince_us_ < kPleuraSeen_us) return;
  isLungSeen_ = true, isLungStill_ = sight.still_mm > sight.pleura_mm / 2;
}

/// A lung that was not looked at is not checked.
std::string LineHands::lungRefusal() const {
  if (isLungSeen_) return {};
  const char* which = !side_ ? "lung of this side" : *side_ == BodySide::Right ? "right lung" : "left lung";
  return std::string("The lung has not been seen since the catheter is in place. Hold the probe over the ") + which +
         ", below or above the clavicle, and keep the pleura in the image for two seconds.";
}

void LineHands::flushSaline(const AttemptEvent& event, Vec3 from_mm) {
  flush_ = SalineFlush{static_cast<double>(time_us_) * 1e-6, event.wall, from_mm};
  flushed_ = event, flushed_.tip_mm = from_mm, flushBloodTime_s_ = bloodTime_s_;
  bubblesSince_us_.reset();
}

std::span<const Bubble> LineHands::bubbles() {
  if (!flush_) return {};
  return bubbles_.at(*flush_, static_cast<double>(time_us_) * 1e-6 - flush_->time_s, physiology_, flushBloodTime_s_);
}

/// Reports each flush once.
void LineHands::lookForBubbles(int seen) {
  if (!flush_ || bubblesSince_us_ == kTold_us) return;
  if (seen < kBubblesSeen) return bubblesSince_us_.reset();
  if (!bubblesSince_us_) bubblesSince_us_ = time_us_;
  if (time_us_ - *bubblesSince_us_ < kBubblesSeen_us) return;
  bubblesSince_us_ = kTold_us;
  report({.kind = AttemptEventKind::BubblesSeen,
          .wall = flushed_.wall,
          .into = flushed_.wall,
          .vessel = flushed_.vessel,
          .tip_mm = flushed_.tip_mm});
}

std::vector<FlexibleRod> LineHands::rods() const {
  const auto rounded = [](Vec3 at_mm) {
    for (int axis = 0; axis < 3; ++axis) at_mm[axis] = std::round(at_mm[axis] * 100) / 100;
    return at_mm;
  };
  const auto rodOf = [](const Wire& wire, RodMaterial material) {
    return FlexibleRod{material, wire.diameter_mm / 2, wire.innerDiameter_mm / 2, {}};
  };
  std::vector<FlexibleRod> rods;
  if (hasWire_) {
    FlexibleRod& wire = rods.emplace_back(rodOf(solver_.wire(), RodMaterial::SteelCoil));
    for (std::size_t i = state_.isWireInNeedle ? 1 : 0; i < wirePath_.size(); ++i)
      wire.nodes_mm.push_back(rounded(wirePath_[i]));
  }
  const auto addTube = [&](const Wire& tube, Instrument instrument, double in_mm) {
    if (in_mm <= 0) return;
    FlexibleRod& rod = rods.emplace_back(rodOf(tube, RodMaterial::Polymer));
    constexpr double kStep_mm = 2;
    for (double at_mm = 0; at_mm < in_mm; at_mm += kStep_mm)
      rod.nodes_mm.push_back(rounded(pointAt(instrument, at_mm)));
    rod.nodes_mm.push_back(rounded(pointAt(instrument, in_mm)));
  };
  addTube(dilator_, Instrument::Dilator, dilator_mm_), addTube(catheter_, Instrument::Catheter, catheter_mm_);
  std::erase_if(rods, [](const FlexibleRod& rod) { return rod.nodes_mm.size() < 2; });
  return rods;
}

std::optional<std::vector<FlexibleRod>> LineHands::takeRods() {
  constexpr std::int64_t kApart_us = 100'000;
  if (!haveRodsMoved_ || time_us_ - rodsTaken_us_ < kApart_us) return std::nullopt;
  haveRodsMoved_ = false, rodsTaken_us_ = time_us_;
  return rods();
}

Vec3 LineHands::vesselAxisAt(Vec3 rest_mm) const {
  return tree_.wallAt(solver_.state().system, rest_mm).axis;
}

void LineHands::fill(AttemptSample& sample) const {
  const auto toHeart = [](const VesselTree::Location& at) {
    return std::isfinite(at.toHeart_mm) ? std::optional(at.toHeart_mm) : std::nullopt;
  };
  if (hasWire_) {
    sample.wire_mm = wireBelowSkin_mm();
    if (solver_.state().tip == WireTip::Lumen) sample.wireToHeart_mm = toHeart(solver_.state().at);
  }
  if (dilator_mm_ > 0) sample.dilator_mm = dilator_mm_;
  if (catheter_mm_ <= 0) return;
  sample.catheter_mm = catheter_mm_;
  if (isCatheterIn_ && isVessel(state_.catheterIn))
    sample.catheterToHeart_mm = toHeart(tree_.locate(state_.catheterIn, pointAt(Instrument::Catheter, catheter_mm_)));
}

std::vector<AttemptEvent> LineHands::takeEvents() {
  return std::exchange(events_, {});
}

}  // namespace insonate
