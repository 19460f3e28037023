#include "classes/ClassPages.h"

#include "classes/ClassContents.h"
#include "people/Accounts.h"
#include "person/PersonPage.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/Attention.h>
#include <insonate/curriculum/ClassAccess.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/teaching/AttemptNotes.h>
#include <insonate/teaching/HeatMap.h>
#include <insonate/teaching/MetricCatalog.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace insonate::web {
namespace {

struct ClassFacts {
  Cohort cohort{};
  std::optional<Curriculum> curriculum{};
  std::vector<Person> people{};  ///< all members, sorted by id
  std::vector<Member> learners{};
  HeatMap heat{};
  std::vector<AttemptFacts> unproven{};       ///< attempts that wait for acceptance, the latest first
  std::vector<FlaggedAttempt> implausible{};  ///< implausible attempts, the latest first
  std::int64_t now_us = 0;
};

/// Replaces outdated standings, so that the page never shows a level that has lapsed since.
Result<void> bringUpToDate(const SignedIn& by, ClassFacts& facts) {
  std::vector<std::string> outdated;
  for (const Member& one : facts.learners)
    if (!one.standingIsCurrent) outdated.push_back(one.person.id);
  if (outdated.empty() || !facts.curriculum) return {};
  const auto standings = CohortStore(by).standings(facts.cohort.id, outdated);
  if (!standings) return tl::unexpected(standings.error());
  for (Member& one : facts.learners)
    if (const auto found = standings->find(one.person.id); found != standings->end()) {
      one.standing = found->second;
      one.standingIsCurrent = true;
    }
  return {};
}

Result<ClassFacts> readClass(const SignedIn& by, const Cohort& cohort) {
  ClassFacts facts{.cohort = cohort, .now_us = by.now_us()};
  auto members = CohortStore(by).members(cohort.id);
  if (!members) return tl::unexpected(members.error());
  std::ranges::transform(*members, std::back_inserter(facts.people), &Member::person);
  std::ranges::sort(facts.people, {}, &Person::id);
  std::ranges::copy_if(*members, std::back_inserter(facts.learners), [](const Member& one) { return !one.teaches; });
  auto curriculum = curriculumOf(by, cohort);
  if (!curriculum) return tl::unexpected(curriculum.error());
  facts.curriculum = std::move(*curriculum);
  const auto last = AttemptStore(by).recentOfCohort(cohort.id, kLastAttempts);
  if (!last) return tl::unexpected(last.error());
  facts.heat = heatMapOf(*last);
  facts.implausible = implausibleOf(*last);
  std::ranges::copy_if(*last, std::back_inserter(facts.unproven), waitsForAcceptance);
  std::ranges::sort(facts.unproven, std::greater(), &AttemptFacts::begun_us);
  if (auto done = bringUpToDate(by, facts); !done) return tl::unexpected(done.error());
  return facts;
}

Markup linkTo(const ClassFacts& facts, const Member& member) {
  return link("/classes/" + encoded(facts.cohort.id) + "/people/" + encoded(member.person.id),
              displayName(member.person));
}

/// Items for attempts at which an instructor should look.
Markup attemptConcerns(const ClassFacts& facts) {
  Markup items;
  const auto add = [&](const AttemptFacts& attempt, const std::string& why) {
    const auto member =
        std::ranges::find(facts.learners, attempt.person, [](const Member& one) { return one.person.id; });
    if (member == facts.learners.end()) return;
    const std::string address = "/attempts/" + encoded(attempt.id) + "?class=" + encoded(facts.cohort.id);
    items += element("li", {},
                     linkTo(facts, *member) + text(": attempt of ") +
                         element("a", {{"href", address}}, timeOf(attempt.begun_us)) +
                         element("span", {{"class", "quiet"}}, " - " + why));
  };
  for (const AttemptFacts& one : facts.unproven) add(one, "not proven; counts only after you accept it");
  for (const FlaggedAttempt& one : facts.implausible) add(one.facts, implausibleText(one.facts, one.flags));
  return items;
}

Markup attentionSection(const ClassFacts& facts) {
  std::vector<const Member*> needing;
  for (const Member& one : facts.learners)
    if (attentionOf(one, facts.now_us) != Attention::None) needing.push_back(&one);
  std::ranges::stable_sort(needing, std::ranges::greater(),
                           [&](const Member* one) { return attentionOf(*one, facts.now_us); });
  Markup items;
  for (const Member* one : needing) {
    const std::string words = displayText(attentionOf(*one, facts.now_us), *one, facts.now_us);
    const std::string why = one->standing ? " - " + one->standing->sentence : "";
    items += element("li", {}, linkTo(facts, *one) + text(": " + words) + element("span", {{"class", "quiet"}}, why));
  }
  items += attemptConcerns(facts);
  if (items.empty()) return section("Trainees who need attention", paragraph("No trainee needs attention."));
  return section("Trainees who need attention", element("ul", {}, items));
}

/// The state of a trainee who needs attention, and whether an attempt is implausible, as in Review.
std::string attentionWords(const ClassFacts& facts, const Member& member) {
  std::string words = displayText(attentionOf(member, facts.now_us), member, facts.now_us);
  const bool isFlagged = std::ranges::any_of(
      facts.implausible, [&](const FlaggedAttempt& one) { return one.facts.person == member.person.id; });
  if (isFlagged) words += words.empty() ? "implausible attempt" : ", implausible attempt";
  return words;
}

Markup memberSection(const ClassFacts& facts) {
  std::vector<std::vector<Markup>> rows;
  const std::size_t levels = facts.curriculum ? facts.curriculum->levels.size() : 0;
  for (const Member& one : facts.learners) {
    const Level* level = one.standing && facts.curriculum ? facts.curriculum->level(one.standing->level) : nullptr;
    rows.push_back({linkTo(facts, one),
                    text(one.attempts == 0                             ? "not begun"
                         : level                                       ? level->title
                         : one.standing && one.standing->level.empty() ? "all levels mastered"
                                                                       : "..."),
                    text(one.standing ? std::to_string(one.standing->mastered) + " of " + std::to_string(levels) : ""),
                    text(std::to_string(one.attempts)), one.lastAttempt_us ? timeOf(*one.lastAttempt_us) : text("none"),
                    text(attentionWords(facts, one))});
  }
  if (rows.empty()) return section("Members", paragraph("The class has no trainees yet."));
  return section(
      "Members",
      table("Trainees of the class",
            {"Name", "Present level", "Levels mastered", "Attempts", "Last attempt", "Needs attention"}, rows));
}

Markup heatCell(const HeatCell& cell) {
  if (!cell.value) return element("span", {{"class", "quiet"}}, "none");
  if (!cell.share) return text(numberOf(*cell.value));
  const int step = static_cast<int>(std::lround(*cell.share / 10));
  return element("span", {{"class", "heat heat" + std::to_string(step)}},
                 text(numberOf(*cell.value)) + element("span", {{"class", "hidden"}}, ", " + heatWords(cell.share)));
}

Markup skillSection(const ClassFacts& facts) {
  const MetricCatalog& book = MetricCatalog::instance();
  std::vector<std::string> titles{"Name"};
  for (std::size_t i = 0; i < book.comparableCount(); ++i) {
    const MetricMeaning& meaning = book.all()[i];
    titles.push_back(meaning.unit.empty() ? meaning.title : meaning.title + ", " + meaning.unit);
  }
  std::vector<std::vector<Markup>> rows;
  for (const Member& one : facts.learners) {
    const auto row = facts.heat.find(one.person.id);
    if (row == facts.heat.end()) continue;
    rows.push_back({linkTo(facts, one)});
    for (std::size_t i = 0; i < book.comparableCount(); ++i) rows.back().push_back(heatCell(row->second[i]));
  }
  if (rows.empty()) return section("Skill", paragraph("No attempts at levels yet."));
  return section(
      "Skill",
      element("p", {{"class", "quiet"}},
              "Means of the last " + std::to_string(kLastAttempts) +
                  " attempts at levels. Dark blue: value of a novice; yellow: value of an expert (both published).") +
          element("div", {{"class", "wide"}}, table("Skill by metric", titles, rows)));
}

/// Contains nothing that depends on the user, since all users who may see the class share it.
Result<ClassContents::Content> contentOf(const SignedIn& by, const Cohort& cohort) {
  auto facts = readClass(by, cohort);
  if (!facts) return tl::unexpected(facts.error());
  ClassContents::Content content{.sections = attentionSection(*facts) + memberSection(*facts) + skillSection(*facts)};
  content.people = std::move(facts->people);
  return content;
}

Markup exportForm(const std::string& address, const Markup& field, std::string_view button) {
  return element("form", {{"method", "get"}, {"action", address}, {"class", "line"}},
                 field + element("button", {{"type", "submit"}}, button));
}

Markup exportSection(const Visit& visit, const Cohort& cohort) {
  const std::string address = "/classes/" + encoded(cohort.id) + "/export/";
  Markup content = exportForm(address + "attempts.csv", note("All attempts with their metrics, for spreadsheets (CSV)"),
                              "Save attempts");
  if (cohort.curriculum.empty()) return section("Export", content);
  content += exportForm(
      address + "grades.csv",
      note("Share of levels that each trainee has mastered, for Moodle (CSV). Trainees without attempts are left out. "
           "If you identify trainees by e-mail address, trainees without an e-mail address are left out, too.") +
          choiceField("Identify trainees by", "by", {{"email", "e-mail address"}, {"name", "name"}}, "email"),
      "Save grades");
  const std::string home = "https://" + valueOf(visit.request.headers, "host");
  content += exportForm(address + "statements.json",
                        note("Attempts as statements of the Experience API (xAPI 1.0.3), for a learning record store. "
                             "Attempts that do not count are left out. Always enter the same address of your site, "
                             "since the store recognizes people and attempts by this address.") +
                            inputField("Address of your site", "home", "url", "url", home),
                        "Save statements");
  return section("Export", content);
}

Markup addClassForm(const Visit& visit, const std::string& trouble) {
  return section("Add a class",
                 note("A class is a group of people who learn the levels of one curriculum.") +
                     (trouble.empty() ? Markup() : troubleLine(trouble)) +
                     postForm(visit, "/classes",
                              inputField("Name", "name", "text", "off", valueOf(visit.request.form, "name")), "Add"));
}

Response classesPage(const Visit& visit, const std::string& trouble) {
  const auto cohorts = CohortStore(*visit.by).cohorts();
  if (!cohorts) return refusal(visit, 403, cohorts.error().message);
  std::vector<std::vector<Markup>> rows;
  for (const Cohort& one : *cohorts)
    rows.push_back(
        {link("/classes/" + encoded(one.id), listedName(one)),
         text(one.curriculum.empty() ? "none"
                                     : one.curriculum + ", version " + std::to_string(one.curriculumVersion))});
  Markup content = valueOf(visit.request.query, "deleted").empty()
                       ? Markup()
                       : paragraph("The class was deleted. Accounts and attempts were kept.");
  const std::string none = isAdministrator(visit) ? "No classes yet. Add a class below, and then its instructors."
                                                  : "No classes. An administrator adds classes and their instructors.";
  content += rows.empty() ? paragraph(none) : table("Classes", {"Class", "Curriculum"}, rows);
  if (isAdministrator(visit)) content += addClassForm(visit, trouble);
  return page(visit, "Classes", content, trouble.empty() ? 200 : 422);
}

}  // namespace

