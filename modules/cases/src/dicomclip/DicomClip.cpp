#include "../import/DerivedUid.h"
#include "../import/DicomEncoding.h"

#include <insonate/cases/DicomClip.h>
#include <insonate/core/AtomicFile.h>

#include <gdcmTrace.h>
#include <gdcmWriter.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <limits>

namespace insonate {
namespace fs = std::filesystem;
namespace {

using gdcm::DataSet;
using gdcm::Tag;
using gdcm::VR;

constexpr const char* kUltrasoundMultiFrame = "1.2.840.10008.5.1.4.1.1.3.1";
/// Interval that is stated for a clip of one frame, which has none.
constexpr double kOnlyInterval_s = 0.04;
/// The length of a text has 16 bits, and is even.
constexpr std::size_t kLongestText = 65534;

std::uint64_t frameSize(const DicomClip& clip) {
  return std::uint64_t(clip.width) * std::uint64_t(clip.height) * std::uint64_t(clip.channels);
}

std::uint64_t pixelsSize(const DicomClip& clip) {
  return frameSize(clip) * clip.time_s.size();
}

bool isInside(const ClipRegion& region, const DicomClip& clip) {
  return region.left_px >= 0 && region.top_px >= 0 && region.width_px > 0 && region.height_px > 0 &&
         region.left_px + region.width_px <= clip.width && region.top_px + region.height_px <= clip.height;
}

Result<void> checkClip(const DicomClip& clip) {
  if (clip.time_s.empty()) return fail("The clip has no images, so that there is nothing to write.");
  if (!std::ranges::is_sorted(clip.time_s)) return fail("The times of the clip's images do not ascend.");
  const auto isSide = [](int side) { return side >= 1 && side <= std::numeric_limits<std::uint16_t>::max(); };
  if (!isSide(clip.width) || !isSide(clip.height) || (clip.channels != 1 && clip.channels != 3))
    return fail("A frame of " + std::to_string(clip.width) + " x " + std::to_string(clip.height) +
                " pixels cannot be in a DICOM clip. Width and height must be 1 to 65535, and 1 or 3 channels.");
  if (!isInside(clip.region, clip) || !(clip.region.pixel_mm > 0))
    return fail("The ultrasound image is not within the frames of the clip, or it has no scale.");
  if (pixelsSize(clip) > std::numeric_limits<std::uint32_t>::max() - 1)
    return fail("The clip needs more than 4 GB, which a DICOM file cannot contain. Save fewer images or save a video.");
  return {};
}

/// Milliseconds from each frame to the one before; thousandths are enough, and leave room for more frames.
std::vector<double> intervalsOf_ms(const DicomClip& clip) {
  std::vector<double> intervals_ms{0};
  for (std::size_t i = 1; i < clip.time_s.size(); ++i)
    intervals_ms.push_back(std::round((clip.time_s[i] - clip.time_s[i - 1]) * 1e6) / 1000);
  return intervals_ms;
}

/// Cine and multi-frame modules (PS3.3 C.7.6.5, C.7.6.6). A constant interval is stated once, since few viewers read a
/// list of intervals; the rate is for viewers that read neither.
Result<void> putTimes(DataSet& data, const DicomClip& clip) {
  const std::vector<double> intervals_ms = intervalsOf_ms(clip);
  const std::size_t count = intervals_ms.size();
  const double length_s = clip.time_s.back() - clip.time_s.front();
  const double interval_s = count > 1 && length_s > 0 ? length_s / double(count - 1) : kOnlyInterval_s;
  const auto isUsual = [&](double interval_ms) { return std::abs(interval_ms - interval_s * 1000) < 2e-3; };
  const bool isConstant = std::all_of(intervals_ms.begin() + 1, intervals_ms.end(), isUsual);
  const Tag times = isConstant ? Tag(0x0018, 0x1063) : Tag(0x0018, 0x1065);
  std::string text = decimalStrings({interval_s * 1000});
  if (!isConstant) {
    text.clear();
    for (const double interval_ms : intervals_ms) text += (text.empty() ? "" : "\\") + decimalStrings({interval_ms});
    if (text.size() > kLongestText)
      return fail("The clip has " + std::to_string(count) +
                  " images at varying intervals, more than a DICOM file can list. Save fewer images or save a video.");
  }
  put(data, times, VR::DS, text);
  const std::uint16_t pointer[2] = {times.GetGroup(), times.GetElement()};
  putBinary(data, Tag(0x0028, 0x0009), VR::AT, pointer, sizeof pointer);
  put(data, Tag(0x0028, 0x0008), VR::IS, std::to_string(count));
  const std::string rate = std::to_string(std::max(1L, std::lround(1 / interval_s)));
  for (const Tag& tag : {Tag(0x0018, 0x0040), Tag(0x0008, 0x2144)}) put(data, tag, VR::IS, rate);
  return {};
}

/// US region calibration module (PS3.3 C.8.5.5).
void putRegion(DataSet& data, const ClipRegion& region) {
  constexpr std::uint16_t kFlat = 1, kTissue = 1, kCentimeters = 3;
  DataSet item;
  const auto putLong = [&](std::uint16_t element, VR::VRType vr, std::int32_t value) {
    putBinary(item, Tag(0x0018, element), vr, &value, sizeof value);
  };
  const auto putDouble = [&](std::uint16_t element, double value) {
    putBinary(item, Tag(0x0018, element), VR::FD, &value, sizeof value);
  };
  putShorts(item, Tag(0x0018, 0x6012), {kFlat});
  putShorts(item, Tag(0x0018, 0x6014), {kTissue});
  putLong(0x6016, VR::UL, 0);
  putLong(0x6018, VR::UL, region.left_px);
  putLong(0x601a, VR::UL, region.top_px);
  putLong(0x601c, VR::UL, region.left_px + region.width_px - 1);
  putLong(0x601e, VR::UL, region.top_px + region.height_px - 1);
  for (const std::uint16_t element : {0x6020, 0x6022}) putLong(element, VR::SL, 0);
  for (const std::uint16_t element : {0x6024, 0x6026}) putShorts(item, Tag(0x0018, element), {kCentimeters});
  putDouble(0x6028, region.left_mm / 10);
  putDouble(0x602a, region.top_mm / 10);
  for (const std::uint16_t element : {0x602c, 0x602e}) putDouble(element, region.pixel_mm / 10);
  putSequence(data, Tag(0x0018, 0x6011), {item});
}

/// Returns a text of 64 letters at most, without the separators of values and without half a letter of UTF-8.
std::string lineOf(std::string text) {
  constexpr std::size_t kLongest = 64;
  std::ranges::replace_if(
      text, [](char c) { return c == '\\' || static_cast<unsigned char>(c) < ' '; }, ' ');
  if (text.size() <= kLongest) return text;
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return text.substr(0, end);
}

/// Series, equipment and SOP common modules.
void putClipSeries(DataSet& data, const DicomClip& clip) {
  const std::string seed = clip.identity.seed + "/clip/" + clip.seed;
  put(data, Tag(0x0008, 0x0005), VR::CS, "ISO_IR 192");
  put(data, Tag(0x0008, 0x0016), VR::UI, kUltrasoundMultiFrame);
  put(data, Tag(0x0008, 0x0018), VR::UI, derivedUid(seed + "/instance"));
  put(data, Tag(0x0008, 0x001c), VR::CS, "YES");  // Synthetic Data
  putTimeOfWriting(data);
  put(data, Tag(0x0008, 0x0060), VR::CS, "US");
  put(data, Tag(0x0008, 0x0070), VR::LO, "Insonate");
  const std::string& description = clip.identity.description;
  put(data, Tag(0x0008, 0x103e), VR::LO,
      lineOf("SIMULATED ultrasound" + (description.empty() ? "" : ", " + description)));
  put(data, Tag(0x0008, 0x1090), VR::LO, "Insonate");
  put(data, Tag(0x0018, 0x1020), VR::LO, INSONATE_VERSION);
  put(data, Tag(0x0020, 0x000e), VR::UI, derivedUid(seed + "/series"));
  put(data, Tag(0x0020, 0x0011), VR::IS, "3");
  put(data, Tag(0x0020, 0x0013), VR::IS, "1");
  put(data, Tag(0x0020, 0x0020), VR::CS, "");
  put(data, Tag(0x0020, 0x0060), VR::CS, "");
}

/// Image and US image modules (PS3.3 C.8.5.6). Pixel Spacing is for viewers that do not read regions.
void putFrames(DataSet& data, const DicomClip& clip) {
  put(data, Tag(0x0008, 0x0008), VR::CS, "DERIVED\\SECONDARY");
  put(data, Tag(0x0008, 0x2111), VR::ST, "Simulated from a CT by Insonate; not acquired from a patient.");
  put(data, Tag(0x0028, 0x0004), VR::CS, clip.channels == 1 ? "MONOCHROME2" : "RGB");
  put(data, Tag(0x0028, 0x0030), VR::DS, decimalStrings({clip.region.pixel_mm, clip.region.pixel_mm}));
  put(data, Tag(0x0028, 0x0301), VR::CS, "NO");
  put(data, Tag(0x0028, 0x2110), VR::CS, "00");
  if (clip.channels == 3) putShorts(data, Tag(0x0028, 0x0006), {0});
  for (const auto& [element, value] :
       {std::pair<std::uint16_t, std::uint16_t>{0x0002, static_cast<std::uint16_t>(clip.channels)},
        {0x0010, static_cast<std::uint16_t>(clip.height)},
        {0x0011, static_cast<std::uint16_t>(clip.width)},
        {0x0014, 0},
        {0x0100, 8},
        {0x0101, 8},
        {0x0102, 7},
        {0x0103, 0}})
    putShorts(data, Tag(0x0028, element), {value});
}

/// Writes all elements but the pixels. The pixels are the last element, and are written frame by frame, since a clip
/// may be larger than the memory.
Result<void> writeHead(const DicomClip& clip, std::ostream& out) {
  static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");
  gdcm::Writer writer;
  DataSet& data = writer.GetFile().GetDataSet();
  putPatientAndStudy(data, clip.identity, uidsOf(clip.identity));
  putClipSeries(data, clip);
  putFrames(data, clip);
  putRegion(data, clip.region);
  if (auto ok = putTimes(data, clip); !ok) return ok;
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  writer.SetStream(out);
  if (!writer.Write() && out) return fail("The clip could not be encoded as DICOM.");
  const auto size = static_cast<std::uint32_t>(pixelsSize(clip) + pixelsSize(clip) % 2);
  out.write("\xe0\x7f\x10\x00OB\0\0", 8);
  out.write(reinterpret_cast<const char*>(&size), sizeof size);
  return {};
}

}  // namespace

Result<void> writeDicomClip(const DicomClip& clip, const fs::path& file,
                            const std::function<Result<void>(std::size_t, std::vector<std::uint8_t>&)>& draw,
                            const Progress& progress) {
  if (auto ok = checkClip(clip); !ok) return ok;
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  return writeAtomically(file, [&](const fs::path& beside) -> Result<void> {
    std::ofstream out(beside, std::ios::binary);
    if (auto ok = writeHead(clip, out); !ok) return ok;
    std::vector<std::uint8_t> pixels;
    for (std::size_t i = 0; i < clip.time_s.size() && out; ++i) {
      if (!report(progress, "writing DICOM", double(i) / double(clip.time_s.size())))
        return fail(std::string(kCancelled));
      if (auto drawn = draw(i, pixels); !drawn) return drawn;
      if (pixels.size() != frameSize(clip))
        return fail("Image " + std::to_string(i + 1) + " of the clip has another size than the others.");
      out.write(reinterpret_cast<const char*>(pixels.data()), static_cast<std::streamsize>(pixels.size()));
    }
    if (pixelsSize(clip) % 2 != 0) out.put('\0');
    out.close();
    if (out) return {};
    return fail("Could not write " + file.string() +
                ": the disk is full or the folder cannot be written. Free space or choose another folder.");
  });
}

}  // namespace insonate
