#include "SegReader.h"

#include "../files/LabelNames.h"
#include "../import/DicomElements.h"
#include "../import/DicomFrames.h"
#include "../import/DicomLayout.h"
#include "CieLab.h"

#include <gdcmByteValue.h>
#include <gdcmImageReader.h>
#include <gdcmReader.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

namespace insonate {
namespace fs = std::filesystem;
namespace {

using gdcm::DataSet;
using gdcm::Tag;

const Tag kPixelData(0x7fe0, 0x0010);

struct Segment {
  std::uint8_t label = 0;
  std::size_t order = 0;
};
using Segments = std::map<unsigned, Segment>;

std::string firstCode(const DataSet& data, Tag sequence, Tag part) {
  const auto items = itemsOf(data, sequence);
  return items.empty() ? std::string{} : textOf(items.front(), part);
}

/// By the code, then by the names that the file gives.
std::optional<Label> labelOf(const DataSet& item) {
  const Tag type(0x0062, 0x000f);
  if (firstCode(item, type, Tag(0x0008, 0x0102)) == "SCT")
    if (const auto known = labelFromSnomed(firstCode(item, type, Tag(0x0008, 0x0100)))) return known;
  for (const std::string& name : {textOf(item, Tag(0x0062, 0x0005)), firstCode(item, type, Tag(0x0008, 0x0104))})
    if (const auto known = labelFromAnyName(name)) return known;
  return std::nullopt;
}

std::optional<LabelColour> colourOf(const DataSet& item) {
  const Tag tag(0x0062, 0x000d);
  if (!item.FindDataElement(tag)) return std::nullopt;
  const gdcm::ByteValue* bytes = item.GetDataElement(tag).GetByteValue();
  DicomLab lab{};
  if (!bytes || bytes->GetLength() < sizeof lab) return std::nullopt;
  std::memcpy(lab.data(), bytes->GetPointer(), sizeof lab);
  return colourOfDicomLab(lab);
}

Segments segmentsOf(const DataSet& data, DicomSegments& result) {
  Segments segments;
  for (const DataSet& item : itemsOf(data, Tag(0x0062, 0x0002))) {
    const auto number = shortOf(item, Tag(0x0062, 0x0004));
    if (!number) continue;
    const auto known = labelOf(item);
    const std::string what =
        "The segment \"" + textOf(item, Tag(0x0062, 0x0005)) + "\" (number " + std::to_string(*number) + ")";
    result.notes.push_back(
        known ? what + " is read as " + labelName(*known) + " (" + std::to_string(*known) + ")."
              : what + " is no structure this program knows and is read as soft tissue; rename it to change that.");
    segments[*number] = {known.value_or(kSoftTissue), segments.size()};
    if (const auto colour = colourOf(item); colour && known && *colour != labelTable()[*known].colour)
      result.colours.try_emplace(*known, *colour);
  }
  return segments;
}

Result<void> readPixels(const fs::path& file, const DataSet& data, std::size_t count, DicomSegments& result) {
  const std::string cutOff = " holds fewer pixels than it says: it is cut off or damaged. Copy or export it again.";
  const unsigned bits = shortOf(data, Tag(0x0028, 0x0100)).value_or(0);
  const std::string type = upper(textOf(data, Tag(0x0062, 0x0001)));
  if (!(type == "BINARY" && bits == 1) && !(type == "FRACTIONAL" && bits == 8))
    return fail(file.string() + " is a segmentation of a kind that is not read here (" + type + ", " +
                std::to_string(bits) + " bits). Save it as a binary segmentation.");
  const std::size_t needed = bits == 1 ? (count + 7) / 8 : count;
  if (bits == 8) {
    const unsigned most = shortOf(data, Tag(0x0062, 0x000e)).value_or(255);
    result.threshold = static_cast<int>(std::clamp((most + 1) / 2, 1U, 255U));
    result.notes.push_back("The segments are fractions; voxels of which at least half belongs to a segment are in it.");
  }
  const gdcm::ByteValue* bytes =
      data.FindDataElement(kPixelData) ? data.GetDataElement(kPixelData).GetByteValue() : nullptr;
  if (bytes) {
    if (bytes->GetLength() < needed) return fail(file.string() + cutOff);
    result.pixels.assign(bytes->GetPointer(), bytes->GetPointer() + needed);
    return {};
  }
  if (bits == 1) return fail(file.string() + " is compressed in a way that is not read here. Save it uncompressed.");
  gdcm::ImageReader reader;
  reader.SetFileName(file.c_str());
  if (!reader.Read() || reader.GetImage().GetBufferLength() < needed) return fail(file.string() + cutOff);
  result.pixels.resize(reader.GetImage().GetBufferLength());
  if (!reader.GetImage().GetBuffer(reinterpret_cast<char*>(result.pixels.data()))) return fail(file.string() + cutOff);
  return {};
}

/// Which segment each frame is of; a frame that says nothing is of the only one.
std::vector<std::optional<unsigned>> segmentNumbers(const DataSet& data, std::size_t frames) {
  const auto numberIn = [](const DataSet& groups) -> std::optional<unsigned> {
    for (const DataSet& item : itemsOf(groups, Tag(0x0062, 0x000a))) return shortOf(item, Tag(0x0062, 0x000b));
    return std::nullopt;
  };
  std::optional<unsigned> shared;
  for (const DataSet& groups : itemsOf(data, Tag(0x5200, 0x9229))) shared = numberIn(groups);
  std::vector<std::optional<unsigned>> numbers(frames, shared);
  const auto perFrame = itemsOf(data, Tag(0x5200, 0x9230));
  for (std::size_t f = 0; f < std::min(frames, perFrame.size()); ++f)
    if (const auto number = numberIn(perFrame[f])) numbers[f] = number;
  return numbers;
}

/// Distance of neighbouring slices: what the file says, else the smallest one between its frames.
double stepOf(const DataSet& data, const DicomSlice& first, const std::vector<DicomSegments::Frame>& frames,
              Vec3 normal) {
  for (const DataSet& groups : itemsOf(data, Tag(0x5200, 0x9229)))
    for (const DataSet& measures : itemsOf(groups, Tag(0x0028, 0x9110)))
      if (const auto step = numberOf(measures, Tag(0x0018, 0x0088)); step && std::abs(*step) > 0)
        return std::abs(*step);
  std::set<double> places;
  for (const auto& frame : frames) places.insert(dot(frame.position_mm, normal));
  double smallest = 0;
  for (auto at = places.begin(); at != places.end() && std::next(at) != places.end(); ++at) {
    const double distance = *std::next(at) - *at;
    if (distance > 0.01 && (smallest == 0 || distance < smallest)) smallest = distance;
  }
  return smallest > 0 ? smallest : first.thickness_mm.value_or(1);
}

Result<void> readFrames(const fs::path& file, const DataSet& data, DicomSegments& result) {
  const std::vector<DicomSlice> slices = framesOf(file, data);
  const DicomSlice& first = slices.front();
  const int announced = integerOf(data, Tag(0x0028, 0x0008)).value_or(1);
  if (announced != static_cast<int>(slices.size()) || first.columns < 1 || first.rows < 1)
    return fail(file.string() + " does not say for each of its " + std::to_string(announced) +
                " frames where it lies.");
  Segments segments = segmentsOf(data, result);
  const auto numbers = segmentNumbers(data, slices.size());
  const std::size_t area = static_cast<std::size_t>(first.columns) * first.rows;
  std::vector<std::size_t> order;
  for (std::size_t f = 0; f < slices.size(); ++f) {
    const DicomSlice& s = slices[f];
    if (!s.position_mm || !s.orientation || !s.pixelSpacing_mm)
      return fail(file.string() + " does not say where its frame " + std::to_string(f + 1) + " lies in the patient.");
    const auto segment = numbers[f]             ? segments.find(*numbers[f])
                         : segments.size() == 1 ? segments.begin()
                                                : segments.end();
    if (segment == segments.end())
      return fail(file.string() + " does not describe the segment of its frame " + std::to_string(f + 1) + ".");
    constexpr double kSame = 1e-3;
    for (int axis = 0; axis < 2; ++axis)
      if (norm((*s.orientation)[axis] - (*first.orientation)[axis]) > kSame ||
          std::abs((*s.pixelSpacing_mm)[axis] - (*first.pixelSpacing_mm)[axis]) > kSame)
        return fail(file.string() +
                    " has frames in several orientations or pixel sizes. Save one segmentation for each.");
    result.frames.push_back({*s.position_mm, segment->second.label, f * area});
    order.push_back(segment->second.order);
  }
  result.columns = first.columns;
  result.rows = first.rows;
  result.spacing_mm = {(*first.pixelSpacing_mm)[1], (*first.pixelSpacing_mm)[0]};
  const auto [i, j] = *first.orientation;
  if (!(std::abs(norm(i) - 1) < 0.01 && std::abs(norm(j) - 1) < 0.01 && std::abs(dot(i, j)) < 0.01))
    return fail(file.string() + " has rows and columns that are no unit vectors at right angles.");
  result.direction = {normalized(i), normalized(j - dot(i, j) * i)};
  result.step_mm = stepOf(data, first, result.frames, cross(result.direction[0], result.direction[1]));
  if (auto ok = checkVoxelSize({result.spacing_mm[0], result.spacing_mm[1], result.step_mm}); !ok)
    return fail(file.string() + ": " + ok.error().message);
  std::ranges::stable_sort(result.frames, {}, [&](const DicomSegments::Frame& f) { return order[f.first / area]; });
  return readPixels(file, data, area * slices.size(), result);
}

std::string sopClassOf(const gdcm::Reader& reader) {
  return textOf(reader.GetFile().GetDataSet(), Tag(0x0008, 0x0016));
}

constexpr const char* kSegmentation = "1.2.840.10008.5.1.4.1.1.66.4";

Result<DicomSegments> read(const fs::path& file) {
  if (layoutOf(file) != DicomLayout::kWhole)
    return fail(file.string() + " is no whole DICOM file: it is cut off or damaged. Copy or export it again.");
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  if (!reader.Read()) return fail(file.string() + " could not be read as DICOM. Copy or export it again.");
  const DataSet& data = reader.GetFile().GetDataSet();
  if (sopClassOf(reader) != kSegmentation)
    return fail(file.string() + " is DICOM, but no segmentation of voxels. Choose the file of the segmentation.");
  DicomSegments result;
  if (auto ok = readFrames(file, data, result); !ok) return tl::unexpected(ok.error());
  result.seriesUid = firstCode(data, Tag(0x0008, 0x1115), Tag(0x0020, 0x000e));
  return result;
}

}  // namespace

bool isDicomSegmentation(const fs::path& file) {
  const DicomLayout layout = layoutOf(file);
  if (layout == DicomLayout::kNotDicom || layout == DicomLayout::kCutInHeader) return false;
  try {
    gdcm::Reader reader;
    reader.SetFileName(file.c_str());
    const std::set<Tag> skip;
    return reader.ReadUpToTag(Tag(0x0008, 0x0018), skip) && sopClassOf(reader) == kSegmentation;
  } catch (const std::exception&) {
    return false;
  }
}

Result<DicomSegments> readDicomSegments(const fs::path& file) {
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  try {
    return read(file);
  } catch (const std::exception&) {
    return fail(file.string() + " is damaged DICOM. Copy or export it again.");
  }
}

}  // namespace insonate
