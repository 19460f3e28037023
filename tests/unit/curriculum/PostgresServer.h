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
  /// It ends at once, in the middle of what it does.
  void crash();
  /// It ends, and who asks now is connected and hears nothing, as behind a network that was cut.
  void fallSilent();
  /// Unless it runs.
  void start();

 private:
  PostgresServer();
  int run(const std::string& program) const;

  TemporaryFolder folder_;
  std::string asUser_;
  int port_ = 0;
  int process_ = -1;
  bool runs_ = false;
  int silent_ = -1;  ///< what listens in its place
  int databases_ = 0;
};

}  // namespace insonate::test
