#include "../dicomseg/SegReader.h"
#include "../import/DerivedUid.h"
#include "../import/DicomLayout.h"
#include "LabelGrid.h"
#include "LabelNames.h"
#include "NumberNames.h"
#include "OwnNumbers.h"
#include "SlicerSegmentation.h"
#include "VolumeFile.h"

#include <insonate/cases/LabelFile.h>
#include <insonate/cases/StructureSet.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace insonate {
namespace fs = std::filesystem;
namespace {

/// "a.b" of "a.b.nii.gz" and of "a.b.seg.nrrd".
fs::path withoutEndings(const fs::path& file) {
  fs::path name = file;
  for (const char* ending : {".gz", ".nii", ".nrrd", ".nhdr", ".mha", ".mhd", ".seg"})
    if (name.extension() == ending) name.replace_extension();
  return name;
}

/// Also recognizes the names that this program gives to unknown numbers.
std::optional<std::uint8_t> meaningOf(const NumberName& described) {
  if (const auto known = labelFromSnomed(described.snomedCode)) return *known;
  if (const auto known = labelFromAnyName(described.name)) return *known;
  for (int number = kLabelCount; number < 256; ++number)
    if (described.name == labelName(static_cast<std::uint8_t>(number))) return static_cast<std::uint8_t>(number);
  return std::nullopt;
}

std::uint8_t labelFor(std::int32_t value, const NumberName& described, OwnNumbers& numbers, LabelReadResult& result) {
  std::optional<std::uint8_t> label = meaningOf(described);
  if (!label) {
    label = numbers.take(value);
    result.notes.push_back(
        unknownStructure("The label \"" + described.name + "\" (number " + std::to_string(value) + ")", *label));
    if (!isOwnLabel(*label)) return *label;
    result.own[*label] = {tidyLabelName(described.name), kSoftTissue};
    result.foreign.insert(*label);
  }
  if (described.color && *described.color != caseLabelColor({}, *label))
    result.colors.try_emplace(*label, *described.color);
  return *label;
}

Result<LabelReadResult> mapByNames(const fs::path& file, const NumberNames& names, const std::string& source) {
  const auto values = readLabelValues(file);
  if (!values) return tl::unexpected(values.error());
  LabelReadResult result{LabelMap(values->geometry), {}};
  result.notes.push_back("The meaning of the numbers was taken from " + source + ".");
  OwnNumbers numbers;
  for (const auto& [value, described] : names)
    if (const auto meaning = meaningOf(described)) numbers.keep(*meaning);
  std::map<std::int32_t, std::uint8_t> meanings;
  std::set<std::int32_t> undescribed;
  for (std::size_t v = 0; v < values->voxels.size(); ++v) {
    const std::int32_t value = values->voxels[v];
    if (value == 0) continue;
    const auto found = names.find(value);
    if (found == names.end()) {
      undescribed.insert(value);
      continue;
    }
    const auto [meaning, isNew] = meanings.try_emplace(value);
    if (isNew) {
      meaning->second = labelFor(value, found->second, numbers, result);
      result.structures.push_back({value, found->second.name, meaning->second});
    }
    result.labels.voxels[v] = meaning->second;
  }
  std::ranges::sort(result.structures, {}, &ReadStructure::number);
  for (const std::int32_t value : undescribed)
    result.notes.push_back("The number " + std::to_string(value) + " is not described and was ignored.");
  return result;
}

std::string numbersOf(const std::vector<ReadStructure>& structures) {
  constexpr std::size_t kListed = 6;
  std::string text;
  for (std::size_t n = 0; n < std::min(kListed, structures.size()); ++n)
    text += (n > 0 ? ", " : "") + std::to_string(structures[n].number);
  return structures.size() <= kListed ? text : text + " and " + std::to_string(structures.size() - kListed) + " more";
}

/// 1 is the skin here, the spleen for TotalSegmentator, and whatever was drawn first in many other programs.
Result<LabelReadResult> readUnnamed(const fs::path& file, bool areProgramLabels) {
  auto result = readLabelMap(file);
  if (result && result->isUnnamed && !areProgramLabels)
    return fail(file.string() + " does not say what its numbers (" + numbersOf(result->structures) +
                ") mean. Name them with --names FILE, or state with --ours that they are Insonate's label numbers.");
  return result;
}

/// A segmentation states the meaning of its numbers.
Result<LabelReadResult> readNamed(const fs::path& file, const NumberMeaning& meaning) {
  const auto header = readVolumeFile(file, ReadPart::kHeader);
  if (!header) return tl::unexpected(header.error());
  const fs::path beside = withoutEndings(file).string() + ".label.txt";
  std::error_code error;
  const bool isSegmentation = isSlicerSegmentation(header->metadata);
  const fs::path described = !meaning.names.empty()                         ? meaning.names
                             : !isSegmentation && fs::exists(beside, error) ? beside
                                                                            : fs::path();
  if (!described.empty()) {
    const auto names = readNumberNames(described);
    if (!names) return tl::unexpected(names.error());
    return mapByNames(file, *names, described.filename().string());
  }
  if (isSegmentation) return readLabelMap(file);
  if (const NumberNames names = namesInExtension(header->extension); !names.empty())
    return mapByNames(file, names, "the file's header");
  return readUnnamed(file, meaning.areProgramLabels);
}

/// A case contains no identity of the patient.
void forgetForeignNames(LabelReadResult& read) {
  for (const std::uint8_t label : read.foreign) read.own[label].name.clear();
}

tl::unexpected<Error> inFile(const fs::path& file, const Error& error) {
  return fail(error.message == kCancelled ? error.message : file.string() + ": " + error.message);
}

Result<LabelReadResult> fromDicom(const PatientCase& patient, const fs::path& file, const Progress& progress) {
  const auto segments = readDicomSegments(file);
  if (!segments) return tl::unexpected(segments.error());
  auto placed = placeSegments(*segments, patient.ct.geometry, progress);
  if (!placed) return inFile(file, placed.error());
  const std::string& source = patient.manifest.source;
  const bool knowsItsSeries = source.find("UID was replaced by 2.25.") != std::string::npos;
  if (knowsItsSeries && !segments->seriesUid.empty() &&
      source.find(derivedUid(segments->seriesUid)) == std::string::npos)
    placed->notes.push_back(
        "The segmentation was made for another DICOM series than the one from which this case was imported. Check that "
        "the labels fit the CT.");
  return placed;
}

}  // namespace

Result<LabelReadResult> importLabels(const PatientCase& patient, const fs::path& file, const NumberMeaning& meaning,
                                     const Progress& progress) {
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    return fail("There is no file " + file.string() +
                " with labels. Name a DICOM segmentation or RT Structure Set, NRRD, NIfTI or MetaImage.");
  if (!isVolumeFile(file)) {
    if (layoutOf(file) == DicomLayout::kNotDicom)
      return fail(file.string() +
                  " contains no labels: it is neither a DICOM segmentation or RT Structure Set nor NRRD, NIfTI or "
                  "MetaImage.");
    if (isStructureSet(file)) return readStructureSet(patient, file, {}, progress);
    auto read = fromDicom(patient, file, progress);
    if (read) forgetForeignNames(*read);
    return read;
  }
  auto read = readNamed(file, meaning);
  if (!read) return read;
  auto placed = placeLabels(read->labels, patient.ct.geometry, read->notes, progress);
  if (!placed) return inFile(file, placed.error());
  read->labels = std::move(*placed);
  forgetForeignNames(*read);
  return read;
}

}  // namespace insonate
