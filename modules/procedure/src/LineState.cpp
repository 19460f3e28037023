#include <insonate/procedure/LineState.h>

#include <algorithm>

namespace insonate {
namespace {

void perform(LineState& state, const AttemptEvent& event) {
  ++state.performed[static_cast<std::size_t>(event.act)];
  const auto lumen = static_cast<std::size_t>(std::clamp(event.amount, 1.0, double{kCatheterLumens})) - 1;
  switch (event.act) {
    case LineAct::DetachSyringe:
      state.isSyringeOn = false;
      return;
    case LineAct::AttachSyringe:
      state.isSyringeOn = true, state.isHubCovered = false;
      return;
    case LineAct::CoverHub:
    case LineAct::UncoverHub:
      state.isHubCovered = event.act == LineAct::CoverHub;
      return;
    case LineAct::HoldWire:
    case LineAct::ReleaseWire:
      state.isWireHeld = event.act == LineAct::HoldWire;
      return;
    case LineAct::NickSkin:
      state.isNicked = true;
      return;
    case LineAct::AspirateLumen:
      state.isAspirated[lumen] = true;
      return;
    case LineAct::FlushLumen:
      state.isFlushed[lumen] = true;
      return;
    default:
      return;
  }
}

void enter(LineState& state, const AttemptEvent& event) {
  if (event.instrument == Instrument::Wire) {
    state.wireIn = event.into, state.wireVessel = event.vessel;
    state.isHubCovered = false;
  } else if (event.instrument == Instrument::Catheter) {
    state.catheterIn = event.into, state.catheterVessel = event.vessel;
  } else if (event.instrument == Instrument::Dilator && (event.into == kVein || event.into == kArtery)) {
    ++state.dilations;
  }
}

void remove(LineState& state, Instrument instrument) {
  if (instrument == Instrument::Wire) {
    state.wireIn = kBackground, state.wireVessel = 0, state.dilations = 0, state.isWireKinked = false,
    state.wireStop_mm = 0;
    state.isWireSeenInShortAxis = state.isWireSeenInLongAxis = state.isWireHeld = false;
  } else if (instrument == Instrument::Catheter) {
    state.catheterIn = kBackground, state.catheterVessel = 0;
    state.isAspirated = {}, state.isFlushed = {};
    for (const LineAct act : {LineAct::SecureCatheter, LineAct::ApplyDressing, LineAct::CheckLungSliding})
      state.performed[static_cast<std::size_t>(act)] = 0;
  }
}

std::string refusalAtHub(const LineState& state, LineAct act) {
  switch (act) {
    case LineAct::DetachSyringe:
      return state.isSyringeOn ? "" : "The syringe is already off the needle.";
    case LineAct::AttachSyringe:
      if (state.isSyringeOn) return "The syringe is already on the needle.";
      return state.isWireInNeedle ? "The wire is in the needle. Remove the wire before you attach the syringe." : "";
    case LineAct::CoverHub:
      if (state.isSyringeOn) return "The syringe closes the hub. Detach the syringe first.";
      if (state.isWireInNeedle) return "The wire is in the hub.";
      return state.isHubCovered ? "The hub is already covered." : "";
    case LineAct::UncoverHub:
      return state.isHubCovered ? "" : "The hub is not covered.";
    default:
      return {};
  }
}

std::string refusalOfWireAct(const LineState& state, LineAct act) {
  if (state.isWireLost) return "The wire is in the body and cannot be reached.";
  if (!state.isWireIn()) return "The wire is not in the body.";
  if (act == LineAct::HoldWire) return state.isWireHeld ? "The wire is already held." : "";
  if (act == LineAct::ReleaseWire) return state.isWireHeld ? "" : "The wire is not held.";
  if (state.isNeedleInBody) return "The needle is still in the skin. Withdraw it over the wire first.";
  return state.isNicked ? "The skin is already nicked." : "";
}

std::string refusalOfCheck(const LineState& state) {
  if (state.catheter_mm > 0) return state.isWireIn() ? "The wire is in the catheter. Remove the wire first." : "";
  if (!state.isNeedleInBody) return "Neither a needle nor a catheter is in the body.";
  if (state.isWireInNeedle) return "The wire is in the needle.";
  return {};
}

std::string refusalAtLumen(const LineState& state, LineAct act, int lumen) {
  if (lumen < 1 || lumen > kCatheterLumens) return "The catheter has the lumens 1 to 3.";
  if (state.catheter_mm <= 0) return "The catheter is not in the body.";
  // The wire runs through the distal lumen, whose number is 1.
  if (lumen == 1 && state.isWireIn()) return "The wire is in this lumen. Remove the wire first.";
  if (act == LineAct::AspirateLumen && state.catheterIn != kVein && state.catheterIn != kArtery)
    return "No blood comes: the catheter is in no vessel.";
  const auto index = static_cast<std::size_t>(lumen) - 1;
  return act == LineAct::FlushLumen && state.isFlushed[index] ? "This lumen is already flushed." : "";
}

std::string refusalOfWire(const LineState& state, bool isAdvanced) {
  if (state.isWireLost) return "The wire is in the body and cannot be reached.";
  if (!isAdvanced) return state.isWireIn() ? "" : "The wire is not in the body.";
  if (state.isWireKinked) return "The wire has a kink. Withdraw the whole wire and insert a new one.";
  if (state.isWireIn()) return {};
  if (state.catheter_mm > 0) return "The catheter is in place and needs no wire.";
  if (!state.isNeedleInBody) return "The wire enters through the needle. Insert the needle first.";
  return state.isSyringeOn ? "The syringe is on the needle. Detach it before you insert the wire." : "";
}

std::string refusalOverWire(const LineState& state, Instrument instrument, bool isAdvanced) {
  const bool isDilator = instrument == Instrument::Dilator;
  const double in_mm = state.length_mm(instrument);
  const std::string name(nameOf(instrument));
  if (!isAdvanced) return in_mm > 0 ? "" : "The " + name + " is not in the body.";
  if (state.isWireIn() && state.isWireKinked)
    return "The " + name + " does not pass the kink of the wire. Withdraw the whole wire and insert a new one.";
  if (in_mm > 0) return {};
  if (!state.isWireIn()) return "The " + name + " goes over the wire, and no wire is in the body.";
  if (state.isNeedleInBody) return "The needle is still in the skin. Withdraw it over the wire first.";
  if ((isDilator ? state.catheter_mm : state.dilator_mm) > 0)
    return isDilator ? "The catheter is on the wire." : "The dilator is on the wire. Withdraw it first.";
  return {};
}

}  // namespace

double LineState::length_mm(Instrument instrument) const {
  switch (instrument) {
    case Instrument::Wire:
      return wire_mm;
    case Instrument::Dilator:
      return dilator_mm;
    case Instrument::Catheter:
      return catheter_mm;
    case Instrument::Needle:
      break;
  }
  return 0;
}

void follow(LineState& state, const AttemptSample& sample) {
  const bool wasWireIn = state.isWireIn();
  state.isNeedleInBody = sample.needleDepth_mm.has_value();
  state.wire_mm = sample.wire_mm.value_or(0);
  constexpr double kGoesOn_mm = 1;
  if (state.wire_mm < state.wireStop_mm - kBackOff_mm || state.wire_mm > state.wireStop_mm + kGoesOn_mm)
    state.wireStop_mm = 0;
  if (!state.isNeedleInBody || !state.isWireIn())
    state.isWireInNeedle = false;
  else if (!wasWireIn)
    state.isWireInNeedle = true;
  state.dilator_mm = sample.dilator_mm.value_or(0), state.catheter_mm = sample.catheter_mm.value_or(0);
  const double inHeart_mm = state.isWireIn() && state.wireIn == kVein ? -sample.wireToHeart_mm.value_or(0) : 0;
  state.rhythm = inHeart_mm > kTachycardiaFrom_mm ? HeartRhythm::Tachycardia
                 : inHeart_mm > 0                 ? HeartRhythm::ExtraBeats
                                                  : HeartRhythm::Sinus;
}

void follow(LineState& state, const AttemptEvent& event, bool hasTarget) {
  const bool isTarget = event.wall == kVein && (!hasTarget || event.vessel == 1);
  switch (event.kind) {
    case AttemptEventKind::Entered:
      if (event.wall == kSkin && !state.isWireIn()) state.isNicked = false;
      return;
    case AttemptEventKind::NeedleReplaced:
      state.isSyringeOn = true, state.isHubCovered = false;
      return;
    case AttemptEventKind::Performed:
      return perform(state, event);
    case AttemptEventKind::WireInShortAxis:
      state.isWireSeenInShortAxis |= isTarget;
      return;
    case AttemptEventKind::WireInLongAxis:
      state.isWireSeenInLongAxis |= isTarget;
      return;
    case AttemptEventKind::InstrumentEntered:
      return enter(state, event);
    case AttemptEventKind::InstrumentRemoved:
      return remove(state, event.instrument);
    case AttemptEventKind::InstrumentStopped:
      if (event.instrument == Instrument::Wire) state.wireStop_mm = event.depth_mm;
      return;
    case AttemptEventKind::WireKinked:
      state.isWireKinked = true;
      return;
    case AttemptEventKind::WireLost:
      state.isWireLost = true, state.isWireHeld = false;
      return;
    default:
      return;
  }
}

std::string refusalOf(const LineState& state, LineAct act, int lumen) {
  switch (act) {
    case LineAct::DetachSyringe:
    case LineAct::AttachSyringe:
    case LineAct::CoverHub:
    case LineAct::UncoverHub:
      return refusalAtHub(state, act);
    case LineAct::HoldWire:
    case LineAct::ReleaseWire:
    case LineAct::NickSkin:
      return refusalOfWireAct(state, act);
    case LineAct::MeasurePressure:
    case LineAct::FlushForBubbles:
    case LineAct::TrustBloodColor:
      return refusalOfCheck(state);
    case LineAct::AspirateLumen:
    case LineAct::FlushLumen:
      return refusalAtLumen(state, act, lumen);
    case LineAct::SecureCatheter:
    case LineAct::ApplyDressing:
    case LineAct::CheckLungSliding:
      return state.catheter_mm > 0 ? "" : "The catheter is not in the body.";
    default:
      return state.count(act) > 0 ? "This is already done." : "";
  }
}

std::string refusalOf(const LineState& state, Instrument instrument, bool isAdvanced) {
  if (instrument == Instrument::Needle) return {};
  return instrument == Instrument::Wire ? refusalOfWire(state, isAdvanced)
                                        : refusalOverWire(state, instrument, isAdvanced);
}

}  // namespace insonate
