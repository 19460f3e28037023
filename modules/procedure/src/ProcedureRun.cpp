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

/// Tells whether a state of the instruments of the line holds.
bool holds(const StateCondition& condition, const LineState& line) {
  switch (condition.what) {
    case StateCondition::What::Performed:
      return line.count(condition.act) > 0;
    case StateCondition::What::SyringeOff:
      return line.isNeedleInBody && !line.isSyringeOn;
    case StateCondition::What::WireSeenInShortAxis:
      return line.isWireSeenInShortAxis;
    case StateCondition::What::WireSeenInLongAxis:
      return line.isWireSeenInLongAxis;
    case StateCondition::What::LumensFlushed:
      return std::ranges::all_of(line.isFlushed, std::identity{});
    default:
      return false;
  }
}

}  // namespace

ProcedureRun::ProcedureRun(Procedure procedure, const ImageField& imageField, std::vector<std::string> vessels)
    : procedure_(std::move(procedure)),
      vessels_(std::move(vessels)),
      metrics_(imageField, !vessels_.empty()),
      steps_(procedure_.steps.size()),
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
  const bool isOverWire = metrics_.line().isWireIn();
  if (pulledOut && !isOverWire && !ended && due_ > procedure_.passBegins && due_ < steps_.size()) {
    due_ = procedure_.passBegins;
    std::fill(steps_.begin() + static_cast<std::ptrdiff_t>(due_), steps_.end(), Step{});
  }
  const bool isNamed = event.vessel != 0 && event.vessel != kUnnamedVessel;
  watchRules(event.time_us, isNamed ? vesselName(event, vessels_) : std::string());
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

/// Ends the current step, or a later one if only optional ones are between; true if a step ended.
bool ProcedureRun::complete(std::int64_t time_us, const AttemptEvent* event) {
  const auto lasts = [&](const StateCondition& holding) {
    using enum StateCondition::What;
    if (holding.what != ProbeOnSkin && holding.what != AspiratingInVein) return holds(holding, metrics_.line());
    const auto& since_us = holding.what == ProbeOnSkin ? probeOnSkin_us_ : aspirating_us_;
    return since_us && static_cast<double>(time_us - *since_us) * 1e-6 >= holding.for_s;
  };
  for (std::size_t i = due_; i < steps_.size(); ++i) {
    const auto& until = procedure_.steps[i].until;
    const auto* happening = std::get_if<EventCondition>(&until);
    if (happening ? event && isAsRequested(*happening, *event) && (happening->wall != kVein || isTarget(*event))
                  : lasts(std::get<StateCondition>(until))) {
      for (; due_ < i; ++due_) steps_[due_] = {StepState::Skipped, time_us};
      steps_[due_++] = {StepState::Done, time_us};
      return true;
    }
    if (!procedure_.steps[i].optional) return false;
  }
  return false;
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
