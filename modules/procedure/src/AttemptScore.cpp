#include "LineWords.h"

#include <insonate/procedure/AttemptScore.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace insonate {
namespace {

const ProcedureRule& ruleOf(const ProcedureRun& run, const ProcedureRun::Finding& finding) {
  return run.procedure().rules[finding.rule];
}

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f", value);
  return text;
}

std::string positionSentence(double tilt_deg) {
  if (tilt_deg == 0) return "The patient lies flat.";
  return "The patient lies with the head " + rounded(std::abs(tilt_deg)) +
         (tilt_deg > 0 ? " degrees down." : " degrees up.");
}

/// "the right internal jugular vein"; "the vein" if the case does not name it.
std::string withArticle(const AttemptEvent& event, const ProcedureRun& run) {
  const std::string name = vesselName(event, run.vessels());
  if (name.empty()) return "the " + std::string(labelTable()[event.wall].name);
  return event.vessel == 0 || event.vessel == kUnnamedVessel ? name : "the " + name;
}

std::string capital(std::string text) {
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

bool isTargetVein(const AttemptEvent& event, const ProcedureRun& run) {
  return event.wall == kVein && (run.vessels().empty() || event.vessel == 1);
}

std::string veinSentence(const AttemptEvent& event, bool firstVein, const ProcedureRun& run) {
  const std::string name = withArticle(event, run);
  if (event.kind == AttemptEventKind::Left) return "The posterior wall of " + name + " is punctured.";
  if (isTargetVein(event, run)) return capital(name) + (firstVein ? " is reached." : " is punctured again.");
  return capital(name) + " is punctured, which is not the target: the " + run.vessels()[0] + ".";
}

std::string punctureSentence(const AttemptEvent& event, bool firstVein, const ProcedureRun& run) {
  if (event.wall == kSkin) return "The skin is punctured.";
  if (event.wall == kVein) return veinSentence(event, firstVein, run);
  if (event.wall == kArtery && event.kind == AttemptEventKind::Entered)
    return capital(withArticle(event, run)) + " is punctured.";
  return "The needle goes through the wall of: " + std::string(labelTable()[event.wall].name) + ".";
}

std::string findingText(const AttemptEvent& event, bool firstVein, const ProcedureRun& run) {
  switch (event.kind) {
    case AttemptEventKind::Entered:
    case AttemptEventKind::Left:
      return punctureSentence(event, firstVein, run);
    case AttemptEventKind::Withdrawn:
      return "The needle is out of the skin.";
    case AttemptEventKind::Struck:
      return "The needle meets bone.";
    case AttemptEventKind::NeedleReplaced:
      return "A new needle is taken.";
    case AttemptEventKind::Frozen:
      return "Image and needle are frozen.";
    case AttemptEventKind::Released:
      return "Image and needle are released.";
    case AttemptEventKind::Centered:
      return capital(withArticle(event, run)) + " is in the middle of the image.";
    case AttemptEventKind::Compressed:
      return capital(withArticle(event, run)) + " is compressed.";
    case AttemptEventKind::ColorShown:
      return "Color Doppler shows " + withArticle(event, run) + ".";
    case AttemptEventKind::Positioned:
      return positionSentence(event.tilt_deg);
    default:
      return lineSentence(event, withArticle(event, run));
  }
}

/// An event is not reported if a finding of the same moment reports it together with advice.
bool isToldByFinding(const AttemptEvent& event, const ProcedureRun& run) {
  const bool wrong = event.kind == AttemptEventKind::Struck || event.kind == AttemptEventKind::Left ||
                     (event.kind == AttemptEventKind::Entered && event.wall != kSkin && event.wall != kVein);
  return wrong && std::ranges::any_of(run.findings(), [&](const auto& f) { return f.time_us == event.time_us; });
}

std::vector<AttemptMoment> momentsOf(const ProcedureRun& run) {
  std::vector<AttemptMoment> moments;
  bool veinReached = false;
  for (const AttemptEvent& event : run.milestones()) {
    const bool vein = event.kind == AttemptEventKind::Entered && isTargetVein(event, run);
    if (!isToldByFinding(event, run))
      moments.push_back({event.time_us, findingText(event, !veinReached, run), std::nullopt});
    veinReached |= vein;
  }
  for (const ProcedureRun::Finding& finding : run.findings()) {
    const ProcedureRule& rule = ruleOf(run, finding);
    moments.push_back({finding.time_us, findingText(rule, finding), rule.severity});
  }
  std::ranges::stable_sort(moments, {}, &AttemptMoment::time_us);
  return moments;
}

/// Without a puncture of the skin, "no artery punctured" would be the value of an expert.
std::vector<MetricScore> metricScores(const ProcedureRun& run) {
  const MetricValues values = run.metrics().values();
  const bool isPunctured = values[Metric::Passes] > 0;
  std::vector<MetricScore> scores;
  for (const MetricDefinition& definition : metricTable()) {
    MetricScore score{definition.metric, values[definition.metric], std::nullopt, std::nullopt};
    const auto& norms = run.procedure().norms;
    if (const auto norm = std::ranges::find(norms, definition.metric, &MetricNorm::metric); norm != norms.end())
      score.norm = *norm;
    if (score.value && score.norm && isPunctured)
      score.share =
          100 * std::clamp((*score.value - score.norm->novice) / (score.norm->expert - score.norm->novice), 0.0, 1.0);
    scores.push_back(std::move(score));
  }
  return scores;
}

std::optional<double> pointsOf(const ProcedureRun& run, const AttemptScore& score) {
  double sum = 0, cost = 0;
  int shares = 0;
  for (const MetricScore& metric : score.metrics)
    if (metric.share) sum += *metric.share, ++shares;
  if (shares == 0) return std::nullopt;
  if (!score.criticalErrors.empty()) return 0;
  for (const ProcedureRun::Finding& finding : run.findings())
    cost += ruleOf(run, finding).severity == Severity::Major ? kMajorDeduction : kMinorDeduction;
  return std::clamp(sum / shares - cost, 0.0, score.succeeded ? 100 : kMaxPointsWithoutSuccess);
}

/// Advice of the earliest finding of this severity.
std::string adviceOn(const ProcedureRun& run, Severity severity) {
  for (const ProcedureRun::Finding& finding : run.findings())
    if (const ProcedureRule& rule = ruleOf(run, finding); rule.severity == severity)
      return rule.advice.empty() ? rule.text : rule.advice;
  return {};
}

/// The first mandatory step that was not done.
std::string adviceOnStep(const ProcedureRun& run) {
  const auto& steps = run.procedure().steps;
  for (std::size_t i = run.nextStep().value_or(steps.size()); i < steps.size(); ++i)
    if (!steps[i].optional)
      return "The attempt ended before '" + steps[i].title + "' was done: practice that step next.";
  return {};
}

/// Share from which a metric needs no advice: the value is nearly that of an expert.
constexpr double kNearlyExpert = 90;

std::string adviceOnMetric(const std::vector<MetricScore>& metrics) {
  const MetricScore* least = nullptr;
  for (const MetricScore& metric : metrics)
    if (metric.share && *metric.share < kNearlyExpert && (!least || *metric.share < *least->share)) least = &metric;
  return least ? least->norm->advice : "No improvement is needed: repeat the attempt in the same way.";
}

std::string adviceOf(const ProcedureRun& run, const std::vector<MetricScore>& metrics) {
  for (std::string advice : {adviceOn(run, Severity::Critical), adviceOn(run, Severity::Major), adviceOnStep(run),
                             adviceOn(run, Severity::Minor)})
    if (!advice.empty()) return advice;
  return adviceOnMetric(metrics);
}

}  // namespace

