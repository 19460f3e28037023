#pragma once

#include <insonate/core/Result.h>

#include <QtSql/QSqlError>
#include <string>
#include <string_view>

namespace insonate::store {

enum class Way { Read, Write };

/// Differences between SQLite and PostgreSQL; all other SQL is the same for both.
struct Dialect {
  std::string_view name;          ///< name in migration files
  std::string_view driver;        ///< Qt's name of the driver
  std::string_view options;       ///< options of Qt's connection
  std::string_view setUp;         ///< statements that set up each connection
  std::string_view beginReading;  ///< begins a transaction that reads one consistent snapshot
  /// Begins a transaction as the only writer in the whole store, so that a new number is the last number plus one and
  /// no transaction must be retried.
  std::string_view beginWriting;
  std::string_view integer, real, text,
      strict;  ///< text that replaces {INTEGER}, {REAL}, {TEXT} and {STRICT} in migrations

  static const Dialect& sqlite();
  static const Dialect& postgresql();

  /// A migration's text for this dialect.
  std::string spelled(std::string_view migration) const;
};

/// Converts a driver's error to a sentence that says what to do. `place` names the store.
Error sentenceOf(const QSqlError& error, const std::string& place);
/// Tells whether an error means that the connection can no longer be used.
bool isLost(const QSqlError& error);

}  // namespace insonate::store
