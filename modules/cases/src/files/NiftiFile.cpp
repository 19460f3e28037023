#include "NiftiFile.h"

#include "WholeFile.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <span>

namespace insonate {
namespace fs = std::filesystem;
namespace {

constexpr std::int32_t kSize1 = 348, kSize2 = 540;

/// Positions and widths of the header fields of NIfTI-1 and NIfTI-2 (nifti.nimh.nih.gov, nifti1.h and nifti2.h).
class HeaderBytes {
 public:
  explicit HeaderBytes(std::string bytes) : bytes_(std::move(bytes)) {
    if (bytes_.size() < kSize1) return;
    swapped_ = !isSize(at<std::int32_t>(0));
    const std::int32_t size = at<std::int32_t>(0);
    second_ = size == kSize2;
    valid_ = isSize(size) && bytes_.size() >= static_cast<std::size_t>(size) &&
             bytes_.compare(second_ ? 4 : 344, 3, second_ ? "n+2" : "n+1") == 0;
  }
  bool valid() const { return valid_; }
  bool swapped() const { return swapped_; }
  double headerSize() const { return second_ ? kSize2 : kSize1; }

  double dimension(int n) const {
    return second_ ? double(at<std::int64_t>(16 + 8 * n)) : at<std::int16_t>(40 + 2 * n);
  }
  int datatype() const { return at<std::int16_t>(second_ ? 12 : 70); }
  double pixelSize(int n) const { return real(76 + 4 * n, 104 + 8 * n); }
  double offset() const { return second_ ? double(at<std::int64_t>(168)) : at<float>(108); }
  double slope() const { return real(112, 176); }
  double intercept() const { return real(116, 184); }
  int units() const { return second_ ? at<std::int32_t>(500) : at<std::uint8_t>(123); }
  int qformCode() const { return second_ ? at<std::int32_t>(344) : at<std::int16_t>(252); }
  int sformCode() const { return second_ ? at<std::int32_t>(348) : at<std::int16_t>(254); }
  /// Quaternion b, c, d, then the offset x, y, z.
  double qform(int n) const { return real(256 + 4 * n, 352 + 8 * n); }
  double sform(int row, int column) const { return real(280 + 16 * row + 4 * column, 400 + 32 * row + 8 * column); }

 private:
  static bool isSize(std::int32_t size) { return size == kSize1 || size == kSize2; }
  double real(int first, int second) const { return second_ ? at<double>(second) : at<float>(first); }
  template <class T>
  T at(int offset) const {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), bytes_.data() + offset, sizeof(T));
    if (swapped_) std::ranges::reverse(bytes);
    return std::bit_cast<T>(bytes);
  }

  std::string bytes_;
  bool swapped_ = false, second_ = false, valid_ = false;
};

/// nifti1.h, "METHOD 2": a rotation as a quaternion, and the sign of the third axis in pixdim[0].
Transform qformOf(const HeaderBytes& header) {
  const double b = header.qform(0), c = header.qform(1), d = header.qform(2);
  const double a = std::sqrt(std::max(0.0, 1 - b * b - c * c - d * d));
  Transform t;
  t.linear.column[0] = {a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)};
  t.linear.column[1] = {2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)};
  t.linear.column[2] = {2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - c * c - b * b};
  for (int n = 0; n < 3; ++n) t.linear.column[n] = t.linear.column[n] * header.pixelSize(n + 1);
  if (header.pixelSize(0) < 0) t.linear.column[2] = -1.0 * t.linear.column[2];
  t.offset = {header.qform(3), header.qform(4), header.qform(5)};
  return t;
}

Transform sformOf(const HeaderBytes& header) {
  Transform t;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) t.linear.column[column][row] = header.sform(row, column);
    t.offset[row] = header.sform(row, 3);
  }
  return t;
}

double millimetresOf(int units) {
  constexpr int kSpace = 7, kMetre = 1, kMicrometre = 3;
  return (units & kSpace) == kMetre ? 1000 : (units & kSpace) == kMicrometre ? 0.001 : 1;
}

