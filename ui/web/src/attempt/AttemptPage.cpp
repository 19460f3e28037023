#include "attempt/AttemptPage.h"

#include "attempt/MetricSection.h"
#include "attempt/PathSection.h"
#include "comments/Comments.h"
#include "forms/FormPages.h"
#include "live/LiveUpdates.h"
#include "person/PersonPage.h"
#include "video/VideoPage.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/Implausible.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/RepeatedValues.h>

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

Result<Markup> flagSection(const Visit& visit, const AttemptFacts& attempt) {
  std::vector<Implausible> flags = implausibilities(attempt);
  const auto repeated = repeatedValues(*visit.by, attempt.person);
  if (!repeated) return tl::unexpected(repeated.error());
  if (repeated->contains(attempt.id)) flags.push_back(Implausible::SameValues);
  if (flags.empty()) return Markup();
  Markup items;
  for (const Implausible flag : flags) items += element("li", {}, displayText(flag, attempt));
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
  const std::int64_t since = visit.live.numberOfLastChange();
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
  content += *video + *comments + *forms + pathSection(visit, id) + metricSection(kept->facts, level);
  if (visit.by->person().role != Role::Trainee) {
    const auto flags = flagSection(visit, kept->facts);
    if (!flags) return refusal(visit, 403, flags.error().message);
    content += *flags;
  }
  content +=
      element("div", {{"class", "screen"}}, decisionSection(visit, kept->facts, queryOf(visit), decisionTrouble));
  // The result of the verification arrives within seconds.
  const bool isLive = status == 200 && kept->facts.proof == AttemptProof::Verifying;
  Response response = isLive ? livePage(visit, "Attempt", content, "/attempts/" + encoded(id) + "/events", since)
                             : page(visit, "Attempt", content, status);
  if (!video->empty()) response.headers.push_back(kVideoPolicy);
  return response;
}

}  // namespace

Response showAttempt(const Visit& visit, const Parts& parts) {
  return attemptPage(visit, parts[0], {}, 200);
}

Response followAttempt(const Visit& visit, const Parts& parts) {
  const auto kept = AttemptStore(*visit.by).attempt(parts[0]);
  return kept ? follow(visit, {kept->facts.person}) : refusal(visit, 404, kept.error().message);
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
