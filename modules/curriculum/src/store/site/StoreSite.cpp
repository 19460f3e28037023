#include "store/PasswordProof.h"
#include "store/Session.h"
#include "store/site/Site.h"

#include <insonate/curriculum/PeopleStore.h>

namespace insonate::store {

bool StoreSite::answers() {
  return true;
}

Result<void> StoreSite::greet(Core& here) {
  if (here.place() == place()) return fail(place() + " cannot be its own server; name the server's address.");
  const auto people = inTransaction(*core_, Way::Read, [](Transaction& transaction) -> Result<bool> {
    return transaction.row("SELECT id FROM people LIMIT 1").has_value();
  });
  if (!people) return tl::unexpected(people.error());
  if (!*people) return fail(place() + " has no people yet; open it and set up its administrator first.");
  return {};
}

Result<std::set<std::string>> StoreSite::unknownPeople(const std::set<std::string>& ids) {
  return inTransaction(*core_, Way::Read, [&](Transaction& transaction) -> Result<std::set<std::string>> {
    std::set<std::string> unknown;
    for (const std::string& id : ids)
      if (!transaction.row("SELECT id FROM people WHERE id = ?", id)) unknown.insert(id);
    return unknown;
  });
}

Result<Taken> StoreSite::take(const SentBatch& batch) {
  return inTransaction(*core_, Way::Write,
                       [&](Transaction& transaction) { return takeBatch(transaction, *core_, sender_, batch); });
}

Result<Taught> StoreSite::teach() {
  return readTaught(*core_, sender_);
}

Result<AttemptsElsewhere> StoreSite::attemptsElsewhere(const Digests& known, const std::string& after) {
  return readElsewhere(*core_, sender_, known, after);
}

Result<std::optional<SentPerson>> StoreSite::signIn(const std::string& name, const std::string& password) {
  if (sender_.isTrusted) return std::nullopt;
  const auto known = provePassword(*core_, name, password, "workstation " + sender_.workstation);
  if (!known) return tl::unexpected(known.error());
  return inTransaction(*core_, Way::Write, [&](Transaction& transaction) -> Result<std::optional<SentPerson>> {
    knowAt(transaction, sender_.workstation, known->person.id, core_->now_us());
    core_->audit(transaction, known->person.id, "sign in at workstation", known->person.id, sender_.workstation);
    return SentPerson{known->person, known->hashed, known->mustChange, known->passwordVersion};
  });
}

Result<SentPerson> StoreSite::changePassword(const std::string& name, const std::string& old,
                                             const std::string& password) {
  const auto known = provePassword(*core_, name, old, "workstation " + sender_.workstation);
  if (!known) return tl::unexpected(known.error());
  const SignedIn by(std::make_shared<Session>(core_, known->person, known->passwordVersion, known->mustChange));
  if (auto changed = PeopleStore(by).changeOwnPassword(old, password); !changed) return tl::unexpected(changed.error());
  auto person = signIn(name, password);
  if (!person) return tl::unexpected(person.error());
  if (!*person)
    return fail("The password of the server's database can be changed only with the tools of the database server.");
  return std::move(**person);
}

/// A workstation that opens the database keeps its recordings itself (StoreServices::recordings).
Result<void> StoreSite::takeRecordings(Core& /*here*/, UploadReport& /*report*/, const Progress& /*progress*/) {
  return {};
}

}  // namespace insonate::store
