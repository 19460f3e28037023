#pragma once

#include <insonate/core/Result.h>

#include <QtSql/QSqlError>
#include <string>
#include <string_view>

namespace insonate::store {

/// Kinds of transactions. `Log` writes entries about the access itself only (the audit log, failed sign-ins). On a
/// read-only database, such entries are written into the copy that is read, and are lost with it.
enum class Way { Read, Write, Log };

/// Differences between the SQL of SQLite and PostgreSQL; all other statements are the same for both.
struct Dialect {
  std::string_view name;          ///< name of the dialect in the file names of migrations
  std::string_view driver;        ///< name of Qt's database driver
  std::string_view options;       ///< options of a Qt connection (QSqlDatabase)
  std::string_view setUp;         ///< SQL statements that set up each new connection
  std::string_view beginReading;  ///< SQL statement that begins a transaction on one consistent snapshot, for reading
  /// SQL statement that begins a transaction as the only writer in the whole database, so that numbers have no gaps and
  /// no transaction must be retried.
  std::string_view beginWriting;
  /// SQL texts that replace {INTEGER}, {REAL}, {TEXT} and {STRICT} in migrations.
  std::string_view integer, real, text, strict;

  static const Dialect& sqlite();
  static const Dialect& postgresql();

  /// Returns a migration's text in this dialect.
  std::string spelled(std::string_view migration) const;
};

/// Converts an error of the database driver to a sentence that says what to do. `place` names the database.
Error findingText(const QSqlError& error, const std::string& place);
/// Tells whether an error of the database driver means that the connection is lost.
bool isLost(const QSqlError& error);

}  // namespace insonate::store
