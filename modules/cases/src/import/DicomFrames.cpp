#include "DicomFrames.h"

#include "DicomElements.h"

#include <algorithm>
#include <cctype>
#include <cstdint>

namespace insonate {
namespace {

using gdcm::DataSet;
using gdcm::Tag;

void readPlane(const DataSet& plane, DicomSlice& slice) {
  if (const auto p = numbersOf(plane, Tag(0x0020, 0x0032)); p.size() == 3) slice.position_mm = Vec3{p[0], p[1], p[2]};
  if (const auto o = numbersOf(plane, Tag(0x0020, 0x0037)); o.size() == 6)
    slice.orientation = {Vec3{o[0], o[1], o[2]}, Vec3{o[3], o[4], o[5]}};
  if (const auto s = numbersOf(plane, Tag(0x0028, 0x0030)); s.size() == 2) slice.pixelSpacing_mm = {s[0], s[1]};
  if (const auto t = numberOf(plane, Tag(0x0018, 0x0050))) slice.thickness_mm = t;
  if (const auto s = numberOf(plane, Tag(0x0028, 0x1053))) slice.slope = s;
  if (const auto i = numberOf(plane, Tag(0x0028, 0x1052))) slice.intercept = i;
  if (std::string k = textOf(plane, Tag(0x0018, 0x1210)); !k.empty()) slice.kernel = std::move(k);
}

/// DICOM PS3.3 C.7.6.16: the attributes of a plain CT file, in functional groups.
void readFunctionalGroups(const DataSet& groups, DicomSlice& slice) {
  for (const Tag& tag :
       {Tag(0x0020, 0x9113), Tag(0x0020, 0x9116), Tag(0x0028, 0x9110), Tag(0x0028, 0x9145), Tag(0x0018, 0x9314)})
    for (const DataSet& item : itemsOf(groups, tag)) readPlane(item, slice);
}

/// The day of a series, "2026-11-24"; the study's day if it has none.
std::string dateOf(const DataSet& data) {
  for (const Tag& tag : {Tag(0x0008, 0x0021), Tag(0x0008, 0x0020)})
    if (const std::string day = textOf(data, tag);
        day.size() == 8 && std::ranges::all_of(day, [](unsigned char c) { return std::isdigit(c) != 0; }))
      return day.substr(0, 4) + "-" + day.substr(4, 2) + "-" + day.substr(6);
  return {};
}

std::optional<std::array<int, 2>> paddingOf(const DataSet& data) {
  const auto first = shortOf(data, Tag(0x0028, 0x0120));
  if (!first) return std::nullopt;
  const bool isSigned = shortOf(data, Tag(0x0028, 0x0103)).value_or(0) == 1;
  const auto value = [&](unsigned raw) { return isSigned ? int(static_cast<std::int16_t>(raw)) : int(raw); };
  const int a = value(*first), b = value(shortOf(data, Tag(0x0028, 0x0121)).value_or(*first));
  return std::array{std::min(a, b), std::max(a, b)};
}

}  // namespace

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::vector<DicomSlice> framesOf(const std::filesystem::path& file, const DataSet& data) {
  DicomSlice slice;
  slice.file = file;
  slice.modality = textOf(data, Tag(0x0008, 0x0060));
  slice.studyUid = textOf(data, Tag(0x0020, 0x000d));
  slice.seriesUid = textOf(data, Tag(0x0020, 0x000e));
  slice.sopUid = textOf(data, Tag(0x0008, 0x0018));
  slice.frameOfReferenceUid = textOf(data, Tag(0x0020, 0x0052));
  slice.acquisition = integerOf(data, Tag(0x0020, 0x0012));
  slice.instance = integerOf(data, Tag(0x0020, 0x0013));
  slice.rows = static_cast<int>(shortOf(data, Tag(0x0028, 0x0010)).value_or(0));
  slice.columns = static_cast<int>(shortOf(data, Tag(0x0028, 0x0011)).value_or(0));
  slice.padding = paddingOf(data);
  slice.description = lineOf(data, Tag(0x0008, 0x103e));
  slice.bodyPart = lineOf(data, Tag(0x0018, 0x0015));
  slice.date = dateOf(data);
  slice.burnedInText = upper(textOf(data, Tag(0x0028, 0x0301))) == "YES";
  slice.lossy = textOf(data, Tag(0x0028, 0x2110)) == "01";
  const std::string unit = upper(textOf(data, Tag(0x0028, 0x1054)));
  slice.otherUnit = !unit.empty() && unit != "HU";
  slice.lookupTable = !itemsOf(data, Tag(0x0028, 0x3000)).empty();
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

}  // namespace insonate
