#pragma once

#include <insonate/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace insonate {

/// Number of bytes found in a file, after decompression.
struct HeldBytes {
  double count = 0;
  bool streamBreaks = false;  ///< true if a compressed stream ended early or did not match its checksum
};

/// Reads a file's bytes from its beginning, decompressed if it is a gzip file.
class GzipReader {
 public:
  explicit GzipReader(const std::filesystem::path& file);
  ~GzipReader();
  /// Reads up to the size of `bytes`; returns the number read.
  std::size_t read(std::span<char> bytes);
  /// Skips `count` bytes; returns false if fewer bytes are left.
  bool skip(std::size_t count);
  /// Tells whether the compressed stream was damaged.
  bool broken() const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

/// Counts the bytes of a file, decompressed if it is a gzip file, and checks the gzip checksum.
HeldBytes decompressedBytes(const std::filesystem::path& file);

/// Decompresses and counts the zlib or gzip stream at `offset` of a file.
HeldBytes inflatedBytes(const std::filesystem::path& file, std::uint64_t offset);

/// Returns the number of bytes of a file after `offset`.
double bytesFrom(const std::filesystem::path& file, std::uint64_t offset);

/// Fails with a sentence if fewer bytes were found in the file than its header promised.
Result<void> checkHeld(const std::filesystem::path& file, double promised_bytes, HeldBytes held);

/// Refuses a MetaImage header whose number of dimensions would make ITK 5.2 loop endlessly.
Result<void> checkMetaImageHeader(const std::filesystem::path& file);

/// Fails with a sentence, before memory is allocated, if an NRRD holds fewer bytes of voxels than its header promised.
/// The voxels are in the NRRD file or in one other file. For voxels written as text, the check assumes the shortest
/// possible text per number.
Result<void> checkWholeNrrd(const std::filesystem::path& file, double promised_bytes);

/// Fails with a sentence if a MetaImage ends or is damaged before the last byte that its header promised. The voxels
/// are in the MetaImage file, in one other file or in a list of files, compressed or not. `promised_bytes` is the size
/// of all voxels, decompressed.
Result<void> checkWholeMetaImage(const std::filesystem::path& file, double promised_bytes);

}  // namespace insonate
