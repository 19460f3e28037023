#include "video/VideoFiles.h"

#include "video/PathText.h"

#include <insonate/core/AtomicFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <system_error>

namespace insonate::web {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char *kTime = "t_us", *kSay = "say", *kSeverity = "severity", *kMoments = "moments", *kPath = "path";

struct KeptVideo {
  fs::path file;
  fs::file_time_type used;
  std::uint64_t bytes = 0;
};

}  // namespace

fs::path VideoFiles::video(const std::string& attempt) const {
  return folder_ / (attempt + ".webm");
}

bool VideoFiles::has(const std::string& attempt) const {
  std::error_code error;
  return isUsed() && fs::is_regular_file(video(attempt), error);
}

Result<void> VideoFiles::keepMoments(const std::string& attempt, const std::vector<AttemptMoment>& moments,
                                     const std::optional<NeedlePath>& path) const {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) return fail(folder_.string() + " cannot be made: " + error.message() + ".");
  fs::permissions(folder_, fs::perms::owner_all, error);
  json list = json::array();
  for (const AttemptMoment& one : moments)
    list.push_back({{kTime, one.time_us},
                    {kSay, one.description},
                    {kSeverity, one.severity ? json(static_cast<int>(*one.severity)) : json(nullptr)}});
  json object;
  object[kMoments] = std::move(list);
  if (path) object[kPath] = pathToJson(*path);
  return writeAtomically(folder_ / (attempt + ".json"), object.dump(-1, ' ', false, json::error_handler_t::replace));
}

std::vector<AttemptMoment> VideoFiles::moments(const std::string& attempt) const {
  std::vector<AttemptMoment> moments;
  try {
    std::ifstream in(folder_ / (attempt + ".json"));
    const json object = json::parse(in);
    for (const json& one : object.at(kMoments)) {
      AttemptMoment moment{.time_us = one.at(kTime), .description = one.at(kSay), .severity = {}};
      if (!one.at(kSeverity).is_null()) moment.severity = static_cast<Severity>(one.at(kSeverity).get<int>());
      moments.push_back(std::move(moment));
    }
  } catch (const json::exception&) {
    return {};
  }
  return moments;
}

std::optional<NeedlePath> VideoFiles::path(const std::string& attempt) const {
  std::ifstream in(folder_ / (attempt + ".json"));
  const json object = json::parse(in, nullptr, false);
  return object.is_object() && object.contains(kPath) ? pathFromJson(object[kPath]) : std::nullopt;
}

Result<void> VideoFiles::remove(const std::string& attempt) const {
  Result<void> done;
  for (const fs::path& file : {video(attempt), folder_ / (attempt + ".json")}) {
    std::error_code error;
    fs::remove(file, error);
    if (error) done = fail(file.string() + " could not be deleted: " + error.message() + ".");
  }
  return done;
}

void VideoFiles::use(const std::string& attempt) const {
  std::error_code ignored;
  fs::last_write_time(folder_ / (attempt + ".json"), fs::file_time_type::clock::now(), ignored);
}

void VideoFiles::trim(std::uint64_t max_bytes, const std::string& newest) const {
  std::error_code error;
  std::vector<KeptVideo> videos;
  std::uint64_t all_bytes = 0;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    if (entry.path().extension() != ".webm") continue;
    // Another server may be writing a hidden file beside, which becomes the video.
    const bool isPart = entry.path().filename().string().starts_with('.');
    if (isPart && entry.last_write_time(error) > fs::file_time_type::clock::now() - std::chrono::hours(24)) continue;
    fs::path beside = entry.path();
    KeptVideo kept{entry.path(), fs::last_write_time(beside.replace_extension(".json"), error), entry.file_size(error)};
    all_bytes += kept.bytes;
    if (entry.path() != video(newest)) videos.push_back(std::move(kept));
  }
  std::ranges::sort(videos, {}, &KeptVideo::used);
  for (const KeptVideo& one : videos) {
    if (all_bytes <= max_bytes) return;
    fs::path beside = one.file;
    fs::remove(one.file, error);
    fs::remove(beside.replace_extension(".json"), error);
    all_bytes -= one.bytes;
  }
}

}  // namespace insonate::web
