#pragma once

#include <insonate/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace insonate {

/// Bytes found in a file, decompressed.
struct HeldBytes {
  double count = 0;
  bool streamBreaks = false;  ///< a compressed stream ended early or did not match its check sum
};

/// Reads a file's bytes from its beginning, decompressed if it is a gzip file.
class GzipReader {
 public:
  explicit GzipReader(const std::filesystem::path& file);
  ~GzipReader();
  /// Reads up to the size of `bytes`; returns the number read.
  std::size_t read(std::span<char> bytes);
  /// Skips bytes; false if fewer are left.
  bool skip(std::size_t count);
  /// Tells whether the stream was damaged.
  bool broken() const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

/// Reads to the end, where the check sum stands.
HeldBytes decompressedBytes(const std::filesystem::path& file);

/// Decompresses the zlib or gzip stream at `offset` of a file.
HeldBytes inflatedBytes(const std::filesystem::path& file, std::uint64_t offset);

/// Number of bytes of a file behind `offset`.
double bytesFrom(const std::filesystem::path& file, std::uint64_t offset);

/// Fails with a sentence where less was found than promised.
Result<void> checkHeld(const std::filesystem::path& file, double promised_bytes, HeldBytes held);

/// Refuses a number of dimensions for which ITK 5.2 would look without end.
Result<void> checkMetaImageHeader(const std::filesystem::path& file);

/// Fails with a sentence when an NRRD with its voxels inside or in one other file holds fewer bytes than promised,
/// before memory is asked for. Of numbers written as text, each is taken for the shortest.
Result<void> checkWholeNrrd(const std::filesystem::path& file, double promised_bytes);

/// Fails with a sentence when a MetaImage with its voxels inside, in one other file or in a list of files, compressed
/// or not, ends or breaks before its last promised byte. `promised_bytes` are those of all voxels, decompressed.
Result<void> checkWholeMetaImage(const std::filesystem::path& file, double promised_bytes);

}  // namespace insonate