/// NIfTI's frame is right-anterior-superior.
Transform patientFromIndex(const HeaderBytes& header) {
  constexpr int kScanner = 1;
  const bool q = header.qformCode() > 0, s = header.sformCode() > 0;
  Transform t = s && (!q || header.sformCode() == kScanner) ? sformOf(header) : qformOf(header);
  if (!q && !s) {
    t = {};
    for (int n = 0; n < 3; ++n) t.linear.column[n] = t.linear.column[n] * std::abs(header.pixelSize(n + 1));
    return t;
  }
  const double scale = millimetresOf(header.units());
  const Mat3 lpsFromRas{{{{-scale, 0, 0}, {0, -scale, 0}, {0, 0, scale}}}};
  return Transform{lpsFromRas, {}} * t;
}

struct Datatype {
  int bytesEach = 0, components = 1;
  void (*copy)(std::span<char> bytes, bool swapped, float* values) = nullptr;
};

template <class T>
void copyAs(std::span<char> bytes, bool swapped, float* values) {
  for (std::size_t n = 0; n < bytes.size() / sizeof(T); ++n) {
    char* const from = bytes.data() + n * sizeof(T);
    if (swapped) std::reverse(from, from + sizeof(T));
    T value;
    std::memcpy(&value, from, sizeof(T));
    values[n] = static_cast<float>(value);
  }
}

/// Size of a voxel; none for complex numbers and other types that are not images.
Datatype datatypeOf(int code) {
  static const std::map<int, Datatype> known{
      {2, {1, 1, copyAs<std::uint8_t>}},     {4, {2, 1, copyAs<std::int16_t>}},
      {8, {4, 1, copyAs<std::int32_t>}},     {16, {4, 1, copyAs<float>}},
      {64, {8, 1, copyAs<double>}},          {128, {1, 3, copyAs<std::uint8_t>}},
      {256, {1, 1, copyAs<std::int8_t>}},    {512, {2, 1, copyAs<std::uint16_t>}},
      {768, {4, 1, copyAs<std::uint32_t>}},  {1024, {8, 1, copyAs<std::int64_t>}},
      {1280, {8, 1, copyAs<std::uint64_t>}}, {2304, {1, 4, copyAs<std::uint8_t>}}};
  const auto found = known.find(code);
  return found == known.end() ? Datatype{} : found->second;
}

/// The grid, with the sizes that the header states.
Result<VolumeHeader> describe(const fs::path& file, const HeaderBytes& header, const Datatype& type) {
  VolumeHeader raw;
  const double axes = header.dimension(0);
  for (int n = 1; n <= std::min(axes, 7.0); ++n) {
    const double size = header.dimension(n);
    if (n > 3 && size > 1)
      return fail(file.string() + " has " + std::to_string(static_cast<int>(axes)) +
                  " dimensions, e.g. time; export one three-dimensional volume of it.");
    if (n > 3) continue;
    if (size < 1 || size > 100000)
      return fail(file.string() + " states that it has " + std::to_string(static_cast<long long>(size)) +
                  " voxels along one axis.");
    raw.size[n - 1] = static_cast<int>(size);
  }
  raw.patientFromIndex = patientFromIndex(header);
  raw.oriented = header.qformCode() > 0 || header.sformCode() > 0;
  raw.components = type.components;
  raw.eightBit = type.bytesEach == 1;
  return raw;
}

/// Extensions lie between header and voxels: after four bytes, of which the first tells whether there are any, each has
/// its size, a code and its content (nifti1.h, "HEADER EXTENSIONS").
std::string extensionsOf(const fs::path& file, const HeaderBytes& header) {
  constexpr double kLargest = 1 << 24;
  constexpr std::size_t kFlag = 4, kOwn = 8;
  const double from = header.headerSize(), size = header.offset() - from;
  if (!(size > kFlag + kOwn) || size > kLargest) return {};
  std::string bytes(static_cast<std::size_t>(size), '\0');
  GzipReader in(file);
  if (!in.skip(static_cast<std::size_t>(from))) return {};
  bytes.resize(in.read({bytes.data(), bytes.size()}));
  if (bytes.size() <= kFlag || bytes[0] == 0) return {};
  std::string content;
  for (std::size_t at = kFlag; at + kOwn <= bytes.size();) {
    std::array<char, 4> stated;
    std::memcpy(stated.data(), bytes.data() + at, stated.size());
    if (header.swapped()) std::ranges::reverse(stated);
    const auto length = std::bit_cast<std::int32_t>(stated);
    if (length <= std::int32_t(kOwn) || at + length > bytes.size()) break;
    content.append(bytes, at + kOwn, length - kOwn);
    at += length;
  }
  return content;
}

