#include "CaseFiles.h"
#include "ManifestJson.h"

#include <insonate/cases/CaseListing.h>
#include <insonate/cases/CaseVersions.h>
#include <insonate/core/AtomicFile.h>
#include <insonate/core/Fingerprint.h>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <thread>

namespace insonate {
namespace fs = std::filesystem;
namespace {

constexpr const char *kVersions = "versions", *kPublished = "published.json";

/// Lock for one save at a time among the cases of one folder, over all programs; it ends with the program that holds
/// it. File systems without locks have none.
class SavingTurn {
 public:
  explicit SavingTurn(const fs::path& parent) : file_(::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {}
  ~SavingTurn() {
    if (file_ >= 0) ::close(file_);
  }
  SavingTurn(const SavingTurn&) = delete;
  SavingTurn& operator=(const SavingTurn&) = delete;

  Result<void> wait(const Progress& progress) {
    while (file_ >= 0 && ::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      if (!report(progress, "Waiting for another save", 0)) return fail(std::string(kCancelled));
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return {};
  }

 private:
  int file_;
};

fs::path parentOf(const fs::path& folder) {
  const fs::path named = folder.has_filename() ? folder : folder.parent_path();
  return named.has_parent_path() ? named.parent_path() : fs::path(".");
}

void add(Fingerprint& fingerprint, Vec3 v) {
  // Reading straightens directions, which must not count as a change.
  constexpr double kGrain = 1e4;
  for (int a = 0; a < 3; ++a) fingerprint.add(static_cast<std::uint64_t>(std::llround(v[a] * kGrain)));
}

CaseVersion versionOf(const PatientCase& patient) {
  CaseVersion version = patient.manifest.version;
  version.content = contentHashOf(patient), version.voxels = voxelHashOf(patient);
  return version;
}

std::string folderName(int number) {
  std::string digits = std::to_string(number);
  return std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

std::vector<std::pair<CaseVersion, fs::path>> keptIn(const fs::path& folder) {
  std::vector<std::pair<CaseVersion, fs::path>> kept;
  const auto look = [&](const fs::path& place) {
    std::error_code error;
    std::vector<std::string> notes;
    if (!fs::exists(place / kManifestFile, error)) return;
    if (const auto manifest = readManifest(place / kManifestFile, notes); manifest && manifest->version.number > 0)
      kept.emplace_back(manifest->version, place);
  };
  look(folder);
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder / kVersions, error)) look(entry.path());
  std::ranges::sort(kept, std::greater{}, [](const auto& one) { return one.first.number; });
  return kept;
}

/// Hard links of the files of a folder in another folder.
Result<void> link(const fs::path& from, const fs::path& to) {
  std::error_code error;
  const auto options = fs::copy_options::recursive;
  fs::copy(from, to, options | fs::copy_options::create_hard_links, error);
  if (error) {  // a file system without hard links
    fs::remove_all(to, error);
    fs::copy(from, to, options, error);
  }
  if (error) return fail("Could not keep the earlier version of " + from.string() + ": " + error.message() + ".");
  return {};
}

/// Stores the case of `folder` as a version among `versions`, completely or not at all.
Result<void> keepVersion(const CaseManifest& manifest, const fs::path& folder, const fs::path& versions) {
  const fs::path place = versions / folderName(manifest.version.number);
  std::error_code error;
  if (fs::exists(place / kManifestFile, error)) return {};  // it was published and has been kept since
  fs::create_directories(versions, error);
  if (error) return fail("Could not write " + versions.string() + ": " + error.message() + ".");
  return writeFolderAtomically(place,
                               [&](const fs::path& beside) -> Result<void> {
                                 for (const char* name : {kCtFile, kLabelFile, kPlainLabelFile, kSnapFile})
                                   if (fs::exists(folder / name, error))
                                     if (auto ok = link(folder / name, beside / name); !ok) return ok;
                                 return writeAtomically(beside / kManifestFile, manifestToJson(manifest));
                               },
                               {});
}

fs::path versionFolder(const fs::path& folder, int number) {
  return folder / kVersions / folderName(number);
}

/// Numbers of the version that is published now, and of those that were published before, which programs before version
/// 0.2 did not note.
std::vector<int> publishedVersions(const fs::path& folder) {
  std::ifstream file(folder / kVersions / kPublished);
  const auto pointer = nlohmann::json::parse(file, nullptr, false);
  std::vector<int> numbers;
  const auto add = [&](const nlohmann::json& number) {
    if (number.is_number_integer() && number.get<int>() > 0) numbers.push_back(number.get<int>());
  };
  if (!pointer.is_object() || !pointer.contains("version")) return numbers;
  add(pointer["version"]);
  if (!numbers.empty() && pointer.contains("earlier"))
    for (const auto& number : pointer["earlier"]) add(number);
  return numbers;
}

/// Trainees and curricula know a case by its title.
bool isPublishedWithOtherTitle(const fs::path& folder, const CaseManifest& manifest) {
  const std::vector<int> published = publishedVersions(folder);
  if (published.empty() || published.front() != manifest.version.number) return false;
  const auto there = readCaseManifest(versionFolder(folder, published.front()));
  return there && there->title != manifest.title;
}

bool isSame(const CtVolume& a, const CtVolume& b) {
  return sameGrid(a.geometry, b.geometry) && a.voxels == b.voxels;
}

/// The case that a folder holds, without its voxels.
struct CaseThere {
  CaseManifest manifest;  ///< `version` has the fingerprints of the content, and the number 0 if it is no version
  bool hasSameCt = false;
};

CaseThere thereOf(const PatientCase& patient, bool hasSameCt) {
  CaseThere there{patient.manifest, hasSameCt};
  const CaseVersion version = versionOf(patient);
  // A folder that another program changed is not the version that it names.
  if (patient.manifest.version.content != version.content) there.manifest.version.number = 0;
  there.manifest.version.content = version.content, there.manifest.version.voxels = version.voxels;
  return there;
}

/// Compares the case of a folder with the one to save. A folder that cannot be read is not a version.
std::optional<CaseThere> caseThere(const fs::path& named, const CtVolume& ct) {
  const auto read = readCase(named);
  return read ? std::optional(thereOf(read->patient, isSame(read->patient.ct, ct))) : std::nullopt;
}

/// saveCaseVersion() of a caller that holds the lock. `isNew`: true makes a new version even of unchanged content.
Result<CaseVersion> saveInTurn(const PatientCase& patient, const fs::path& named, std::optional<CaseThere> there,
                               const std::string& date, const std::string& author, bool isNew,
                               const Progress& progress) {
  CaseVersion version = versionOf(patient);
  bool keep = false;
  if (there) {
    CaseVersion& old = there->manifest.version;
    const auto kept = keptIn(named);
    const int latest = kept.empty() ? 0 : kept.front().first.number;
    if (old.number == 0) old.number = latest + 1;
    keep = isNew || old.content != version.content;
    version.number = keep ? std::max(latest, old.number) + 1 : old.number;
    version.date = keep || old.date.empty() ? date : old.date;
    version.author = keep ? author : old.author;
  } else {
    version.number = 1, version.date = date, version.author = author;
  }
  CaseManifest manifest = patient.manifest;
  manifest.version = version;
  const auto write = [&](const fs::path& beside) -> Result<void> {
    std::error_code error;
    const fs::path sameCt = there && there->hasSameCt ? named / kCtFile : fs::path();
    if (auto ok = writeCaseFiles(patient, manifest, beside, sameCt, progress); !ok) return ok;
    if (fs::exists(named / kVersions, error))
      if (auto ok = link(named / kVersions, beside / kVersions); !ok) return ok;
    return keep ? keepVersion(there->manifest, named, beside / kVersions) : Result<void>{};
  };
  if (auto ok = writeFolderAtomically(named, write, {kPlainLabelFile}); !ok) return tl::unexpected(ok.error());
  return version;
}

}  // namespace

std::string voxelHashOf(const PatientCase& patient) {
  Fingerprint fingerprint;
  for (const int size : patient.labels.geometry.size) fingerprint.add(static_cast<std::uint64_t>(size));
  std::array<std::uint64_t, 256> tissue{};
  for (int label = 0; label < 256; ++label)
    tissue[label] = tissueOf(patient.manifest.ownLabels, static_cast<std::uint8_t>(label));
  for (const auto label : patient.labels.voxels) fingerprint.add(tissue[label]);
  for (const auto hu : patient.ct.voxels) fingerprint.add(std::uint64_t{static_cast<std::uint16_t>(hu)});
  return fingerprint.text();
}

std::string contentHashOf(const PatientCase& patient) {
  Fingerprint fingerprint;
  fingerprint.add(voxelHashOf(patient));
  const VolumeGeometry& g = patient.ct.geometry;
  add(fingerprint, g.origin_mm), add(fingerprint, g.spacing_mm);
  for (const Vec3& axis : g.direction.column) add(fingerprint, axis);
  for (const Target& target : patient.manifest.targets) {
    fingerprint.add(target.name), fingerprint.add(std::uint64_t{target.label});
    add(fingerprint, target.position_mm);
  }
  for (const NamedVessel& vessel : patient.manifest.vessels) {
    fingerprint.add(vessel.name), fingerprint.add(std::uint64_t{vessel.label});
    for (const NamedVessel::Point& point : vessel.course) {
      add(fingerprint, point.position_mm);
      add(fingerprint, Vec3{point.radius_mm, 0, 0});
    }
    for (const Vec3& click_mm : vessel.clicks_mm) add(fingerprint, click_mm);
  }
  for (const StartPose& pose : patient.manifest.startPoses) {
    fingerprint.add(pose.name);
    add(fingerprint, pose.position_mm), add(fingerprint, pose.axial), add(fingerprint, pose.lateral);
  }
  return fingerprint.text();
}

std::string today() {
  const std::time_t seconds = std::time(nullptr);
  std::tm local{};
  localtime_r(&seconds, &local);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", &local);
  return text.data();
}

Result<CaseVersion> saveCaseVersion(const PatientCase& patient, const fs::path& folder, const std::string& date,
                                    const std::string& author, const Progress& progress) {
  if (auto ok = checkVolumes(patient); !ok) return tl::unexpected(ok.error());
  if (auto ok = checkFolderTarget(folder); !ok) return tl::unexpected(ok.error());
  SavingTurn turn(parentOf(folder));
  if (auto ok = turn.wait(progress); !ok) return tl::unexpected(ok.error());
  const fs::path named = folder.has_filename() ? folder : folder.parent_path();
  return saveInTurn(patient, named, caseThere(named, patient.ct), date, author, false, progress);
}

std::optional<fs::path> findVersion(const fs::path& folder, const std::string& voxelHash) {
  for (const auto& [version, place] : keptIn(folder))
    if (!voxelHash.empty() && version.voxels == voxelHash) return place;
  return std::nullopt;
}

std::vector<CaseVersion> versionsOf(const fs::path& folder) {
  std::vector<CaseVersion> versions;
  for (auto& [version, place] : keptIn(folder))
    // A published version that has not changed since is listed twice.
    if (versions.empty() || versions.back().number != version.number) versions.push_back(version);
  return versions;
}

Result<CaseVersion> publishCase(const PatientCase& seen, const fs::path& folder, const std::string& date,
                                const Progress& progress) {
  if (auto ok = checkFolderTarget(folder); !ok) return tl::unexpected(ok.error());
  const fs::path named = folder.has_filename() ? folder : folder.parent_path();
  SavingTurn turn(parentOf(folder));
  if (auto ok = turn.wait(progress); !ok) return tl::unexpected(ok.error());
  auto there = readCase(named);
  if (!there) return tl::unexpected(there.error());
  CaseManifest& manifest = there->patient.manifest;
  CaseThere same = thereOf(there->patient, true);
  if (same.manifest.version.content != contentHashOf(seen))
    return fail("Another program has saved " + named.string() + " meanwhile. Check the case and publish it again.");
  auto version = saveInTurn(there->patient, named, std::move(same), date, manifest.version.author,
                            isPublishedWithOtherTitle(named, manifest), progress);
  if (!version) return version;
  manifest.version = *version;
  if (auto ok = keepVersion(manifest, named, named / kVersions); !ok) return tl::unexpected(ok.error());
  std::vector<int> earlier = publishedVersions(named);
  std::erase(earlier, version->number);
  const nlohmann::json pointer{{"version", version->number}, {"earlier", earlier}};
  if (auto ok = writeAtomically(named / kVersions / kPublished, pointer.dump(2) + '\n'); !ok)
    return tl::unexpected(ok.error());
  return version;
}

int publishedVersion(const fs::path& folder) {
  const std::vector<int> published = publishedVersions(folder);
  std::error_code error;
  if (published.empty() || !fs::exists(versionFolder(folder, published.front()) / kManifestFile, error)) return 0;
  return published.front();
}

std::optional<fs::path> findPublishedVersion(const fs::path& folder, const std::string& voxelHash) {
  for (const int number : publishedVersions(folder)) {
    const fs::path place = versionFolder(folder, number);
    const auto manifest = readCaseManifest(place);
    if (!voxelHash.empty() && manifest && manifest->version.voxels == voxelHash) return place;
  }
  return std::nullopt;
}

fs::path caseForTraining(const fs::path& folder) {
  const int number = publishedVersion(folder);
  return number > 0 ? versionFolder(folder, number) : folder;
}

std::optional<fs::path> caseOfVersion(const fs::path& folder) {
  const fs::path place = folder.has_filename() ? folder : folder.parent_path();
  std::error_code error;
  if (place.parent_path().filename() != kVersions) return std::nullopt;
  const fs::path whole = place.parent_path().parent_path();
  return fs::exists(whole / kCtFile, error) ? std::optional(whole) : std::nullopt;
}

}  // namespace insonate
