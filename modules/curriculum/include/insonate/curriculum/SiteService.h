#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace insonate {

/// Answers the requests that workstations send to a server (SiteUpload) through a SiteLink. The server stores data that
/// a workstation sends only if the people who made the data have the permission on the server, whatever permissions the
/// workstation claims. Ended attempts wait for their verification (VerificationQueue). Keeps nothing between requests.
/// May be used on any thread.
class SiteService {
 public:
  static constexpr std::int64_t kRecordingsPerDay_bytes = 20'000'000'000;

  /// `recordingsPerDay_bytes`: maximum size of the recordings that one workstation may send in 24 hours, so that it
  /// cannot fill the server's disk. Recordings that are still incomplete count, even if their first part arrived
  /// earlier.
  explicit SiteService(CurriculumStore server, std::int64_t recordingsPerDay_bytes = kRecordingsPerDay_bytes)
      : server_(std::move(server)), recordingsPerDay_bytes_(recordingsPerDay_bytes) {}

  /// Returns the name of the workstation with this token; empty if there is none or its token was revoked. The time of
  /// the request is stored to the minute.
  Result<std::optional<std::string>> workstationOf(const std::string& token) const;
  /// Answers a request of a workstation, as SiteLink::send() sends it: messages in JSON, or a part of a recording.
  /// Fails with a sentence for the workstation.
  Result<std::string> answer(const std::string& workstation, const std::string& path, const std::string& body) const;

 private:
  CurriculumStore server_;
  std::int64_t recordingsPerDay_bytes_;
};

}  // namespace insonate
