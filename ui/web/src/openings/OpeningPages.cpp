#include "openings/OpeningPages.h"

#include "classes/TaughtClass.h"
#include "openings/TestCodes.h"
#include "people/Accounts.h"

#include <insonate/curriculum/OpeningStore.h>
#include <insonate/teaching/OverlappingOpening.h>

#include <QDateTime>
#include <algorithm>
#include <cstdint>

namespace insonate::web {
namespace {

constexpr std::int64_t kUsualLength_us = std::int64_t{2} * 3600 * 1'000'000;
constexpr const char *kEveryone = "everyone", *kClass = "class", *kDateTimeFormat = "yyyy-MM-ddTHH:mm";

/// Why a form was refused, and whether the same form is accepted when it is sent again.
struct Refusal {
  std::string sentence{};
  bool canRepeat = false;
};

Choices testsOf(const TaughtClass& taught) {
  Choices tests;
  if (!taught.curriculum) return tests;
  for (const Level& level : taught.curriculum->levels)
    if (level.assistance == Assistance::Test) tests.emplace_back(level.name, level.title);
  return tests;
}

/// People for whom the user may open a test. Tests of an archived class cannot be opened.
Choices audiences(const Visit& visit, const TaughtClass& taught) {
  Choices choices;
  if (!taught.cohort.archived) choices.emplace_back(kClass, "the class " + taught.cohort.name);
  if (isAdministrator(visit)) choices.emplace_back(kEveryone, "everyone");
  return choices;
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
    const bool canEnd =
        (isOwn || isAdministrator(visit)) && (state == OpeningState::Open || state == OpeningState::Waiting);
    rows.push_back(
        {text(level ? level->title : one.level), stateOf(one, now_us), timeOf(one.start_us),
         one.end_us ? timeOf(*one.end_us) : text("until the test is closed"), text(codeWords(visit, one)),
         text(isOwn ? "this class" : "everyone"), text(one.openedBy),
         canEnd ? postForm(visit, addressOf(taught) + "/close", hiddenField("opening", one.id), "Close") : Markup()});
  }
  return table("Opened tests, newest first", {"Test", "State", "Start", "End", "Code", "Open to", "Opened by", "Close"},
               rows);
}

/// "CET, UTC+01:00"
std::string zoneOf(const QDateTime& time) {
  const std::string name = time.timeZoneAbbreviation().toStdString();
  const std::string offset = time.toOffsetFromUtc(time.offsetFromUtc()).timeZoneAbbreviation().toStdString();
  return name.empty() || name == offset ? offset : name + ", " + offset;
}

/// The value of a field for date and time, in the server's time zone.
std::string fieldValue(std::int64_t time_us) {
  return QDateTime::fromMSecsSinceEpoch(time_us / 1000).toString(QLatin1String(kDateTimeFormat)).toStdString();
}

/// Reads a field for date and time, in the server's time zone; empty: no time.
Result<std::optional<std::int64_t>> timeIn(const Fields& form, const std::string& name, const std::string& label) {
  const std::string& typed = valueOf(form, name);
  if (typed.empty()) return std::optional<std::int64_t>();
  const QDateTime time = QDateTime::fromString(QString::fromStdString(typed), Qt::ISODate);
  if (!time.isValid() || time.date().year() < 2000 || time.date().year() > 2999)
    return fail(label + ": '" + typed + "' is not a date with a time. Enter them as 2026-11-30T14:00.");
  return std::optional(time.toMSecsSinceEpoch() * 1000);
}

Markup openForm(const Visit& visit, const TaughtClass& taught, const Refusal& refused) {
  const Choices tests = testsOf(taught), whom = audiences(visit, taught);
  if (tests.empty())
    return section("Open a test", paragraph(taught.curriculum ? "The curriculum of this class has no test."
                                                              : std::string(kNoCurriculum)));
  if (whom.empty()) return section("Open a test", paragraph("The class is archived: its tests cannot be opened."));
  const auto& form = visit.request.form;
  const std::int64_t now_us = visit.by->now_us();
  const std::string zone = zoneOf(QDateTime::fromMSecsSinceEpoch(now_us / 1000));
  Markup content = note(
      "An attempt counts if it begins between start and end, even if the attempt ends later. A start in the past means "
      "now. Workstations learn of an opening within five minutes. Without an end, the test stays open until you close "
      "it, and needs a code. If you set a code, only trainees who enter the code can take the test. The table shows "
      "the code to you alone, in this browser and until you sign out.");
  content += note("Times are in the time zone of the server, at present " + zone + ".");
  if (!refused.sentence.empty()) content += troubleLine(refused.sentence);
  Markup fields =
      choiceField("Test", "level", tests, valueOf(form, "level")) +
      choiceField("Open to", "whom", whom, valueOf(form, "whom")) +
      optionalField("Start (" + zone + ")", "start", "datetime-local", typedOr(visit, "start", fieldValue(now_us))) +
      optionalField("End (" + zone + "; empty: until the test is closed)", "end", "datetime-local",
                    typedOr(visit, "end", fieldValue(now_us + kUsualLength_us))) +
      optionalField("Code (optional, 4 to 32 characters)", "test-code", "text", valueOf(form, "test-code"));
  if (refused.canRepeat)
    fields += hiddenField("warned", valueOf(form, "level") + " " + valueOf(form, "start") + " " + valueOf(form, "end"));
  content += postForm(visit, addressOf(taught), fields, refused.canRepeat ? "Open again" : "Open");
  return section("Open a test", content);
}

Response openingsPage(const Visit& visit, const TaughtClass& taught, const Refusal& refused) {
  const auto openings = OpeningStore(*visit.by).listByCohort(taught.cohort.id);
  if (!openings) return refusal(visit, 403, openings.error().message);
  const Markup list = openings->empty() ? paragraph("No test has been opened: attempts at tests are practice.")
                                        : openingTable(visit, taught, *openings);
  return page(visit, "Tests of " + taught.cohort.name,
              note("An attempt at a test counts only if the test was open for the trainee when the attempt began.") +
                  list + openForm(visit, taught, refused) +
                  element("p", {}, link("/classes/" + encoded(taught.cohort.id), "Back to the class")),
              refused.sentence.empty() ? 200
              : refused.canRepeat      ? 409
                                       : 422);
}

Result<NewOpening> openingIn(const Fields& form, const TaughtClass& taught) {
  const std::string& whom = valueOf(form, "whom");
  if (whom != kClass && whom != kEveryone) return fail("Choose the people to whom the test is open.");
  if (!taught.curriculum) return fail(kNoCurriculum);
  const auto start = timeIn(form, "start", "Start"), end = timeIn(form, "end", "End");
  if (!start) return tl::unexpected(start.error());
  if (!end) return tl::unexpected(end.error());
  return NewOpening{.cohort = whom == kClass ? taught.cohort.id : "",
                    .curriculum = taught.curriculum->name,
                    .level = valueOf(form, "level"),
                    .start_us = *start,
                    .end_us = *end,
                    .code = valueOf(form, "test-code")};
}

/// Warns of another opening at the same time; "" if there is none, or if the user was warned of the same times.
Result<std::string> warningOf(const Visit& visit, const TaughtClass& taught, const NewOpening& opening) {
  const Fields& form = visit.request.form;
  const auto openings = OpeningStore(*visit.by).listByCohort(taught.cohort.id);
  if (!openings) return tl::unexpected(openings.error());
  const TestOpening* open = overlappingOpening(*openings, opening, visit.by->now_us());
  const std::string asked = opening.level + " " + valueOf(form, "start") + " " + valueOf(form, "end");
  if (!open || valueOf(form, "warned") == asked) return std::string();
  const Level* level = taught.curriculum->level(opening.level);
  return "The test '" + (level ? level->title : opening.level) + "' is open already, or opens during this time" +
         (open->hasCode ? ", with a code" : "") +
         ". If you open it again, each of the two openings is enough to take the test.";
}

}  // namespace

