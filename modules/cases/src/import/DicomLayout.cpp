#include "DicomLayout.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>

namespace insonate {
namespace {

constexpr std::uint32_t kUndefinedLength = 0xffffffff;
constexpr std::uint32_t kDelimiters = 0xfffe;  // group of the delimiters
constexpr std::uint64_t kUntilDelimiter = ~std::uint64_t{0};
constexpr std::uint32_t kPixelDataCode = 0x7fe00010, kItem = 0xfffee000, kItemEnd = 0xfffee00d,
                        kSequenceEnd = 0xfffee0dd;

/// PS3.5 table 6.2-1: representations with two bytes of length, and those with four.
constexpr std::array<std::string_view, 21> kShort{"AE", "AS", "AT", "CS", "DA", "DS", "DT", "FL", "FD", "IS", "LO",
                                                  "LT", "PN", "SH", "SL", "SS", "ST", "TM", "UI", "UL", "US"};
constexpr std::array<std::string_view, 13> kLong{"OB", "OW", "OF", "OD", "OL", "OV", "SQ",
                                                 "UT", "UN", "UC", "UR", "SV", "UV"};

bool isAmong(const auto& one, const auto& all) {
  return std::ranges::find(all, one) != all.end();
}

struct Encoding {
  bool explicitVr = false, bigEndian = false;
};

/// DICOM PS3.5 section 7: data elements, sequences of items, and encapsulated pixel fragments.
class Walker {
 public:
  explicit Walker(const std::filesystem::path& file)
      : in_(std::make_unique<std::ifstream>(file, std::ios::binary)),
        size_(*in_ ? std::filesystem::file_size(file) : 0) {}

  DicomLayout walk() {
    const std::string start = peek(0, 132);
    const bool part10 = start.size() == 132 && start.substr(128) == "DICM";
    if (!part10 && !startsLikeDataSet(start))
      return start.starts_with("DICM") ? DicomLayout::kCutInHeader : shortFile(start);
    position_ = part10 ? 132 : 0;
    std::string syntax;
    if (!readMeta(syntax)) return DicomLayout::kCutInHeader;
    if (syntax == "1.2.840.10008.1.2.1.99" && !inflate()) return DicomLayout::kCutInHeader;
    Encoding encoding{syntax != "1.2.840.10008.1.2", syntax == "1.2.840.10008.1.2.2"};
    if (syntax.empty()) encoding.explicitVr = looksExplicit();
    const bool whole = elements(encoding, size_, 0);
    if (whole) return DicomLayout::kWhole;
    return pixelsBegan_ ? DicomLayout::kCutInPixels : DicomLayout::kCutInHeader;
  }

 private:
  struct Element {
    std::uint32_t tag = 0, length = 0;
    std::string vr;
  };

  static DicomLayout shortFile(const std::string& start) {
    // The 128 bytes before "DICM" are usually zero, so that a shorter file of zeros is probably a cut DICOM file.
    const bool zeros = !start.empty() && start.size() < 132 && start.find_first_not_of('\0') == std::string::npos;
    return zeros ? DicomLayout::kCutInHeader : DicomLayout::kNotDicom;
  }

  /// Without a preamble a file starts with group 2 or 8 and a small length.
  static bool startsLikeDataSet(const std::string& start) {
    return start.size() >= 16 && (start[0] == 2 || start[0] == 8) && start[1] == 0 && start[3] == 0;
  }

  std::string peek(std::uint64_t at, std::size_t count) {
    if (at >= size_) return {};
    std::string bytes(std::min<std::uint64_t>(count, size_ - at), '\0');
    in_->clear();
    in_->seekg(static_cast<std::streamoff>(at));
    in_->read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return *in_ ? bytes : std::string{};
  }

  /// PS3.5 A.5: the remainder is a stream of RFC 1951. GDCM accepts the output of a broken stream as complete.
  bool inflate() {
    std::string packed = peek(position_, size_ - position_), all, piece(1U << 20, '\0');
    z_stream stream{};
    if (::inflateInit2(&stream, -MAX_WBITS) != Z_OK) return false;
    stream.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    int state = Z_OK;
    constexpr std::size_t kMost = std::size_t{1} << 31;
    while (state == Z_OK && all.size() < kMost) {
      stream.next_out = reinterpret_cast<Bytef*>(piece.data());
      stream.avail_out = static_cast<uInt>(piece.size());
      state = ::inflate(&stream, Z_NO_FLUSH);
      all.append(piece, 0, piece.size() - stream.avail_out);
    }
    ::inflateEnd(&stream);
    size_ = all.size();
    position_ = 0;
    in_ = std::make_unique<std::istringstream>(std::move(all));
    return state == Z_STREAM_END;
  }

  static std::uint32_t number(std::string_view bytes, bool bigEndian) {
    std::uint32_t value = 0;
    for (std::size_t n = 0; n < bytes.size(); ++n) {
      const std::uint32_t byte = static_cast<unsigned char>(bytes[n]);
      value |= byte << (8 * (bigEndian ? bytes.size() - 1 - n : n));
    }
    return value;
  }

