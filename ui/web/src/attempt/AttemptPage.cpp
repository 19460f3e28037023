#include "attempt/AttemptPage.h"

#include "comments/Comments.h"
#include "forms/FormPages.h"
#include "person/PersonPage.h"
#include "video/VideoPage.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/Implausible.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/teaching/HeatMap.h>
#include <insonate/teaching/MetricCatalog.h>

#include <algorithm>

namespace insonate::web {
namespace {

/// The curriculum of the class that the address names, if the user sees this class; else the version of the attempt.
std::optional<Curriculum> rulesFor(const Visit& visit, const AttemptFacts& attempt) {
  Cohort cohort{.curriculum = attempt.curriculum, .curriculumVersion = attempt.curriculumVersion};
  if (const auto cohorts = CohortStore(*visit.by).cohorts()) {
    const auto found = std::ranges::find(*cohorts, valueOf(visit.request.query, "class"), &Cohort::id);
    if (found != cohorts->end() && found->curriculum == attempt.curriculum) cohort = *found;
  }
  return curriculumOf(*visit.by, cohort).value_or(std::nullopt);
}

Markup term(std::string_view name, const Markup& value) {
  return element("dt", {}, name) + element("dd", {}, value);
}

/// Explains the word for an attempt's proof to those who read it for the first time.
std::string proofNote(AttemptProof proof) {
  switch (proof) {
    case AttemptProof::Proven:
      return ": the recording is complete and unchanged, and this person made it";
    case AttemptProof::Verifying:
      return ": the server is computing the result again from the recording; until then a pass does not count";
    case AttemptProof::Accepted:
      return ": the attempt was not proven, but an instructor accepted it";
    case AttemptProof::Earlier:
      return ": stored by an earlier version of the program, which did not prove attempts";
    case AttemptProof::Demonstration:
      return ": neither the person nor the attempt is real";
    case AttemptProof::Unproven:
      break;
  }
  return ": no complete recording proves that this person made the attempt; a pass counts only after an instructor has "
         "accepted the attempt";
}

Markup attemptFacts(const AttemptFacts& attempt, const Person& person, const Level* level) {
  Markup list = term("Person", text(displayName(person))) + term("Begun", timeOf(attempt.begun_us)) +
                term("Level", text(level                   ? level->title
                                   : attempt.level.empty() ? "Free practice"
                                                           : attempt.level)) +
                term("Case", text(attempt.caseName)) +
                term("Duration", text(numberOf(double(attempt.length_us / 100'000) / 10) + " s"));
  if (attempt.points) list += term("Points", text(numberOf(*attempt.points) + " of 100"));
  list += term("Proof", text(nameOf(attempt.proof)) + element("span", {{"class", "quiet"}}, proofNote(attempt.proof)));
  if (level && level->assistance == Assistance::Test) list += term("Test", text(nameOf(attempt.testConditions)));
  return element("dl", {}, list);
}

std::string limitOf(const MetricStandard& standard, const std::string& unit) {
  std::string limit =
      standard.minimum ? "at least " + numberOf(*standard.minimum) : "at most " + numberOf(*standard.maximum);
  if (!unit.empty()) limit += " " + unit;
  return standard.critical ? limit + ", critical" : limit;
}

Markup metricSection(const AttemptFacts& attempt, const Level* level) {
  const Judgement judgement = level ? judge(level->pass, attempt) : Judgement{};
  std::vector<std::vector<Markup>> rows;
  for (const MetricMeaning& meaning : MetricCatalog::instance().all()) {
    const auto value = valueIn(attempt, meaning);
    if (!value) continue;
    Markup standardCell, metCell;
    for (std::size_t i = 0; level && i < level->pass.standards.size(); ++i) {
      const MetricStandard& standard = level->pass.standards[i];
      if (standard.metric != meaning.id) continue;
      standardCell = text(limitOf(standard, meaning.unit));
      metCell = element("span", {{"class", judgement.standardsMet[i] ? "met" : "missed"}},
                        judgement.standardsMet[i] ? "\u2713 met" : "\u2717 missed");
    }
    const auto share = shareIn(attempt, meaning);
    rows.push_back({text(meaning.title), text(numberOf(*value) + (meaning.unit.empty() ? "" : " " + meaning.unit)),
                    standardCell, metCell, text(share && meaning.id != "points" ? heatWords(share) : "")});
  }
  if (rows.empty()) return section("Metrics", paragraph("No values were measured."));
  return section("Metrics",
                 table("Metrics of the attempt",
                       {"Metric", "Value", "Standard of the level", "Result", "Compared with published values"}, rows));
}

Markup flagSection(const AttemptFacts& attempt) {
  Markup items;
  for (const Implausible flag : implausibilities(attempt)) items += element("li", {}, displayText(flag, attempt));
  if (items.empty()) return {};
  return section("Implausible values",
                 paragraph("An instructor should check this attempt, for these reasons:") + element("ul", {}, items));
}

/// Forms by which an instructor decides whether the attempt counts; empty for others.
Markup decisionSection(const Visit& visit, const AttemptFacts& attempt, const std::string& query,
                       const std::string& trouble) {
  const Person& by = visit.by->person();
  const bool hasEnded = attempt.state == AttemptState::Completed || attempt.state == AttemptState::Abandoned;
  if (by.role == Role::Trainee || by.id == attempt.person || !hasEnded) return {};
  const std::string address = "/attempts/" + encoded(attempt.id);
  Markup content;
  if (!trouble.empty()) content += troubleLine(trouble);
  if (attempt.proof == AttemptProof::Unproven || attempt.proof == AttemptProof::Verifying)
    content += note("The attempt is not proven, so a pass does not count. Accept the attempt if you have watched it.") +
               postForm(visit, address + "/accept" + query, inputField("Reason", "reason", "text", "off"), "Accept");
  content += note(
                 "A voided attempt counts neither as a pass nor as a failure. Void the attempt if, for instance, a "
                 "device failed.") +
             postForm(visit, address + "/void" + query, inputField("Reason", "reason", "text", "off"), "Void");
  return section("Does this attempt count?", content);
}

/// The query by which a page of the attempt leads back to this one.
std::string queryOf(const Visit& visit) {
  const std::string& cohort = valueOf(visit.request.query, "class");
  return cohort.empty() ? "" : "?class=" + encoded(cohort);
}

std::string addressOf(const Visit& visit, const std::string& attempt) {
  return "/attempts/" + encoded(attempt) + queryOf(visit);
}

Response attemptPage(const Visit& visit, const std::string& id, const CommentDraft& draft, int status,
                     const std::string& decisionTrouble = {}) {
  const auto kept = AttemptStore(*visit.by).attempt(id);
  if (!kept) return refusal(visit, 404, kept.error().message);
  const auto person = PeopleStore(*visit.by).person(kept->facts.person);
  if (!person) return refusal(visit, 403, person.error().message);
  const auto rules = rulesFor(visit, kept->facts);
  const Level* level = rules ? levelOf(*rules, kept->facts) : nullptr;
  const std::string outcome = outcomeWords(kept->facts, rules ? &*rules : nullptr);
  Markup content = element("p", {{"class", "outcome"}}, outcome);
  if (!kept->voidReason.empty()) content += paragraph("Reason: " + kept->voidReason);
  content += attemptFacts(kept->facts, *person, level);
  const auto comments = commentSection(visit, kept->facts, queryOf(visit), draft);
  if (!comments) return refusal(visit, 403, comments.error().message);
  const auto video = videoSection(visit, *kept, queryOf(visit));
  if (!video) return refusal(visit, 403, video.error().message);
  const auto forms = formSection(visit, kept->facts, queryOf(visit));
  if (!forms) return refusal(visit, 403, forms.error().message);
  content += *video + *comments + *forms + metricSection(kept->facts, level);
  if (visit.by->person().role != Role::Trainee) content += flagSection(kept->facts);
  content += decisionSection(visit, kept->facts, queryOf(visit), decisionTrouble);
  Response response = page(visit, "Attempt", content, status);
  if (!video->empty()) response.headers.push_back(kVideoPolicy);
  return response;
}

}  // namespace

Response showAttempt(const Visit& visit, const Parts& parts) {
  return attemptPage(visit, parts[0], {}, 200);
}

Response acceptAttempt(const Visit& visit, const Parts& parts) {
  const auto accepted = AttemptStore(*visit.by).accept(parts[0], valueOf(visit.request.form, "reason"));
  return accepted ? redirect(addressOf(visit, parts[0]))
                  : attemptPage(visit, parts[0], {}, 400, accepted.error().message);
}

Response voidAttempt(const Visit& visit, const Parts& parts) {
  const auto voided = AttemptStore(*visit.by).voidAttempt(parts[0], valueOf(visit.request.form, "reason"));
  return voided ? redirect(addressOf(visit, parts[0])) : attemptPage(visit, parts[0], {}, 400, voided.error().message);
}

Response addComment(const Visit& visit, const Parts& parts) {
  CommentDraft draft{.time = valueOf(visit.request.form, "at"), .text = valueOf(visit.request.form, "text")};
  const auto at_us = recordingTime(draft.time);
  const auto added = at_us ? CommentStore(*visit.by).add(parts[0], *at_us, draft.text)
                           : Result<std::string>(tl::unexpected(at_us.error()));
  if (added) return redirect(addressOf(visit, parts[0]));
  draft.trouble = added.error().message;
  return attemptPage(visit, parts[0], draft, 400);
}

Response removeComment(const Visit& visit, const Parts& parts) {
  if (auto removed = CommentStore(*visit.by).remove(parts[0], parts[1]); !removed)
    return refusal(visit, 403, removed.error().message);
  return redirect(addressOf(visit, parts[0]));
}

}  // namespace insonate::web
