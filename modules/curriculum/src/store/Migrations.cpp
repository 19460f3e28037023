#include "store/Migrations.h"

#include "store/sql/FileCopy.h"
#include "store/sql/Transaction.h"

#include <insonate/embedded/migrations.h>

#include <charconv>
#include <map>
#include <string>
#include <vector>

namespace insonate::store {
namespace {

/// Files are named NUMBER_name, or NUMBER_name_DIALECT if dialects differ; files of a number are sorted by name.
std::map<int, std::vector<embedded::migrations::File>> migrationsFor(const Dialect& dialect) {
  const std::string_view other = dialect.name == "sqlite" ? "_postgresql" : "_sqlite";
  std::map<int, std::vector<embedded::migrations::File>> found;
  for (const auto& file : embedded::migrations::files()) {
    if (file.name.ends_with(other)) continue;
    int number = 0;
    std::from_chars(file.name.data(), file.name.data() + file.name.size(), number);
    found[number].push_back(file);
  }
  return found;
}

Result<int> schemaOf(Connection& connection) {
  const auto rows = connection.rows("SELECT MAX(number) FROM schema_migrations", {});
  if (!rows) return tl::unexpected(rows.error());
  return rows->front().count(0);
}

Result<void> refuseNewer(int schema, const std::string& place) {
  if (schema <= newestSchema()) return {};
  return fail(place + " was made by a newer Insonate (its schema is " + std::to_string(schema) +
              ", this program knows " + std::to_string(newestSchema()) + "); install that version.");
}

Result<void> keepCopy(Connection& connection, const Address& address, int schema) {
  if (address.isServer || schema == 0) return {};
  return copyToFile(connection, copyBeforeMigration(address.file.toStdString(), schema));
}

Result<void> step(Connection& connection, int number, const std::vector<embedded::migrations::File>& files,
                  std::int64_t now_us) {
  Transaction transaction(connection, Way::Write);
  const auto done = transaction.number("SELECT COUNT(*) FROM schema_migrations WHERE number = ?", number);
  if (done == 0) {
    for (const auto& file : files) transaction.script(connection.dialect().spelled(file.text));
    transaction.run("INSERT INTO schema_migrations VALUES (?, ?)", number, now_us);
  }
  return transaction.commit();
}

tl::unexpected<Error> notUpgraded(Connection& connection, const Error& why) {
  if (connection.dialect().name != "postgresql") return tl::unexpected(why);
  return fail(connection.place() + " could not be upgraded to schema " + std::to_string(newestSchema()) + ": " +
              why.message +
              " If this user does not own the tables, upgrade as their owner: insonate-cli curriculum migrate.");
}

}  // namespace

int newestSchema() {
  return migrationsFor(Dialect::sqlite()).rbegin()->first;
}

std::filesystem::path copyBeforeMigration(const std::filesystem::path& file, int schema) {
  return file.string() + ".schema-" + std::to_string(schema);
}

Result<void> refuseForeign(Connection& connection) {
  if (connection.dialect().name != "sqlite") return {};
  const auto rows =
      connection.rows("SELECT SUM(name = 'schema_migrations'), COUNT(*) FROM sqlite_master WHERE type = 'table'", {});
  if (!rows) return tl::unexpected(rows.error());
  if (rows->front().number(0) > 0 || rows->front().number(1) == 0) return {};
  return fail(connection.place() + " is a database of another program; name another file for the curriculum's store.");
}

Result<void> migrate(Connection& connection, const Address& address, std::int64_t now_us) {
  // A role that may use the tables but owns none cannot execute the statements below.
  if (const auto present = schemaOf(connection); present && *present == newestSchema()) return {};
  {
    // Holds the writers' lock: two processes that create a table at once would conflict on a server.
    Transaction transaction(connection, Way::Write);
    transaction.script(
        connection.dialect().spelled("CREATE TABLE IF NOT EXISTS schema_migrations (number {INTEGER} NOT NULL PRIMARY "
                                     "KEY, applied_us {INTEGER} NOT NULL) "
                                     "{STRICT}"));
    if (auto done = transaction.commit(); !done) return notUpgraded(connection, done.error());
  }
  const auto schema = schemaOf(connection);
  if (!schema) return tl::unexpected(schema.error());
  if (auto ok = refuseNewer(*schema, connection.place()); !ok) return ok;
  if (*schema == newestSchema()) return {};
  if (auto kept = keepCopy(connection, address, *schema); !kept) return kept;
  for (const auto& [number, files] : migrationsFor(connection.dialect()))
    if (number > *schema)
      if (auto done = step(connection, number, files, now_us); !done) return notUpgraded(connection, done.error());
  return {};
}

}  // namespace insonate::store
