#include "Answer.h"
#include "Groups.h"
#include "Lookup.h"
#include "StoreCounts.h"

#include <insonate/curriculum/AuditAnchors.h>
#include <insonate/simulator/EventCheck.h>
#include <insonate/teaching/RecomputedAttempts.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace insonate::cli {
namespace {

struct VerifyOptions {
  std::string anchor, anchorFile, cases;
};

Result<std::vector<AuditAnchor>> anchorsOf(const VerifyOptions& options) {
  std::vector<AuditAnchor> anchors;
  if (!options.anchorFile.empty()) {
    auto read = readAuditAnchors(options.anchorFile);
    if (!read) return read;
    anchors = std::move(*read);
  }
  if (options.anchor.empty()) return anchors;
  auto one = parseAuditAnchor(options.anchor);
  if (!one) return tl::unexpected(one.error());
  anchors.push_back(std::move(*one));
  return anchors;
}

/// Pages, keys, hashes and the log.
Result<void> verifyWhole(const SignedIn& by, const std::vector<AuditAnchor>& anchors) {
  if (auto whole = StoreUpkeep(by).verify(); !whole || anchors.empty()) return whole;
  return AuditLog(by).verify(anchors);
}

class Names {
 public:
  explicit Names(std::vector<Person> people) : people_(std::move(people)) {}
  /// The id of who is not there.
  std::string of(const std::string& id) const {
    const auto found = std::ranges::find(people_, id, &Person::id);
    return found == people_.end() ? id : found->name;
  }

 private:
  std::vector<Person> people_;
};

Json toJson(const RecomputedAttempts& found, const Names& names) {
  Json differences = Json::array(), left = Json::array(), implausible = Json::array(), notCompared = Json::array();
  for (const StoreDifference& one : found.differences)
    differences.push_back({{"attempt", one.attempt.empty() ? Json(nullptr) : Json(one.attempt)},
                           {"person", one.person},
                           {"person_name", names.of(one.person)},
                           {"field", one.field},
                           {"stored", one.stored},
                           {"expected", one.expected}});
  for (const RecomputedAttempts::Left& one : found.left)
    left.push_back(
        {{"attempt", one.attempt}, {"person", one.person}, {"person_name", names.of(one.person)}, {"why", one.why}});
  for (const RecomputedAttempts::Flagged& one : found.implausible) {
    std::string why;
    for (const std::string& word : one.words) why += (why.empty() ? "" : "; ") + word;
    implausible.push_back(
        {{"attempt", one.attempt}, {"person", one.person}, {"person_name", names.of(one.person)}, {"why", why}});
  }
  Json eventsNotCompared = Json::array();
  for (const auto& [why, attempts] : found.eventsNotCompared)
    eventsNotCompared.push_back({{"why", why}, {"attempts", attempts}});
  for (const auto& [what, attempts] : found.notCompared)
    notCompared.push_back({{"what", what}, {"attempts", attempts}});
  return {{"recomputed", found.compared},
          {"differences", differences},
          {"not_recomputed", left},
          {"not_compared", notCompared},
          {"events_not_computed", eventsNotCompared},
          {"implausible", implausible}};
}

std::string section(const std::string& title, const Json& rows, const std::vector<Column>& columns) {
  constexpr std::size_t kShown = 50;
  if (rows.empty()) return "";
  if (rows.size() <= kShown) return title + "\n" + tableOf(rows, columns);
  const Json first(std::vector<Json>(rows.begin(), rows.begin() + kShown));
  return title + "\n" + tableOf(first, columns) + "and " + std::to_string(rows.size() - kShown) +
         " more; --json names all.\n";
}

/// Sentences: which attempts were compared, which were not and why, and which need attention.
std::string textOf(const Json& found) {
  const std::vector<Column> whose{{"person_name", "person"}, {"attempt", "attempt"}, {"why", "why"}};
  const auto titled = [&](const char* key, const std::string& title, const std::vector<Column>& columns) {
    return section(title + " (" + std::to_string(found[key].size()) + "):", found[key], columns);
  };
  return "Attempts recomputed from their recordings: " + found["recomputed"].dump() + "\n" +
         titled("not_recomputed", "Attempts that cannot be recomputed", whose) +
         titled("not_compared", "Values that are not compared", {{"what", "what"}, {"attempts", "attempts"}}) +
         titled("events_not_computed", "Needle events that cannot be computed again",
                {{"why", "why"}, {"attempts", "attempts"}}) +
         titled("implausible", "Implausible attempts, to look at in Review", whose) +
         titled("differences", "Values that do not agree",
                {{"person_name", "person"},
                 {"attempt", "attempt"},
                 {"field", "value"},
                 {"stored", "stored"},
                 {"expected", "expected"}});
}

Result<Answer> verify(const SignedIn& by, const VerifyOptions& options) {
  const auto anchors = anchorsOf(options);
  if (!anchors) return tl::unexpected(anchors.error());
  if (auto whole = verifyWhole(by, *anchors); !whole) return tl::unexpected(whole.error());
  EventCheck check({options.cases});
  const CompareEvents events = [&](const AttemptRecording& recording, const Progress& progress) {
    return check.compare(recording, progress);
  };
  const auto found = compareDatabase(by, events, terminalProgress());
  if (!found) return tl::unexpected(found.error());
  auto people = visiblePeople(by);
  if (!people) return tl::unexpected(people.error());
  const auto facts = StoreUpkeep(by).facts();
  if (!facts) return tl::unexpected(facts.error());
  Answer answer{toJson(*found, Names(std::move(*people))), ""};
  answer.text = textOf(answer.object);
  answer.object.update({{"whole", found->differences.empty()}, {"anchor", nullptr}});
  answer.object.update(countsJson(*facts));
  if (!found->differences.empty()) {
    answer.failure = facts->place + " does not agree with its recordings, its log and its attempts: " +
                     std::to_string(found->differences.size()) +
                     " values differ, and no anchor is given. Another program has written to the database. Compare the "
                     "database with a backup.";
    return answer;
  }
  const auto anchor = AuditLog(by).anchor();
  if (!anchor) return tl::unexpected(anchor.error());
  const std::string now = std::to_string(anchor->number) + ":" + anchor->hash;
  answer.object["anchor"] = now;
  answer.text += facts->place + " is intact: " + countsOf(*facts) +
                 ".\nKeep this anchor in another place. Later it shows whether the log was rewritten: --anchor " + now;
  return answer;
}

}  // namespace

void addVerifyCommand(CLI::App& curriculum, Outcome& outcome) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = addSignedInCommand(
      curriculum, outcome, "verify",
      "Verify a store: check its pages, keys and hashes, and compare its attempts and standings with "
      "recordings and log",
      [options](const SignedIn& by) { return verify(by, *options); });
  command->add_option("--anchor", options->anchor,
                      "NUMBER:HASH from an earlier verify: checks that the log was not rewritten since");
  command->add_option("--anchors", options->anchorFile,
                      "File of anchors that insonate-server writes: checks that the log was not rewritten since");
  command
      ->add_option("--cases", options->cases,
                   "Folder of case folders, in which the needle events of attempts are computed again; built-in cases "
                   "need none")
      ->check(CLI::ExistingDirectory);
}

}  // namespace insonate::cli
