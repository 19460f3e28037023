#include "StructureFile.h"

#include "../import/DicomElements.h"
#include "../import/DicomFrames.h"
#include "../import/DicomLayout.h"

#include <gdcmReader.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace insonate {
namespace fs = std::filesystem;
namespace {

using gdcm::Tag;

const Tag kCharacterSet(0x0008, 0x0005), kRoiNumber(0x3006, 0x0084);

/// Names in the items of a sequence have the character set of the file.
std::string nameIn(gdcm::DataSet item, Tag tag, const gdcm::DataSet& file) {
  if (file.FindDataElement(kCharacterSet)) item.Replace(file.GetDataElement(kCharacterSet));
  return lineOf(item, tag);
}

std::optional<LabelColor> displayColorOf(const gdcm::DataSet& item) {
  const auto rgb = numbersOf(item, Tag(0x3006, 0x002a));
  if (rgb.size() != 3 || std::ranges::any_of(rgb, [](double c) { return c < 0 || c > 255; })) return std::nullopt;
  return LabelColor{static_cast<std::uint8_t>(rgb[0]), static_cast<std::uint8_t>(rgb[1]),
                    static_cast<std::uint8_t>(rgb[2])};
}

/// Appends a closed contour; returns why it cannot be read, or nothing.
std::string addContour(const gdcm::DataSet& item, DrawnStructure& structure) {
  const Tag data(0x3006, 0x0050), count(0x3006, 0x0046);
  const std::vector<double> numbers = numbersOf(item, data);
  if (numbers.empty() && !textOf(item, data).empty()) return "has a contour with coordinates that are not numbers";
  if (numbers.size() % 3 != 0) return "has a contour whose coordinates do not come in threes";
  const auto stated = integerOf(item, count);
  if (stated && static_cast<std::size_t>(std::max(*stated, 0)) != numbers.size() / 3)
    return "has a contour of " + std::to_string(numbers.size() / 3) + " points that should have " +
           std::to_string(*stated);
  constexpr double kFarthest_mm = 1e5;
  if (std::ranges::any_of(numbers, [](double c) { return std::abs(c) > kFarthest_mm; }))
    return "has a contour that lies more than 100 m away";
  if (numbers.size() < 9) {
    ++structure.withoutArea;
    return {};
  }
  ContourCorners corners;
  corners.reserve(numbers.size() / 3);
  for (std::size_t n = 0; n < numbers.size(); n += 3) corners.push_back({numbers[n], numbers[n + 1], numbers[n + 2]});
  structure.contours.push_back(std::move(corners));
  return {};
}

void addContours(const gdcm::DataSet& roi, DrawnStructure& structure) {
  structure.color = displayColorOf(roi);
  for (const gdcm::DataSet& item : itemsOf(roi, Tag(0x3006, 0x0040))) {
    const std::string type = upper(textOf(item, Tag(0x3006, 0x0042)));
    if (type != "CLOSED_PLANAR" && type != "CLOSEDPLANAR_XOR") {
      ++structure.otherContours;
      continue;
    }
    if (const std::string damage = addContour(item, structure); !damage.empty() && structure.damage.empty())
      structure.damage = damage;
  }
}

/// PS3.3 C.8.8.5: the series on whose images the structures were drawn.
std::set<std::string> referencedSeries(const gdcm::DataSet& data) {
  std::set<std::string> uids;
  for (const gdcm::DataSet& frame : itemsOf(data, Tag(0x3006, 0x0010)))
    for (const gdcm::DataSet& study : itemsOf(frame, Tag(0x3006, 0x0012)))
      for (const gdcm::DataSet& series : itemsOf(study, Tag(0x3006, 0x0014)))
        uids.insert(textOf(series, Tag(0x0020, 0x000e)));
  uids.erase("");
  return uids;
}

std::string classOf(const gdcm::Reader& reader) {
  std::string sopClass = textOf(reader.GetFile().GetDataSet(), Tag(0x0008, 0x0016));
  return sopClass.empty() ? textOf(reader.GetFile().GetHeader(), Tag(0x0002, 0x0002)) : sopClass;
}

bool isStructureSetClass(const gdcm::Reader& reader) {
  return classOf(reader) == "1.2.840.10008.5.1.4.1.1.481.3" ||
         upper(textOf(reader.GetFile().GetDataSet(), Tag(0x0008, 0x0060))) == "RTSTRUCT";
}

Result<StructureSet> readWholeFile(const fs::path& file) {
  if (layoutOf(file) != DicomLayout::kWhole)
    return fail(file.string() + " is not a complete DICOM file: it is cut off or damaged. Copy or export it again.");
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  if (!reader.Read()) return fail(file.string() + " could not be read as DICOM. Copy or export it again.");
  if (!isStructureSetClass(reader))
    return fail(file.string() + " is a DICOM file, but not an RT Structure Set. Choose the file with the structures.");
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();
  StructureSet set;
  std::map<int, std::size_t> byNumber;
  for (const gdcm::DataSet& item : itemsOf(data, Tag(0x3006, 0x0020))) {
    const auto number = integerOf(item, Tag(0x3006, 0x0022));
    if (!number) continue;
    DrawnStructure structure;
    structure.number = *number;
    structure.name = nameIn(item, Tag(0x3006, 0x0026), data);
    structure.algorithm = textOf(item, Tag(0x3006, 0x0036));
    if (byNumber.try_emplace(*number, set.structures.size()).second) set.structures.push_back(std::move(structure));
  }
  if (set.structures.empty()) return fail(file.string() + " contains no structures. Export the structure set again.");
  const auto structureOf = [&](const gdcm::DataSet& item) -> DrawnStructure* {
    const auto number = integerOf(item, kRoiNumber);
    const auto found = number ? byNumber.find(*number) : byNumber.end();
    return found == byNumber.end() ? nullptr : &set.structures[found->second];
  };
  for (const gdcm::DataSet& item : itemsOf(data, Tag(0x3006, 0x0039)))
    if (DrawnStructure* structure = structureOf(item)) addContours(item, *structure);
  for (const gdcm::DataSet& item : itemsOf(data, Tag(0x3006, 0x0080)))
    if (DrawnStructure* structure = structureOf(item)) structure->type = upper(textOf(item, Tag(0x3006, 0x00a4)));
  set.seriesUids = referencedSeries(data);
  return set;
}

void silenceGdcm() {
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
}

}  // namespace

Result<StructureSet> readStructureFile(const fs::path& file) {
  silenceGdcm();
  try {
    return readWholeFile(file);
  } catch (const std::exception&) {
    return fail(file.string() + " is damaged DICOM. Copy or export it again.");
  }
}

bool isStructureSet(const fs::path& file) {
  silenceGdcm();
  try {
    if (layoutOf(file) != DicomLayout::kWhole) return false;
    gdcm::Reader reader;
    reader.SetFileName(file.c_str());
    return reader.ReadUpToTag(Tag(0x0008, 0x0060)) && isStructureSetClass(reader);
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace insonate
