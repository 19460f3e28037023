#include "store/PeopleRows.h"
#include "store/Session.h"

#include <insonate/curriculum/ClassAccess.h>

#include <algorithm>

namespace insonate {

Result<std::vector<Person>> seeClass(const SignedIn& by, const std::string& cohort, bool isRefresh) {
  using store::Act;
  using store::Actor;
  using store::Transaction;
  store::Session& session = *by.session();
  const auto attempts = session.read({.act = Act::SeeCohortAttempts, .cohort = cohort, .isLoggedHourly = isRefresh},
                                     [](Transaction&, const Actor&) -> Result<void> { return {}; });
  if (!attempts) return tl::unexpected(attempts.error());
  return session.read(
      {.act = Act::SeeMembers, .cohort = cohort, .isLoggedHourly = isRefresh},
      [&](Transaction& transaction, const Actor&) -> Result<std::vector<Person>> {
        std::vector<Person> people;
        for (const store::Row& row : transaction.rows("SELECT " INSONATE_PERSON_COLUMNS
                                                      " FROM memberships JOIN people ON people.id = memberships.person "
                                                      "WHERE memberships.cohort = ?",
                                                      cohort))
          people.push_back(store::personOf(row));
        std::ranges::sort(people, {}, &Person::id);
        return people;
      });
}

}  // namespace insonate
