#include <insonate/procedure/AttemptScore.h>
#include <insonate/procedure/ProcedureRun.h>

#include <algorithm>
#include <array>
#include <functional>

namespace insonate {
namespace {

/// Present duration of a state.
void follow(std::optional<std::int64_t>& since_us, bool holds, std::int64_t now_us) {
  if (!holds) since_us.reset();
  if (holds && !since_us) since_us = now_us;
}

/// Tells whether any counter increased between the two.
bool countedMore(const MetricValues& before, const MetricValues& after) {
  using enum Metric;
  constexpr std::array kCounts{VeinPunctures, OtherVeinPunctures, ArteryPunctures, PosteriorWallPunctures,
                               LungPunctures, BoneContacts,       Passes};
  return std::ranges::any_of(kCounts, [&](Metric count) { return after[count] > before[count]; });
}

bool isMilestone(const AttemptEvent& event) {
  using enum AttemptEventKind;
  return event.kind == NeedleReplaced || event.kind == Frozen || event.kind >= Positioned;
}

bool isAsRequested(const EventCondition& wanted, const AttemptEvent& event) {
  return wanted.kind == event.kind && (!wanted.wall || *wanted.wall == event.wall) &&
         (!wanted.act || *wanted.act == event.act) && (!wanted.instrument || *wanted.instrument == event.instrument);
}

/// Tells whether a state of the instruments of the line holds. `hasTarget`: vessel 1 is the target.
bool holds(const StateCondition& condition, const LineState& line, bool hasTarget) {
  const auto isTarget = [&](Label label, std::uint8_t vessel) { return label == kVein && (!hasTarget || vessel == 1); };
  using enum StateCondition::What;
  switch (condition.what) {
    case Performed:
      return line.count(condition.act) > 0;
    case SyringeOff:
      return line.isNeedleInBody && !line.isSyringeOn;
    case WireSeenInShortAxis:
      return line.isWireSeenInShortAxis;
    case WireSeenInLongAxis:
      return line.isWireSeenInLongAxis;
    case LumensFlushed:
      return std::ranges::all_of(line.isFlushed, std::identity{});
    case NeedleOffWire:
      return line.isWireIn() && !line.isNeedleInBody;
    case SkinNicked:
      return line.isNicked && line.isWireIn();
    case DilatorRemoved:
      return line.dilations > 0 && line.dilator_mm == 0;
    case WireInTarget:
      return line.isWireIn() && isTarget(line.wireIn, line.wireVessel) && !line.isWireKinked &&
             (line.wire_mm >= condition.wire_mm || line.rhythm != HeartRhythm::Sinus);
    case VesselDilated:
      return line.dilations > 0;
    case CatheterInTarget:
      return line.catheter_mm > 0 && isTarget(line.catheterIn, line.catheterVessel);
    case CatheterWithoutWire:
      return line.catheterIn != kBackground && line.catheter_mm > 0 && !line.isWireIn();
    default:
      return false;
  }
}

/// Tells whether a step is met by a state that implies the steps before it, so that they no longer can be done.
bool impliesEarlierSteps(const ProcedureStep& step) {
  const auto* state = std::get_if<StateCondition>(&step.until);
  return state && state->what >= StateCondition::What::WireInTarget;
}

}  // namespace

ProcedureRun::ProcedureRun(Procedure procedure, const ImageField& imageField, std::vector<std::string> vessels)
    : procedure_(std::move(procedure)),
      vessels_(std::move(vessels)),
      metrics_(imageField, !vessels_.empty()),
      steps_(procedure_.steps.size()),
      isLine_(hasLine(procedure_)),
      told_(procedure_.rules.size()) {}

void ProcedureRun::add(const AttemptSample& sample) {
  metrics_.add(sample);
  follow(probeOnSkin_us_, sample.patientFromProbe && sample.probeForce_N > 0, sample.time_us);
  const bool draws = sample.aspirating && metrics_.needle() == NeedlePlace::Vein;
  aspirating_us_ = draws ? metrics_.aspiratingBloodSince_us() : std::nullopt;
  complete(sample.time_us, nullptr);
  watchRules(sample.time_us, {});
}

void ProcedureRun::add(const AttemptEvent& event) {
  const MetricValues before = metrics_.values();
  metrics_.add(event);
  followVessel(event);
  const bool ended = complete(event.time_us, &event);
  const bool pulledOut = event.kind == AttemptEventKind::Withdrawn && event.wall == kSkin;
  if (isMilestone(event) || pulledOut || countedMore(before, metrics_.values())) milestones_.push_back(event);
  const bool isOver = (ended || due_ == steps_.size()) && !hasHarmed_;
  if (pulledOut && !metrics_.line().isWireIn() && metrics_.line().catheter_mm == 0 && !isOver)
    restartAt(procedure_.passBegins);
  if (event.kind == AttemptEventKind::Entered)
    hasHarmed_ = event.wall != kSkin && (hasHarmed_ || event.wall == kArtery || event.wall == kAirway);
  if (isLine_) restartLine(event);
  const bool isNamed = event.vessel != 0 && event.vessel != kUnnamedVessel;
  watchRules(event.time_us, isNamed ? vesselName(event, vessels_) : std::string());
}

void ProcedureRun::restartAt(std::size_t step) {
  if (due_ <= step) return;
  due_ = step;
  std::fill(steps_.begin() + static_cast<std::ptrdiff_t>(due_), steps_.end(), Step{});
}

/// A wire that comes out before the catheter is in has to be inserted again: through the needle if it is still in the
/// body, else after another puncture. An act that follows later than its step still counts as done.
void ProcedureRun::restartLine(const AttemptEvent& event) {
  const LineState& line = metrics_.line();
  if (event.kind == AttemptEventKind::InstrumentRemoved && event.instrument == Instrument::Wire &&
      line.catheter_mm == 0) {
    std::size_t wire = procedure_.passBegins;
    for (std::size_t i = 0; line.isNeedleInBody && i < steps_.size(); ++i)
      if (const auto* state = std::get_if<StateCondition>(&procedure_.steps[i].until);
          state && state->what == StateCondition::What::WireInTarget)
        wire = i;
    restartAt(wire);
  }
  if (event.kind != AttemptEventKind::Performed) return;
  for (std::size_t i = 0; i < due_; ++i) {
    const auto* state = std::get_if<StateCondition>(&procedure_.steps[i].until);
    const bool isLate = state && state->what == StateCondition::What::Performed && state->act == event.act;
    if (isLate && steps_[i].state == StepState::Skipped) steps_[i] = {StepState::Done, event.time_us};
  }
}

void ProcedureRun::followVessel(const AttemptEvent& event) {
  if (event.kind > AttemptEventKind::Withdrawn) return;
  const bool isVessel = event.wall == kVein || event.wall == kArtery;
  if (isVessel && event.into == event.wall)
    vesselWall_ = event;
  else if (isVessel || event.wall == kSkin)
    vesselWall_.reset();
}

std::string ProcedureRun::vesselAtTip() const {
  return vesselWall_ ? vesselName(*vesselWall_, vessels_) : std::string();
}

bool ProcedureRun::isMet(const StateCondition& condition, std::int64_t time_us) const {
  using enum StateCondition::What;
  if (condition.what == VeinsSurveyed) return metrics_.value(Metric::VeinsSurveyed).value_or(0) >= condition.veins;
  if (condition.what != ProbeOnSkin && condition.what != AspiratingInVein)
    return holds(condition, metrics_.line(), !vessels_.empty());
  const auto& since_us = condition.what == ProbeOnSkin ? probeOnSkin_us_ : aspirating_us_;
  return since_us && static_cast<double>(time_us - *since_us) * 1e-6 >= condition.for_s;
}

bool ProcedureRun::isMet(const EventCondition& condition, const AttemptEvent& event) const {
  return isAsRequested(condition, event) && (condition.wall != kVein || isTarget(event));
}

/// Ends the current step, or a later one if only optional ones are between, or if the later one implies those between;
/// true if a step ended.
bool ProcedureRun::complete(std::int64_t time_us, const AttemptEvent* event) {
  bool isOptional = true;  // all steps from the current one to this one
  for (std::size_t i = due_; i < steps_.size(); ++i) {
    const ProcedureStep& step = procedure_.steps[i];
    const auto* happening = std::get_if<EventCondition>(&step.until);
    const bool isMetNow =
        happening ? event && isMet(*happening, *event) : isMet(std::get<StateCondition>(step.until), time_us);
    if (isMetNow && (isOptional || impliesEarlierSteps(step))) {
      steps_[i] = {StepState::Done, time_us};
      // The patient may lie in this position from the start: nothing before it was left out.
      const bool isPosition = event && event->kind == AttemptEventKind::Positioned;
      if (!isPosition || i == due_) goOnAfter(i, time_us);
      return true;
    }
    isOptional = isOptional && step.optional;
    if (!isOptional && !isLine_) return false;
  }
  return false;
}

/// Makes the first open step after this one the current step; open steps before it are skipped.
void ProcedureRun::goOnAfter(std::size_t step, std::int64_t time_us) {
  for (; due_ <= step || (due_ < steps_.size() && steps_[due_].state == StepState::Done); ++due_)
    if (steps_[due_].state != StepState::Done) steps_[due_] = {StepState::Skipped, time_us};
}

void ProcedureRun::watchRules(std::int64_t time_us, const std::string& vessel) {
  for (std::size_t i = 0; i < told_.size(); ++i) {
    const MetricLimit& limit = procedure_.rules[i].limit;
    const auto value = metrics_.value(limit.metric);
    if (!limit.isBeyond(value)) continue;
    const bool isCount = definitionOf(limit.metric).unit.empty();
    if (told_[i] && !(isCount && *value > *told_[i])) continue;
    told_[i] = value;
    findings_.push_back({i, time_us, *value, vessel});
  }
}

std::optional<std::size_t> ProcedureRun::nextStep() const {
  return due_ < steps_.size() ? std::optional(due_) : std::nullopt;
}

bool ProcedureRun::succeeded() const {
  return std::ranges::all_of(procedure_.success,
                             [&](const MetricLimit& limit) { return limit.isBeyond(metrics_.value(limit.metric)); });
}

}  // namespace insonate
