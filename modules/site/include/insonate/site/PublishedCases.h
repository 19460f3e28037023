#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// A published version of a case (cases/CaseVersions.h) on a server.
struct PublishedCase {
  struct File {
    std::string name{};  ///< name in the folder: "ct.nrrd"
    std::int64_t size_bytes = 0;
  };
  std::string id{};  ///< 16 hexadecimal digits, which identify title and content among all cases
  std::string title{};
  CaseVersion version{};
  std::filesystem::path folder{};
  std::vector<File> files{};    ///< all files of the version that are not empty
  std::string whyNotOffered{};  ///< reason why workstations do not receive this case; empty if they do

  std::int64_t size_bytes() const;
};

/// Access to the published cases in a folder that contains the folders of cases. Reads a manifest once, since a version
/// does not change, and never reads volumes. May be used on any thread.
class PublishedCases {
 public:
  /// Largest part of a file that a workstation receives at once.
  static constexpr std::int64_t kPart_bytes = std::int64_t{1} << 20;

  /// `cases`: may be empty, for a server without cases.
  explicit PublishedCases(std::filesystem::path cases) : cases_(std::move(cases)) {}

  /// Returns the published versions, sorted by title. Of several cases with the same title, only the one that was saved
  /// last is offered to workstations; it comes first. Cases of which no version was published are left out. Fails if
  /// the folder cannot be read.
  Result<std::vector<PublishedCase>> list() const;
  /// Returns the titles of the offered cases. Fails like list().
  Result<std::vector<std::string>> offeredTitles() const;
  /// Returns the list of offered cases as JSON, for downloadCases().
  Result<std::string> listText() const;

  /// A part of a file of a case: `size` bytes from the byte `begin` on.
  struct Part {
    std::filesystem::path file{};
    std::uint64_t begin = 0, size = 0;
  };
  /// Finds the part of an offered case that a workstation asks for. `path` is "ID/NAME/OFFSET". Fails with a sentence
  /// for the workstation.
  Result<Part> part(const std::string& path) const;

 private:
  struct Known {
    std::filesystem::file_time_type saved{};  ///< time of the version's folder when the manifest was read
    PublishedCase read{};                     ///< title and version
  };
  std::optional<PublishedCase> caseIn(const std::filesystem::path& folder) const;

  std::filesystem::path cases_;
  mutable std::mutex mutex_;
  mutable std::map<std::filesystem::path, Known> known_;
};

}  // namespace insonate
