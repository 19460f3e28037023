#include <insonate/cases/CaseListing.h>
#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/Phantom.h>
#include <insonate/simulator/AttemptCase.h>

#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace insonate {
namespace {

namespace fs = std::filesystem;

/// Seed of the built-in necks that the window shows.
constexpr std::uint32_t kSeed = 1;

Result<PatientCase> readFrom(const fs::path& folder) {
  auto read = readCase(folder);
  if (!read) return tl::unexpected(read.error());
  return std::move(read->patient);
}

std::vector<fs::path> foldersIn(const fs::path& cases) {
  std::error_code error;
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(cases, error))
    if (entry.is_directory(error)) folders.push_back(entry.path());
  return folders;
}

/// The case with the recorded voxels. Only cases that were never saved as a version must be read to compare them.
std::optional<Result<PatientCase>> findIn(const fs::path& cases, const AttemptHeader& header) {
  const auto folders = foldersIn(cases);
  for (const fs::path& folder : folders)
    if (const auto version = findVersion(folder, header.caseHash)) return readFrom(*version);
  for (const fs::path& folder : folders) {
    const auto manifest = readCaseManifest(folder);
    if (!manifest || manifest->version.number != 0 || manifest->title != header.caseName) continue;
    auto read = readFrom(folder);
    if (read && voxelHashOf(*read) == header.caseHash) return read;
  }
  return std::nullopt;
}

}  // namespace

Result<PatientCase> caseOfAttempt(const AttemptHeader& header, const std::vector<fs::path>& libraries,
                                  const Progress& progress) {
  bool isLibraryNamed = false;
  for (const fs::path& library : libraries) {
    if (library.empty()) continue;
    isLibraryNamed = true;
    if (auto found = findIn(library, header)) return std::move(*found);
  }
  for (const PhantomVariant& variant : phantomVariants()) {
    if (variant.title != header.caseName) continue;
    auto made = makePhantom(variant.name, kSeed, progress);
    if (!made || voxelHashOf(*made) == header.caseHash) return made;
  }
  return fail("The attempt's case, '" + header.caseName +
              "', is not here: it is no built-in case of this version, and " +
              (isLibraryNamed ? "the folder of cases has none with these voxels. Copy the case there."
                              : "no folder of cases is named."));
}

}  // namespace insonate