/// Error of a file that ends early, or whose compressed data are damaged.
tl::unexpected<Error> cutOff(const fs::path& file, double promised_bytes) {
  HeldBytes held = decompressedBytes(file);
  held.streamBreaks = true;
  return tl::unexpected(checkHeld(file, promised_bytes, held).error());
}

/// Passes values to `sink` block by block, without blocks of zeros.
Result<void> passValues(const fs::path& file, const HeaderBytes& header, const Datatype& type, std::size_t count,
                        std::size_t components, const ValueSink& sink) {
  const double slope = header.slope(), intercept = header.intercept();
  const bool isScaled =
      std::isfinite(slope) && slope != 0 && std::isfinite(intercept) && (slope != 1 || intercept != 0);
  const double from = std::max(header.offset(), header.headerSize());
  const double promised = from + double(count) * double(type.bytesEach);
  const std::size_t most = (std::size_t{1} << 16) * components;
  std::vector<char> chunk(most * type.bytesEach);
  std::vector<float> values(most);
  GzipReader in(file);
  if (!in.skip(static_cast<std::size_t>(from))) return cutOff(file, promised);
  for (std::size_t done = 0; done < count;) {
    const std::size_t some = std::min(most, count - done);
    const std::span<char> bytes(chunk.data(), some * type.bytesEach);
    if (in.read(bytes) != bytes.size()) return cutOff(file, promised);
    if (isScaled || std::ranges::any_of(bytes, [](char byte) { return byte != 0; })) {
      type.copy(bytes, header.swapped(), values.data());
      if (isScaled)
        for (float& value : std::span(values).first(some)) value = static_cast<float>(value * slope + intercept);
      sink(done, std::span(values).first(some));
    }
    done += some;
  }
  char end = 0;
  in.read({&end, 1});  // the checksum is at the end
  if (in.broken()) return cutOff(file, promised);
  return {};
}

Result<double> statedCount(const fs::path& file, const VolumeHeader& raw) {
  constexpr double kMaxValues = 4e9;
  const double count = double(raw.size[0]) * raw.size[1] * raw.size[2] * raw.components;
  if (count > kMaxValues) return fail(file.string() + " states that it has more voxels than Insonate can handle.");
  return count;
}

struct OpenedNifti {
  HeaderBytes header;
  Datatype type;
  VolumeHeader raw;
};

Result<OpenedNifti> openNifti(const fs::path& file) {
  std::string bytes(kSize2, '\0');
  bytes.resize(GzipReader(file).read({bytes.data(), bytes.size()}));
  HeaderBytes header(std::move(bytes));
  constexpr double kFarthest = 1e9;
  if (!header.valid() || !(header.offset() < kFarthest))
    return fail("Could not read " + file.string() + ": it is not a NIfTI file. Copy or export it again.");
  const Datatype type = datatypeOf(header.datatype());
  if (!type.copy)
    return fail(file.string() +
                " has voxels of a number type that Insonate cannot read. Convert it to 16-bit integers.");
  auto raw = describe(file, header, type);
  if (!raw) return tl::unexpected(raw.error());
  raw->extension = extensionsOf(file, header);
  return OpenedNifti{std::move(header), type, std::move(*raw)};
}

}  // namespace

Result<VolumeHeader> readNiftiHeader(const fs::path& file) {
  auto opened = openNifti(file);
  if (!opened) return tl::unexpected(opened.error());
  return std::move(opened->raw);
}

Result<VolumeHeader> readNiftiBlocks(const fs::path& file, const ValueSink& sink) {
  auto opened = openNifti(file);
  if (!opened) return tl::unexpected(opened.error());
  const VolumeHeader& header = opened->raw;
  if (auto ok = checkVoxelSize(spacingOf(header)); !ok) return fail(file.string() + ": " + ok.error().message);
  const auto count = statedCount(file, header);
  if (!count) return tl::unexpected(count.error());
  // Deflate compresses to a thousandth at most.
  constexpr double kMostCompressed = 1100;
  const double promised = *count * opened->type.bytesEach;
  if (promised > kMostCompressed * bytesFrom(file, 0)) return cutOff(file, promised);
  if (auto ok = passValues(file, opened->header, opened->type, static_cast<std::size_t>(*count),
                           static_cast<std::size_t>(header.components), sink);
      !ok)
    return tl::unexpected(ok.error());
  return std::move(opened->raw);
}

}  // namespace insonate
