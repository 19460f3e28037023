#pragma once

#include <insonate/core/Result.h>

#include <QtCore/QString>
#include <string>

namespace insonate::store {

/// Address of a curriculum database: an SQLite file, or a database on a PostgreSQL server.
struct Address {
  bool isServer = false;
  QString file{};                                  ///< file of an SQLite database
  QString copyOf{};                                ///< file that messages name, if `file` is a copy of it
  QString host{}, database{}, user{}, password{};  ///< address and account of a PostgreSQL database
  int port = 5432;

  static Result<Address> parse(const std::string& text);
  /// Returns the address for messages, without the password.
  std::string place() const;
};

}  // namespace insonate::store
