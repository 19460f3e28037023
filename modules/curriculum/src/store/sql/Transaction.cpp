#include "store/sql/Transaction.h"

#include "store/FailureNotes.h"

namespace insonate::store {

Transaction::Transaction(Connection& connection, Way way) : connection_(connection) {
  const Dialect& dialect = connection.dialect();
  script(std::string(way == Way::Read ? dialect.beginReading : dialect.beginWriting));
  open_ = true;
}

Transaction::~Transaction() {
  if (open_ && !connection_.isLost()) (void)connection_.script("ROLLBACK");
}

std::vector<Row> Transaction::asked(std::string_view sql, const std::vector<QVariant>& values) {
  if (error_) return {};
  auto rows = connection_.rows(sql, values);
  if (rows) return std::move(*rows);
  keep(rows.error());
  return {};
}

std::int64_t Transaction::told(std::string_view sql, const std::vector<QVariant>& values) {
  if (error_) return 0;
  const auto changed = connection_.run(sql, values);
  if (changed) return *changed;
  keep(changed.error());
  return 0;
}

void Transaction::script(const std::string& sql) {
  if (error_) return;
  if (auto done = connection_.script(sql); !done) error_ = done.error();
}

void Transaction::keep(const Error& error) {
  error_ = error;
  noteDatabaseFailure(error);
}

Result<void> Transaction::commit() {
  if (!error_)
    if (auto done = connection_.script("COMMIT"); !done) keep(done.error());
  if (error_) return tl::unexpected(*error_);
  open_ = false;
  return {};
}

}  // namespace insonate::store
