#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// An attempt or form that waits to be sent to the server.
struct PendingUpload {
  std::int64_t number = 0;
  std::string kind{};  ///< kind of the data: "attempt" or "form"
  std::string id{};    ///< id of the attempt or form
  std::int64_t since_us = 0;
};

/// Result of an exchange of data between a workstation and its server.
struct UploadReport {
  int attempts = 0, forms = 0;                 ///< numbers of attempts and forms that the server accepted
  int people = 0, cohorts = 0, curricula = 0;  ///< numbers of people, cohorts and curricula that came from the server
                                               ///< and were new or different on this workstation
  /// Sentences about data that could not be sent, with what to do: a name that belongs to another person on the server,
  /// a curriculum that differs on the server. Everything else was sent.
  std::vector<std::string> troubles{};
};

/// Exchanges data between the database of a workstation and that of a server: downloads people, roles, cohorts and
/// curricula, and uploads attempts and forms. No user needs to be signed in, since no data is disclosed. Data is sent
/// again until the server confirms it; data that arrives twice is stored once. After the first exchange, the
/// workstation has the people, cohorts and curricula of the server. A person whom only the workstation knows is
/// uploaded as a disabled trainee, whom an administrator of the server may enable.
class SiteUpload {
 public:
  SiteUpload(CurriculumStore here, CurriculumStore server) : here_(std::move(here)), server_(std::move(server)) {}

  /// Exchanges data in batches; each batch is one transaction. Batches before a failure or a cancellation remain
  /// stored. Fails if the server cannot be reached or has no people yet.
  Result<UploadReport> exchange(const Progress& progress = {}) const;
  /// Returns the number of attempts and forms that wait to be sent. Without a server they wait indefinitely.
  Result<std::int64_t> pending() const;

 private:
  CurriculumStore here_, server_;
};

/// Returns attempts and forms that wait to be sent to the server, oldest first, at most `count` (1..1000). For
/// administrators and instructors.
Result<std::vector<PendingUpload>> pendingUploads(const SignedIn& by, int count);

}  // namespace insonate
