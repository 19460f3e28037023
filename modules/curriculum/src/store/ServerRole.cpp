#include "store/Session.h"

#include <insonate/curriculum/StoreUpkeep.h>

#include <algorithm>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Transaction;

/// Names that need no quotes in PostgreSQL; longer names are cut there without a warning.
bool isPlainRole(const std::string& role) {
  constexpr std::size_t kLongest = 63;
  return !role.empty() && role.size() <= kLongest && !(role[0] >= '0' && role[0] <= '9') &&
         std::ranges::all_of(role, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

/// Triggers keep facts from being changed, but the owner of a table can switch its triggers off. This role owns no
/// table, and can only add to the log and to the published curricula. An erasure of a person replaces details of the
/// log, which a trigger and the check of the log control. The role can use tables of later schemas, too.
std::string grantsTo(const std::string& role) {
  return "GRANT USAGE ON SCHEMA public TO " + role +
         "; GRANT SELECT, INSERT, UPDATE, DELETE ON ALL TABLES IN SCHEMA public TO " + role +
         "; GRANT USAGE ON ALL SEQUENCES IN SCHEMA public TO " + role +
         "; REVOKE INSERT, UPDATE, DELETE ON schema_migrations FROM " + role +
         "; REVOKE UPDATE, DELETE ON audit, curricula FROM " + role + "; GRANT UPDATE (detail) ON audit TO " + role +
         "; ALTER DEFAULT PRIVILEGES IN SCHEMA public GRANT SELECT, INSERT, UPDATE, DELETE ON TABLES TO " + role +
         "; ALTER DEFAULT PRIVILEGES IN SCHEMA public GRANT USAGE ON SEQUENCES TO " + role;
}

/// PostgreSQL only warns of permissions that a user cannot pass on, or that a role has by other means.
Result<void> grant(Transaction& transaction, const std::string& role) {
  const bool isOwner = transaction.number(
      "SELECT CAST(pg_has_role(relowner, 'USAGE') AS INTEGER) FROM pg_class WHERE oid = CAST('audit' AS regclass)");
  if (transaction.error()) return tl::unexpected(*transaction.error());
  if (!isOwner)
    return fail("The user of " + transaction.place() +
                " does not own the tables, and cannot give permissions on them. Give the address with their owner.");
  transaction.script(grantsTo(role));
  const bool canRewrite = transaction.number("SELECT CAST(has_table_privilege(?, 'audit', 'UPDATE') AS INTEGER)", role);
  if (transaction.error()) return tl::unexpected(*transaction.error());
  if (canRewrite)
    return fail(
        "The role " + role +
        " owns the tables or is a superuser, and could rewrite the audit log. Make another role for the server.");
  return {};
}

}  // namespace

Result<void> StoreUpkeep::grantServerRole(const std::string& role) const {
  if (!isPlainRole(role))
    return fail(
        "'" + role.substr(0, 100) +
        "' is not a name that this command accepts: use up to 63 small letters, digits and underscores, and begin "
        "with a letter.");
  return by_.session()->write({.act = Act::LookAfterStore, .detail = "grant to role " + role},
                              [&](Transaction& transaction, const Actor&) -> Result<void> {
                                if (!by_.session()->core().address().isServer)
                                  return fail(transaction.place() +
                                              " is a file, which has no roles. Give the address of a PostgreSQL "
                                              "database.");
                                return grant(transaction, role);
                              });
}

}  // namespace insonate
