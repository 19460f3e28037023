#include "store/AttemptRows.h"
#include "store/Texts.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace insonate::store {
namespace {

constexpr std::size_t kMaxMetrics = 500;

bool isHash(const std::string& text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

Result<void> checkMetrics(const std::vector<MetricFact>& metrics) {
  if (metrics.size() > kMaxMetrics)
    return fail("The attempt has " + std::to_string(metrics.size()) + " metrics. The maximum is 500.");
  std::set<std::string> ids;
  for (const MetricFact& metric : metrics) {
    if (auto ok = checkText("The metric's id", metric.id, 200); !ok) return ok;
    if (metric.id.empty() || !ids.insert(metric.id).second)
      return fail("The attempt has the metric '" + metric.id +
                  "' twice, or a metric without an id. List each metric once, with its id.");
    if (metric.value && !std::isfinite(*metric.value))
      return fail("The metric '" + metric.id + "' is not a finite number; leave it out where it was not measured.");
  }
  return {};
}

}  // namespace

Result<void> checkBegun(const AttemptFacts& facts) {
  if (!isUuid(facts.id))
    return fail("'" + facts.id.substr(0, 100) + "' is not a UUID in lower case, but the id of an attempt must be one.");
  const std::pair<const char*, const std::string*> texts[] = {{"The attempt's curriculum", &facts.curriculum},
                                                              {"The attempt's level", &facts.level},
                                                              {"The attempt's procedure", &facts.procedure},
                                                              {"The name of the attempt's case", &facts.caseName},
                                                              {"The hash of the attempt's case", &facts.caseHash}};
  for (const auto& [what, text] : texts)
    if (auto ok = checkText(what, *text); !ok) return ok;
  if (facts.curriculumVersion < 0 || facts.procedureVersion < 0)
    return fail("The attempt's version of its curriculum or procedure is negative; versions count from 1.");
  return {};
}

Result<void> checkEnded(const AttemptFacts& facts) {
  if (facts.state != AttemptState::Completed && facts.state != AttemptState::Abandoned)
    return fail("An attempt can only end as completed or abandoned. It can be voided afterwards, with a reason.");
  if (facts.length_us < 0 || facts.criticalErrors < 0)
    return fail("The attempt's length or its number of critical errors is negative; they count from 0.");
  if (facts.points && !(*facts.points >= 0 && *facts.points <= 100))
    return fail("The attempt's points are not within 0 and 100; leave them out where there are none.");
  if (auto ok = checkText("The name of the attempt's recording", facts.recording); !ok) return ok;
  if (facts.recording.find_first_of("/\\") != std::string::npos || facts.recording == "..")
    return fail("The attempt's recording '" + facts.recording + "' is not a file name. Leave out the folder.");
  if (!facts.recordingHash.empty() && !isHash(facts.recordingHash))
    return fail("The hash of the attempt's recording is not a SHA-256 in lower-case hexadecimal digits.");
  if (!facts.handsHash.empty() && !isHash(facts.handsHash))
    return fail("The hash of the hands' motion in the attempt does not have 64 lower-case hexadecimal digits.");
  return checkMetrics(facts.metrics);
}

bool sameBeginning(const AttemptFacts& a, const AttemptFacts& b) {
  const auto beginning = [](const AttemptFacts& of) {
    return std::tie(of.id, of.person, of.curriculum, of.curriculumVersion, of.level, of.procedure, of.procedureVersion,
                    of.caseName, of.caseHash, of.begun_us);
  };
  return beginning(a) == beginning(b);
}

bool sameEnd(const AttemptFacts& a, const AttemptFacts& b) {
  const auto end = [](const AttemptFacts& of) {
    return std::tie(of.length_us, of.state, of.succeeded, of.criticalErrors, of.points, of.metrics, of.recording,
                    of.recordingHash, of.handsHash);
  };
  return end(a) == end(b);
}

}  // namespace insonate::store
