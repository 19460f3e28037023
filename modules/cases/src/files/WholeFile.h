#pragma once

#include <insonate/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <optional>

namespace insonate {

/// What a NIfTI file's header says; the library behind ITK fills missing voxels with zeros and says nothing of frames.
struct NiftiHeader {
  double promised_bytes = 0;  ///< header and voxels together, decompressed
  bool oriented = false;      ///< has an sform or a qform
};

/// What was found, decompressed.
struct HeldBytes {
  double count = 0;
  bool streamBreaks = false;  ///< a compressed stream ended early or did not match its check sum
};

/// Fails with a sentence where less was found than promised.
Result<void> checkHeld(const std::filesystem::path& file, double promised_bytes, HeldBytes held);

/// Of a NIfTI-1 or NIfTI-2 file, compressed or not, in either byte order; nothing when it is neither.
std::optional<NiftiHeader> readNiftiHeader(const std::filesystem::path& file);

/// Fails with a sentence when a NIfTI file ends, or its compressed stream breaks, before its last promised byte.
Result<void> checkWholeNifti(const std::filesystem::path& file, const NiftiHeader& header);

/// The same for MetaImage with its voxels inside, in one other file or in a list of files, compressed or not.
/// `promised_bytes` are those of all voxels, decompressed.
Result<void> checkWholeMetaImage(const std::filesystem::path& file, double promised_bytes);

}  // namespace insonate
