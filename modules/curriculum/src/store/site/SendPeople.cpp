#include "store/Names.h"
#include "store/PeopleRows.h"
#include "store/Texts.h"
#include "store/site/Up.h"

#include <set>
#include <string>
#include <vector>

namespace insonate::store {
namespace {

struct Sent {
  Person person{};
  std::string password{};
  bool mustChange = false;
  std::int64_t version = 1;
};

Result<std::vector<Sent>> peopleOf(Core& here) {
  return inTransaction(here, Way::Read, [](Transaction& transaction) -> Result<std::vector<Sent>> {
    std::vector<Sent> people;
    for (const Row& row :
         transaction.rows("SELECT " INSONATE_PERSON_COLUMNS
                          ", password, must_change, version FROM people JOIN credentials ON person = id"))
      people.push_back({personOf(row), row.text(6), row.truth(7), row.number(8)});
    return people;
  });
}

/// Free name on the server: "anna", or "anna-2" if another anna exists, and so on.
std::string freeName(Transaction& server, const std::string& name) {
  std::string free = name;
  for (int i = 2; server.row("SELECT id FROM people WHERE name_key = ?", nameKey(free)); ++i)
    free = name + "-" + std::to_string(i);
  return free;
}

void insert(Transaction& server, const Core& here, const Core& core, const Sent& sent, UploadReport& report) {
  const std::string name = freeName(server, sent.person.name);
  server.run("INSERT INTO people VALUES (?, ?, ?, ?, ?, ?, 1)", sent.person.id, name, nameKey(name),
             sent.person.fullName, sent.person.email, nameOf(Role::Trainee));
  server.run("INSERT INTO credentials VALUES (?, ?, ?, ?)", sent.person.id, sent.password, sent.mustChange,
             sent.version);
  core.audit(server, "", "add person of workstation", sent.person.id, name + " of " + here.workstation());
  if (name != sent.person.name)
    report.troubles.push_back("The server already has another person '" + sent.person.name + "': this one is '" + name +
                              "' there and here from now on. An administrator can rename them on the server.");
  report.troubles.push_back(
      "'" + name +
      "' existed only on this computer, and is now a disabled trainee on the server. An administrator decides there.");
}

}  // namespace

Result<void> sendPeople(Core& here, Core& server, UploadReport& report) {
  const auto people = peopleOf(here);
  if (!people) return tl::unexpected(people.error());
  const auto known = inTransaction(server, Way::Read, [](Transaction& transaction) -> Result<std::set<std::string>> {
    std::set<std::string> ids;
    for (const Row& row : transaction.rows("SELECT id FROM people")) ids.insert(row.text(0));
    return ids;
  });
  if (!known) return tl::unexpected(known.error());
  std::vector<Sent> unknown;
  for (const Sent& sent : *people)
    if (!known->contains(sent.person.id)) unknown.push_back(sent);
  if (unknown.empty()) return {};
  return inTransaction(server, Way::Write, [&](Transaction& transaction) -> Result<void> {
    for (const Sent& sent : unknown)
      if (!findPerson(transaction, sent.person.id)) insert(transaction, here, server, sent, report);
    return {};
  });
}

}  // namespace insonate::store
