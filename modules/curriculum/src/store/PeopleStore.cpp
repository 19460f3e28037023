#include "store/Names.h"
#include "store/Outbox.h"
#include "store/PasswordProof.h"
#include "store/Passwords.h"
#include "store/PeopleRows.h"
#include "store/Session.h"
#include "store/Texts.h"

#include <insonate/curriculum/PeopleStore.h>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Transaction;

/// Tells whether this person is the only one who can still sign in as an administrator.
bool isLastAdministrator(Transaction& transaction, const std::string& person) {
  return transaction.number("SELECT COUNT(*) FROM people WHERE role = 'administrator' AND disabled = 0 AND id <> ?",
                            person) == 0;
}

Result<void> changePerson(Transaction& transaction, const Person& person) {
  const auto before = store::findPerson(transaction, person.id);
  if (!before) return store::unknownPerson();
  if (auto ok = store::checkIsNotErased(transaction, person.id); !ok) return ok;
  if (auto ok = store::checkNameIsFree(transaction, person); !ok) return ok;
  // Accounts of earlier programs may share an address; their other data can still be changed.
  if (store::nameKey(person.email) != store::nameKey(before->email))
    if (auto ok = store::checkEmailIsFree(transaction, person); !ok) return ok;
  const bool staysAdministrator = person.role == Role::Administrator && !person.disabled;
  if (before->role == Role::Administrator && !before->disabled && !staysAdministrator &&
      isLastAdministrator(transaction, person.id))
    return fail(before->name + " is the last administrator. Make another person an administrator first.");
  transaction.run(
      "UPDATE people SET name = ?, name_key = ?, full_name = ?, email = ?, role = ?, disabled = ? WHERE id = ?",
      person.name, store::nameKey(person.name), person.fullName, person.email, store::nameOf(person.role),
      person.disabled, person.id);
  // Trainees do not teach: an instructor who becomes a trainee no longer sees the former cohorts.
  if (person.role == Role::Trainee)
    transaction.run("DELETE FROM memberships WHERE person = ? AND teaches = 1", person.id);
  return {};
}

/// The log names people by their ids alone, so that a name can be erased.
std::string described(const Person& person) {
  return std::string(store::nameOf(person.role)) + (person.disabled ? ", disabled" : "");
}

}  // namespace

Result<Person> PeopleStore::person(const std::string& id) const {
  return by_.session()->read({.act = Act::SeePerson, .person = id},
                             [&](Transaction& transaction, const Actor&) -> Result<Person> {
                               const auto found = store::findPerson(transaction, id);
                               if (!found) return store::unknownPerson();
                               return *found;
                             });
}

Result<std::vector<Person>> PeopleStore::all() const {
  return by_.session()->read(
      {.act = Act::SeeAllPeople}, [&](Transaction& transaction, const Actor&) -> Result<std::vector<Person>> {
        std::vector<Person> people;
        for (const auto& row : transaction.rows("SELECT " INSONATE_PERSON_COLUMNS " FROM people ORDER BY name_key"))
          people.push_back(store::personOf(row));
        return people;
      });
}

Result<Person> PeopleStore::add(const NewPerson& person, const std::string& password, const std::string& cohort) const {
  store::Session& session = *by_.session();
  const auto hashed = store::checkedAndHashed(password, session.core().passwordCost());
  if (!hashed) return tl::unexpected(hashed.error());
  const bool asTrainee = person.role == Role::Trainee && !cohort.empty();
  const std::string id = store::freshUuid();
  const std::string detail = id + ", " + std::string(store::nameOf(person.role));
  return session.write({.act = asTrainee ? Act::AddTrainee : Act::AddPerson, .cohort = cohort, .detail = detail},
                       [&](Transaction& transaction, const Actor&) -> Result<Person> {
                         auto added = store::insertPerson(transaction, id, person, *hashed, true);
                         if (!added || cohort.empty()) return added;
                         if (auto in = store::putIntoCohort(transaction, cohort, *added, person.role != Role::Trainee);
                             !in)
                           return tl::unexpected(in.error());
                         return added;
                       });
}

