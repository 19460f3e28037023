#include <insonate/curriculum/StoreUpkeep.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/teaching/RecomputedAttempts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace insonate {
namespace {

constexpr double kSame = 1e-9;
constexpr int kAtOnce = 500;

std::string textOf(const std::optional<double>& value) {
  if (!value) return "n/a";
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.10g", *value);
  return text.data();
}

std::string textOf(bool truth) {
  return truth ? "yes" : "no";
}

std::string textOf(AttemptState state) {
  return state == AttemptState::Completed ? "completed" : "abandoned";
}

bool isSame(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b) return !a && !b;
  return std::abs(*a - *b) <= kSame * std::max({1.0, std::abs(*a), std::abs(*b)});
}

/// Compares the values of one attempt one by one.
class Comparison {
 public:
  Comparison(const AttemptFacts& stored, RecomputedAttempts& into) : stored_(stored), into_(into) {}

  void differs(const std::string& field, const std::string& stored, const std::string& expected) {
    into_.differences.push_back({stored_.id, stored_.person, field, stored, expected});
  }
  void expect(const std::string& field, const std::string& stored, const std::string& expected) {
    if (stored != expected) differs(field, stored, expected);
  }
  void expect(const std::string& field, const std::optional<double>& stored, const std::optional<double>& expected) {
    if (!isSame(stored, expected)) differs(field, textOf(stored), textOf(expected));
  }
  void leaveOut(const std::string& what) { ++into_.notCompared[what]; }

  void expectOutcome(const AttemptFacts& fresh, int recordedVersion) {
    const int version = stored_.procedureVersion;
    if (version < recordedVersion || version > fresh.procedureVersion)
      return differs("procedure version", std::to_string(version),
                     std::to_string(recordedVersion) + " to " + std::to_string(fresh.procedureVersion));
    if (version < fresh.procedureVersion)
      return leaveOut("outcome and points: scored by version " + std::to_string(version) + " of " + stored_.procedure +
                      ", which is at " + std::to_string(fresh.procedureVersion) + " here");
    expect("succeeded", textOf(stored_.succeeded), textOf(fresh.succeeded));
    expect("critical errors", std::to_string(stored_.criticalErrors), std::to_string(fresh.criticalErrors));
    expect("points", stored_.points, fresh.points);
  }

  void expectMetrics(const AttemptFacts& fresh) {
    for (const MetricFact& metric : stored_.metrics) {
      const auto found = std::ranges::find(fresh.metrics, metric.id, &MetricFact::id);
      if (found == fresh.metrics.end())
        leaveOut("metric " + metric.id + ": not defined here");
      else if (metric.version > found->version)
        differs("version of metric " + metric.id, std::to_string(metric.version), std::to_string(found->version));
      else if (metric.version < found->version)
        leaveOut("metric " + metric.id + ": measured by definition " + std::to_string(metric.version) + ", " +
                 std::to_string(found->version) + " here");
      else
        expect("metric " + metric.id, metric.value, found->value);
    }
    for (const MetricFact& metric : fresh.metrics)
      if (std::ranges::find(stored_.metrics, metric.id, &MetricFact::id) == stored_.metrics.end())
        leaveOut("metric " + metric.id + ": not stored, as in attempts from before it was defined");
  }

  Result<void> expectEvents(const AttemptRecording& recording, const CompareEvents& events, const Progress& progress) {
    if (!events) return {};
    const auto found = events(recording, progress);
    if (!found && found.error().message == kCancelled) return tl::unexpected(found.error());
    if (!found) {
      ++into_.eventsNotCompared[found.error().message];
      return {};
    }
    for (const EventDifference& one : *found) differs(one.what, one.recorded, one.expected);
    return {};
  }

  void expectBeginning(const AttemptFacts& fresh) {
    expect("procedure", stored_.procedure, fresh.procedure);
    expect("case", stored_.caseName, fresh.caseName);
    expect("case hash", stored_.caseHash, fresh.caseHash);
    expect("begun, us since 1970", std::to_string(stored_.begun_us), std::to_string(fresh.begun_us));
  }

 private:
  const AttemptFacts& stored_;
  RecomputedAttempts& into_;
};

