#include "DicomElements.h"
#include "DicomLayout.h"
#include "DicomSlice.h"

#include <gdcmReader.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string_view>
#include <utility>

namespace insonate {
namespace fs = std::filesystem;
namespace {

using gdcm::DataSet;
using gdcm::Tag;

constexpr std::string_view kStorage = "1.2.840.10008.5.1.4.1.1.";
const Tag kPixelData(0x7fe0, 0x0010);

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// Why an object that is no slice stays out; empty for slices.
std::string notASlice(const std::string& sopClass, const std::string& modality, const DataSet& data) {
  const auto storage = [&](std::string_view suffix) {
    const std::string full = std::string(kStorage) + std::string(suffix);
    return sopClass == full || sopClass.starts_with(full + ".");
  };
  if (sopClass == "1.2.840.10008.1.3.10") return "a DICOM directory: an index without pictures";
  if (storage("66") || modality == "SEG") return "a DICOM segmentation; only the CT is imported";
  if (storage("88") || modality == "SR") return "a structured report without pictures";
  if (storage("11") || modality == "PR") return "a presentation state without pictures";
  if (storage("481") || modality.starts_with("RT")) return "a radiotherapy object";
  if (storage("7")) return "a secondary capture (screenshot), not a slice";
  if (!data.FindDataElement(kPixelData))
    return modality == "CT" ? "DICOM that is a CT slice without pixel data" : "DICOM without pixel data";
  const std::string type = upper(textOf(data, Tag(0x0008, 0x0008)));
  for (const char* scout : {"LOCALIZER", "SCOUT", "TOPOGRAM"})
    if (type.find(scout) != std::string::npos) return "a scout (localizer), not a slice";
  if (modality == "CT" && shortOf(data, Tag(0x0028, 0x0002)).value_or(1) != 1)
    return "a colour picture, not a CT slice";
  return {};
}

void readPlane(const DataSet& plane, DicomSlice& slice) {
  if (const auto p = numbersOf(plane, Tag(0x0020, 0x0032)); p.size() == 3) slice.position_mm = Vec3{p[0], p[1], p[2]};
  if (const auto o = numbersOf(plane, Tag(0x0020, 0x0037)); o.size() == 6)
    slice.orientation = {Vec3{o[0], o[1], o[2]}, Vec3{o[3], o[4], o[5]}};
  if (const auto s = numbersOf(plane, Tag(0x0028, 0x0030)); s.size() == 2) slice.pixelSpacing_mm = {s[0], s[1]};
  if (const auto t = numberOf(plane, Tag(0x0018, 0x0050))) slice.thickness_mm = t;
  if (const auto s = numberOf(plane, Tag(0x0028, 0x1053))) slice.slope = s;
  if (const auto i = numberOf(plane, Tag(0x0028, 0x1052))) slice.intercept = i;
}

/// DICOM PS3.3 C.7.6.16: the same attributes as in a plain CT file, but inside functional groups.
void readFunctionalGroups(const DataSet& groups, DicomSlice& slice) {
  for (const Tag& tag : {Tag(0x0020, 0x9113), Tag(0x0020, 0x9116), Tag(0x0028, 0x9110), Tag(0x0028, 0x9145)})
    for (const DataSet& item : itemsOf(groups, tag)) readPlane(item, slice);
}

std::optional<std::array<int, 2>> paddingOf(const DataSet& data) {
  const auto first = shortOf(data, Tag(0x0028, 0x0120));
  if (!first) return std::nullopt;
  const bool isSigned = shortOf(data, Tag(0x0028, 0x0103)).value_or(0) == 1;
  const auto value = [&](unsigned raw) { return isSigned ? int(static_cast<std::int16_t>(raw)) : int(raw); };
  const int a = value(*first), b = value(shortOf(data, Tag(0x0028, 0x0121)).value_or(*first));
  return std::array{std::min(a, b), std::max(a, b)};
}

std::vector<DicomSlice> slicesOf(const fs::path& file, const std::string& modality, const DataSet& data) {
  DicomSlice slice;
  slice.file = file;
  slice.modality = modality;
  slice.studyUid = textOf(data, Tag(0x0020, 0x000d));
  slice.seriesUid = textOf(data, Tag(0x0020, 0x000e));
  slice.sopUid = textOf(data, Tag(0x0008, 0x0018));
  slice.frameOfReferenceUid = textOf(data, Tag(0x0020, 0x0052));
  slice.acquisition = integerOf(data, Tag(0x0020, 0x0012));
  slice.instance = integerOf(data, Tag(0x0020, 0x0013));
  slice.rows = static_cast<int>(shortOf(data, Tag(0x0028, 0x0010)).value_or(0));
  slice.columns = static_cast<int>(shortOf(data, Tag(0x0028, 0x0011)).value_or(0));
  slice.padding = paddingOf(data);
  slice.burnedInText = upper(textOf(data, Tag(0x0028, 0x0301))) == "YES";
  readPlane(data, slice);
  const auto frames = itemsOf(data, Tag(0x5200, 0x9230));
  if (frames.empty()) return {slice};
  for (const DataSet& shared : itemsOf(data, Tag(0x5200, 0x9229))) readFunctionalGroups(shared, slice);
  std::vector<DicomSlice> slices(frames.size(), slice);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    slices[f].frame = static_cast<int>(f);
    slices[f].instance = static_cast<int>(f) + 1;
    slices[f].sopUid += "/" + std::to_string(f);
    readFunctionalGroups(frames[f], slices[f]);
  }
  return slices;
}

bool namedLikeDicom(const fs::path& file) {
  const std::string extension = upper(file.extension().string());
  return extension == ".DCM" || extension == ".DICOM" || extension == ".IMA";
}

DicomScan scan(const fs::path& file) {
  const DicomLayout layout = layoutOf(file);
  if (layout == DicomLayout::kNotDicom)
    return {{}, namedLikeDicom(file) ? "named like DICOM, but it is none" : "neither DICOM nor a volume"};
  if (layout == DicomLayout::kCutInHeader) return {{}, "DICOM that is cut off or damaged in its header"};
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  std::set<Tag> skip;
  if (!reader.ReadUpToTag(kPixelData, skip)) return {{}, "DICOM that is cut off or damaged in its header"};
  const DataSet& data = reader.GetFile().GetDataSet();
  const std::string modality = textOf(data, Tag(0x0008, 0x0060));
  std::string sopClass = textOf(data, Tag(0x0008, 0x0016));
  if (sopClass.empty()) sopClass = textOf(reader.GetFile().GetHeader(), Tag(0x0002, 0x0002));
  if (auto reason = notASlice(sopClass, modality, data); !reason.empty()) return {{}, reason};
  DicomScan result{slicesOf(file, modality, data), {}};
  for (DicomSlice& slice : result.slices) slice.cutOff = layout == DicomLayout::kCutInPixels;
  return result;
}

}  // namespace

DicomScan scanDicom(const fs::path& file) {
  gdcm::Trace::DebugOff();
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  try {
    return scan(file);
  } catch (const std::exception&) {
    return {{}, "DICOM that is damaged"};
  }
}

}  // namespace insonate
