#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/RepeatedValues.h>
#include <insonate/teaching/AttemptNotes.h>

#include <algorithm>

namespace insonate {

Result<AttemptNotes> readAttemptCounts(const SignedIn& by, const std::string& person) {
  AttemptNotes notes;
  auto comments = CommentStore(by).countsOf(person);
  if (!comments) return tl::unexpected(comments.error());
  notes.comments = std::move(*comments);
  const auto forms = FormStore(by).listByPerson(person);
  if (!forms) return tl::unexpected(forms.error());
  for (const StoredForm& one : *forms)
    if (!one.filled.attempt.empty() && one.filled.by != person) ++notes.forms[one.filled.attempt];
  return notes;
}

Result<AttemptNotes> readAttemptNotes(const SignedIn& by, const std::string& person,
                                      const std::vector<AttemptFacts>& history) {
  auto notes = readAttemptCounts(by, person);
  if (!notes) return notes;
  const auto repeated = repeatedValues(by, person);
  if (!repeated) return tl::unexpected(repeated.error());
  for (const AttemptFacts& one : history) {
    auto flags = implausibilities(one);
    if (repeated->contains(one.id)) flags.push_back(Implausible::SameValues);
    if (!flags.empty()) notes->implausible[one.id] = std::move(flags);
  }
  return notes;
}

std::vector<FlaggedAttempt> implausibleOf(std::vector<AttemptFacts> attempts) {
  std::ranges::sort(attempts, {}, &AttemptFacts::begun_us);
  PlausibilityCheck plausibility;
  std::vector<FlaggedAttempt> flagged;
  for (AttemptFacts& one : attempts)
    if (auto flags = plausibility.check(one); !flags.empty()) flagged.push_back({std::move(one), std::move(flags)});
  std::ranges::reverse(flagged);
  return flagged;
}

bool isUnproven(const StoredAttempt& attempt) {
  const AttemptFacts& facts = attempt.facts;
  const bool hasEnded = facts.state == AttemptState::Completed || facts.state == AttemptState::Abandoned;
  return hasEnded && !attempt.crashed && facts.proof == AttemptProof::Unproven &&
         facts.testConditions != TestConditions::Practice;
}

std::string outcomeText(const StoredAttempt& attempt, const Curriculum* curriculum) {
  std::string outcome = outcomeWords(attempt.facts, curriculum);
  if (!attempt.voidReason.empty()) outcome += ": " + attempt.voidReason;
  if (isUnproven(attempt) && outcome.find("not proven") == std::string::npos) outcome += ", not proven";
  if (attempt.facts.proof == AttemptProof::Verifying) outcome += ", being verified by the server";
  if (attempt.facts.proof == AttemptProof::Accepted) outcome += ", accepted";
  return outcome;
}

std::string implausibleText(const AttemptFacts& attempt, const std::vector<Implausible>& flags) {
  std::string words;
  for (const Implausible flag : flags) words += (words.empty() ? "" : ", ") + displayText(flag, attempt);
  return words;
}

std::string commentText(const CommentStore::Count& count, bool isInstructor) {
  // An instructor's own comment is not unread for the instructor.
  if (!isInstructor || count.unread == 0) return commentCountText(count);
  return std::to_string(count.all) + ", " + std::to_string(count.unread) + " unread by trainee";
}

}  // namespace insonate
