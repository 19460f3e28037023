#include "CaseMessages.h"

#include <insonate/cases/CaseListing.h>
#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/Phantom.h>
#include <insonate/site/PublishedCases.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <numeric>
#include <optional>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

namespace insonate {
namespace {

namespace fs = std::filesystem;

bool hasFile(const PublishedCase& one, std::string_view name) {
  return std::ranges::find(one.files, name, &PublishedCase::File::name) != one.files.end();
}

/// Reads title and version.
PublishedCase readFrom(const fs::path& folder) {
  PublishedCase one;
  one.folder = folder;
  if (const auto manifest = readCaseManifest(folder)) {
    one.title = manifest->title, one.version = manifest->version;
    one.id = caseId(one.title, one.version.content);
  } else {
    one.title = folder.parent_path().parent_path().filename().string();
  }
  return one;
}

/// Adds the present files, which may still be on their way into the folder.
PublishedCase withFiles(PublishedCase one) {
  for (const std::string& name : caseFileNames()) {
    std::error_code error;
    const auto size_bytes = fs::file_size(one.folder / name, error);
    if (!error && size_bytes > 0) one.files.push_back({name, static_cast<std::int64_t>(size_bytes)});
  }
  if (one.id.empty())
    one.whyNotOffered = "its case.json cannot be read";
  else if (!hasFile(one, "ct.nrrd") || !(hasFile(one, "labels.seg.nrrd") || hasFile(one, "labels.nrrd")))
    one.whyNotOffered = "its CT or its labels are missing";
  else if (phantomVariant(one.title))
    one.whyNotOffered = "a built-in case has the same title; give the case another title and publish it again";
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

}  // namespace

std::int64_t PublishedCase::size_bytes() const {
  return std::accumulate(files.begin(), files.end(), std::int64_t{0},
                         [](std::int64_t sum, const File& file) { return sum + file.size_bytes; });
}

/// Returns no value if no version of the case was published.
std::optional<PublishedCase> PublishedCases::caseIn(const fs::path& folder) const {
  if (publishedVersion(folder) == 0) return std::nullopt;
  const fs::path version = caseForTraining(folder);
  std::error_code error;
  const auto saved = fs::last_write_time(version, error);
  Known& known = known_[folder];
  // A manifest that could not be read is read again.
  if (known.read.folder != version || known.saved != saved || known.read.id.empty()) known = {saved, readFrom(version)};
  return withFiles(known.read);
}

Result<std::vector<PublishedCase>> PublishedCases::list() const {
  std::vector<PublishedCase> published;
  if (cases_.empty()) return published;
  const std::lock_guard lock(mutex_);
  std::error_code error;
  for (fs::directory_iterator entry(cases_, error), end; !error && entry != end; entry.increment(error))
    if (auto one = caseIn(entry->path())) published.push_back(std::move(*one));
  if (error)
    return fail("The server's folder of cases, " + cases_.string() + ", cannot be read: " + error.message() + ".");
  std::ranges::sort(published, [](const PublishedCase& a, const PublishedCase& b) {
    return std::tuple(a.title, !a.whyNotOffered.empty(), b.version.date, b.version.number, a.folder) <
           std::tuple(b.title, !b.whyNotOffered.empty(), a.version.date, a.version.number, b.folder);
  });
  for (std::size_t i = 1; i < published.size(); ++i)
    if (published[i].title == published[i - 1].title && published[i].whyNotOffered.empty())
      published[i].whyNotOffered = "another case has the same title and was saved later";
  return published;
}

Result<std::vector<std::string>> PublishedCases::offeredTitles() const {
  const auto all = list();
  if (!all) return tl::unexpected(all.error());
  std::vector<std::string> titles;
  for (const PublishedCase& one : *all)
    if (one.whyNotOffered.empty()) titles.push_back(one.title);
  return titles;
}

Result<std::string> PublishedCases::listText() const {
  auto all = list();
  if (!all) return tl::unexpected(all.error());
  std::erase_if(*all, [](const PublishedCase& one) { return !one.whyNotOffered.empty(); });
  return caseListText(*all);
}

Result<PublishedCases::Part> PublishedCases::part(const std::string& path) const {
  const auto all = list();
  if (!all) return tl::unexpected(all.error());
  const WantedPart wanted = wantedFrom(path);
  for (const PublishedCase& one : *all) {
    if (one.id != wanted.id || !one.whyNotOffered.empty()) continue;
    for (const PublishedCase::File& file : one.files)
      if (file.name == wanted.name && wanted.offset_bytes >= 0 && wanted.offset_bytes < file.size_bytes)
        return Part{one.folder / file.name, static_cast<std::uint64_t>(wanted.offset_bytes),
                    static_cast<std::uint64_t>(std::min(kPart_bytes, file.size_bytes - wanted.offset_bytes))};
  }
  return fail("The server no longer offers this version of the case. The next exchange downloads the current version.");
}

}  // namespace insonate
