#include "MaskFile.h"

#include "../files/VolumeFile.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace fs = std::filesystem;
namespace {

/// Finds out whether all values are zero or one other whole number.
class MaskValues {
 public:
  explicit MaskValues(const VolumeGeometry& geometry) : inside_(geometry) {}

  void take(std::size_t first, std::span<const float> values) {
    std::uint8_t* const inside = inside_.at(first, values.size());
    for (std::size_t n = 0; n < values.size(); ++n) {
      const float value = values[n];
      if (value == 0) continue;
      inside[n] = 1;
      if (value == value_) continue;
      if (value_ != 0)
        isSeveral_ = true;
      else
        value_ = value;
      isWhole_ = isWhole_ && value > 0 && value == std::floor(value);
    }
  }
  Volume<std::uint8_t> takeInside() { return inside_.take(); }
  std::string objection() const {
    return !isWhole_ ? "it holds negative values or fractions" : isSeveral_ ? "it holds several values" : "";
  }

 private:
  ArrivingVolume<std::uint8_t> inside_;
  float value_ = 0;
  bool isSeveral_ = false, isWhole_ = true;
};

}  // namespace

Result<Mask> readMask(const fs::path& file) {
  const auto header = readVolumeHeader(file);
  if (!header) return tl::unexpected(header.error());
  if (header->components != 1)
    return fail(file.string() + " has " + std::to_string(header->components) +
                " values per voxel, e.g. color; a mask has one.");
  const auto geometry = orthogonalGeometry(*header);
  if (!geometry) return fail(file.string() + ": " + geometry.error().message);
  MaskValues values(*geometry);
  const auto read =
      readVolumeBlocks(file, [&values](std::size_t first, std::span<const float> some) { values.take(first, some); });
  if (!read) return tl::unexpected(read.error());
  return Mask{values.takeInside(), values.objection()};
}

fs::path withoutEndings(const fs::path& file) {
  fs::path name = file;
  for (const char* ending : {".gz", ".nii", ".nrrd", ".nhdr", ".mha", ".mhd", ".seg"})
    if (name.extension() == ending) name.replace_extension();
  return name;
}

Result<std::vector<fs::path>> volumesIn(const fs::path& folder) {
  constexpr std::size_t kMostFiles = 2000;
  std::vector<fs::path> files;
  std::error_code error;
  const auto addFrom = [&](const fs::path& from, std::vector<fs::path>* folders) {
    for (fs::directory_iterator entry(from, error), end; !error && entry != end; entry.increment(error)) {
      std::error_code ignored;
      if (entry->path().filename().string().starts_with(".")) continue;
      if (entry->is_regular_file(ignored) && isVolumeFile(entry->path())) files.push_back(entry->path());
      if (folders && entry->is_directory(ignored)) folders->push_back(entry->path());
    }
  };
  std::vector<fs::path> folders;
  addFrom(folder, &folders);
  for (const fs::path& one : folders) addFrom(one, nullptr);
  if (error) return fail("Could not read the folder " + folder.string() + ": " + error.message() + ".");
  if (files.empty())
    return fail("The folder " + folder.string() +
                " contains no labels: choose a folder of masks or label maps (NIfTI, NRRD, MetaImage).");
  if (files.size() > kMostFiles)
    return fail("The folder " + folder.string() + " contains " + std::to_string(files.size()) +
                " volumes. Choose the folder with the masks of one patient.");
  std::ranges::sort(files);
  return files;
}

}  // namespace insonate
