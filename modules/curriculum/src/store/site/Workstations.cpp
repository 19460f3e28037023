#include "store/Passwords.h"
#include "store/Session.h"
#include "store/Texts.h"

#include <insonate/curriculum/Workstations.h>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Row;
using store::Transaction;

Result<void> checkName(const std::string& name) {
  if (name.empty() || name.size() > 64) return fail("The name of a workstation has 1 to 64 characters.");
  return store::checkTitle("The name of the workstation", name);
}

}  // namespace

Result<std::string> Workstations::add(const std::string& name) const {
  if (auto ok = checkName(name); !ok) return tl::unexpected(ok.error());
  const std::string token = store::randomToken();
  if (token.empty()) return fail("There are no random numbers for a token; restart the program.");
  store::Core& core = by_.session()->core();
  return by_.session()->write(
      {.act = Act::ManageWorkstations, .detail = "add " + name},
      [&](Transaction& transaction, const Actor& actor) -> Result<std::string> {
        const auto known = transaction.row("SELECT revoked_us FROM workstations WHERE name = ?", name);
        if (known && known->isNull(0))
          return fail("The workstation '" + name + "' has a token already. Revoke it first, or choose another name.");
        if (known)
          transaction.run(
              "UPDATE workstations SET token_hash = ?, added_by = ?, added_us = ?, seen_us = NULL, revoked_us = NULL, "
              "store_secret = '' WHERE name = ?",
              store::sha256(token), actor.id, core.now_us(), name);
        else
          transaction.run("INSERT INTO workstations VALUES (?, ?, ?, ?, NULL, NULL, '')", name, store::sha256(token),
                          actor.id, core.now_us());
        return token;
      });
}

Result<void> Workstations::revoke(const std::string& name) const {
  store::Core& core = by_.session()->core();
  return by_.session()->write({.act = Act::ManageWorkstations, .detail = "revoke " + name},
                              [&](Transaction& transaction, const Actor&) -> Result<void> {
                                const auto changed = transaction.run(
                                    "UPDATE workstations SET revoked_us = ? WHERE name = ? AND revoked_us IS NULL",
                                    core.now_us(), name);
                                // People sign in anew where a revoked workstation gets a new token.
                                transaction.run("DELETE FROM workstation_people WHERE workstation = ?", name);
                                if (changed == 0)
                                  return fail("There is no workstation '" + name + "' with a token; look at the list.");
                                return {};
                              });
}

Result<std::vector<Workstation>> Workstations::list() const {
  return by_.session()->read(
      {.act = Act::ManageWorkstations, .detail = "list"},
      [&](Transaction& transaction, const Actor&) -> Result<std::vector<Workstation>> {
        std::vector<Workstation> workstations;
        for (const Row& row : transaction.rows(
                 "SELECT workstations.name, CASE WHEN full_name = '' THEN people.name ELSE full_name END, added_us, "
                 "seen_us, revoked_us FROM workstations JOIN people ON people.id = added_by ORDER BY "
                 "workstations.name"))
          workstations.push_back({row.text(0), row.text(1), row.number(2), row.time(3), row.time(4)});
        return workstations;
      });
}

}  // namespace insonate
