#pragma once

#include "store/Core.h"
#include "store/sql/Transaction.h"

#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/Person.h>

#include <optional>
#include <string>

namespace insonate::store {

/// Columns of the table `people` that personOf() reads.
#define INSONATE_PERSON_COLUMNS "people.id, people.name, people.full_name, people.email, people.role, people.disabled"

Person personOf(const Row& row, std::size_t first = 0);
std::optional<Person> findPerson(Transaction& transaction, const std::string& id);
/// Returns the error of a request about a person who does not exist.
tl::unexpected<Error> unknownPerson();

Result<void> checkPerson(const Person& person);
/// Fails if another person has the sign-in name.
Result<void> checkNameIsFree(Transaction& transaction, const Person& person);
/// Fails if another person has the e-mail address, ignoring case: two accounts would split the attempts of one person.
Result<void> checkEmailIsFree(Transaction& transaction, const Person& person);
/// Inserts a person with a new id (freshUuid()) and an already hashed password; fails on an invalid or used name or
/// e-mail address.
Result<Person> insertPerson(Transaction& transaction, const std::string& id, const NewPerson& person,
                            const std::string& hashed, bool mustChange);

bool isErased(Transaction& transaction, const std::string& person);
/// Fails if the person was erased (PersonData::erase()).
Result<void> checkIsNotErased(Transaction& transaction, const std::string& person);
/// Refuses texts about a person who was erased, since they could not be erased any more.
Result<void> checkTakesTexts(Transaction& transaction, const std::string& person);

/// Fails if the cohort is archived.
Result<void> checkIsNotArchived(Transaction& transaction, const std::string& cohort);
/// Adds a person to a cohort, as instructor (`teaches`) or learner; an existing member gets this role. Fails if a
/// trainee would become an instructor, if the person was erased, and if the cohort is archived.
Result<void> putIntoCohort(Transaction& transaction, const std::string& cohort, const Person& person, bool teaches);

/// Sets a person's new password; sessions that were opened with the old password end.
void setPassword(Transaction& transaction, const std::string& person, const std::string& hashed, bool mustChange);

}  // namespace insonate::store