std::string vesselName(const AttemptEvent& event, const std::vector<std::string>& vessels) {
  using enum AttemptEventKind;
  const bool hasWall = event.kind <= Withdrawn || (event.kind >= Centered && event.kind <= InstrumentEntered) ||
                       event.kind == ColorShown || event.kind == BubblesSeen;
  if (!hasWall || (event.wall != kVein && event.wall != kArtery)) return {};
  if (event.vessel > 0 && event.vessel <= vessels.size()) return vessels[event.vessel - 1U];
  return event.wall == kVein && !vessels.empty() ? "another vein" : "";
}

std::string findingText(const ProcedureRule& rule, const ProcedureRun::Finding& finding) {
  return finding.vessel.empty() ? rule.text : capital(finding.vessel) + ": " + rule.text;
}

AttemptScore computeScore(const ProcedureRun& run, AttemptStatus status) {
  AttemptScore score;
  score.succeeded = status == AttemptStatus::Completed && run.succeeded();
  score.metrics = metricScores(run);
  score.moments = momentsOf(run);
  std::ranges::copy_if(score.moments, std::back_inserter(score.criticalErrors),
                       [](const AttemptMoment& moment) { return moment.severity == Severity::Critical; });
  score.points = pointsOf(run, score);
  score.advice = adviceOf(run, score.metrics);
  return score;
}

}  // namespace insonate
