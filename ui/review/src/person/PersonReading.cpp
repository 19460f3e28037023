#include "PersonReading.h"

#include <insonate/curriculum/PeopleStore.h>

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
  auto notes = readAttemptNotes(by, person, facts.history);
  if (!notes) return tl::unexpected(notes.error());
  facts.notes = std::move(*notes);
  auto newest = attempts.page(person, kPage);
  if (!newest) return tl::unexpected(newest.error());
  facts.newest = std::move(*newest);
  if (!curriculum) return facts;
  facts.progress = computeProgress(*curriculum, facts.history, now_us);
  facts.standing = computeStanding(*curriculum, facts.history, facts.progress, now_us, *changes);
  return facts;
}

}  // namespace insonate::review