Result<void> PeopleStore::change(const Person& person) const {
  if (auto ok = store::checkPerson(person); !ok) return ok;
  return by_.session()->write(
      {.act = Act::ChangePerson, .person = person.id, .detail = described(person)},
      [&](Transaction& transaction, const Actor&) { return changePerson(transaction, person); });
}

Result<void> PeopleStore::changeOwnDetails(const std::string& fullName, const std::string& email) const {
  const std::string& id = by_.person().id;
  return by_.session()->write(
      {.act = Act::ChangeOwnDetails, .person = id}, [&](Transaction& transaction, const Actor&) -> Result<void> {
        if (auto ok = store::checkTitle("The full name", fullName); !ok) return ok;
        if (auto ok = store::checkEmail(email); !ok) return ok;
        const auto before = store::findPerson(transaction, id);
        if (!before) return store::unknownPerson();
        if (store::nameKey(email) != store::nameKey(before->email))
          if (auto ok = store::checkEmailIsFree(transaction, Person{.id = id, .email = email}); !ok) return ok;
        transaction.run("UPDATE people SET full_name = ?, email = ? WHERE id = ?", fullName, email, id);
        return {};
      });
}

Result<void> PeopleStore::changeOwnPassword(const std::string& old, const std::string& password) const {
  store::Session& session = *by_.session();
  const std::string& id = by_.person().id;
  if (by_.isGuest()) return fail("Sign in first: a guest has no password.");
  if (password == old) return fail("The new password is the same as the old one. Choose another one.");
  const auto hashed = store::checkedAndHashed(password, session.core().passwordCost());
  if (!hashed) return tl::unexpected(hashed.error());
  // A wrong old password counts toward the lock-out, as at sign-in.
  if (const auto known = store::provePassword(session.core(), by_.person().name, old); !known)
    return tl::unexpected(known.error());
  const auto version = session.write(
      {.act = Act::ChangeOwnPassword, .person = id},
      [&](Transaction& transaction, const Actor&) -> Result<std::int64_t> {
        if (const auto site = transaction.row("SELECT server FROM site"); site && site->text(0).starts_with("http"))
          return fail("Your password is stored on " + site->text(0) + "; change it there.");
        store::setPassword(transaction, id, *hashed, false);
        store::putIntoOutbox(transaction, session.core(), "password", id);
        return transaction.number("SELECT version FROM credentials WHERE person = ?", id);
      });
  if (!version) return tl::unexpected(version.error());
  session.hasPassword(*version);
  return {};
}

Result<std::string> PeopleStore::staySignedIn() const {
  store::Session& session = *by_.session();
  const std::string& id = by_.person().id;
  const std::string token = store::randomToken();
  if (token.empty()) return fail("There are no random numbers for a token; restart the program.");
  return session.write({.act = Act::StaySignedIn, .person = id},
                       [&](Transaction& transaction, const Actor& actor) -> Result<std::string> {
                         transaction.run("INSERT INTO sign_in_tokens VALUES (?, ?, ?, ?)", store::sha256(token), id,
                                         actor.passwordVersion, session.core().now_us());
                         return token;
                       });
}

Result<void> PeopleStore::revokeTokens() const {
  const std::string& id = by_.person().id;
  return by_.session()->write({.act = Act::StaySignedIn, .person = id},
                              [&](Transaction& transaction, const Actor&) -> Result<void> {
                                transaction.run("DELETE FROM sign_in_tokens WHERE person = ?", id);
                                return {};
                              });
}

Result<void> PeopleStore::resetPassword(const std::string& person, const std::string& password) const {
  store::Session& session = *by_.session();
  const auto hashed = store::checkedAndHashed(password, session.core().passwordCost());
  if (!hashed) return tl::unexpected(hashed.error());
  return session.write({.act = Act::ResetPassword, .person = person},
                       [&](Transaction& transaction, const Actor&) -> Result<void> {
                         const auto found = store::findPerson(transaction, person);
                         if (!found) return store::unknownPerson();
                         if (auto ok = store::checkIsNotErased(transaction, person); !ok) return ok;
                         store::setPassword(transaction, person, *hashed, true);
                         store::resetFailures(transaction, found->name);
                         return {};
                       });
}

}  // namespace insonate