/// Reason why an attempt cannot be recomputed; empty if it can be.
std::string whyNotRecomputed(const StoredAttempt& kept) {
  if (kept.crashed) return "the recording stopped early";
  if (kept.facts.recording.empty()) return "it has no recording";
  if (!kept.recordingFile.empty()) return "";
  return "its recording '" + kept.facts.recording + "' of " + kept.facts.workstation + " is not kept by this store";
}

Result<void> recompute(const StoredAttempt& kept, const CompareEvents& events, const Progress& progress,
                       RecomputedAttempts& into) {
  const AttemptFacts& facts = kept.facts;
  std::string why = whyNotRecomputed(kept);
  if (why.empty())
    if (const auto compared = compareWithRecording(facts, kept.recordingFile, into, events, progress); !compared)
      why = compared.error().message;
  if (why == kCancelled) return fail(why);
  if (!why.empty()) into.left.push_back({facts.id, facts.person, why});
  return {};
}

void flag(PlausibilityCheck& check, const AttemptFacts& facts, RecomputedAttempts& into) {
  RecomputedAttempts::Flagged flagged{facts.id, facts.person, {}};
  for (const Implausible flag : check.check(facts)) flagged.words.push_back(displayText(flag, facts));
  if (!flagged.words.empty()) into.implausible.push_back(std::move(flagged));
}

}  // namespace

Result<void> compareWithRecording(const AttemptFacts& stored, const std::filesystem::path& file,
                                  RecomputedAttempts& into, const CompareEvents& events, const Progress& progress) {
  Comparison comparison(stored, into);
  const auto hash = recordingHash(file);
  if (!hash) return tl::unexpected(hash.error());
  if (*hash != stored.recordingHash) {
    ++into.compared;
    comparison.differs("recording hash", stored.recordingHash, *hash);
    return {};
  }
  const auto recording = AttemptRecording::open(file);
  if (!recording) return tl::unexpected(recording.error());
  const auto fresh = factsOfRecording(file, Hands::PersonOrScript);
  if (!fresh) return tl::unexpected(fresh.error());
  ++into.compared;
  if (recording->header().isScripted) comparison.differs("hands", "a person's", "a script's");
  comparison.expectBeginning(*fresh);
  if (stored.state != AttemptState::Voided) comparison.expect("state", textOf(stored.state), textOf(fresh->state));
  comparison.expect("length, us", std::to_string(stored.length_us), std::to_string(fresh->length_us));
  if (!stored.handsHash.empty()) comparison.expect("hash of the hands", stored.handsHash, fresh->handsHash);
  comparison.expectOutcome(*fresh, recording->header().procedureVersion);
  comparison.expectMetrics(*fresh);
  return comparison.expectEvents(*recording, events, progress);
}

Result<RecomputedAttempts> recomputeAttempts(const SignedIn& by, const CompareEvents& events,
                                             const Progress& progress) {
  RecomputedAttempts all;
  const auto facts = StoreUpkeep(by).facts();
  if (!facts) return tl::unexpected(facts.error());
  const double total = static_cast<double>(std::max<std::int64_t>(1, facts->attempts));
  PlausibilityCheck plausibility;
  double done = 0;
  for (std::int64_t after = 0;;) {
    const auto page = StoreCheck(by).attempts(after, kAtOnce);
    if (!page) return tl::unexpected(page.error());
    if (page->empty()) return all;
    after = page->back().arrival;
    for (const StoredAttempt& kept : *page) {
      const double share = std::min(1.0, done++ / total);
      const Progress within = [&](std::string_view, double) { return report(progress, "recomputing attempts", share); };
      if (!within({}, 0)) return fail(std::string(kCancelled));
      if (kept.facts.state == AttemptState::Open) continue;
      if (const auto compared = recompute(kept, events, within, all); !compared)
        return tl::unexpected(compared.error());
      flag(plausibility, kept.facts, all);
    }
  }
}

Result<RecomputedAttempts> compareDatabase(const SignedIn& by, const CompareEvents& events, const Progress& progress) {
  auto found = recomputeAttempts(by, events, progress);
  if (!found) return found;
  for (const auto& more : {StoreCheck(by).againstLog(), StoreCheck(by).standings()}) {
    if (!more) return tl::unexpected(more.error());
    found->differences.insert(found->differences.end(), more->begin(), more->end());
  }
  return found;
}

}  // namespace insonate
