#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

struct PendingUpload {
  std::int64_t number = 0;
  std::string kind{};  ///< "attempt", "form"
  std::string id{};    ///< of the attempt or form
  std::int64_t since_us = 0;
};

struct UploadReport {
  int attempts = 0, forms = 0;                 ///< that the server took
  int people = 0, cohorts = 0, curricula = 0;  ///< that came from the server and are new or other here
  /// Sentences about what could not be sent and what to do: a name that belongs to another person on the server, a
  /// curriculum that differs there. Everything else was sent.
  std::vector<std::string> troubles{};
};

/// Brings a workstation's store and its server's together: people, roles, cohorts and curricula flow down, attempts and
/// forms flow up. Needs nobody signed in, since nobody gets to see anything. A fact is sent until the server has said
/// that it has it; sent twice, it is there once. From the first time on, the workstation's people, cohorts and
/// curricula are the server's; whoever was only here is sent up as a disabled trainee, for the server's administrator
/// to decide.
class SiteUpload {
 public:
  SiteUpload(CurriculumStore here, CurriculumStore server) : here_(std::move(here)), server_(std::move(server)) {}

  /// In batches, each a transaction; what was done before a failure or a cancellation stays done. Fails where the
  /// server cannot be reached (all stays pending) or has no people yet.
  Result<UploadReport> exchange(const Progress& progress = {}) const;
  /// Number of facts that wait for the server. Every workstation has them; without a server they stay.
  Result<std::int64_t> pending() const;

 private:
  CurriculumStore here_, server_;
};

/// Oldest first, at most `count` (1..1000); administrators and instructors.
Result<std::vector<PendingUpload>> pendingUploads(const SignedIn& by, int count);

}  // namespace insonate
