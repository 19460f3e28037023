#include "DicomPicture.h"

#include <gdcmBitmap.h>
#include <gdcmByteValue.h>
#include <gdcmSequenceOfFragments.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace insonate {
namespace {

/// PS3.5 G.3.1: tells whether the runs and copies from here on produce exactly this number of bytes.
bool unpacksTo(std::size_t wanted, std::string_view packed) {
  std::size_t made = 0;
  while (made < wanted && !packed.empty()) {
    const int first = static_cast<signed char>(packed.front());
    const std::size_t taken = first >= 0 ? static_cast<std::size_t>(first) + 2 : first == -128 ? 1 : 2;
    if (taken > packed.size()) return false;
    made += first >= 0 ? static_cast<std::size_t>(first) + 1 : first == -128 ? 0 : static_cast<std::size_t>(1 - first);
    packed.remove_prefix(taken);
  }
  return made == wanted;
}

/// PS3.5 G.5: a frame is a header of 64 bytes, then a segment for each byte of a pixel.
bool holdsFrame(std::string_view frame, std::size_t pixels, std::size_t bytesEach) {
  std::array<std::uint32_t, 16> header{};
  if (frame.size() < sizeof header) return false;
  std::memcpy(header.data(), frame.data(), sizeof header);
  if (header[0] != bytesEach) return false;
  return std::all_of(header.begin() + 1, header.begin() + 1 + static_cast<std::ptrdiff_t>(bytesEach),
                     [&](std::uint32_t from) {
                       return from >= sizeof header && from < frame.size() && unpacksTo(pixels, frame.substr(from));
                     });
}

/// GDCM 3.0 terminates the program if a run-length frame produces fewer or more bytes than it has pixels.
bool holdsRunLengths(const gdcm::SequenceOfFragments& fragments, const std::array<unsigned, 3>& size,
                     std::size_t bytesEach) {
  if (fragments.GetNumberOfFragments() != size[2]) return false;
  for (unsigned f = 0; f < size[2]; ++f) {
    const gdcm::ByteValue* bytes = fragments.GetFragment(f).GetByteValue();
    if (!bytes || !holdsFrame({bytes->GetPointer(), bytes->GetLength()}, std::size_t{size[0]} * size[1], bytesEach))
      return false;
  }
  return true;
}

std::string_view bytesOf(const gdcm::Fragment& fragment) {
  const gdcm::ByteValue* bytes = fragment.GetByteValue();
  return bytes && bytes->GetPointer() ? std::string_view(bytes->GetPointer(), bytes->GetLength()) : std::string_view();
}

/// Tells whether these bytes begin with the start of a JPEG, JPEG-LS or JPEG 2000 stream.
bool beginsStream(std::string_view bytes) {
  return bytes.starts_with("\xff\xd8\xff") || bytes.starts_with("\xff\x4f\xff\x51");
}

/// The fragments of compressed pixels. Some writers leave out the item of the offset table, so that GDCM takes the
/// first fragment for it.
struct Pieces {
  explicit Pieces(const gdcm::SequenceOfFragments& fragments) : table(bytesOf(fragments.GetTable())) {
    if (beginsStream(table)) bytes.push_back(std::exchange(table, {}));
    for (std::size_t f = 0; f < fragments.GetNumberOfFragments(); ++f)
      bytes.push_back(bytesOf(fragments.GetFragment(f)));
  }
  std::string_view table;
  std::vector<std::string_view> bytes;
};

/// Tells for each fragment whether a frame begins there, by the offset table; empty if the table names no fragments.
std::vector<bool> startsInTable(const Pieces& pieces) {
  std::vector<bool> starts(pieces.bytes.size());
  std::uint64_t place = 0;
  std::size_t entry = 0;
  for (std::size_t f = 0; f < starts.size(); ++f) {
    std::uint32_t offset = 0;
    if (pieces.table.size() >= (entry + 1) * sizeof offset) {
      std::memcpy(&offset, pieces.table.data() + entry * sizeof offset, sizeof offset);
      starts[f] = offset == place;
      entry += starts[f];
    }
    constexpr std::uint64_t kItemHeader = 8;
    place += kItemHeader + pieces.bytes[f].size();
  }
  return entry > 0 && entry * sizeof(std::uint32_t) == pieces.table.size() ? starts : std::vector<bool>{};
}

/// Tells for each fragment whether a frame begins there. PS3.5 A.4: a frame may have several fragments, and the offset
/// table may be empty.
std::vector<bool> startsOfFrames(const Pieces& pieces, unsigned frames) {
  std::vector<bool> starts(pieces.bytes.size(), pieces.bytes.size() == frames);
  if (frames == 1 || pieces.bytes.size() == frames) {
    starts[0] = true;
    return starts;
  }
  starts = startsInTable(pieces);
  if (!starts.empty()) return starts;
  starts.resize(pieces.bytes.size());
  std::transform(pieces.bytes.begin(), pieces.bytes.end(), starts.begin(), beginsStream);
  return starts;
}

/// Compressed stream of each frame; empty if the fragments cannot be assigned to frames.
std::vector<std::string> streamsOf(const gdcm::SequenceOfFragments& fragments, unsigned frames) {
  const Pieces pieces(fragments);
  const std::vector<bool> starts = startsOfFrames(pieces, frames);
  if (!starts[0] || static_cast<unsigned>(std::ranges::count(starts, true)) != frames) return {};
  std::vector<std::string> streams;
  for (std::size_t f = 0; f < starts.size(); ++f) {
    if (starts[f]) streams.emplace_back();
    streams.back() += pieces.bytes[f];
  }
  return streams;
}

/// GDCM 3.0 reads frames of several fragments only in part: lossless JPEG fails if a fragment has few bytes.
gdcm::DataElement asOneFragmentEach(const std::vector<std::string>& streams) {
  auto fragments = gdcm::SequenceOfFragments::New();
  for (const std::string& stream : streams) {
    gdcm::Fragment fragment;
    fragment.SetByteValue(stream.data(), gdcm::VL(static_cast<std::uint32_t>(stream.size())));
    fragments->AddFragment(fragment);
  }
  gdcm::DataElement pixels(gdcm::Tag(0x7fe0, 0x0010), 0, gdcm::VR::OB);
  pixels.SetValue(*fragments);
  return pixels;
}

/// T.81 B.2.4.2 and C.2: tells whether no length has more codes than can exist.
bool areHuffmanTables(std::string_view tables) {
  while (!tables.empty()) {
    constexpr std::size_t kCounts = 16;
    if (tables.size() < 1 + kCounts) return false;
    std::size_t values = 0, codes = 0;
    for (std::size_t length = 1; length <= kCounts; ++length) {
      const auto count = static_cast<unsigned char>(tables[length]);
      values += count;
      codes = 2 * codes + count;
      if (codes > std::size_t{1} << length) return false;
    }
    if (values > 256 || tables.size() < 1 + kCounts + values) return false;
    tables.remove_prefix(1 + kCounts + values);
  }
  return true;
}

/// Tells whether the header of a JPEG or JPEG-LS stream (ITU-T T.81 B.2, T.87 C.2) describes one image of this size.
bool isOfSize(std::string_view stream, const std::array<unsigned, 3>& size, unsigned maxBits) {
  const auto byte = [&](std::size_t at) { return at < stream.size() ? static_cast<unsigned char>(stream[at]) : 0U; };
  const auto pair = [&](std::size_t at) { return byte(at) << 8 | byte(at + 1); };
  bool fits = false;
  for (std::size_t at = 2; at + 9 < stream.size() && byte(at) == 0xff; at += 2 + pair(at + 2)) {
    const unsigned marker = byte(at + 1);
    constexpr unsigned kTables = 0xc4, kScan = 0xda, kApplication = 0xe0, kJpegLs = 0xf7;
    if (pair(at + 2) < 2) return false;
    if (marker == kScan) return fits;
    const bool otherJfif =
        stream.substr(at + 4, 4) == "JFIF" && byte(at + 9) != 1;  // a revision that fails an assertion
    if (marker == kApplication && otherJfif) return false;
    if (marker == kTables && !areHuffmanTables(stream.substr(at + 4, pair(at + 2) - 2U))) return false;
    if (marker != kJpegLs && (marker < 0xc0 || marker > 0xcf || marker == kTables)) continue;
    fits = !fits && byte(at + 4) <= maxBits && pair(at + 5) == size[1] && pair(at + 7) == size[0] && byte(at + 9) == 1;
    if (!fits) return false;
  }
  return false;
}

bool isJpeg(const gdcm::TransferSyntax& syntax) {
  using Syntax = gdcm::TransferSyntax;
  for (const auto one : {Syntax::JPEGBaselineProcess1, Syntax::JPEGExtendedProcess2_4, Syntax::JPEGLosslessProcess14,
                         Syntax::JPEGLosslessProcess14_1, Syntax::JPEGLSLossless, Syntax::JPEGLSNearLossless})
    if (syntax == one) return true;
  return false;
}

}  // namespace

