#include "store/sql/Connection.h"

#include "store/sql/PrivateFile.h"

#include <sqlite3.h>

#include <QtCore/QFileInfo>
#include <QtSql/QSqlDriver>
#include <QtSql/QSqlRecord>
#include <atomic>
#include <chrono>
#include <thread>

namespace insonate::store {
namespace {

QString freshName() {
  static std::atomic<unsigned> counter{0};
  return QString("insonate-%1").arg(counter++);
}

QString latin(std::string_view text) {
  return QString::fromLatin1(text.data(), static_cast<int>(text.size()));
}

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds kPatience{10};
constexpr std::chrono::milliseconds kPause{2};

/// Retries every 2 ms for 10 s. SQLite's own handler sleeps up to 100 ms and rarely finds the gap between two
/// transactions of a busy writer.
int waitForOthers(void*, int tries) {
  if (tries >= kPatience / kPause) return 0;
  std::this_thread::sleep_for(kPause);
  return 1;
}

/// Retries until a Clock::time_point, for several statements that have one deadline.
int waitUntil(void* deadline, int /*tries*/) {
  if (Clock::now() >= *static_cast<const Clock::time_point*>(deadline)) return 0;
  std::this_thread::sleep_for(kPause);
  return 1;
}

}  // namespace

Connection::Connection(const Address& address, QString name)
    : dialect_(address.isServer ? Dialect::postgresql() : Dialect::sqlite()),
      place_(address.place()),
      name_(std::move(name)),
      database_(QSqlDatabase::addDatabase(latin(dialect_.driver), name_)) {}

Connection::~Connection() {
  prepared_.clear();
  database_.close();
  database_ = {};
  QSqlDatabase::removeDatabase(name_);
}

Result<std::unique_ptr<Connection>> Connection::open(const Address& address) {
  std::unique_ptr<Connection> connection(new Connection(address, freshName()));
  if (auto ready = connection->setUp(address); !ready) return tl::unexpected(ready.error());
  return connection;
}

Result<void> Connection::setUp(const Address& address) {
  if (!database_.isValid())
    return fail("Qt's driver " + std::string(dialect_.driver) + " is not installed, which " + place_ +
                " needs; install it.");
  database_.setDatabaseName(address.isServer ? address.database : address.file);
  database_.setHostName(address.host);
  database_.setUserName(address.user);
  database_.setPassword(address.password);
  if (address.isServer) database_.setPort(address.port);
  database_.setConnectOptions(latin(dialect_.options));
  if (!address.isServer && QFileInfo(address.file).isDir())
    return fail(place_ + " is a folder; name a file for the curriculum's store.");
  if (!address.isServer) makePrivate(address.file.toStdString());
  if (!database_.open()) return tl::unexpected(errorFrom(database_.lastError()));
  const std::string settings(dialect_.setUp);
  if (address.isServer) return script(settings);
  Clock::time_point deadline = Clock::now() + kPatience;
  sqlite3_busy_handler(handle(), waitUntil, &deadline);
  // A new file changes to WAL under a lock for which SQLite does not call its busy handler: if several programs open it
  // at once, some get SQLITE_BUSY immediately. All settings can be repeated.
  auto done = script(settings);
  while (!done && (sqlite3_errcode(handle()) & 0xff) == SQLITE_BUSY && waitUntil(&deadline, 0) != 0)
    done = script(settings);
  sqlite3_busy_handler(handle(), waitForOthers, nullptr);
  return done;
}

sqlite3* Connection::handle() const {
  return *static_cast<sqlite3* const*>(database_.driver()->handle().constData());
}

Error Connection::errorFrom(const QSqlError& error) {
  lost_ = lost_ || store::isLost(error);
  return findingText(error, place_);
}

Result<QSqlQuery*> Connection::executed(std::string_view sql, const std::vector<QVariant>& values) {
  auto found = prepared_.find(sql);
  if (found == prepared_.end()) {
    QSqlQuery query(database_);
    query.setForwardOnly(true);
    if (!query.prepare(QString::fromUtf8(sql.data(), static_cast<int>(sql.size()))))
      return tl::unexpected(errorFrom(query.lastError()));
    found = prepared_.emplace(sql, std::move(query)).first;
  }
  QSqlQuery& query = found->second;
  for (std::size_t i = 0; i < values.size(); ++i) query.bindValue(static_cast<int>(i), values[i]);
  if (!query.exec()) {
    const Error error = errorFrom(query.lastError());
    prepared_.erase(found);
    return tl::unexpected(error);
  }
  return &query;
}

Result<std::vector<Row>> Connection::rows(std::string_view sql, const std::vector<QVariant>& values) {
  const auto query = executed(sql, values);
  if (!query) return tl::unexpected(query.error());
  std::vector<Row> rows;
  const int columns = (*query)->record().count();
  while ((*query)->next()) {
    std::vector<QVariant> row;
    row.reserve(static_cast<std::size_t>(columns));
    for (int i = 0; i < columns; ++i) row.push_back((*query)->value(i));
    rows.emplace_back(std::move(row));
  }
  const QSqlError error = (*query)->lastError();
  (*query)->finish();
  if (error.isValid()) return tl::unexpected(errorFrom(error));
  return rows;
}

Result<std::int64_t> Connection::run(std::string_view sql, const std::vector<QVariant>& values) {
  const auto query = executed(sql, values);
  if (!query) return tl::unexpected(query.error());
  const std::int64_t changed = (*query)->numRowsAffected();
  (*query)->finish();
  return changed;
}

Result<void> Connection::script(const std::string& sql) {
  if (dialect_.name == "sqlite") {
    char* words = nullptr;
    if (sqlite3_exec(handle(), sql.c_str(), nullptr, nullptr, &words) == SQLITE_OK) return {};
    const QSqlError error("", QString::fromUtf8(words), QSqlError::StatementError,
                          QString::number(sqlite3_extended_errcode(handle())));
    sqlite3_free(words);
    return tl::unexpected(errorFrom(error));
  }
  QSqlQuery query(database_);
  bool done = query.exec(QString::fromStdString(sql));
  // Each statement has a result of its own, which must be read to detect its failure.
  while (done && query.nextResult()) done = !query.lastError().isValid();
  if (query.lastError().isValid()) return tl::unexpected(errorFrom(query.lastError()));
  return {};
}

}  // namespace insonate::store
