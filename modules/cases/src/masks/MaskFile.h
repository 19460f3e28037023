#pragma once

#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <filesystem>
#include <string>

namespace insonate {

/// A file that contains one structure: one value inside, zero outside.
struct Mask {
  Volume<std::uint8_t> inside;  ///< 1 in the structure, else 0
  std::string objection;        ///< reason why the file is no mask, e.g. that it has several values; empty for a mask
};

/// Reads a mask (NRRD, NIfTI, MetaImage). A volume with other values is no error, but has an objection.
Result<Mask> readMask(const std::filesystem::path& file);

/// "a.b" of "a.b.nii.gz" and of "a.b.seg.nrrd".
std::filesystem::path withoutEndings(const std::filesystem::path& file);

/// Returns the volume files in a folder and in its subfolders, in the order of their names. Fails if there are none.
Result<std::vector<std::filesystem::path>> volumesIn(const std::filesystem::path& folder);

}  // namespace insonate
