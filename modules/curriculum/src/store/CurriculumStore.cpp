#include "store/PasswordProof.h"
#include "store/Passwords.h"
#include "store/PeopleRows.h"
#include "store/Session.h"
#include "store/Texts.h"

#include <insonate/curriculum/CurriculumStore.h>

namespace insonate {
namespace {

using store::Core;
using store::Transaction;
using store::Way;

}  // namespace

CurriculumStore::CurriculumStore(std::shared_ptr<store::Core> core) : core_(std::move(core)) {}

Result<CurriculumStore> CurriculumStore::open(const std::string& address, const StoreServices& services) {
  auto core = Core::open(address, services);
  if (!core) return tl::unexpected(core.error());
  return CurriculumStore(std::move(*core));
}

const std::string& CurriculumStore::place() const {
  return core_->place();
}

const std::string& CurriculumStore::workstation() const {
  return core_->workstation();
}

bool CurriculumStore::isReadOnly() const {
  return core_->isReadOnly();
}

const std::filesystem::path& CurriculumStore::recordings() const {
  return core_->recordings();
}

Result<bool> CurriculumStore::hasPeople() const {
  return inTransaction(*core_, Way::Read, [](Transaction& transaction) -> Result<bool> {
    return transaction.row("SELECT id FROM people LIMIT 1").has_value();
  });
}

Result<SignedIn> CurriculumStore::createFirstAdministrator(const NewPerson& first, const std::string& password) const {
  if (auto ok = store::checkPassword(password); !ok) return tl::unexpected(ok.error());
  const auto hashed = store::hashedPassword(password, core_->passwordCost());
  if (!hashed) return tl::unexpected(hashed.error());
  NewPerson added = first;
  added.role = Role::Administrator;
  const auto person = inTransaction(*core_, Way::Write, [&](Transaction& transaction) -> Result<Person> {
    if (transaction.row("SELECT id FROM people LIMIT 1"))
      return fail(core_->place() + " has people already; sign in, or ask an administrator to add you.");
    auto inserted = store::insertPerson(transaction, store::freshUuid(), added, *hashed, false);
    if (inserted) core_->audit(transaction, inserted->id, "create first administrator", inserted->id, "");
    return inserted;
  });
  if (!person) return tl::unexpected(person.error());
  return SignedIn(std::make_shared<store::Session>(core_, *person, 1, false));
}

Result<SignedIn> CurriculumStore::signIn(const std::string& name, const std::string& password) const {
  const auto known = store::provePassword(*core_, name, password);
  if (!known) return tl::unexpected(known.error());
  return SignedIn(std::make_shared<store::Session>(core_, known->person, known->passwordVersion, known->mustChange));
}

Result<SignedIn> CurriculumStore::signInByToken(const std::string& token) const {
  const auto session =
      inTransaction(*core_, Way::Log, [&](Transaction& transaction) -> Result<std::shared_ptr<store::Session>> {
        const auto row = transaction.row(
            "SELECT " INSONATE_PERSON_COLUMNS
            ", credentials.version FROM sign_in_tokens JOIN people ON people.id = sign_in_tokens.person "
            "JOIN credentials ON credentials.person = people.id WHERE hash = ? AND disabled = 0 AND must_change = 0 "
            "AND credentials.version = sign_in_tokens.version",
            store::sha256(token));
        if (!row) return fail("This computer no longer keeps you signed in. Sign in with your password.");
        const Person person = store::personOf(*row);
        core_->audit(transaction, person.id, "sign in", person.id, "token");
        return std::make_shared<store::Session>(core_, person, row->number(6), false);
      });
  if (!session) return tl::unexpected(session.error());
  return SignedIn(*session);
}

SignedIn CurriculumStore::guest() const {
  return SignedIn(std::make_shared<store::Session>(core_, Person{}, 0, false));
}

}  // namespace insonate
