#include "store/PeopleRows.h"

#include "store/Names.h"
#include "store/Texts.h"

namespace insonate::store {

Person personOf(const Row& row, std::size_t first) {
  return {.id = row.text(first),
          .name = row.text(first + 1),
          .fullName = row.text(first + 2),
          .email = row.text(first + 3),
          .role = roleNamed(row.text(first + 4)),
          .disabled = row.truth(first + 5)};
}

std::optional<Person> findPerson(Transaction& transaction, const std::string& id) {
  const auto row = transaction.row("SELECT " INSONATE_PERSON_COLUMNS " FROM people WHERE id = ?", id);
  return row ? std::optional(personOf(*row)) : std::nullopt;
}

tl::unexpected<Error> unknownPerson() {
  return fail("There is no such person; reload the list.");
}

Result<void> checkPerson(const Person& person) {
  if (auto ok = checkSignInName(person.name); !ok) return ok;
  if (auto ok = checkTitle("The full name", person.fullName); !ok) return ok;
  return checkEmail(person.email);
}

Result<void> checkNameIsFree(Transaction& transaction, const Person& person) {
  const auto taken =
      transaction.number("SELECT COUNT(*) FROM people WHERE name_key = ? AND id <> ?", nameKey(person.name), person.id);
  if (taken > 0) return fail("There is a person named '" + person.name + "' already; choose another name.");
  return {};
}

Result<void> checkEmailIsFree(Transaction& transaction, const Person& person) {
  if (person.email.empty()) return {};
  for (const Row& row : transaction.rows("SELECT email FROM people WHERE email <> '' AND id <> ?", person.id))
    if (nameKey(row.text(0)) == nameKey(person.email))
      return fail("The e-mail address " + person.email +
                  " belongs to another account. Use that account, or enter another address.");
  return {};
}

Result<Person> insertPerson(Transaction& transaction, const std::string& id, const NewPerson& added,
                            const std::string& hashed, bool mustChange) {
  const Person person{id, added.name, added.fullName, added.email, added.role, false};
  if (auto ok = checkPerson(person); !ok) return tl::unexpected(ok.error());
  if (auto ok = checkNameIsFree(transaction, person); !ok) return tl::unexpected(ok.error());
  if (auto ok = checkEmailIsFree(transaction, person); !ok) return tl::unexpected(ok.error());
  transaction.run("INSERT INTO people VALUES (?, ?, ?, ?, ?, ?, 0)", person.id, person.name, nameKey(person.name),
                  person.fullName, person.email, nameOf(person.role));
  transaction.run("INSERT INTO credentials VALUES (?, ?, ?, 1)", person.id, hashed, mustChange);
  return person;
}

bool isErased(Transaction& transaction, const std::string& person) {
  return transaction.number("SELECT COUNT(*) FROM erasures WHERE person = ?", person) > 0;
}

Result<void> checkIsNotErased(Transaction& transaction, const std::string& person) {
  if (!isErased(transaction, person)) return {};
  return fail("This person was erased, and the account stays disabled. Add the person again to make a new account.");
}

Result<void> checkTakesTexts(Transaction& transaction, const std::string& person) {
  if (!isErased(transaction, person)) return {};
  return fail("This person was erased, so that no texts about the person are stored any more.");
}

Result<void> checkIsNotArchived(Transaction& transaction, const std::string& cohort) {
  const auto found = transaction.row("SELECT name FROM cohorts WHERE id = ? AND archived = 1", cohort);
  if (found) return fail("The class '" + found->text(0) + "' is archived. An administrator can restore it.");
  return {};
}

Result<void> putIntoCohort(Transaction& transaction, const std::string& cohort, const Person& person, bool teaches) {
  if (!transaction.row("SELECT id FROM cohorts WHERE id = ?", cohort))
    return fail("There is no such class; reload the list.");
  if (auto ok = checkIsNotArchived(transaction, cohort); !ok) return ok;
  if (auto ok = checkIsNotErased(transaction, person.id); !ok) return ok;
  if (teaches && person.role == Role::Trainee)
    return fail(person.name + " is a trainee and cannot teach. Give this person the role of instructor first.");
  transaction.run(
      "INSERT INTO memberships VALUES (?, ?, ?) ON CONFLICT (cohort, person) DO UPDATE SET teaches = excluded.teaches",
      cohort, person.id, teaches);
  return {};
}

void setPassword(Transaction& transaction, const std::string& person, const std::string& hashed, bool mustChange) {
  transaction.run("UPDATE credentials SET password = ?, must_change = ?, version = version + 1 WHERE person = ?",
                  hashed, mustChange, person);
}

}  // namespace insonate::store
