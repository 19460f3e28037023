#include "Answer.h"
#include "Groups.h"
#include "Lookup.h"

#include <insonate/curriculum/OpeningStore.h>

#include <QtCore/QDateTime>
#include <QtCore/QString>
#include <algorithm>
#include <map>
#include <memory>

namespace insonate::cli {
namespace {

struct OpenArguments {
  std::string className, everyoneOf, level, from, until, code;
};

struct EnterArguments {
  std::string level, className, code;
};

/// Local time unless the text ends with Z or an offset.
Result<std::optional<std::int64_t>> timeOf(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const QDateTime time = QDateTime::fromString(QString::fromStdString(text).replace(' ', 'T'), Qt::ISODate);
  if (time.isValid()) return time.toMSecsSinceEpoch() * 1000;
  return fail("'" + text + "' is not a time. Write it as 2026-12-01T14:30 in local time, or with Z at its end in UTC.");
}

Json rowOf(const TestOpening& opening, const std::map<std::string, std::string>& classes, std::int64_t now_us) {
  const auto found = classes.find(opening.cohort);
  const auto timeOrNull = [](const std::optional<std::int64_t>& time_us) {
    return time_us ? Json(timeText(*time_us)) : Json(nullptr);
  };
  return {{"id", opening.id},
          {"class", opening.cohort.empty()   ? "(everyone)"
                    : found == classes.end() ? opening.cohort
                                             : found->second},
          {"curriculum", opening.curriculum},
          {"level", opening.level},
          {"start", timeText(opening.start_us)},
          {"end", timeOrNull(opening.end_us)},
          {"code", opening.hasCode},
          {"state", nameOf(stateAt(opening, now_us))},
          {"opened_by", opening.openedBy},
          {"closed", timeOrNull(opening.closed_us)},
          {"closed_by", opening.closedBy}};
}

Result<std::map<std::string, std::string>> classNames(const SignedIn& by) {
  const auto cohorts = CohortStore(by).cohorts();
  if (!cohorts) return tl::unexpected(cohorts.error());
  std::map<std::string, std::string> names;
  for (const Cohort& cohort : *cohorts) names[cohort.id] = cohort.name;
  return names;
}

/// Openings that the signed-in user may see: of a class, else of all classes and everyone.
Result<std::vector<TestOpening>> openingsOf(const SignedIn& by, const std::string& className) {
  const OpeningStore openings(by);
  if (!className.empty()) {
    const auto cohort = classNamed(by, className);
    return cohort ? openings.listByCohort(cohort->id) : tl::unexpected(cohort.error());
  }
  if (by.person().role == Role::Administrator) return openings.all();
  const auto cohorts = CohortStore(by).cohorts();
  if (!cohorts) return tl::unexpected(cohorts.error());
  std::vector<TestOpening> all;
  for (const Cohort& cohort : *cohorts) {
    auto of = openings.listByCohort(cohort.id);
    if (!of) return of;
    for (const TestOpening& one : *of)
      if (std::ranges::find(all, one) == all.end()) all.push_back(one);
  }
  return all;
}

Result<Answer> open(const SignedIn& by, const OpenArguments& a) {
  if (a.className.empty() == a.everyoneOf.empty())
    return fail("State either the class with --class, or the curriculum with --everyone.");
  NewOpening opening{.curriculum = a.everyoneOf, .level = a.level, .code = a.code};
  const auto start = timeOf(a.from), end = timeOf(a.until);
  for (const auto& time : {start, end})
    if (!time) return tl::unexpected(time.error());
  opening.start_us = *start, opening.end_us = *end;
  const auto names = classNames(by);
  if (!names) return tl::unexpected(names.error());
  if (!a.className.empty()) {
    const auto cohort = classNamed(by, a.className);
    if (!cohort) return tl::unexpected(cohort.error());
    opening.cohort = cohort->id;
  }
  const auto opened = OpeningStore(by).open(opening);
  if (!opened) return tl::unexpected(opened.error());
  const Json row = rowOf(*opened, *names, by.now_us());
  return Answer{{{"opening", row}},
                "The test '" + opened->level + "' is open for " + row["class"].get<std::string>() + " from " +
                    timeText(opened->start_us) + (opened->end_us ? " to " + timeText(*opened->end_us) : "") +
                    (opened->hasCode ? ", with a code" : "") + ". Id of the opening: " + opened->id + "."};
}

Result<Answer> list(const SignedIn& by, const std::string& className) {
  const auto openings = openingsOf(by, className);
  if (!openings) return tl::unexpected(openings.error());
  const auto names = classNames(by);
  if (!names) return tl::unexpected(names.error());
  Json rows = Json::array();
  for (const TestOpening& one : *openings) rows.push_back(rowOf(one, *names, by.now_us()));
  return Answer{
      {{"openings", rows}},
      rows.empty()
          ? "No test has been opened, so attempts at tests are practice. Open a test with 'curriculum tests open'."
          : tableOf(rows, {{"level", "level"},
                           {"class", "class"},
                           {"state", "state"},
                           {"start", "start"},
                           {"end", "end"},
                           {"code", "code"},
                           {"opened_by", "opened by"},
                           {"id", "opening"}})};
}

Result<Answer> close(const SignedIn& by, const std::string& id) {
  const auto openings = openingsOf(by, "");
  if (!openings) return tl::unexpected(openings.error());
  const auto found = std::ranges::find(*openings, id, &TestOpening::id);
  if (found == openings->end())
    return fail("There is no opening of a test with the id '" + id +
                "' that you can see. 'curriculum tests list' lists them.");
  if (auto done = OpeningStore(by).close(found->cohort, id); !done) return tl::unexpected(done.error());
  return Answer{{{"id", id}, {"state", "closed"}},
                "The test '" + found->level + "' is closed. Attempts that have begun still count."};
}

/// The curriculum of the signed-in trainee's class that has the level.
Result<std::string> curriculumWith(const SignedIn& by, const EnterArguments& a) {
  const auto classes = classesOf(by, by.person());
  if (!classes) return tl::unexpected(classes.error());
  for (const Cohort& cohort : *classes) {
    if (cohort.curriculum.empty() || (!a.className.empty() && !sameName(a.className, cohort.name))) continue;
    const auto curriculum = curriculumOf(by, cohort);
    if (!curriculum) return tl::unexpected(curriculum.error());
    if (curriculum->level(a.level)) return curriculum->name;
  }
  return fail("No class of yours has a level '" + a.level + "'; 'curriculum levels' lists the levels of your classes.");
}

Result<Answer> enter(const SignedIn& by, const EnterArguments& a) {
  const auto curriculum = curriculumWith(by, a);
  if (!curriculum) return tl::unexpected(curriculum.error());
  const auto admission = OpeningStore(by).enterCode(*curriculum, a.level, a.code);
  if (!admission) return tl::unexpected(admission.error());
  if (admission->kind == TestAdmission::Kind::Closed)
    return fail("The test '" + a.level + "' is not open for you. Ask the instructor to open the test.");
  return Answer{{{"level", a.level},
                 {"state", "open"},
                 {"end", admission->end_us ? Json(timeText(*admission->end_us)) : Json(nullptr)}},
                "The test '" + a.level + "' is open for you" +
                    (admission->end_us ? " until " + timeText(*admission->end_us) : "") + "."};
}

}  // namespace

void addTestCommands(CLI::App& curriculum, Outcome& outcome) {
  CLI::App& tests = *curriculum.add_subcommand("tests", "Open and close tests; attempts at closed tests are practice");
  tests.require_subcommand(1);
  const auto opened = std::make_shared<OpenArguments>();
  CLI::App* opening = addSignedInCommand(tests, outcome, "open", "Open a test, for a time, with a code, or both",
                                         [opened](const SignedIn& by) { return open(by, *opened); });
  opening->add_option("LEVEL", opened->level, "Name of a level with the assistance 'test'")->required();
  opening->add_option("--class", opened->className, "Class for which the test is opened");
  opening->add_option("--everyone", opened->everyoneOf, "Curriculum whose test is opened for all people");
  opening->add_option("--from", opened->from, "Start, such as 2026-12-01T14:30 (default: now)");
  opening->add_option("--until", opened->until, "End (default: until it is closed)");
  opening->add_option("--code", opened->code, "Code that trainees enter, 4 to 32 characters (default: none)");

  const auto listed = std::make_shared<std::string>();
  addSignedInCommand(tests, outcome, "list", "List when and for whom tests were opened, newest first",
                     [listed](const SignedIn& by) { return list(by, *listed); })
      ->add_option("CLASS", *listed, "Name of the class (default: all classes)");
  const auto closed = std::make_shared<std::string>();
  addSignedInCommand(tests, outcome, "close", "Close a test that was opened; attempts that have begun still count",
                     [closed](const SignedIn& by) { return close(by, *closed); })
      ->add_option("OPENING", *closed, "Id of the opening, from 'tests list'")
      ->required();
  const auto entered = std::make_shared<EnterArguments>();
  CLI::App* entering = addSignedInCommand(tests, outcome, "enter", "Enter the code of a test that is open for you",
                                          [entered](const SignedIn& by) { return enter(by, *entered); });
  entering->add_option("LEVEL", entered->level, "Name of the level")->required();
  entering->add_option("CODE", entered->code, "Code from the instructor")->required();
  entering->add_option("--class", entered->className, "Class of the test, if several classes have the level");
}

}  // namespace insonate::cli
