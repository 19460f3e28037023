#include "CaseFiles.h"

#include <insonate/cases/CaseListing.h>
#include <insonate/core/Fingerprint.h>

#include <fstream>
#include <iterator>

namespace insonate {
namespace fs = std::filesystem;

const std::vector<std::string>& caseFileNames() {
  static const std::vector<std::string> names{kCtFile, kLabelFile, kPlainLabelFile, kSnapFile, kManifestFile};
  return names;
}

Result<CaseManifest> readCaseManifest(const fs::path& folder) {
  std::vector<std::string> notes;
  return readManifest(folder / kManifestFile, notes);
}

std::string diskFingerprint(const fs::path& folder) {
  Fingerprint state;
  std::ifstream manifest(folder / kManifestFile, std::ios::binary);
  state.add(std::string(std::istreambuf_iterator<char>(manifest), {}));
  for (const char* name : {kCtFile, kLabelFile, kPlainLabelFile}) {
    std::error_code none;
    const fs::path file = folder / name;
    if (!fs::exists(file, none)) continue;
    state.add(name);
    state.add(std::uint64_t{fs::file_size(file, none)});
    state.add(static_cast<std::uint64_t>(fs::last_write_time(file, none).time_since_epoch().count()));
  }
  return state.text();
}

}  // namespace insonate
