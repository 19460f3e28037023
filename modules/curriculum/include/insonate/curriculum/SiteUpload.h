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
  std::string id{};    ///< id of the attempt or form
  std::int64_t since_us = 0;
};

struct UploadReport {
  int attempts = 0, forms = 0;                 ///< number that the server accepted
  int people = 0, cohorts = 0, curricula = 0;  ///< number that came from the server and was new or different here
  /// Sentences that name each fact that could not be sent and say what to do: a name that belongs to another person on
  /// the server, a curriculum that differs on the server. Everything else was sent.
  std::vector<std::string> troubles{};
};

/// Exchanges facts between a workstation's store and its server's: people, roles, cohorts and curricula are
/// downloaded, attempts and forms are uploaded. Needs no signed-in user, since it discloses nothing. A fact is sent
/// until the server confirms it; a fact sent twice is stored once. After the first exchange the workstation's people,
/// cohorts and curricula are the server's; a person known only here is uploaded as a disabled trainee, for the
/// server's administrator to decide.
class SiteUpload {
 public:
  SiteUpload(CurriculumStore here, CurriculumStore server) : here_(std::move(here)), server_(std::move(server)) {}

  /// Exchanges facts in batches, each a transaction; batches before a failure or a cancellation stay done. Fails if
  /// the server cannot be reached (everything stays pending) or has no people yet.
  Result<UploadReport> exchange(const Progress& progress = {}) const;
  /// Number of facts that wait for the server. Every workstation has them; without a server they stay.
  Result<std::int64_t> pending() const;

 private:
  CurriculumStore here_, server_;
};

/// Returns the waiting facts, oldest first, at most `count` (1..1000). For administrators and instructors.
Result<std::vector<PendingUpload>> pendingUploads(const SignedIn& by, int count);

}  // namespace insonate
