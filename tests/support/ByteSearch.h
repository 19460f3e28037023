#pragma once

#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace insonate::test {

/// Decompresses the zlib or gzip stream at the start of `packed`; empty if there is none.
inline std::string unpacked(std::string_view packed) {
  z_stream stream{};
  constexpr int kZlibOrGzip = 47;
  if (::inflateInit2(&stream, kZlibOrGzip) != Z_OK) return {};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string all, piece(1U << 16, '\0');
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    state = ::inflate(&stream, Z_NO_FLUSH);
    all.append(piece, 0, piece.size() - stream.avail_out);
  }
  ::inflateEnd(&stream);
  return all;
}

/// As UTF-16, of a text in ASCII.
inline std::string wide(const std::string& text, bool bigEndian) {
  std::string result;
  for (const char letter : text) result += bigEndian ? std::string{'\0', letter} : std::string{letter, '\0'};
  return result;
}

/// Base64 (RFC 4648) of a text at any place among other text: without the letters that depend on neighbors.
inline std::string inBase64(const std::string& text, std::size_t place) {
  const std::string bytes = std::string(place, '\0') + text;
  const std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string code;
  for (std::size_t bit = 0; bit + 6 <= 8 * bytes.size(); bit += 6) {
    const auto byte = [&](std::size_t n) { return n < bytes.size() ? static_cast<unsigned char>(bytes[n]) : 0U; };
    const unsigned pair = byte(bit / 8) << 8 | byte(bit / 8 + 1);
    code += letters[pair >> (10 - bit % 8) & 63];
  }
  return code.substr((8 * place + 5) / 6);
}

/// The marks that occur in some bytes, as ASCII, UTF-16 or base64, also in what is packed within.
inline std::vector<std::string> marksIn(const std::string& bytes, const std::vector<std::string>& marks) {
  std::vector<std::string> found;
  const auto look = [&](const std::string& text) {
    for (const std::string& mark : marks)
      for (const std::string& form :
           {mark, wide(mark, false), wide(mark, true), inBase64(mark, 0), inBase64(mark, 1), inBase64(mark, 2)})
        if (text.find(form) != std::string::npos) found.push_back(mark);
  };
  look(bytes);
  // gzip of RFC 1952, and what PNG and MetaImage hold (RFC 1950).
  for (const char* start : {"\x1f\x8b\x08", "\x78\x01", "\x78\x5e", "\x78\x9c", "\x78\xda"})
    for (std::size_t at = bytes.find(start); at != std::string::npos; at = bytes.find(start, at + 1))
      look(unpacked(std::string_view(bytes).substr(at)));
  return found;
}

/// "file: mark" for each mark in the content or the name of each file and folder below `folder`; counts what it read.
inline std::vector<std::string> marksBelow(const std::filesystem::path& folder, const std::vector<std::string>& marks,
                                           int& files) {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    std::vector<std::string> here = marksIn(name, marks);
    if (entry.is_regular_file()) {
      ++files;
      std::ifstream in(entry.path(), std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(in), {}};
      for (std::string& mark : marksIn(bytes, marks)) here.push_back(std::move(mark));
    }
    for (const std::string& mark : here) found.push_back(name + ": " + mark);
  }
  return found;
}

}  // namespace insonate::test
