#include "Answer.h"
#include "Groups.h"
#include "LevelPath.h"
#include "Lookup.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/Implausible.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/RepeatedValues.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/teaching/AttemptProofOf.h>

#include <QtCore/QUuid>
#include <algorithm>
#include <memory>
#include <set>

namespace insonate::cli {
namespace {

struct AddArguments {
  std::string recording, level, className;
};

struct ListArguments {
  std::string person;
  int count = 20;
  std::int64_t before = 0;
};

/// Arguments of `void` and `accept`.
struct ReasonArguments {
  std::string attempt, reason;
};

Json factsJson(const AttemptFacts& facts) {
  Json metrics = Json::object();
  for (const MetricFact& metric : facts.metrics) metrics[metric.id] = orNull(metric.value);
  return {{"id", facts.id},
          {"curriculum", facts.curriculum},
          {"curriculum_version", facts.curriculumVersion},
          {"level", facts.level},
          {"procedure", facts.procedure},
          {"case", facts.caseName},
          {"workstation", facts.workstation},
          {"begun", timeText(facts.begun_us)},
          {"length_s", static_cast<double>(facts.length_us) * 1e-6},
          {"state", nameOf(facts.state)},
          {"broke_off", hasBrokenOff(facts)},
          {"voided", facts.state == AttemptState::Voided},
          {"succeeded", isSuccess(facts)},
          {"critical_errors", facts.criticalErrors},
          {"points", orNull(pointsOf(facts))},
          {"recording", facts.recording},
          {"proof", nameOf(facts.proof)},
          {"metrics", metrics}};
}

/// Null if the level is no test.
Json sittingJson(const Level& level, const AttemptFacts& facts) {
  return level.assistance == Assistance::Test ? Json(nameOf(facts.testConditions)) : Json(nullptr);
}

/// The class by whose curriculum an attempt counts: the one that is named, else the only one that has the level.
Result<Curriculum> curriculumFor(const SignedIn& by, const AddArguments& a) {
  const auto classes = classesOf(by, by.person());
  if (!classes) return tl::unexpected(classes.error());
  std::vector<Curriculum> found;
  for (const Cohort& cohort : *classes) {
    if (cohort.curriculum.empty() || (!a.className.empty() && !sameName(a.className, cohort.name))) continue;
    auto curriculum = curriculumOf(by, cohort);
    if (!curriculum) return curriculum;
    if (curriculum->level(a.level) && std::ranges::find(found, *curriculum) == found.end())
      found.push_back(std::move(*curriculum));
  }
  if (found.empty())
    return fail("No class of yours has a level '" + a.level +
                "'; 'curriculum levels' lists the levels of your classes.");
  if (found.size() > 1)
    return fail("More than one of your classes has a level '" + a.level + "'; name one with --class.");
  return std::move(found.front());
}

/// The same for the same recording of the same person, so that what is added twice is there once.
std::string idOf(const AttemptFacts& facts, const Person& person) {
  const QUuid space = QUuid::fromString(QString::fromStdString(person.id));
  return QUuid::createUuidV5(space, QString::fromStdString(facts.recordingHash))
      .toString(QUuid::WithoutBraces)
      .toStdString();
}

/// Why an attempt that nothing proves does not count yet; "" for others.
std::string noteOf(const AttemptProofOf& proven, const std::string& attempt) {
  if (proven.proof == AttemptProof::Proven) return "";
  return "\nNot proven: " + proven.why +
         " A pass counts once an instructor accepts the attempt ('curriculum attempts accept " + attempt +
         " --reason ...').";
}

/// The level of facts that name one already, as those of a recording made for it.
Result<Curriculum> curriculumOfFacts(const SignedIn& by, const AttemptFacts& facts, const AddArguments& a) {
  auto curriculum = curriculumFor(by, a);
  if (!curriculum || facts.curriculum.empty()) return curriculum;
  if (curriculum->name == facts.curriculum && curriculum->version == facts.curriculumVersion) return curriculum;
  return fail(a.recording + " was recorded for version " + std::to_string(facts.curriculumVersion) + " of '" +
              facts.curriculum + "', but none of your classes uses it. Ask an instructor.");
}

Result<Answer> addToLevel(const SignedIn& by, AttemptFacts facts, const AddArguments& a, const AttemptProofOf& proven) {
  const auto curriculum = curriculumOfFacts(by, facts, a);
  if (!curriculum) return tl::unexpected(curriculum.error());
  const Level& level = *curriculum->level(a.level);
  if (level.procedure != facts.procedure)
    return fail(a.recording + " is an attempt at '" + facts.procedure + "', and level '" + level.name + "' asks for '" +
                level.procedure + "'; choose another level or recording.");
  facts.curriculum = curriculum->name, facts.curriculumVersion = curriculum->version, facts.level = level.name;
  if (auto added = AttemptStore(by).add(facts, a.recording); !added) return tl::unexpected(added.error());
  const auto kept = AttemptStore(by).attempt(facts.id);
  if (!kept) return tl::unexpected(kept.error());
  facts.testConditions = kept->facts.testConditions;
  const auto path = levelPath(by, *curriculum, by.person().id);
  if (!path) return tl::unexpected(path.error());
  const LevelProgress& progress = *std::ranges::find(*path, level.name, &LevelProgress::level);
  const bool passed = judge(level.pass, facts).passed;
  const std::vector<std::string> missedOnes = missedStandards(level.pass, facts);
  std::string missed;
  for (const std::string& one : missedOnes) missed += (missed.empty() ? ", and missed: " : "; ") + one;
  return Answer{{{"attempt", factsJson(facts)},
                 {"passed", passed},
                 {"counts", isCounted(facts, level)},
                 {"sitting", sittingJson(level, facts)},
                 {"missed_standards", missedOnes},
                 {"level", level.name},
                 {"state", nameOf(progress.state)},
                 {"why", progress.why}},
                (countsAsPractice(facts, level) ? outcomeWords(facts, &*curriculum)
                 : passed                       ? "Passed" + missed
                                                : "Not passed: " + reasonOfFailure(level.pass, facts)) +
                    ". " + level.title + ": " + progress.why + "\nAttempt " + facts.id + noteOf(proven, facts.id)};
}

Result<Answer> add(const SignedIn& by, AddArguments a) {
  auto facts = factsOfRecording(a.recording);
  if (!facts) return tl::unexpected(facts.error());
  facts->person = by.person().id;
  const auto proven = proofOfAttempt(AttemptStore(by), *facts, a.recording);
  if (!proven) return tl::unexpected(proven.error());
  facts->proof = proven->proof;
  if (!proven->isOfStore) {
    facts->id = idOf(*facts, by.person());
    facts->curriculum.clear(), facts->curriculumVersion = 0, facts->level.clear();
  } else if (!a.level.empty() && a.level != facts->level) {
    return fail(a.recording + " was recorded " +
                (facts->level.empty() ? "in free practice" : "for the level '" + facts->level + "'") +
                " and counts only for this level. Leave out --level.");
  } else {
    a.level = facts->level;
  }
  if (!a.level.empty()) return addToLevel(by, std::move(*facts), a, *proven);
  if (auto kept = AttemptStore(by).add(*facts, a.recording); !kept) return tl::unexpected(kept.error());
  return Answer{{{"attempt", factsJson(*facts)}, {"passed", nullptr}, {"level", nullptr}},
                "Stored as free practice, attempt " + facts->id};
}

/// The curricula of a person's classes, by which their attempts pass.
Result<std::vector<Curriculum>> curriculaOf(const SignedIn& by, const Person& person) {
  const auto classes = classesOf(by, person);
  if (!classes) return tl::unexpected(classes.error());
  std::vector<Curriculum> curricula;
  for (const Cohort& cohort : *classes) {
    if (cohort.curriculum.empty()) continue;
    auto curriculum = curriculumOf(by, cohort);
    if (!curriculum) return tl::unexpected(curriculum.error());
    curricula.push_back(std::move(*curriculum));
  }
  return curricula;
}

/// "passed", "assistance" and "sitting", by the first class whose curriculum has the level; null where none has.
Json judgedBy(const std::vector<Curriculum>& curricula, const AttemptFacts& facts) {
  for (const Curriculum& curriculum : curricula)
    if (const Level* level = levelOf(curriculum, facts))
      return {{"passed", orNull(passedIn(curriculum, facts))},
              {"assistance", nameOf(level->assistance)},
              {"sitting", sittingJson(*level, facts)}};
  return {{"passed", nullptr}, {"assistance", nullptr}, {"sitting", nullptr}};
}

/// Why an attempt needs attention, as ids and as words for a table.
Json flagsOf(const AttemptFacts& facts, const std::set<std::string>& repeated) {
  std::vector<Implausible> flags = implausibilities(facts);
  if (repeated.contains(facts.id)) flags.push_back(Implausible::SameValues);
  Json ids = Json::array();
  std::string words;
  for (const Implausible flag : flags) {
    ids.push_back(idOf(flag));
    words += (words.empty() ? "" : "; ") + displayText(flag, facts);
  }
  return {{"flags", ids}, {"flagged", words}};
}

/// Numbers of comments, and their words for a table.
Json commentsJson(const CommentStore::Count& count) {
  return {{"comments", count.all}, {"unread_comments", count.unread}, {"commented", commentCountText(count)}};
}

Result<Answer> listAttempts(const SignedIn& by, const ListArguments& a) {
  const auto person = personNamed(by, a.person);
  if (!person) return tl::unexpected(person.error());
  const auto page = AttemptStore(by).page(person->id, a.count, a.before);
  if (!page) return tl::unexpected(page.error());
  const auto curricula = curriculaOf(by, *person);
  if (!curricula) return tl::unexpected(curricula.error());
  const auto comments = CommentStore(by).countsOf(person->id);
  if (!comments) return tl::unexpected(comments.error());
  // For who teaches: of one's own attempts nothing is said.
  const bool isOwn = person->id == by.person().id;
  const auto repeated = isOwn ? Result<std::set<std::string>>() : repeatedValues(by, person->id);
  if (!repeated) return tl::unexpected(repeated.error());
  Json rows = Json::array();
  for (const StoredAttempt& attempt : *page) {
    rows.push_back(factsJson(attempt.facts));
    rows.back().update(judgedBy(*curricula, attempt.facts));
    if (!isOwn) rows.back().update(flagsOf(attempt.facts, *repeated));
    const auto commented = comments->find(attempt.facts.id);
    rows.back().update(commentsJson(commented == comments->end() ? CommentStore::Count{} : commented->second));
    rows.back().update(
        {{"arrival", attempt.arrival},
         {"crashed", attempt.crashed},
         {"recording_file", attempt.recordingFile.empty() ? Json(nullptr) : Json(attempt.recordingFile.string())},
         {"void_reason", attempt.voidReason.empty() ? Json(nullptr) : Json(attempt.voidReason)}});
  }
  std::vector<Column> columns{{"begun", "begun"},
                              {"level", "level"},
                              {"assistance", "assistance"},
                              {"state", "state"},
                              {"broke_off", "broke off"},
                              {"succeeded", "succeeded"},
                              {"passed", "passed"},
                              {"critical_errors", "critical"},
                              {"points", "points"},
                              {"proof", "proof"},
                              {"sitting", "sitting"},
                              {"commented", "comments"},
                              {"id", "attempt"}};
  if (!isOwn) columns.push_back({"flagged", "needs attention"});
  return Answer{{{"person", toJson(*person)}, {"attempts", rows}},
                rows.empty() ? "No attempts yet. Add one from its recording with 'curriculum attempts add'."
                             : tableOf(rows, columns)};
}

Result<Answer> voidOne(const SignedIn& by, const ReasonArguments& a) {
  if (auto done = AttemptStore(by).voidAttempt(a.attempt, a.reason); !done) return tl::unexpected(done.error());
  return Answer{{{"id", a.attempt}, {"state", "voided"}, {"void_reason", a.reason}},
                "The attempt no longer counts. The attempt and the reason are kept."};
}

Result<Answer> accept(const SignedIn& by, const ReasonArguments& a) {
  if (auto done = AttemptStore(by).accept(a.attempt, a.reason); !done) return tl::unexpected(done.error());
  return Answer{{{"id", a.attempt}, {"proof", nameOf(AttemptProof::Accepted)}},
                "The attempt counts now. Your name and the reason are in the audit log."};
}

}  // namespace

void addAttemptCommands(CLI::App& curriculum, Outcome& outcome) {
  CLI::App& attempts = *curriculum.add_subcommand("attempts", "Manage the attempts of users");
  attempts.require_subcommand(1);
  auto added = std::make_shared<AddArguments>();
  CLI::App* adding =
      addSignedInCommand(attempts, outcome, "add",
                         "Add an attempt of your own from its recording; the store keeps a copy of the recording",
                         [added](const SignedIn& by) { return add(by, *added); });
  adding->add_option("RECORDING", added->recording, "Recording of an attempt that a person made in the window")
      ->required()
      ->check(notEmpty());
  adding->add_option("--level", added->level, "Level of the attempt (default: free practice)");
  adding->add_option("--class", added->className,
                     "Class in which the attempt counts, if several classes have the level");

  auto listed = std::make_shared<ListArguments>();
  CLI::App* listing = addSignedInCommand(attempts, outcome, "list", "List a person's attempts, newest first",
                                         [listed](const SignedIn& by) { return listAttempts(by, *listed); });
  listing->add_option("NAME", listed->person, "Name of the person (default: you)");
  listing->add_option("--count", listed->count, "Maximum number of attempts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  listing->add_option("--before", listed->before, "List only attempts with an arrival number below this (see --json)")
      ->check(CLI::PositiveNumber);

  auto accepted = std::make_shared<ReasonArguments>();
  CLI::App* accepting =
      addSignedInCommand(attempts, outcome, "accept", "Accept an attempt that is not proven, so that it counts",
                         [accepted](const SignedIn& by) { return accept(by, *accepted); });
  accepting->add_option("ATTEMPT", accepted->attempt, "The attempt's id, from 'attempts list'")->required();
  accepting->add_option("--reason", accepted->reason, "Reason to trust the attempt")->required();

  auto voided = std::make_shared<ReasonArguments>();
  CLI::App* voiding =
      addSignedInCommand(attempts, outcome, "void", "Exclude an attempt from the count; the attempt stays in the list",
                         [voided](const SignedIn& by) { return voidOne(by, *voided); });
  voiding->add_option("ATTEMPT", voided->attempt, "The attempt's id, from 'attempts list'")->required();
  voiding->add_option("--reason", voided->reason, "Reason, which the trainee can read")->required();
  addCommentCommands(attempts, outcome);
}

}  // namespace insonate::cli
