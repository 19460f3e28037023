#include "DicomPixels.h"

#include "../files/Hounsfield.h"
#include "DicomElements.h"
#include "DicomPicture.h"

#include <gdcmReader.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

namespace insonate {
namespace {

/// Pixels of one file as stored, all frames.
struct StoredPixels {
  std::vector<char> bytes;
  int columns = 0, rows = 0, frames = 1;
  int bytesEach = 2;
  int shift = 0, bits = 16;
  bool isSigned = false;

  /// Bits above the highest stored one may hold an overlay and are masked off.
  std::int64_t value(std::size_t pixel) const {
    std::uint32_t raw = 0;
    std::memcpy(&raw, bytes.data() + pixel * bytesEach, bytesEach);
    const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
    const std::uint64_t stored = (raw >> shift) & mask;
    const bool negative = isSigned && (stored >> (bits - 1)) != 0;
    return negative ? static_cast<std::int64_t>(stored) - static_cast<std::int64_t>(mask) - 1
                    : static_cast<std::int64_t>(stored);
  }
};

struct Changes {
  std::size_t padding = 0, tooDense = 0;
};

tl::unexpected<Error> refuseFile(const std::filesystem::path& file, const std::string& why) {
  return fail("The slice " + file.string() + " " + why);
}

/// Storage format of the pixels; fails for formats that no CT has.
Result<gdcm::PixelFormat> formatOf(const std::filesystem::path& file, const gdcm::DataSet& data) {
  const std::string shown = textOf(data, gdcm::Tag(0x0028, 0x0004));
  const auto number = [&](std::uint16_t element) { return shortOf(data, gdcm::Tag(0x0028, element)).value_or(0); };
  if (shown == "MONOCHROME1")
    return refuseFile(file,
                      "shows high values as dark (MONOCHROME1), which CT scanners do not. Its values may be inverted "
                      "and not be Hounsfield units. Export the original series.");
  if (number(0x0002) > 1 || (!shown.empty() && shown != "MONOCHROME2"))
    return refuseFile(file, "is not a gray image (MONOCHROME2), so it is not a CT slice. Export the original series.");
  const unsigned allocated = number(0x0100), stored = number(0x0101), high = number(0x0102);
  if ((allocated != 8 && allocated != 16 && allocated != 32) || stored < 1 || high + 1 < stored || high >= allocated)
    return refuseFile(file, "has pixels of " + std::to_string(allocated) + " bits, " + std::to_string(stored) +
                                " of which are used; a CT never has this. Export the original series.");
  const auto narrow = [](unsigned value) { return static_cast<unsigned short>(value); };
  return gdcm::PixelFormat(1, narrow(allocated), narrow(stored), narrow(high), narrow(number(0x0103) == 1));
}

Result<StoredPixels> decode(const std::filesystem::path& file) {
  const std::string cutOff = "contains no complete image: it is cut off or damaged. Copy or export it again.";
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  if (!reader.Read()) return refuseFile(file, cutOff);
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();
  const auto format = formatOf(file, data);
  if (!format) return tl::unexpected(format.error());
  StoredPixels pixels;
  pixels.bytesEach = format->GetBitsAllocated() / 8;
  pixels.bits = format->GetBitsStored();
  pixels.shift = format->GetHighBit() + 1 - format->GetBitsStored();
  pixels.isSigned = format->GetPixelRepresentation() == 1;
  pixels.columns = static_cast<int>(shortOf(data, gdcm::Tag(0x0028, 0x0011)).value_or(0));
  pixels.rows = static_cast<int>(shortOf(data, gdcm::Tag(0x0028, 0x0010)).value_or(0));
  pixels.frames = std::max(1, integerOf(data, gdcm::Tag(0x0028, 0x0008)).value_or(1));
  auto bytes = storedPixels(
      reader.GetFile(),
      {static_cast<unsigned>(pixels.columns), static_cast<unsigned>(pixels.rows), static_cast<unsigned>(pixels.frames)},
      *format);
  if (!bytes) return refuseFile(file, cutOff);
  pixels.bytes = std::move(*bytes);
  return pixels;
}

Result<StoredPixels> decodeSafely(const std::filesystem::path& file) {
  try {
    return decode(file);
  } catch (const std::exception&) {
    return refuseFile(file, "could not be decoded. Copy or export it again.");
  }
}

void toHu(const StoredPixels& pixels, const DicomSlice& slice, std::int16_t* out, Changes& changes) {
  const std::size_t count = static_cast<std::size_t>(pixels.columns) * pixels.rows;
  const double slope = slice.slope.value_or(1), intercept = slice.intercept.value_or(0);
  for (std::size_t n = 0; n < count; ++n) {
    const std::int64_t stored = pixels.value(slice.frame * count + n);
    double hu = static_cast<double>(stored) * slope + intercept;
    const bool padding = slice.padding && stored >= (*slice.padding)[0] && stored <= (*slice.padding)[1];
    if (padding || hu < kAirHu) {
      changes.padding += hu != kAirHu;
      hu = kAirHu;
    }
    constexpr double kMaxHu = std::numeric_limits<std::int16_t>::max();
    if (hu > kMaxHu) {
      ++changes.tooDense;
      hu = kMaxHu;
    }
    out[n] = static_cast<std::int16_t>(std::lround(hu));
  }
}

}  // namespace

Result<SliceValues> readSlices(const DicomSeries& series, std::vector<std::string>& notes, const Progress& progress) {
  const std::size_t sliceSize = static_cast<std::size_t>(series.stack.columns) * series.stack.rows;
  const std::size_t size = sliceSize * series.slices.size();
  std::vector<std::int16_t> hu;  // allocated when a first slice has the size of its header
  std::map<std::filesystem::path, std::vector<std::size_t>> slicesOfFile;
  for (std::size_t n = 0; n < series.slices.size(); ++n) slicesOfFile[series.slices[n].file].push_back(n);
  Changes changes;
  std::size_t done = 0;
  for (const auto& [file, slices] : slicesOfFile) {
    if (!report(progress, "Reading slices", static_cast<double>(done) / static_cast<double>(series.slices.size())))
      return fail(std::string(kCancelled));
    const auto pixels = decodeSafely(file);
    if (!pixels) return tl::unexpected(pixels.error());
    for (const std::size_t n : slices) {
      if (pixels->columns != series.stack.columns || pixels->rows != series.stack.rows ||
          series.slices[n].frame >= pixels->frames)
        return refuseFile(file, "has an image whose size differs from the size in its header. Export it again.");
      hu.resize(size);
      toHu(*pixels, series.slices[n], &hu[n * sliceSize], changes);
    }
    done += slices.size();
  }
  if (changes.padding > 0)
    notes.push_back(std::to_string(changes.padding) +
                    " voxels were padding or below -1024 HU and became -1024 HU (air).");
  if (changes.tooDense > 0)
    notes.push_back(std::to_string(changes.tooDense) + " voxels were above 32767 HU and became 32767 HU.");
  return SliceValues{std::move(hu), changes.tooDense};
}

}  // namespace insonate
