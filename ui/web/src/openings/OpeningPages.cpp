#include "openings/OpeningPages.h"

#include "classes/TaughtClass.h"
#include "openings/TestCodes.h"

#include <insonate/curriculum/OpeningStore.h>

#include <charconv>
#include <cstdint>

namespace insonate::web {
namespace {

constexpr std::int64_t kHour_us = std::int64_t{3600} * 1'000'000;
constexpr int kLongest_h = 24 * 14;

Choices testsOf(const TaughtClass& taught) {
  Choices tests;
  if (!taught.curriculum) return tests;
  for (const Level& level : taught.curriculum->levels)
    if (level.assistance == Assistance::Test) tests.emplace_back(level.name, level.title);
  return tests;
}

std::string addressOf(const TaughtClass& taught) {
  return "/classes/" + encoded(taught.cohort.id) + "/tests";
}

Markup stateOf(const TestOpening& opening, std::int64_t now_us) {
  const OpeningState state = stateAt(opening, now_us);
  Markup words = text(nameOf(state));
  if (state == OpeningState::Closed) words += text(" by " + opening.closedBy + ", ") + timeOf(*opening.closed_us);
  return words;
}

/// The code itself for the instructor who has opened the test, in the same session.
std::string codeWords(const Visit& visit, const TestOpening& opening) {
  if (!opening.hasCode) return "without a code";
  const std::string code = codeOf(visit, opening.id);
  return code.empty() ? "with a code" : "with the code " + code;
}

Markup openingTable(const Visit& visit, const TaughtClass& taught, const std::vector<TestOpening>& openings) {
  const std::int64_t now_us = visit.by->now_us();
  std::vector<std::vector<Markup>> rows;
  for (const TestOpening& one : openings) {
    const Level* level = taught.curriculum ? taught.curriculum->level(one.level) : nullptr;
    const OpeningState state = stateAt(one, now_us);
    const bool isOwn = !one.cohort.empty();
    const bool canEnd = isOwn && (state == OpeningState::Open || state == OpeningState::Waiting);
    const Markup id = element("input", {{"type", "hidden"}, {"name", "opening"}, {"value", one.id}});
    rows.push_back({text(level ? level->title : one.level), stateOf(one, now_us), timeOf(one.start_us),
                    one.end_us ? timeOf(*one.end_us) : text("until the test is closed"), text(codeWords(visit, one)),
                    text(isOwn ? "this class" : "everyone"), text(one.openedBy),
                    canEnd ? postForm(visit, addressOf(taught) + "/close", id, "Close") : Markup()});
  }
  return table("Opened tests, newest first", {"Test", "State", "Start", "End", "Code", "Open to", "Opened by", "Close"},
               rows);
}

Markup openForm(const Visit& visit, const TaughtClass& taught, const std::string& trouble) {
  const Choices tests = testsOf(taught);
  if (tests.empty())
    return section("Open a test", paragraph(taught.curriculum ? "The curriculum of this class has no test."
                                                              : std::string(kNoCurriculum)));
  const auto& form = visit.request.form;
  Markup content = note(
      "The test opens now; workstations open it within five minutes. An attempt counts if it begins before the test "
      "closes, even if the attempt ends later. If you set a code, only trainees who enter the code can take the test. "
      "The "
      "table shows the code to you alone, in this browser and until you sign out.");
  if (!trouble.empty()) content += troubleLine(trouble);
  content += postForm(visit, addressOf(taught),
                      choiceField("Test", "level", tests, valueOf(form, "level")) +
                          choiceField("Duration", "hours",
                                      {{"1", "1 hour"},
                                       {"2", "2 hours"},
                                       {"4", "4 hours"},
                                       {"8", "8 hours"},
                                       {"24", "1 day"},
                                       {"168", "7 days"},
                                       {"0", "until the test is closed (needs a code)"}},
                                      valueOf(form, "hours")) +
                          optionalField("Code (optional, 4 to 32 characters)", "test-code", "text"),
                      "Open");
  return section("Open a test", content);
}

Response openingsPage(const Visit& visit, const TaughtClass& taught, const std::string& trouble) {
  const auto openings = OpeningStore(*visit.by).listByCohort(taught.cohort.id);
  if (!openings) return refusal(visit, 403, openings.error().message);
  const Markup list = openings->empty() ? paragraph("No test has been opened: attempts at tests are practice.")
                                        : openingTable(visit, taught, *openings);
  return page(visit, "Tests of " + taught.cohort.name,
              note("An attempt at a test counts only if the test was open for the trainee when the attempt began.") +
                  list + openForm(visit, taught, trouble) +
                  element("p", {}, link("/classes/" + encoded(taught.cohort.id), "Back to the class")),
              trouble.empty() ? 200 : 422);
}

/// The hours that the form states; 0: until it is closed; empty: not one of the choices.
std::optional<int> hoursOf(const std::string& text) {
  int hours = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), hours);
  const bool isNumber = error == std::errc() && end == text.data() + text.size();
  return isNumber && hours >= 0 && hours <= kLongest_h ? std::optional(hours) : std::nullopt;
}

}  // namespace

Response showOpenings(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) { return openingsPage(visit, taught, {}); });
}

Response openTest(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    const auto hours = hoursOf(valueOf(visit.request.form, "hours"));
    if (!hours) return openingsPage(visit, taught, "Choose the duration for which the test is open.");
    NewOpening opening{.cohort = taught.cohort.id,
                       .level = valueOf(visit.request.form, "level"),
                       .code = valueOf(visit.request.form, "test-code")};
    if (*hours > 0) opening.end_us = visit.by->now_us() + *hours * kHour_us;
    const auto opened = OpeningStore(*visit.by).open(opening);
    if (!opened) return openingsPage(visit, taught, opened.error().message);
    Response response = redirect(addressOf(taught));
    if (!opening.code.empty()) response.headers.push_back(codeHeader(visit, addressOf(taught), opened->id, opening.code));
    return response;
  });
}

Response closeTest(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    const auto closed = OpeningStore(*visit.by).close(taught.cohort.id, valueOf(visit.request.form, "opening"));
    return closed ? redirect(addressOf(taught)) : openingsPage(visit, taught, closed.error().message);
  });
}

}  // namespace insonate::web
