#include "store/sql/Dialect.h"

#include "store/ReadOnlyCopy.h"

#include <sqlite3.h>

#include <QtCore/QString>

namespace insonate::store {

const Dialect& Dialect::sqlite() {
  static const Dialect dialect{.name = "sqlite",
                               .driver = "QSQLITE",
                               .options = "",
                               // Recursive triggers are on: otherwise REPLACE would delete a fact without its trigger.
                               .setUp =
                                   "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON;"
                                   "PRAGMA recursive_triggers = ON; PRAGMA trusted_schema = OFF;"
                                   // 64 MB instead of 2: the data of a class page, so that the next look does not read
                                   // each page again.
                                   "PRAGMA cache_size = -65536",
                               .beginReading = "BEGIN",
                               .beginWriting = "BEGIN IMMEDIATE",
                               .integer = "INTEGER",
                               .real = "REAL",
                               .text = "TEXT",
                               .strict = "STRICT"};
  return dialect;
}

const Dialect& Dialect::postgresql() {
  static const Dialect dialect{
      .name = "postgresql",
      .driver = "QPSQL",
      // A broken connection sends no message: without these settings TCP waits for a quarter of an hour.
      .options =
          "connect_timeout=5;keepalives_idle=5;keepalives_interval=2;keepalives_count=3;tcp_user_timeout=10000;"
          "application_name=insonate",
      .setUp =
          "SET client_min_messages = warning; SET lock_timeout = '10s'; SET statement_timeout = '120s';"
          "SET idle_in_transaction_session_timeout = '120s'; SET synchronous_commit = on;"
          // All queries are about a person or a cohort and have an index. If rows are compared with a row of another
          // table, the planner estimates a third of all rows and reads the whole table: 0.8 s instead of 0.06.
          "SET enable_seqscan = off; SET jit = off",
      .beginReading = "BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY",
      // The number is unique to this program's locks in the database ("insonate" in ASCII).
      .beginWriting = "BEGIN; SELECT pg_advisory_xact_lock(7597132986949923941)",
      .integer = "BIGINT",
      .real = "DOUBLE PRECISION",
      .text = "TEXT COLLATE \"C\"",
      .strict = ""};
  return dialect;
}

std::string Dialect::spelled(std::string_view migration) const {
  const auto put = [](std::string_view words) {
    return QString::fromUtf8(words.data(), static_cast<int>(words.size()));
  };
  return put(migration)
      .replace("{INTEGER}", put(integer))
      .replace("{REAL}", put(real))
      .replace("{TEXT}", put(text))
      .replace("{STRICT}", put(strict))
      .toStdString();
}

namespace {

/// SQLite's error codes are numbers, PostgreSQL's have five letters or digits.
Error sqliteSentence(int code, const std::string& words, const std::string& place) {
  // The permissions of an open file were taken away; SQLite calls this an error of the disk.
  const bool lostPermission = (code & 0xff) == SQLITE_IOERR && isReadOnlyFile(place);
  switch (lostPermission ? SQLITE_READONLY : code & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return {place + " has been in use by another program for longer than 10 s. Nothing was changed; try again."};
    case SQLITE_FULL:
      return {"The disk with " + place + " is full. Nothing was stored; free space and try again."};
    case SQLITE_READONLY:
      return {
          place +
          " cannot be written. Change the permissions of the file and its folder so that you can write them. To only "
          "read the file, start the program again."};
    case SQLITE_CANTOPEN:
      return {place + " cannot be opened. Check that its folder exists and that you may read and write it."};
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return {place + " is damaged or is not a curriculum's database. Put a backup in its place."};
    case SQLITE_IOERR:
      return {place + " could not be read or written (" + words +
              "). Nothing was stored; check the disk and try again."};
    default:
      return {place + " refused this: " + words + ". Nothing was changed."};
  }
}

Error serverSentence(const QString& code, const std::string& words, const std::string& place) {
  if (code.startsWith("28")) return {place + " does not accept this user or password: " + words};
  if (code == "53100")
    return {"The disk of " + place + " is full. Nothing was stored; ask the server's administrator."};
  if (code == "55P03")
    return {place + " has been in use by another workstation for longer than 10 s. Nothing was changed; try again."};
  if (code == "42501") return {place + " does not give this user the permission for this: " + words};
  return {place + " refused this: " + words + " Nothing was changed."};
}

}  // namespace

bool isLost(const QSqlError& error) {
  const QString code = error.nativeErrorCode();
  // Without a code, the server did not answer.
  return error.type() == QSqlError::ConnectionError || code.isEmpty() || code.startsWith("08") ||
         code.startsWith("57P");
}

Error findingText(const QSqlError& error, const std::string& place) {
  const std::string words = error.databaseText().simplified().toStdString();
  bool isNumber = false;
  const QString code = error.nativeErrorCode();
  const int number = code.toInt(&isNumber);
  if (isNumber && code.size() < 5) return sqliteSentence(number, words, place);
  if (isLost(error))
    return {place + " cannot be reached: " + words + ". Check the network and that the server runs, and try again."};
  return serverSentence(code, words, place);
}

}  // namespace insonate::store
