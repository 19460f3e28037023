#pragma once

#include "support/TestData.h"

#include <memory>
#include <string>

namespace insonate::test {

/// A PostgreSQL server of the test's own: loopback, a free port, a temporary folder, an ordinary user. It dies with the
/// test's process.
class PostgresServer {
 public:
  /// The one of this process, started when first asked for; none where PostgreSQL 15 is not installed.
  static PostgresServer* shared();
  ~PostgresServer();
  PostgresServer(const PostgresServer&) = delete;
  PostgresServer& operator=(const PostgresServer&) = delete;

  /// A fresh, empty database, with user and password in it.
  std::string freshDatabase();
  /// As `kill -9` of the server's process and all it had begun, and a start after it.
  void crashAndStart();

 private:
  PostgresServer();
  bool start();
  int run(const std::string& program) const;

  TemporaryFolder folder_;
  std::string asUser_;
  int port_ = 0;
  int process_ = -1;
  int databases_ = 0;
};

}  // namespace insonate::test