Response showOpenings(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) { return openingsPage(visit, taught, {}); });
}

Response openTest(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    const auto opening = openingIn(visit.request.form, taught);
    if (!opening) return openingsPage(visit, taught, {.sentence = opening.error().message});
    const auto warning = warningOf(visit, taught, *opening);
    if (!warning) return refusal(visit, 403, warning.error().message);
    if (!warning->empty()) return openingsPage(visit, taught, {.sentence = *warning, .canRepeat = true});
    const auto opened = OpeningStore(*visit.by).open(*opening);
    if (!opened) return openingsPage(visit, taught, {.sentence = opened.error().message});
    Response response = redirect(addressOf(taught));
    if (!opening->code.empty())
      response.headers.push_back(codeHeader(visit, addressOf(taught), opened->id, opening->code));
    return response;
  });
}

Response closeTest(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    const std::string& id = valueOf(visit.request.form, "opening");
    const auto openings = OpeningStore(*visit.by).listByCohort(taught.cohort.id);
    if (!openings) return refusal(visit, 403, openings.error().message);
    const auto one = std::ranges::find(*openings, id, &TestOpening::id);
    const auto closed = OpeningStore(*visit.by).close(one == openings->end() ? taught.cohort.id : one->cohort, id);
    return closed ? redirect(addressOf(taught)) : openingsPage(visit, taught, {.sentence = closed.error().message});
  });
}

}  // namespace insonate::web
