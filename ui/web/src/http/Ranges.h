#pragma once

#include "http/Messages.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace insonate::web {

/// Part of a file.
struct ByteRange {
  std::uint64_t begin = 0, size = 0;
};

/// Reads the header Range of a request for a file of `size` bytes (RFC 9110): "bytes=0-499", "bytes=500-",
/// "bytes=-500". The whole file if there is no such header, or one that asks for several parts or in another unit.
/// Empty if the part lies outside the file.
std::optional<ByteRange> rangeOf(std::string_view header, std::uint64_t size);

/// Answers a request for a file, or for a part of it (status 206; 416 if the part lies outside). The file is sent while
/// the client receives it. A part is sent only while the file is the one of which the client has other parts (If-Range,
/// ETag). Status 404 if the file cannot be read.
Response sendFile(const Request& request, const std::filesystem::path& file, const std::string& type);

}  // namespace insonate::web
