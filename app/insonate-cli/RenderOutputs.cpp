#include "RenderOutputs.h"

#include <insonate/cases/PatientCase.h>
#include <insonate/core/AtomicFile.h>

#include <unistd.h>

#include <cstdio>

namespace insonate::cli {
namespace fs = std::filesystem;
namespace {

std::string withSuffix(const std::string& file, const std::string& suffix) {
  if (file.empty()) return file;
  const fs::path path(file);
  return (path.parent_path() / (path.stem().string() + suffix + path.extension().string())).string();
}

Result<void> checkFolderOf(const fs::path& target) {
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::is_directory(folder, error))
    return fail("Could not write " + target.string() + ": the folder " + folder.string() +
                " does not exist; create it first.");
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    return fail("Could not write " + target.string() + ": the folder " + folder.string() +
                " cannot be written; choose another.");
  return {};
}

Result<void> checkFile(const std::string& target, const std::string& extension, const std::string& option) {
  if (target.empty()) return {};
  if (fs::path(target).extension() != extension) return fail(option + " " + target + " must end in " + extension + ".");
  std::error_code error;
  if (fs::is_directory(target, error)) return fail(target + " is a folder; " + option + " needs a file name.");
  return checkFolderOf(target);
}

}  // namespace

OutputTargets OutputTargets::numbered(std::size_t index) const {
  char number[32];
  std::snprintf(number, sizeof number, "_%04zu", index);
  return {withSuffix(picture, number),      withSuffix(envelope, number),
          withSuffix(displacement, number), layers,
          withSuffix(mMode, number),        number};
}

Result<void> checkTargets(const OutputTargets& targets, const fs::path& caseFolder) {
  if (auto ok = checkFile(targets.picture, ".png", "--out"); !ok) return ok;
  if (auto ok = checkFile(targets.envelope, ".nrrd", "--envelope"); !ok) return ok;
  if (auto ok = checkFile(targets.displacement, ".nrrd", "--displacement"); !ok) return ok;
  if (auto ok = checkFile(targets.mMode, ".png", "--mmode"); !ok) return ok;
  for (const std::string& file : {targets.picture, targets.envelope, targets.displacement, targets.mMode})
    if (!file.empty() && isCaseFile(caseFolder, file))
      return fail(file + " is a file of the case itself, which would be overwritten. Name another file.");
  return targets.layers.empty() ? Result<void>{} : checkFolderTarget(targets.layers);
}

Result<void> writePictures(const std::map<std::string, BModeImage>& pictures, const fs::path& folder) {
  return writeFolderAtomically(folder, [&](const fs::path& beside) -> Result<void> {
    for (const auto& [name, picture] : pictures)
      if (auto ok = writePng(picture, beside / name); !ok) return ok;
    return {};
  });
}

}  // namespace insonate::cli
