#include "PersonReading.h"

#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/RepeatedValues.h>

namespace insonate::review {

Result<PersonFacts> readPerson(const SignedIn& by, const std::string& person,
                               const std::optional<Curriculum>& curriculum, std::int64_t now_us) {
  PersonFacts facts;
  facts.curriculum = curriculum;
  auto who = PeopleStore(by).person(person);
  if (!who) return tl::unexpected(who.error());
  facts.person = std::move(*who);
  const AttemptStore attempts(by);
  const auto changes = attempts.changes(person);
  if (!changes) return tl::unexpected(changes.error());
  auto history = attempts.history(person);
  if (!history) return tl::unexpected(history.error());
  facts.history = std::move(*history);
  const auto repeated = repeatedValues(by, person);
  if (!repeated) return tl::unexpected(repeated.error());
  for (const AttemptFacts& one : facts.history) {
    auto flags = implausibilities(one);
    if (repeated->contains(one.id)) flags.push_back(Implausible::SameValues);
    if (!flags.empty()) facts.implausible[one.id] = std::move(flags);
  }
  auto newest = attempts.page(person, kPage);
  if (!newest) return tl::unexpected(newest.error());
  facts.newest = std::move(*newest);
  auto comments = CommentStore(by).countsOf(person);
  if (!comments) return tl::unexpected(comments.error());
  facts.comments = std::move(*comments);
  auto forms = formCounts(by, person);
  if (!forms) return tl::unexpected(forms.error());
  facts.forms = std::move(*forms);
  if (!curriculum) return facts;
  facts.progress = computeProgress(*curriculum, facts.history, now_us);
  facts.standing = computeStanding(*curriculum, facts.history, facts.progress, now_us, *changes);
  return facts;
}

Result<std::map<std::string, int>> formCounts(const SignedIn& by, const std::string& person) {
  const auto forms = FormStore(by).listByPerson(person);
  if (!forms) return tl::unexpected(forms.error());
  std::map<std::string, int> counts;
  for (const StoredForm& one : *forms)
    if (!one.filled.attempt.empty() && one.filled.by != person) ++counts[one.filled.attempt];
  return counts;
}

}  // namespace insonate::review
