#pragma once

#include <insonate/core/Result.h>

#include <filesystem>
#include <memory>
#include <span>

namespace insonate {

/// What was found, decompressed.
struct HeldBytes {
  double count = 0;
  bool streamBreaks = false;  ///< a compressed stream ended early or did not match its check sum
};

/// A file's bytes from its beginning, decompressed where it is a gzip file.
class GzipReader {
 public:
  explicit GzipReader(const std::filesystem::path& file);
  ~GzipReader();
  /// As many as there are, at most as many as `bytes` holds.
  std::size_t read(std::span<char> bytes);
  /// False where fewer are left.
  bool skip(std::size_t count);
  /// True where reading met a damaged stream.
  bool broken() const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

/// Reads to the end, where the check sum stands.
HeldBytes decompressedBytes(const std::filesystem::path& file);

/// Fails with a sentence where less was found than promised.
Result<void> checkHeld(const std::filesystem::path& file, double promised_bytes, HeldBytes held);

/// Fails with a sentence when a MetaImage with its voxels inside, in one other file or in a list of files, compressed
/// or not, ends or breaks before its last promised byte. `promised_bytes` are those of all voxels, decompressed.
Result<void> checkWholeMetaImage(const std::filesystem::path& file, double promised_bytes);

}  // namespace insonate
