#pragma once

#include "store/sql/Address.h"
#include "store/sql/Dialect.h"
#include "store/sql/Row.h"

#include <insonate/core/Result.h>

#include <QtSql/QSqlDatabase>
#include <QtSql/QSqlQuery>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;

namespace insonate::store {

/// One connection to a curriculum database, for use by one thread.
class Connection {
 public:
  /// Opens a connection within 10 s, or fails; a missing SQLite file is created.
  static Result<std::unique_ptr<Connection>> open(const Address& address);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  const Dialect& dialect() const { return dialect_; }
  const std::string& place() const { return place_; }
  bool isLost() const { return lost_; }
  /// Returns the handle of SQLite's C interface; null for PostgreSQL.
  sqlite3* handle() const;

  /// Runs an SQL query and returns its rows; the prepared statement is kept for the next call.
  Result<std::vector<Row>> rows(std::string_view sql, const std::vector<QVariant>& values);
  /// Runs an SQL statement and returns the number of changed rows.
  Result<std::int64_t> run(std::string_view sql, const std::vector<QVariant>& values);
  /// Runs any number of SQL statements without bound values.
  Result<void> script(const std::string& sql);

 private:
  Connection(const Address& address, QString name);
  Result<QSqlQuery*> executed(std::string_view sql, const std::vector<QVariant>& values);
  Result<void> setUp(const Address& address);
  Error errorFrom(const QSqlError& error);

  const Dialect& dialect_;
  std::string place_;
  QString name_;
  QSqlDatabase database_;
  std::map<std::string, QSqlQuery, std::less<>> prepared_;
  bool lost_ = false;
};

}  // namespace insonate::store
