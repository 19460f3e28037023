#include "SegReader.h"

#include "../files/LabelNames.h"
#include "../files/OwnNumbers.h"
#include "../import/DicomElements.h"
#include "../import/DicomFrames.h"
#include "../import/DicomLayout.h"
#include "../import/DicomPicture.h"
#include "CieLab.h"

#include <gdcmByteValue.h>
#include <gdcmReader.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <set>

namespace insonate {
namespace fs = std::filesystem;
namespace {

using gdcm::DataSet;
using gdcm::Tag;

const Tag kPixelData(0x7fe0, 0x0010), kLabel(0x0062, 0x0005), kType(0x0062, 0x000f);

struct DicomSegment {
  std::uint8_t part = 0;  ///< 0 for a segment that is not read
  std::size_t order = 0;
};
using Segments = std::map<unsigned, DicomSegment>;

std::string firstCode(const DataSet& data, Tag sequence, Tag part) {
  const auto items = itemsOf(data, sequence);
  return items.empty() ? std::string{} : textOf(items.front(), part);
}

std::optional<Label> labelOfCode(const DataSet& item) {
  const bool snomed = firstCode(item, kType, Tag(0x0008, 0x0102)) == "SCT";
  return snomed ? labelFromSnomed(firstCode(item, kType, Tag(0x0008, 0x0100))) : std::nullopt;
}

/// Finds a label by the code, then by the names in the file.
std::optional<Label> labelOf(const DataSet& item) {
  if (const auto known = labelOfCode(item)) return known;
  for (const std::string& name : {textOf(item, kLabel), firstCode(item, kType, Tag(0x0008, 0x0104))})
    if (const auto known = labelFromAnyName(name)) return known;
  return std::nullopt;
}

/// Tells whether a segment of a label map describes the pixels outside all segments.
bool isBackground(const DataSet& item) {
  return firstCode(item, kType, Tag(0x0008, 0x0102)) == "DCM" &&
         firstCode(item, kType, Tag(0x0008, 0x0100)) == "125040";
}

struct Given {
  std::uint8_t label = 0;
  std::optional<OwnLabel> own;
};

/// Label that this program wrote for a structure outside the label table: the author's name, the code of its tissue,
/// and the number if there is no name. Empty for known structures and for files of other programs.
std::optional<Given> givenHere(const DataSet& item, OwnNumbers& numbers) {
  if (textOf(item, Tag(0x0062, 0x0009)) != kAlgorithm) return std::nullopt;
  const std::string name = tidyLabelName(textOf(item, kLabel));
  if (labelFromName(name)) return std::nullopt;
  int number = 0;
  std::sscanf(name.c_str(), "label %d", &number);
  Given given{numbers.take(number), std::nullopt};
  const bool named = name != labelName(given.label);
  const auto tissue = labelOfCode(item);
  if (isOwnLabel(given.label) && (named || tissue)) given.own = {named ? name : "", tissue.value_or(kSoftTissue)};
  return given;
}

std::optional<LabelColor> colorOf(const DataSet& item) {
  const Tag tag(0x0062, 0x000d);
  if (!item.FindDataElement(tag)) return std::nullopt;
  const gdcm::ByteValue* bytes = item.GetDataElement(tag).GetByteValue();
  DicomLab lab{};
  if (!bytes || bytes->GetLength() < sizeof lab) return std::nullopt;
  std::memcpy(lab.data(), bytes->GetPointer(), sizeof lab);
  return colorOfDicomLab(lab);
}

void giveLabel(const DataSet& item, unsigned number, OwnNumbers& numbers, DicomSegments& result) {
  const std::string what = "The segment \"" + textOf(item, kLabel) + "\" (number " + std::to_string(number) + ")";
  std::uint8_t label = kSoftTissue;
  bool known = true;
  if (auto given = givenHere(item, numbers)) {
    label = given->label;
    if (given->own) result.own[label] = std::move(*given->own);
  } else if (const auto found = labelOf(item)) {
    label = *found;
  } else {
    label = numbers.take(0);
    known = isOwnLabel(label);
    if (known) result.own[label] = {tidyLabelName(textOf(item, kLabel)), kSoftTissue}, result.foreign.insert(label);
    result.notes.push_back(unknownStructure(what, label));
  }
  if (!result.foreign.contains(label) && known)
    result.notes.push_back(what + " is read as " + labelName(label) + " (" + std::to_string(label) + ").");
  if (const auto color = colorOf(item); color && known && !isUsualColor(label, *color))
    result.colors.try_emplace(label, *color);
  const bool isSnomed = firstCode(item, kType, Tag(0x0008, 0x0102)) == "SCT";
  result.structures.push_back(
      {static_cast<std::int32_t>(number), textOf(item, kLabel), label,
       knownStructure(textOf(item, kLabel), isSnomed ? firstCode(item, kType, Tag(0x0008, 0x0100)) : std::string())});
}

Segments segmentsOf(const DataSet& data, const StructureChoices& choices, DicomSegments& result) {
  Segments segments;
  OwnNumbers numbers;
  for (const DataSet& item : itemsOf(data, Tag(0x0062, 0x0002))) {
    const auto number = shortOf(item, Tag(0x0062, 0x0004));
    if (!number) continue;
    if (isBackground(item)) {
      segments[*number] = {};
      continue;
    }
    const std::size_t order = segments.size();
    giveLabel(item, *number, numbers, result);
    ReadStructure& structure = result.structures.back();
    if (!isTaken(structure, choices, true)) structure.state = StructureState::kLeftOut;
    const bool isRead = structure.state != StructureState::kLeftOut;
    segments[*number] = {isRead ? static_cast<std::uint8_t>(result.structures.size()) : std::uint8_t{0}, order};
  }
  return segments;
}

/// The bytes of all pixels, decompressed if necessary.
Result<std::vector<std::uint8_t>> pixelBytes(const fs::path& file, const gdcm::File& dicom, unsigned bits,
                                             const DicomSegments& segments) {
  const std::string cutOff = " holds fewer pixels than it says: it is cut off or damaged. Copy or export it again.";
  const DataSet& data = dicom.GetDataSet();
  if (!data.FindDataElement(kPixelData)) return fail(file.string() + cutOff);
  const std::size_t count = static_cast<std::size_t>(segments.columns) * segments.rows * segments.frames.size();
  if (bits == 1) {
    const gdcm::ByteValue* bytes = data.GetDataElement(kPixelData).GetByteValue();
    if (!bytes)
      return fail(file.string() + " is compressed with a method that Insonate cannot read. Save it uncompressed.");
    const std::size_t needed = (count + 7) / 8;
    if (bytes->GetLength() < needed) return fail(file.string() + cutOff);
    return std::vector<std::uint8_t>(bytes->GetPointer(), bytes->GetPointer() + needed);
  }
  const auto width = static_cast<unsigned short>(bits);
  const auto pixels = storedPixels(dicom,
                                   {static_cast<unsigned>(segments.columns), static_cast<unsigned>(segments.rows),
                                    static_cast<unsigned>(segments.frames.size())},
                                   gdcm::PixelFormat(1, width, width, static_cast<unsigned short>(width - 1), 0));
  if (!pixels) return fail(file.string() + cutOff);
  return std::vector<std::uint8_t>(pixels->begin(), pixels->end());
}

/// The pixels of a label map are numbers of segments (PS3.3 C.8.20.2.3.3), and 0 or the padding value outside of them.
void numbersToParts(const std::vector<std::uint8_t>& bytes, unsigned bits, const Segments& segments,
                    std::optional<unsigned> padding, DicomSegments& result) {
  std::set<unsigned> unknown;
  const std::size_t width = bits / 8;
  result.pixels.resize(bytes.size() / width);
  for (std::size_t p = 0; p < result.pixels.size(); ++p) {
    const unsigned number = width == 1 ? bytes[p] : bytes[2 * p] | unsigned{bytes[2 * p + 1]} << 8;
    if (number == padding) continue;
    if (const auto segment = segments.find(number); segment != segments.end())
      result.pixels[p] = segment->second.part;
    else if (number != 0)
      unknown.insert(number);
  }
  for (const unsigned number : unknown)
    result.notes.push_back("The number " + std::to_string(number) +
                           " in the file belongs to no segment and was ignored.");
}

Result<void> readPixels(const fs::path& file, const gdcm::File& dicom, const Segments& segments,
                        DicomSegments& result) {
  const DataSet& data = dicom.GetDataSet();
  const unsigned bits = shortOf(data, Tag(0x0028, 0x0100)).value_or(0);
  const std::string type = upper(textOf(data, Tag(0x0062, 0x0001)));
  if (!(type == "BINARY" && bits == 1) && !(type == "FRACTIONAL" && bits == 8) &&
      !(result.isLabelMap && (bits == 8 || bits == 16)))
    return fail(file.string() + " is a segmentation of a kind that Insonate cannot read (" + type + ", " +
                std::to_string(bits) + " bits). Save it as a binary segmentation.");
  auto bytes = pixelBytes(file, dicom, bits, result);
  if (!bytes) return tl::unexpected(bytes.error());
  if (result.isLabelMap) {
    numbersToParts(*bytes, bits, segments, shortOf(data, Tag(0x0028, 0x0120)), result);
    return {};
  }
  result.pixels = std::move(*bytes);
  if (bits == 8) {
    const unsigned most = shortOf(data, Tag(0x0062, 0x000e)).value_or(255);
    result.threshold = static_cast<int>(std::clamp((most + 1) / 2, 1U, 255U));
    result.notes.push_back(
        "The segments contain fractions. A voxel belongs to a segment if its fraction is at least one half.");
  }
  return {};
}

/// Segment number of each frame.
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

/// Distance of neighboring slices: as stated in the file, else their thickness, unless frames are closer.
double stepOf(const DataSet& data, const DicomSlice& first, const std::vector<DicomSegments::Frame>& frames,
              Vec3 normal) {
  std::optional<double> step = first.thickness_mm;
  for (const DataSet& groups : itemsOf(data, Tag(0x5200, 0x9229)))
    for (const DataSet& measures : itemsOf(groups, Tag(0x0028, 0x9110)))
      if (const auto between = numberOf(measures, Tag(0x0018, 0x0088)); between && *between != 0) step = between;
  const double said = step && *step != 0 ? std::abs(*step) : std::numeric_limits<double>::max();
  std::set<double> places;
  for (const auto& frame : frames) places.insert(dot(frame.position_mm, normal));
  double smallest = said;
  for (auto at = places.begin(); at != places.end() && std::next(at) != places.end(); ++at)
    // Frames of several segments lie at the same place except for rounding.
    if (const double distance = *std::next(at) - *at; distance > std::min(0.01, 0.1 * said))
      smallest = std::min(smallest, distance);
  return smallest < std::numeric_limits<double>::max() ? smallest : 1;
}

/// Segment of each frame; none for frames of a label map. A frame without a segment belongs to the only one.
Result<std::vector<DicomSegment>> frameSegments(const fs::path& file, const DataSet& data, std::size_t frames,
                                                const Segments& segments, bool isLabelMap) {
  std::vector<DicomSegment> all(frames);
  if (isLabelMap) return all;
  const auto numbers = segmentNumbers(data, frames);
  for (std::size_t f = 0; f < frames; ++f) {
    const auto segment = numbers[f]             ? segments.find(*numbers[f])
                         : segments.size() == 1 ? segments.begin()
                                                : segments.end();
    if (segment == segments.end())
      return fail(file.string() + " does not describe the segment of its frame " + std::to_string(f + 1) + ".");
    all[f] = segment->second;
  }
  return all;
}

Result<void> readFrames(const fs::path& file, const gdcm::File& dicom, const StructureChoices& choices,
                        DicomSegments& result) {
  const DataSet& data = dicom.GetDataSet();
  const std::vector<DicomSlice> slices = framesOf(file, data);
  const DicomSlice& first = slices.front();
  const int announced = integerOf(data, Tag(0x0028, 0x0008)).value_or(1);
  if (announced != static_cast<int>(slices.size()) || first.columns < 1 || first.rows < 1)
    return fail(file.string() + " does not say for each of its " + std::to_string(announced) +
                " frames where it lies.");
  result.isLabelMap = upper(textOf(data, Tag(0x0062, 0x0001))) == "LABELMAP";
  const Segments segments = segmentsOf(data, choices, result);
  if (result.structures.size() > 255)
    return fail(file.string() + " has " + std::to_string(result.structures.size()) +
                " segments; Insonate can read 255. Save the needed segments separately.");
  const auto ofFrame = frameSegments(file, data, slices.size(), segments, result.isLabelMap);
  if (!ofFrame) return tl::unexpected(ofFrame.error());
  const std::size_t area = static_cast<std::size_t>(first.columns) * first.rows;
  for (std::size_t f = 0; f < slices.size(); ++f) {
    const DicomSlice& s = slices[f];
    if (!s.position_mm || !s.orientation || !s.pixelSpacing_mm)
      return fail(file.string() + " does not say where its frame " + std::to_string(f + 1) + " lies in the patient.");
    constexpr double kSame = 1e-3;
    for (int axis = 0; axis < 2; ++axis)
      if (norm((*s.orientation)[axis] - (*first.orientation)[axis]) > kSame ||
          std::abs((*s.pixelSpacing_mm)[axis] - (*first.pixelSpacing_mm)[axis]) > kSame)
        return fail(file.string() +
                    " has frames in several orientations or pixel sizes. Save one segmentation for each.");
    result.frames.push_back({*s.position_mm, (*ofFrame)[f].part, f * area});
  }
  result.columns = first.columns;
  result.rows = first.rows;
  result.spacing_mm = {(*first.pixelSpacing_mm)[1], (*first.pixelSpacing_mm)[0]};
  const auto [i, j] = *first.orientation;
  if (!(std::abs(norm(i) - 1) < 0.01 && std::abs(norm(j) - 1) < 0.01 && std::abs(dot(i, j)) < 0.01))
    return fail(file.string() +
                " has directions of rows and columns that are not unit vectors at right angles. Export it again.");
  result.direction = {normalized(i), normalized(j - dot(i, j) * i)};
  result.step_mm = stepOf(data, first, result.frames, cross(result.direction[0], result.direction[1]));
  if (auto ok = checkVoxelSize({result.spacing_mm[0], result.spacing_mm[1], result.step_mm}); !ok)
    return fail(file.string() + ": " + ok.error().message);
  std::ranges::stable_sort(result.frames, {},
                           [&](const DicomSegments::Frame& f) { return (*ofFrame)[f.first / area].order; });
  if (auto ok = readPixels(file, dicom, segments, result); !ok) return ok;
  if (!result.isLabelMap) std::erase_if(result.frames, [](const DicomSegments::Frame& f) { return f.part == 0; });
  if (result.frames.empty()) return fail(file.string() + ": no segment of it is read. Choose at least one.");
  return {};
}

/// Accepts segmentations, label maps included (PS3.6 A).
bool isSegmentation(const gdcm::Reader& reader) {
  const std::string sopClass = textOf(reader.GetFile().GetDataSet(), Tag(0x0008, 0x0016));
  return sopClass == "1.2.840.10008.5.1.4.1.1.66.4" || sopClass == "1.2.840.10008.5.1.4.1.1.66.7";
}

Result<DicomSegments> read(const fs::path& file, const StructureChoices& choices) {
  if (layoutOf(file) != DicomLayout::kWhole)
    return fail(file.string() + " is not a complete DICOM file: it is cut off or damaged. Copy or export it again.");
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  if (!reader.Read()) return fail(file.string() + " could not be read as DICOM. Copy or export it again.");
  if (!isSegmentation(reader))
    return fail(file.string() + " is a DICOM file, but not a segmentation. Choose the file of the segmentation.");
  DicomSegments result;
  if (auto ok = readFrames(file, reader.GetFile(), choices, result); !ok) return tl::unexpected(ok.error());
  result.seriesUid = firstCode(reader.GetFile().GetDataSet(), Tag(0x0008, 0x1115), Tag(0x0020, 0x000e));
  return result;
}

}  // namespace

Result<DicomSegments> readDicomSegments(const fs::path& file, const StructureChoices& choices) {
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  try {
    return read(file, choices);
  } catch (const std::exception&) {
    return fail(file.string() + " is damaged DICOM. Copy or export it again.");
  }
}

}  // namespace insonate
