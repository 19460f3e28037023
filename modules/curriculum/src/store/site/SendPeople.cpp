#include "store/Names.h"
#include "store/PeopleRows.h"
#include "store/Texts.h"
#include "store/site/Site.h"

#include <set>
#include <string>
#include <vector>

namespace insonate::store {
namespace {

constexpr std::size_t kMostNewPeople = 200;

/// Free name on the server: "anna", or "anna-2" if another anna exists, and so on.
std::string freeName(Transaction& server, const std::string& name) {
  std::string free = name;
  for (int i = 2; server.row("SELECT id FROM people WHERE name_key = ?", nameKey(free)); ++i)
    free = name + "-" + std::to_string(i);
  return free;
}

void insert(Transaction& server, const Core& core, const Sender& sender, const SentPerson& sent,
            std::vector<std::string>& troubles) {
  const std::string name = freeName(server, sent.person.name);
  server.run("INSERT INTO people VALUES (?, ?, ?, ?, ?, ?, 1)", sent.person.id, name, nameKey(name),
             sent.person.fullName, sent.person.email, nameOf(Role::Trainee));
  // The hash of an untrusted workstation is not used: it states how long a comparison takes. An administrator who
  // enables the person sets a password.
  server.run("INSERT INTO credentials VALUES (?, ?, ?, ?)", sent.person.id, sender.isTrusted ? sent.password : "*",
             sent.mustChange, sent.version);
  if (!sender.isTrusted) knowAt(server, sender.workstation, sent.person.id, core.now_us());
  core.audit(server, "", "add person of workstation", sent.person.id, "of " + sender.workstation);
  if (name != sent.person.name)
    troubles.push_back("The server already has another person '" + sent.person.name +
                       "'. On the server and on this computer, the new person is called '" + name +
                       "' from now on. An administrator can rename the person on the server.");
  troubles.push_back("'" + name +
                     "' existed only on this computer, and is now a disabled trainee on the server. An administrator "
                     "can enable this account on the server.");
}

Result<void> checkSent(const SentPerson& sent) {
  if (!isUuid(sent.person.id)) return fail("The id of a person is not a UUID in lower case.");
  return checkPerson(sent.person);
}

}  // namespace

Result<std::vector<SentPerson>> peopleOf(Core& here) {
  return inTransaction(here, Way::Read, [](Transaction& transaction) -> Result<std::vector<SentPerson>> {
    std::vector<SentPerson> people;
    for (const Row& row :
         transaction.rows("SELECT " INSONATE_PERSON_COLUMNS
                          ", password, must_change, version FROM people JOIN credentials ON person = id"))
      people.push_back({personOf(row), row.text(6), row.truth(7), row.number(8)});
    return people;
  });
}

Result<std::vector<std::string>> StoreSite::addPeople(const std::vector<SentPerson>& people) {
  return inTransaction(*core_, Way::Write, [&](Transaction& transaction) -> Result<std::vector<std::string>> {
    std::vector<std::string> troubles;
    if (!sender_.isTrusted && people.size() > kMostNewPeople)
      return fail("The workstation has more than " + std::to_string(kMostNewPeople) +
                  " people whom the server does not know. Add them to the server first.");
    for (const SentPerson& sent : people) {
      if (!sender_.isTrusted)
        if (auto ok = checkSent(sent); !ok) return tl::unexpected(ok.error());
      if (!findPerson(transaction, sent.person.id)) insert(transaction, *core_, sender_, sent, troubles);
    }
    return troubles;
  });
}

}  // namespace insonate::store
