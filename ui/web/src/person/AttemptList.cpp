#include "person/AttemptList.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AttemptTable.h>
#include <insonate/teaching/AttemptNotes.h>

#include <charconv>
#include <cmath>
#include <cstdint>

namespace insonate::web {
namespace {

constexpr std::size_t kAttemptsShown = 100;
constexpr int kAttemptsRead = 200;
constexpr const char *kAllLevels = "*", *kAttemptsField = "attempts", *kBeforeField = "before";

struct AttemptListPage {
  std::vector<StoredAttempt> attempts{};  ///< newest first
  std::int64_t earlier = 0;               ///< `before` of the next page; 0: there are no earlier attempts
};

/// The level that the user chose; empty: all.
std::optional<std::string> chosenLevel(const Visit& visit) {
  const auto chosen = visit.request.query.find(kAttemptsField);
  return chosen == visit.request.query.end() || chosen->second == kAllLevels ? std::nullopt
                                                                             : std::optional(chosen->second);
}

std::int64_t numberIn(const std::string& digits) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return error == std::errc() && end == digits.data() + digits.size() && number > 0 ? number : 0;
}

Result<AttemptListPage> readAttempts(const Visit& visit, const std::string& person) {
  const std::optional<std::string> level = chosenLevel(visit);
  std::int64_t before = numberIn(valueOf(visit.request.query, kBeforeField));
  AttemptListPage page;
  for (;;) {
    auto read = AttemptStore(*visit.by).page(person, kAttemptsRead, before);
    if (!read) return tl::unexpected(read.error());
    for (StoredAttempt& one : *read) {
      before = one.arrival;
      if (level && one.facts.level != *level) continue;
      if (page.attempts.size() == kAttemptsShown) {
        page.earlier = page.attempts.back().arrival;
        return page;
      }
      page.attempts.push_back(std::move(one));
    }
    if (read->size() < std::size_t(kAttemptsRead)) return page;
  }
}

std::string recordingWords(const StoredAttempt& attempt) {
  if (!attempt.recordingFile.empty()) return "on the server";
  return attempt.facts.recording.empty() ? "none" : "on " + attempt.facts.workstation;
}

std::vector<Markup> rowOf(const PersonFacts& facts, const StoredAttempt& attempt, const AttemptNotes& notes,
                          bool isInstructor) {
  const AttemptFacts& one = attempt.facts;
  std::string address = "/attempts/" + encoded(one.id);
  if (facts.cohort) address += "?class=" + encoded(facts.cohort->id);
  Markup outcome = text(outcomeText(attempt, facts.curriculum ? &*facts.curriculum : nullptr));
  if (const auto flags = notes.implausible.find(one.id); isInstructor && flags != notes.implausible.end())
    outcome += element("span", {{"class", "missed"}}, " \u25b2 " + implausibleText(one, flags->second));
  const auto forms = notes.forms.find(one.id);
  const auto comments = notes.comments.find(one.id);
  return {element("a", {{"href", address}}, timeOf(one.begun_us)),
          text(levelTitle(facts, one)),
          outcome,
          text(one.points ? numberOf(*one.points) : ""),
          text(numberOf(std::round(double(one.length_us) / 1e5) / 10)),
          text(recordingWords(attempt)),
          text(forms == notes.forms.end() ? "" : std::to_string(forms->second)),
          text(comments == notes.comments.end() ? "" : commentText(comments->second, isInstructor))};
}

/// The query of this page with other attempts in the list. `before`: 0 for the newest attempts.
std::string addressOfList(const Visit& visit, const PersonFacts& facts, std::int64_t before) {
  std::string query;
  const auto add = [&](const std::string& name, const std::string& value) {
    query += (query.empty() ? "?" : "&") + encoded(name) + "=" + encoded(value);
  };
  for (const auto& [name, value] : visit.request.query)
    if (name != kBeforeField) add(name, value);
  if (before > 0) add(kBeforeField, std::to_string(before));
  return facts.address + query + "#attempts";
}

Markup levelForm(const Visit& visit, const PersonFacts& facts) {
  Choices levels{{kAllLevels, "All attempts"}};
  if (facts.curriculum)
    for (const Level& level : facts.curriculum->levels) levels.emplace_back(level.name, level.title);
  levels.emplace_back("", "Free practice");
  Markup fields;
  for (const char* name : {"class", "level", "metric"})
    if (const auto kept = visit.request.query.find(name); kept != visit.request.query.end())
      fields += hiddenField(name, kept->second);
  fields += choiceField("Attempts at", kAttemptsField, levels, chosenLevel(visit).value_or(kAllLevels)) +
            element("button", {{"type", "submit"}}, "List");
  return element("form", {{"method", "get"}, {"action", facts.address + "#attempts"}, {"class", "line"}}, fields);
}

}  // namespace

Markup attemptFields(const Visit& visit) {
  const std::optional<std::string> level = chosenLevel(visit);
  return level ? hiddenField(kAttemptsField, *level) : Markup();
}

Result<Markup> attemptSection(const Visit& visit, const PersonFacts& facts) {
  const auto titled = [](const Markup& content) {
    return element("section", {{"id", "attempts"}}, element("h2", {}, "Attempts") + content);
  };
  if (facts.history.empty()) return titled(paragraph("No attempts yet."));
  const bool isInstructor = visit.by->person().role != Role::Trainee && visit.by->person().id != facts.person.id;
  const auto page = readAttempts(visit, facts.person.id);
  if (!page) return tl::unexpected(page.error());
  // Only instructors see reasons for attention, which take a search through all attempts.
  const auto notes = isInstructor ? readAttemptNotes(*visit.by, facts.person.id, facts.history)
                                  : readAttemptCounts(*visit.by, facts.person.id);
  if (!notes) return tl::unexpected(notes.error());
  std::vector<std::vector<Markup>> rows;
  for (const StoredAttempt& one : page->attempts) rows.push_back(rowOf(facts, one, *notes, isInstructor));
  Markup content = levelForm(visit, facts);
  content +=
      rows.empty()
          ? paragraph("There are no such attempts.")
          : table("Attempts, newest first",
                  {"Begun", "Level", "Outcome", "Points", "Duration, s", "Recording", "Forms", "Comments"}, rows) +
                note(
                    "Forms: number of checklists and ratings that were handed in. Comments: unread "
                    "comments are those that the trainee has not opened yet.");
  if (numberIn(valueOf(visit.request.query, kBeforeField)) > 0)
    content += element("p", {{"class", "screen"}}, link(addressOfList(visit, facts, 0), "Newest attempts"));
  if (page->earlier > 0)
    content +=
        element("p", {{"class", "screen"}}, link(addressOfList(visit, facts, page->earlier), "Earlier attempts"));
  return titled(content);
}

}  // namespace insonate::web
