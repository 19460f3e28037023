#pragma once

#include <insonate/core/Result.h>

#include <QtSql/QSqlError>
#include <string>
#include <string_view>

namespace insonate::store {

enum class Way { Read, Write };

/// Differences between SQLite and PostgreSQL; everything else is the same SQL for both.
struct Dialect {
  std::string_view name;          ///< as in the names of migrations
  std::string_view driver;        ///< of Qt
  std::string_view options;       ///< of Qt's connection
  std::string_view setUp;         ///< for each connection
  std::string_view beginReading;  ///< one moment's view of everything
  /// One writer at a time in the whole store: numbers are the last one and one, and nothing has to be tried again.
  std::string_view beginWriting;
  std::string_view integer, real, text,
      strict;  ///< what stands for {INTEGER}, {REAL}, {TEXT} and {STRICT} in migrations

  static const Dialect& sqlite();
  static const Dialect& postgresql();

  /// A migration's text for this dialect.
  std::string spelled(std::string_view migration) const;
};

/// Converts a driver's error to a sentence with what to do. `place` names the store.
Error sentenceOf(const QSqlError& error, const std::string& place);
/// The connection is of no more use.
bool isLost(const QSqlError& error);

}  // namespace insonate::store
