#include "Answer.h"
#include "Groups.h"
#include "Lookup.h"
#include "StoreCounts.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/StoreUpkeep.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <memory>

namespace insonate::cli {
namespace {

/// Asks before the store is opened, which alone would bring it up to date.
Result<Answer> migrate(const StoreOptions& options) {
  if (auto there = checkThere(options); !there) return tl::unexpected(there.error());
  const auto password = readOwnPassword(options);
  if (!password) return tl::unexpected(password.error());
  if (auto done = migrateStore(addressOf(options), options.name, *password); !done) return tl::unexpected(done.error());
  const auto store = openStore(options);
  if (!store) return tl::unexpected(store.error());
  const auto by = store->signIn(options.name, *password);
  if (!by) return tl::unexpected(by.error());
  const auto facts = StoreUpkeep(*by).facts();
  if (!facts) return tl::unexpected(facts.error());
  return Answer{countsJson(*facts), facts->place + " is at schema " + std::to_string(facts->schema) +
                                        ", the newest: " + countsOf(*facts) + "."};
}

Result<Answer> backup(const SignedIn& by, const std::string& file) {
  if (auto done = StoreUpkeep(by).backup(file, terminalProgress()); !done) return tl::unexpected(done.error());
  return Answer{{{"file", file}},
                "Wrote " + file + ", and the recordings of its attempts to " + file +
                    ".recordings. 'curriculum restore' checks and restores both."};
}

Result<Answer> restore(const StoreOptions& options, const std::string& backup) {
  const std::string address = addressOf(options);
  if (isServer(address))
    return fail(
        "A store on a server must be restored with the tools of the server (pg_restore). Name a file with --database.");
  const auto password = readOwnPassword(options);
  if (!password) return tl::unexpected(password.error());
  if (auto done = restoreStore(address, backup, options.name, *password); !done) return tl::unexpected(done.error());
  return Answer{{{"database", address}, {"backup", backup}},
                address + " was restored from " + backup + ". The former store was kept beside it."};
}

Result<Answer> grant(const SignedIn& by, const std::string& role) {
  if (auto done = StoreUpkeep(by).grantServerRole(role); !done) return tl::unexpected(done.error());
  return Answer{{{"role", role}},
                role + " can run insonate-server. It cannot change tables, nor delete entries of the audit log."};
}

struct AuditArguments {
  std::string person;
  int count = 50;
  std::int64_t before = 0;
};

Result<Answer> audit(const SignedIn& by, const AuditArguments& a) {
  std::string person;
  if (!a.person.empty()) {
    const auto found = personNamed(by, a.person);
    if (!found) return tl::unexpected(found.error());
    person = found->id;
  }
  const auto page = AuditLog(by).page(a.count, a.before, person);
  if (!page) return tl::unexpected(page.error());
  const auto people = PeopleStore(by).all();
  if (!people) return tl::unexpected(people.error());
  const auto nameOfId = [&](const std::string& id) {
    const auto found = std::ranges::find(*people, id, &Person::id);
    return found == people->end() ? id : found->name;
  };
  Json rows = Json::array();
  for (const AuditEntry& entry : *page)
    rows.push_back({{"number", entry.number},
                    {"time", timeText(entry.time_us)},
                    {"actor", entry.actor},
                    {"actor_name", nameOfId(entry.actor)},
                    {"workstation", entry.workstation},
                    {"act", entry.act},
                    {"person", entry.person},
                    {"person_name", nameOfId(entry.person)},
                    {"detail", entry.detail},
                    {"allowed", entry.allowed},
                    {"hash", entry.hash}});
  return Answer{{{"entries", rows}},
                tableOf(rows, {{"number", "number"},
                               {"time", "time"},
                               {"act", "act"},
                               {"allowed", "allowed"},
                               {"actor_name", "by"},
                               {"person_name", "about"},
                               {"detail", "detail"}})};
}

}  // namespace

void addUpkeepCommands(CLI::App& curriculum, Outcome& outcome) {
  auto copy = std::make_shared<std::string>(), backedUp = std::make_shared<std::string>();
  addSignedInCommand(curriculum, outcome, "backup",
                     "Copy a store (in a file) and its recordings; other users can work meanwhile",
                     [copy](const SignedIn& by) { return backup(by, *copy); })
      ->add_option("FILE", *copy, "File to write")
      ->required()
      ->check(notEmpty());
  addStoreCommand(curriculum, outcome, "restore",
                  "Replace a store by a backup (for administrators of the store, or of the backup if the store is "
                  "missing or damaged)",
                  SigningIn::Yes, [backedUp](const StoreOptions& options) { return restore(options, *backedUp); })
      ->add_option("BACKUP", *backedUp, "File of 'curriculum backup'")
      ->required()
      ->check(notEmpty());
  addStoreCommand(curriculum, outcome, "migrate",
                  "Upgrade a store to the present version of the program, after a backup beside the store, and print "
                  "what the store contains (for administrators of the store)",
                  SigningIn::Yes, migrate);
  auto role = std::make_shared<std::string>();
  addSignedInCommand(
      curriculum, outcome, "grant",
      "Give a PostgreSQL role the permissions that insonate-server needs, and no more (as the owner of the "
      "tables)",
      [role](const SignedIn& by) { return grant(by, *role); })
      ->add_option("ROLE", *role, "Existing role: CREATE ROLE name LOGIN PASSWORD '...'")
      ->required()
      ->check(notEmpty());
  addVerifyCommand(curriculum, outcome);
  auto a = std::make_shared<AuditArguments>();
  CLI::App* log = addSignedInCommand(curriculum, outcome, "audit",
                                     "Print the audit log of accesses to other people's data, newest first",
                                     [a](const SignedIn& by) { return audit(by, *a); });
  log->add_option("--person", a->person, "Print only entries by or about this person");
  log->add_option("--count", a->count, "Maximum number of entries")->check(CLI::Range(1, 1000))->capture_default_str();
  log->add_option("--before", a->before, "Print only entries with a number below this")->check(CLI::PositiveNumber);
}

}  // namespace insonate::cli
