#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// A published version of a case (cases/CaseVersions.h) that a server offers to workstations.
struct PublishedCase {
  struct File {
    std::string name{};  ///< name in the folder: "ct.nrrd"
    std::int64_t size_bytes = 0;
  };
  std::string id{};  ///< 16 hexadecimal digits, which identify title and content among all cases
  std::string title{};
  CaseVersion version{};
  std::filesystem::path folder{};
  std::vector<File> files{};

  std::int64_t size_bytes() const;
};

/// Returns the published versions of all cases whose folders are in the folder `cases`, by title. Of several cases with
/// the same title, the one that was saved last comes first; workstations receive this one. Cases of which no version
/// was published, and cases that cannot be read, are left out. Reads no volumes.
std::vector<PublishedCase> publishedCases(const std::filesystem::path& cases);

inline constexpr std::int64_t kCasePart_bytes = std::int64_t{1} << 20;

/// Answers a request of a workstation for cases (downloadCases()): `path` is "cases" for the list of published cases,
/// in JSON, or "case-files/ID/NAME/OFFSET" for at most kCasePart_bytes of a file of a published version, from this
/// offset. Fails with a sentence for the workstation. May be called on any thread.
Result<std::string> answerCaseRequest(const std::filesystem::path& cases, const std::string& path);

}  // namespace insonate
