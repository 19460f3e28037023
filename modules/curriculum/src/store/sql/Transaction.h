#pragma once

#include "store/sql/Connection.h"

#include <optional>
#include <string_view>
#include <vector>

namespace insonate::store {

/// A database transaction: all changes are made or none. After a failed statement the transaction executes no further
/// statements, returns no rows, and keeps the first error, so that callers need to check only commit(). Without
/// commit() all changes are undone.
class Transaction {
 public:
  Transaction(Connection& connection, Way way);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  template <class... Values>
  std::vector<Row> rows(std::string_view sql, const Values&... values) {
    return asked(sql, {bound(values)...});
  }
  template <class... Values>
  std::optional<Row> row(std::string_view sql, const Values&... values) {
    std::vector<Row> found = asked(sql, {bound(values)...});
    return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
  }
  /// Runs a query and returns the number in the first column of the first row; 0 if there is no row.
  template <class... Values>
  std::int64_t number(std::string_view sql, const Values&... values) {
    const auto found = row(sql, values...);
    return found ? found->number(0) : 0;
  }
  /// Runs a statement and returns the number of changed rows.
  template <class... Values>
  std::int64_t run(std::string_view sql, const Values&... values) {
    return told(sql, {bound(values)...});
  }
  /// Runs SQL statements from a file, such as a migration.
  void script(const std::string& sql);

  const std::optional<Error>& error() const { return error_; }
  const Dialect& dialect() const { return connection_.dialect(); }
  const std::string& place() const { return connection_.place(); }
  Result<void> commit();

 private:
  std::vector<Row> asked(std::string_view sql, const std::vector<QVariant>& values);
  std::int64_t told(std::string_view sql, const std::vector<QVariant>& values);
  void keep(const Error& error);

  Connection& connection_;
  std::optional<Error> error_;
  bool open_ = false;
};

}  // namespace insonate::store