  bool looksExplicit() {
    const std::string bytes = peek(position_, 6);
    return bytes.size() == 6 && std::isupper(static_cast<unsigned char>(bytes[4])) &&
           std::isupper(static_cast<unsigned char>(bytes[5]));
  }

  /// Reads a tag, a representation and a length, and moves after them. False at the end of the file and for an unknown
  /// representation, for which GDCM 3.0 guesses lengths and may terminate the program.
  bool next(Encoding encoding, Element& element) {
    const std::string bytes = peek(position_, 12);
    if (bytes.size() < 8) return false;
    const std::string_view view(bytes);
    element.tag = number(view.substr(0, 2), encoding.bigEndian) << 16 | number(view.substr(2, 2), encoding.bigEndian);
    element.vr.clear();
    position_ += 8;
    if (!encoding.explicitVr || element.tag >> 16 == kDelimiters) {
      element.length = number(view.substr(4, 4), encoding.bigEndian);
      return true;
    }
    element.vr = bytes.substr(4, 2);
    if (isAmong(element.vr, kLong)) {
      if (bytes.size() < 12) return false;
      element.length = number(view.substr(8, 4), encoding.bigEndian);
      position_ += 4;
      return true;
    }
    element.length = number(view.substr(6, 2), encoding.bigEndian);
    return isAmong(element.vr, kShort);
  }

  bool skip(std::uint32_t length) {
    if (length > size_ - position_) return false;
    position_ += length;
    return true;
  }

  /// The file's meta information, group 2, always explicit little endian.
  bool readMeta(std::string& syntax) {
    for (;;) {
      const std::string group = peek(position_, 2);
      if (group.size() < 2) return false;
      if (number(group, false) != 2) return true;
      Element element;
      if (!next({true, false}, element)) return false;
      // All elements that PS3.10 7.1 defines there; GDCM 3.0 terminates the program on others.
      constexpr std::array<std::string_view, 7> kRepresentations{"UL", "OB", "UI", "SH", "AE", "UR", "UN"};
      if (!isAmong(element.vr, kRepresentations)) return false;
      if (element.tag == 0x00020010) {
        syntax = peek(position_, std::min<std::uint32_t>(element.length, 64));
        while (!syntax.empty() && (syntax.back() == '\0' || syntax.back() == ' ')) syntax.pop_back();
      }
      if (!skip(element.length)) return false;
    }
  }

  bool elements(Encoding encoding, std::uint64_t end, int depth) {
    constexpr int kDeepest = 32;
    if (depth > kDeepest) return false;
    while (position_ < end) {
      Element element;
      if (depth == 0 && size_ - position_ < 8) return pixelsBegan_;  // trailing padding
      if (!next(encoding, element)) return false;
      if (element.tag == kItemEnd) return depth > 0 && element.length == 0;
      if (element.tag >> 16 == kDelimiters) return false;
      if (depth == 0 && element.tag == kPixelDataCode) pixelsBegan_ = true;
      if (element.length != kUndefinedLength) {
        if (element.length > end - position_) return false;
        const std::uint64_t behind = position_ + element.length;
        if (element.vr == "SQ" ? !items(encoding, behind, depth) : !skip(element.length)) return false;
      } else if (element.tag == kPixelDataCode) {
        if (!fragments(encoding)) return false;
      } else if (encoding.explicitVr && element.vr != "SQ" && element.vr != "UN") {
        return false;  // PS3.5 7.1.2; GDCM 3.0 terminates the program on it
      } else if (!items(element.vr == "UN" ? Encoding{false, false} : encoding, kUntilDelimiter, depth)) {
        return false;  // PS3.5 6.2.2: UN of undefined length is implicit little endian
      }
    }
    return position_ == end;
  }

  /// Reads the items of a sequence up to its end or its delimiter.
  bool items(Encoding encoding, std::uint64_t end, int depth) {
    while (position_ < end) {
      Element item;
      if (!next(encoding, item)) return false;
      if (item.tag == kSequenceEnd) return item.length == 0;
      if (item.tag != kItem) return false;
      const std::uint64_t itemEnd = item.length == kUndefinedLength ? kUntilDelimiter : position_ + item.length;
      if (!elements(encoding, itemEnd, depth + 1)) return false;
    }
    return position_ == end;
  }

  /// Some writers omit the delimiter after the last fragment.
  bool fragments(Encoding encoding) {
    for (int count = 0;; ++count) {
      Element item;
      if (size_ - position_ < 8) {
        position_ = size_;
        return count > 1;
      }
      if (!next(encoding, item)) return false;
      if (item.tag == kSequenceEnd) return item.length == 0;
      if (item.tag != kItem || item.length == kUndefinedLength || !skip(item.length)) return false;
    }
  }

  std::unique_ptr<std::istream> in_;
  std::uint64_t size_ = 0, position_ = 0;
  bool pixelsBegan_ = false;
};

}  // namespace

DicomLayout layoutOf(const std::filesystem::path& file) {
  try {
    return Walker(file).walk();
  } catch (const std::exception&) {
    return DicomLayout::kNotDicom;  // unreadable
  }
}

}  // namespace insonate
