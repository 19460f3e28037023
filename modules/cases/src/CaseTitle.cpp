#include <insonate/cases/CaseTitle.h>

namespace insonate {

namespace fs = std::filesystem;

void setTitleFromFolder(CaseManifest& manifest, const fs::path& folder) {
  if (manifest.title != kImportedTitle) return;
  fs::path whole = fs::absolute(folder).lexically_normal();
  if (!whole.has_filename()) whole = whole.parent_path();
  const fs::path name = whole.extension() == ".case" ? whole.stem() : whole.filename();
  if (!name.empty()) manifest.title = name.string();
}

}  // namespace insonate