std::optional<std::vector<char>> storedPixels(const gdcm::File& file, const std::array<unsigned, 3>& size,
                                              const gdcm::PixelFormat& format) {
  const gdcm::Tag pixelData(0x7fe0, 0x0010);
  const gdcm::DataSet& data = file.GetDataSet();
  if (!data.FindDataElement(pixelData)) return std::nullopt;
  gdcm::DataElement pixels = data.GetDataElement(pixelData);
  const std::size_t needed = std::size_t{size[0]} * size[1] * size[2] * (format.GetBitsAllocated() / 8);
  // GDCM fills missing pixels.
  const gdcm::ByteValue* plain = pixels.GetByteValue();
  const gdcm::SequenceOfFragments* fragments = pixels.GetSequenceOfFragments();
  if (plain ? plain->GetLength() < needed : !fragments || fragments->GetNumberOfFragments() == 0) return std::nullopt;
  const gdcm::TransferSyntax syntax = file.GetHeader().GetDataSetTransferSyntax();
  if (fragments && syntax == gdcm::TransferSyntax::RLELossless &&
      !holdsRunLengths(*fragments, size, format.GetBitsAllocated() / 8))
    return std::nullopt;
  if (fragments && syntax != gdcm::TransferSyntax::RLELossless) {
    const auto streams = streamsOf(*fragments, size[2]);
    if (streams.empty()) return std::nullopt;
    // GDCM 3.0 decodes the size in the stream into memory of the size in the header, which can overflow.
    if (isJpeg(syntax) && !std::ranges::all_of(streams, [&](const std::string& stream) {
          return isOfSize(stream, size, format.GetBitsAllocated());
        }))
      return std::nullopt;
    pixels = asOneFragmentEach(streams);
  }
  gdcm::Bitmap picture;
  picture.SetNumberOfDimensions(size[2] > 1 ? 3 : 2);
  picture.SetDimensions(size.data());
  picture.SetPixelFormat(format);
  picture.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
  picture.SetTransferSyntax(syntax);
  picture.SetNeedByteSwap(syntax == gdcm::TransferSyntax::ImplicitVRBigEndianPrivateGE);
  picture.SetDataElement(pixels);
  if (picture.GetBufferLength() != needed) return std::nullopt;
  std::vector<char> bytes(needed);
  if (!picture.GetBuffer(bytes.data())) return std::nullopt;
  return bytes;
}

}  // namespace insonate
