#pragma once

#include "server/InventedSite.h"

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/SiteUpload.h>

#include <filesystem>
#include <string>

namespace insonate::bench {

/// A workstation with a database of its own, on which one trainee has made one attempt. For one thread.
class MadeUpWorkstation {
 public:
  /// `folder`: new folder for the database and the recording.
  MadeUpWorkstation(std::filesystem::path folder, std::string name)
      : folder_(std::move(folder)), name_(std::move(name)) {}

  /// Signs the trainee in to the server, and records an attempt of `duration_s` whose motion depends on `seed`.
  Result<void> prepare(const std::string& url, const std::string& token, const std::string& trainee,
                       const Curriculum& curriculum, double duration_s, unsigned seed);
  /// Exchanges data with the server once, as the window does. Returns the duration in ms; fails unless the server has
  /// acknowledged the attempt and its recording.
  Result<double> send(const std::string& url, const std::string& token) const;

  const std::string& attempt() const { return facts_.id; }
  const std::string& recordingHash() const { return facts_.recordingHash; }
  std::filesystem::path recording() const;

 private:
  Result<CurriculumStore> open() const;

  std::filesystem::path folder_;
  std::string name_;
  AttemptFacts facts_{};
};

}  // namespace insonate::bench
