#pragma once

#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/web/WebServer.h>

#include <filesystem>
#include <stop_token>
#include <thread>

namespace insonate::web {

/// Verifies attempts that workstations have sent, one after another, on a thread of its own, until the object is
/// destroyed. Several servers with one database share the work.
class Verifier {
 public:
  /// `cases`: folder with the folders of the server's cases; may be empty. `log`: receives failures of the database;
  /// may be empty.
  Verifier(const CurriculumStore& store, std::filesystem::path cases, Log log);
  Verifier(const Verifier&) = delete;
  Verifier& operator=(const Verifier&) = delete;

 private:
  void run(const std::stop_token& stop);

  CurriculumStore store_;
  std::filesystem::path cases_;
  Log log_;
  std::jthread thread_;  // declared last, since the thread uses the other members
};

}  // namespace insonate::web
