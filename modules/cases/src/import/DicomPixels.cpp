#include "DicomPixels.h"

#include "../files/Hounsfield.h"

#include <gdcmByteValue.h>
#include <gdcmImageReader.h>
#include <gdcmSequenceOfFragments.h>

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

/// Length check of uncompressed pixels: GDCM fills what is missing.
bool isCutOff(const gdcm::File& file, std::size_t expected) {
  const gdcm::Tag pixelData(0x7fe0, 0x0010);
  if (!file.GetDataSet().FindDataElement(pixelData)) return true;
  const gdcm::DataElement& element = file.GetDataSet().GetDataElement(pixelData);
  if (element.GetSequenceOfFragments()) return element.GetSequenceOfFragments()->GetNumberOfFragments() == 0;
  const gdcm::ByteValue* bytes = element.GetByteValue();
  return !bytes || bytes->GetLength() < expected;
}

Result<StoredPixels> decode(const std::filesystem::path& file) {
  const std::string cutOff = "holds no complete picture: it is cut off or damaged. Copy or export it again.";
  gdcm::ImageReader reader;
  reader.SetFileName(file.c_str());
  if (!reader.Read()) return refuseFile(file, cutOff);
  const gdcm::Image& image = reader.GetImage();
  const gdcm::PixelFormat format = image.GetPixelFormat();
  if (image.GetPhotometricInterpretation() == gdcm::PhotometricInterpretation::MONOCHROME1)
    return refuseFile(file,
                      "shows high values dark (MONOCHROME1), as scanners do not; they may have been inverted and be no "
                      "Hounsfield units. Export the original series.");
  if (format.GetSamplesPerPixel() != 1 ||
      image.GetPhotometricInterpretation() != gdcm::PhotometricInterpretation::MONOCHROME2)
    return refuseFile(file, "is not a plain grey picture (MONOCHROME2), as a CT slice is. Export the original series.");
  StoredPixels pixels;
  pixels.bytesEach = format.GetBitsAllocated() / 8;
  pixels.bits = format.GetBitsStored();
  pixels.shift = format.GetHighBit() + 1 - format.GetBitsStored();
  pixels.isSigned = format.GetPixelRepresentation() == 1;
  if ((pixels.bytesEach != 1 && pixels.bytesEach != 2 && pixels.bytesEach != 4) || pixels.bits < 1 ||
      pixels.shift < 0 || pixels.bits + pixels.shift > format.GetBitsAllocated())
    return refuseFile(file, "has pixels of " + std::to_string(format.GetBitsAllocated()) + " bits, " +
                                std::to_string(format.GetBitsStored()) + " of them used, which no CT has.");
  pixels.columns = static_cast<int>(image.GetDimension(0));
  pixels.rows = static_cast<int>(image.GetDimension(1));
  pixels.frames = image.GetNumberOfDimensions() > 2 ? static_cast<int>(image.GetDimension(2)) : 1;
  const std::size_t expected =
      static_cast<std::size_t>(pixels.columns) * pixels.rows * pixels.frames * pixels.bytesEach;
  if (isCutOff(reader.GetFile(), expected) || image.GetBufferLength() < expected) return refuseFile(file, cutOff);
  pixels.bytes.resize(image.GetBufferLength());
  if (!image.GetBuffer(pixels.bytes.data())) return refuseFile(file, cutOff);
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

Result<std::vector<std::int16_t>> readSlices(const DicomSeries& series, std::vector<std::string>& notes,
                                             const Progress& progress) {
  const std::size_t sliceSize = static_cast<std::size_t>(series.stack.columns) * series.stack.rows;
  std::vector<std::int16_t> hu(sliceSize * series.slices.size());
  std::map<std::filesystem::path, std::vector<std::size_t>> slicesOfFile;
  for (std::size_t n = 0; n < series.slices.size(); ++n) slicesOfFile[series.slices[n].file].push_back(n);
  Changes changes;
  std::size_t done = 0;
  for (const auto& [file, slices] : slicesOfFile) {
    if (!report(progress, "Reading slices", static_cast<double>(done) / static_cast<double>(hu.size() / sliceSize)))
      return fail(std::string(kCancelled));
    const auto pixels = decodeSafely(file);
    if (!pixels) return tl::unexpected(pixels.error());
    for (const std::size_t n : slices) {
      if (pixels->columns != series.stack.columns || pixels->rows != series.stack.rows ||
          series.slices[n].frame >= pixels->frames)
        return refuseFile(file, "has a picture of another size than its header says.");
      toHu(*pixels, series.slices[n], &hu[n * sliceSize], changes);
    }
    done += slices.size();
  }
  if (changes.padding > 0)
    notes.push_back(std::to_string(changes.padding) +
                    " voxels were padding or below -1024 HU and became -1024 HU (air).");
  if (*std::ranges::min_element(hu) >= 0)
    notes.push_back("No value of the CT is below 0: it may not be in Hounsfield units; air should be near -1000.");
  if (changes.tooDense > 0)
    notes.push_back(std::to_string(changes.tooDense) + " voxels were above 32767 HU and became 32767 HU.");
  return hu;
}

}  // namespace insonate
