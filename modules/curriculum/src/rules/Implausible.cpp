#include <insonate/curriculum/Implausible.h>

#include <algorithm>
#include <cstdio>

namespace insonate {
namespace {

std::optional<double> valueOf(const std::vector<MetricFact>& metrics, std::string_view id) {
  const auto found = std::ranges::find(metrics, id, &MetricFact::id);
  return found == metrics.end() ? std::nullopt : found->value;
}

/// A missing value counts as 0: the event did not happen.
double amountOf(const AttemptFacts& facts, std::string_view id) {
  return valueOf(facts.metrics, id).value_or(0);
}

double length_s(const AttemptFacts& facts) {
  return static_cast<double>(facts.length_us) * 1e-6;
}

/// A steady probe after the puncture is good practice if the probe moved before: the path alone is not implausible.
bool isWithoutProbe(const AttemptFacts& facts) {
  return !facts.metrics.empty() && amountOf(facts, "probe_path_mm") <= 0 && amountOf(facts, "vein_checks") <= 0 &&
         amountOf(facts, "tip_in_picture_percent") <= 0;
}

std::string seconds(double value_s) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f\u00a0s", value_s);
  return text;
}

}  // namespace

std::string_view idOf(Implausible flag) {
  switch (flag) {
    case Implausible::WithoutProbe:
      return "without_probe";
    case Implausible::FastToVein:
      return "fast_to_vein";
    case Implausible::WithoutNeedlePath:
      return "without_needle_path";
    case Implausible::Short:
      return "short";
    case Implausible::SameValues:
      return "same_values";
  }
  return "";
}

std::string displayText(Implausible flag, const AttemptFacts& facts) {
  switch (flag) {
    case Implausible::WithoutProbe:
      return "the probe was not used";
    case Implausible::FastToVein:
      return "implausibly fast: time to vein " + seconds(amountOf(facts, "time_to_vein_s"));
    case Implausible::WithoutNeedlePath:
      return "the needle's tip did not move";
    case Implausible::Short:
      return "implausibly short: completed in " + seconds(length_s(facts));
    case Implausible::SameValues:
      return "all values of an earlier attempt";
  }
  return "";
}

std::vector<Implausible> implausibilities(const AttemptFacts& facts) {
  std::vector<Implausible> flags;
  // A failure gains nothing: an attempt that is finished at once by mistake is not a forgery.
  if (!facts.succeeded) return flags;
  const bool isCompleted = facts.state == AttemptState::Completed;
  const auto toVein_s = valueOf(facts.metrics, "time_to_vein_s");
  const bool isInserted = amountOf(facts, "passes") > 0 || amountOf(facts, "vein_punctures") > 0;
  if (isCompleted && isWithoutProbe(facts)) flags.push_back(Implausible::WithoutProbe);
  if (toVein_s && *toVein_s < kFastToVein_s) flags.push_back(Implausible::FastToVein);
  if (isInserted && amountOf(facts, "needle_path_mm") <= 0) flags.push_back(Implausible::WithoutNeedlePath);
  if (isCompleted && length_s(facts) < kShort_s) flags.push_back(Implausible::Short);
  return flags;
}

bool describesNeedle(const std::vector<MetricFact>& metrics) {
  return valueOf(metrics, "passes").value_or(0) > 0;
}

std::vector<Implausible> PlausibilityCheck::check(const AttemptFacts& facts) {
  std::vector<Implausible> flags = implausibilities(facts);
  if (!facts.succeeded || !describesNeedle(facts.metrics)) return flags;
  std::vector<std::optional<double>> values;
  for (const MetricFact& metric : facts.metrics) values.push_back(metric.value);
  if (!values_.insert(std::move(values)).second) flags.push_back(Implausible::SameValues);
  return flags;
}

}  // namespace insonate