Response showClasses(const Visit& visit, const Parts& /*parts*/) {
  return classesPage(visit, {});
}

Response addClass(const Visit& visit, const Parts& /*parts*/) {
  const auto added = CohortStore(*visit.by).add(valueOf(visit.request.form, "name"));
  return added ? redirect("/classes/" + encoded(added->id) + "/members") : classesPage(visit, added.error().message);
}

Response showClass(const Visit& visit, const Parts& parts) {
  const auto cohorts = CohortStore(*visit.by).cohorts();
  if (!cohorts) return refusal(visit, 403, cohorts.error().message);
  const auto cohort = std::ranges::find(*cohorts, parts[0], &Cohort::id);
  if (cohort == cohorts->end()) return refusal(visit, 404, "There is no such class, or it is not yours.");
  const auto shown = visit.classes.show(visit, *cohort, [&] { return contentOf(*visit.by, *cohort); });
  if (!shown) return refusal(visit, 403, shown.error().message);
  const std::string address = "/classes/" + encoded(cohort->id);
  Markup ways;
  for (const auto& [path, words] : {std::pair{"/members", "Members and settings"},
                                    {"/tests", "Open and close tests"},
                                    {"/comparison", "Compare with another class"},
                                    {"/raters", "Agreement of raters"}})
    ways += element("p", {}, link(address + path, words));
  return livePage(visit, listedName(*cohort),
                  element("div", {{"class", "screen"}}, ways) + shown->sections +
                      element("div", {{"class", "screen"}}, exportSection(visit, *cohort)),
                  address + "/events", shown->number);
}

Response followClass(const Visit& visit, const Parts& parts) {
  const auto members = seeClass(*visit.by, parts[0], isByItself(visit.request));
  if (!members) return refusal(visit, 403, members.error().message);
  std::set<std::string> people;
  for (const Person& one : *members) people.insert(one.id);
  return follow(visit, std::move(people));
}

}  // namespace insonate::web
