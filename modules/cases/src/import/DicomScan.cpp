#include "DicomElements.h"
#include "DicomFrames.h"
#include "DicomLayout.h"

#include <gdcmReader.h>
#include <gdcmTrace.h>

#include <array>
#include <fstream>
#include <set>
#include <string_view>

namespace insonate {
namespace fs = std::filesystem;
namespace {

using gdcm::DataSet;
using gdcm::Tag;

constexpr std::string_view kStorage = "1.2.840.10008.5.1.4.1.1.";
const Tag kPixelTag(0x7fe0, 0x0010);

/// Reason why an object that is not a slice is excluded; empty for slices.
std::string notASlice(const std::string& sopClass, const std::string& modality, const DataSet& data, bool hasPixels) {
  const auto storage = [&](std::string_view suffix) {
    const std::string full = std::string(kStorage) + std::string(suffix);
    return sopClass == full || sopClass.starts_with(full + ".");
  };
  if (storage("66") || modality == "SEG") return "a DICOM segmentation; only the CT is imported";
  if (storage("88") || modality == "SR") return "a structured report without images";
  if (storage("11") || modality == "PR") return "a presentation state without images";
  if (storage("481") || modality.starts_with("RT")) return "a radiotherapy object";
  if (storage("7")) return "a secondary capture (screenshot), not a slice";
  // GDCM terminates the program on some recognition codes.
  if (data.FindDataElement(Tag(0x0008, 0x0010))) return "an image in the ACR-NEMA format, which is older than DICOM";
  if (!hasPixels) return modality == "CT" ? "DICOM that is a CT slice without pixel data" : "DICOM without pixel data";
  const std::string type = upper(textOf(data, Tag(0x0008, 0x0008)));
  for (const char* scout : {"LOCALIZER", "SCOUT", "TOPOGRAM"})
    if (type.find(scout) != std::string::npos) return "a scout (localizer), not a slice";
  if (modality == "CT" && shortOf(data, Tag(0x0028, 0x0002)).value_or(1) != 1) return "a color image, not a CT slice";
  return {};
}

bool namedLikeDicom(const fs::path& file) {
  const std::string extension = upper(file.extension().string());
  return extension == ".DCM" || extension == ".DICOM" || extension == ".IMA";
}

/// Reason why a file that is not DICOM is excluded.
std::string notDicom(const fs::path& file) {
  std::array<char, 4> start{};
  std::ifstream(file, std::ios::binary).read(start.data(), start.size());
  const std::string_view bytes(start.data(), start.size());
  if (bytes == "PK\3\4") return "a ZIP archive; unpack it and import the folder";
  if (bytes.starts_with("\x1f\x8b")) return "compressed by gzip; unpack it and import the folder";
  return namedLikeDicom(file) ? "named like DICOM, but not a DICOM file" : "neither DICOM nor a volume";
}

/// Reason why a complete header could not be read.
std::string whyUnread(const gdcm::FileMetaInformation& header) {
  const std::string syntax = textOf(header, Tag(0x0002, 0x0010));
  if (!syntax.empty() && gdcm::TransferSyntax::GetTSType(syntax.c_str()) == gdcm::TransferSyntax::TS_END)
    return "DICOM with an encoding that Insonate cannot read (" + syntax + "); export it uncompressed";
  return "DICOM that is cut off or damaged in its header";
}

DicomScan scan(const fs::path& file) {
  const DicomLayout layout = layoutOf(file);
  if (layout == DicomLayout::kNotDicom) return {{}, notDicom(file)};
  if (layout == DicomLayout::kCutInHeader) return {{}, "DICOM that is cut off or damaged in its header"};
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  const bool cut = layout == DicomLayout::kCutInPixels;
  std::set<Tag> skip;
  // GDCM terminates the program if compressed pixels end early.
  if (cut) skip.insert(kPixelTag);
  if (!reader.ReadUpToTag(kPixelTag, skip)) return {{}, whyUnread(reader.GetFile().GetHeader())};
  const DataSet& data = reader.GetFile().GetDataSet();
  const std::string modality = textOf(data, Tag(0x0008, 0x0060));
  std::string sopClass = textOf(data, Tag(0x0008, 0x0016));
  if (sopClass.empty()) sopClass = textOf(reader.GetFile().GetHeader(), Tag(0x0002, 0x0002));
  if (sopClass == "1.2.840.10008.1.3.10")
    return {{}, "a DICOM directory, which is an index without images; the images are in the folders beside it", true};
  if (auto reason = notASlice(sopClass, modality, data, cut || data.FindDataElement(kPixelTag)); !reason.empty())
    return {{}, reason};
  DicomScan result{framesOf(file, data), {}, false};
  for (DicomSlice& slice : result.slices) slice.cutOff = cut;
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
