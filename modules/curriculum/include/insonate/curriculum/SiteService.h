#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <optional>
#include <string>
#include <utility>

namespace insonate {

/// Answers the requests of workstations to a server (SiteUpload at the other end of a SiteLink). It stores what they
/// send by the permissions of their people on the server, not by those that a workstation claims, and lets ended
/// attempts wait for their verification (VerificationQueue). Keeps nothing between requests. For any thread.
class SiteService {
 public:
  explicit SiteService(CurriculumStore server) : server_(std::move(server)) {}

  /// Returns the name of the workstation with this token; empty if there is none or its token was revoked. The time of
  /// the request is stored to the minute.
  Result<std::optional<std::string>> workstationOf(const std::string& token) const;
  /// Answers a request of a workstation, as SiteLink::ask() sends it: messages in JSON, or a part of a recording. Fails
  /// with a sentence for the workstation.
  Result<std::string> answer(const std::string& workstation, const std::string& path, const std::string& body) const;

 private:
  CurriculumStore server_;
};

}  // namespace insonate
