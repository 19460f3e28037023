#pragma once

#include <insonate/core/Result.h>

#include <QtCore/QString>
#include <string>

namespace insonate::store {

/// Address of a store: a file, or a database on a PostgreSQL server.
struct Address {
  bool isServer = false;
  QString file{};                                  ///< for SQLite
  QString host{}, database{}, user{}, password{};  ///< for PostgreSQL
  int port = 5432;

  static Result<Address> parse(const std::string& text);
  /// Address for messages, without the password.
  std::string place() const;
};

}  // namespace insonate::store
