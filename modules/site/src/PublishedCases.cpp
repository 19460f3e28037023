#include "CaseMessages.h"

#include <insonate/cases/CaseListing.h>
#include <insonate/cases/CaseVersions.h>
#include <insonate/site/PublishedCases.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <functional>
#include <numeric>
#include <optional>
#include <system_error>
#include <tuple>

namespace insonate {
namespace {

namespace fs = std::filesystem;

std::optional<PublishedCase> publishedIn(const fs::path& folder) {
  if (publishedVersion(folder) == 0) return std::nullopt;
  PublishedCase one;
  one.folder = caseForTraining(folder);
  const auto manifest = readManifestOf(one.folder);
  if (!manifest) return std::nullopt;
  one.title = manifest->title, one.version = manifest->version;
  one.id = caseId(one.title, one.version.content);
  for (const std::string& name : caseFileNames()) {
    std::error_code error;
    const auto size_bytes = fs::file_size(one.folder / name, error);
    if (!error) one.files.push_back({name, static_cast<std::int64_t>(size_bytes)});
  }
  return one;
}

/// The file and offset that "ID/NAME/OFFSET" means.
struct WantedPart {
  std::string_view id{}, name{};
  std::int64_t offset_bytes = -1;
};

WantedPart wantedFrom(std::string_view path) {
  const std::size_t first = path.find('/'), second = path.find('/', first + 1);
  if (first == std::string_view::npos || second == std::string_view::npos) return {};
  WantedPart wanted{.id = path.substr(0, first), .name = path.substr(first + 1, second - first - 1)};
  const std::string_view offset = path.substr(second + 1);
  const auto [end, error] = std::from_chars(offset.data(), offset.data() + offset.size(), wanted.offset_bytes);
  if (error != std::errc() || end != offset.data() + offset.size()) return {};
  return wanted;
}

Result<std::string> partOf(const fs::path& file, std::int64_t offset_bytes, std::int64_t size_bytes) {
  std::string bytes(static_cast<std::size_t>(std::min(kCasePart_bytes, size_bytes - offset_bytes)), '\0');
  std::ifstream in(file, std::ios::binary);
  if (!in.seekg(offset_bytes) || !in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    return fail("The server cannot read a file of the case. Tell the administrator of the server.");
  return bytes;
}

}  // namespace

std::int64_t PublishedCase::size_bytes() const {
  return std::accumulate(files.begin(), files.end(), std::int64_t{0},
                         [](std::int64_t sum, const File& file) { return sum + file.size_bytes; });
}

std::vector<PublishedCase> publishedCases(const fs::path& cases) {
  std::vector<PublishedCase> published;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(cases, error))
    if (entry.is_directory(error))
      if (auto one = publishedIn(entry.path())) published.push_back(std::move(*one));
  std::ranges::sort(published, [](const PublishedCase& a, const PublishedCase& b) {
    return std::tie(a.title, b.version.date, b.version.number, b.folder) <
           std::tie(b.title, a.version.date, a.version.number, a.folder);
  });
  return published;
}

Result<std::string> answerCaseRequest(const fs::path& cases, const std::string& path) {
  const auto published = cases.empty() ? std::vector<PublishedCase>() : publishedCases(cases);
  if (path == kCaseList) return caseListText(published);
  const std::string_view kFiles = kCaseFiles;
  const WantedPart wanted =
      path.starts_with(kFiles) ? wantedFrom(std::string_view(path).substr(kFiles.size())) : WantedPart{};
  for (const PublishedCase& one : published) {
    if (one.id != wanted.id) continue;
    for (const PublishedCase::File& file : one.files)
      if (file.name == wanted.name && wanted.offset_bytes >= 0 && wanted.offset_bytes < file.size_bytes)
        return partOf(one.folder / file.name, wanted.offset_bytes, file.size_bytes);
  }
  return fail("The server does not offer this version of the case any more. The next exchange finds the present one.");
}

}  // namespace insonate
