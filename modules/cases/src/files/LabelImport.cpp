#include "../dicomseg/SegReader.h"
#include "../import/DerivedUid.h"
#include "../import/DicomLayout.h"
#include "../masks/LabelAssembly.h"
#include "../masks/MaskFile.h"
#include "../rtstruct/StructureSet.h"
#include "LabelNames.h"
#include "NumberNames.h"
#include "SlicerSegmentation.h"
#include "VolumeFile.h"

#include <insonate/cases/LabelFile.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>

namespace insonate {
namespace fs = std::filesystem;
namespace {

struct Sources {
  const PatientCase& patient;
  const NumberMeaning& meaning;
  const Progress& progress;
};

tl::unexpected<Error> inFile(const fs::path& file, const Error& error) {
  return fail(error.message == kCancelled ? error.message : file.string() + ": " + error.message);
}

/// Places the numbers of a label map that have names.
Result<void> addNumbers(const Sources& from, const fs::path& file, const NumberNames& names, const std::string& source,
                        LabelAssembly& assembly) {
  const auto values = readLabelValues(file);
  if (!values) return tl::unexpected(values.error());
  assembly.addNote("The meaning of the numbers was taken from " + source + ".");
  assembly.keepNumbers(names);
  std::set<std::int32_t> occurring;
  std::int32_t last = 0;
  for (const std::int32_t value : values->voxels)
    if (value != last && value != 0) occurring.insert(last = value);
  std::map<std::int32_t, std::uint16_t> numberOf;
  for (const std::int32_t value : occurring) {
    const auto described = names.find(value);
    if (described == names.end()) {
      assembly.addNote("The number " + std::to_string(value) + " is not described and was ignored.");
      continue;
    }
    const auto number = assembly.add(value, described->second, "The label");
    if (!number) return tl::unexpected(number.error());
    if (assembly.isRead(*number)) numberOf[value] = *number;
  }
  Volume<std::uint16_t> parts(values->geometry);
  std::int32_t former = 0;
  std::uint16_t part = 0;
  for (std::size_t v = 0; v < parts.voxels.size(); ++v) {
    const std::int32_t value = values->voxels[v];
    if (value != former) {
      const auto found = numberOf.find(value);
      part = found == numberOf.end() ? std::uint16_t{0} : found->second;
      former = value;
    }
    parts.voxels[v] = part;
  }
  return assembly.composer().place(parts, Sampling::kSmooth, from.progress);
}

/// A file of one structure, named by the file. Returns false for a file that is no mask.
Result<bool> addMask(const Sources& from, const fs::path& file, LabelAssembly& assembly) {
  const std::string name = withoutEndings(file).filename().string();
  const ReadStructure structure{1, name};
  auto mask = isTaken(structure, from.meaning.choices, !isLeftOut(name)) ? readMask(file) : Result<Mask>(Mask{});
  if (!mask) return tl::unexpected(mask.error());
  if (!mask->objection.empty()) {
    assembly.addNote(file.filename().string() + " is no mask of one structure and was left out: " + mask->objection +
                     ".");
    return false;
  }
  const auto number = assembly.add(1, {name}, "The mask");
  if (!number) return tl::unexpected(number.error());
  if (!assembly.isRead(*number)) return true;
  if (auto ok = assembly.composer().place(mask->inside, *number, from.progress); !ok) return tl::unexpected(ok.error());
  return true;
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

/// Names of a label map's numbers, and the file that states them.
struct FoundNames {
  NumberNames names;
  std::string source;
};

/// Names beside a label map. A file of names for one label map is binding; other programs also write JSON files of
/// other content with these names.
Result<FoundNames> namesBeside(const fs::path& file) {
  std::error_code error;
  const fs::path stem = withoutEndings(file), folder = file.parent_path();
  if (const fs::path own = stem.string() + ".label.txt"; fs::exists(own, error)) {
    auto names = readNumberNames(own);
    if (!names) return tl::unexpected(names.error());
    return FoundNames{std::move(*names), own.filename().string()};
  }
  for (const fs::path& beside :
       {fs::path(stem.string() + ".json"), folder / "dataset.json", folder / "metadata.json",
        folder / "label_dict.json", folder / "labels.json", folder.parent_path() / "dataset.json"}) {
    if (!fs::is_regular_file(beside, error)) continue;
    if (auto names = readNumberNames(beside)) return FoundNames{std::move(*names), beside.filename().string()};
  }
  return FoundNames{};
}

Result<FoundNames> namesOf(const fs::path& file, const VolumeHeader& header, const NumberMeaning& meaning) {
  if (!meaning.names.empty()) {
    auto names = readNumberNames(meaning.names);
    if (!names) return tl::unexpected(names.error());
    return FoundNames{std::move(*names), meaning.names.filename().string()};
  }
  if (isSlicerSegmentation(header.metadata)) return FoundNames{};
  auto found = namesBeside(file);
  if (!found || (!found->names.empty() && found->source.ends_with(".label.txt"))) return found;
  if (NumberNames names = namesInExtension(header.extension); !names.empty())
    return FoundNames{std::move(names), "the file's header"};
  return found;
}

Result<LabelReadResult> readSlicer(const fs::path& file, const StructureChoices& choices) {
  const auto header = readVolumeHeader(file);
  if (!header) return tl::unexpected(header.error());
  const auto geometry = orthogonalGeometry(*header);
  if (!geometry) return inFile(file, geometry.error());
  return readSlicerSegmentation(file, *header, *geometry, &choices);
}

Result<void> adoptFrom(const Sources& from, Result<LabelReadResult> read, LabelAssembly& assembly) {
  if (!read) return tl::unexpected(read.error());
  return assembly.adopt(std::move(*read), from.progress);
}

/// One volume. In a folder, a volume without names is a mask.
Result<void> addVolume(const Sources& from, const fs::path& file, bool isInFolder, LabelAssembly& assembly) {
  const auto header = readVolumeHeader(file);
  if (!header) return tl::unexpected(header.error());
  const auto found = namesOf(file, *header, from.meaning);
  if (!found) return tl::unexpected(found.error());
  if (!found->names.empty()) return addNumbers(from, file, found->names, found->source, assembly);
  if (isSlicerSegmentation(header->metadata)) return adoptFrom(from, readSlicer(file, from.meaning.choices), assembly);
  const bool isNamedMask = labelFromAnyName(withoutEndings(file).filename().string()).has_value();
  if (isInFolder || isNamedMask) {
    const auto isMask = addMask(from, file, assembly);
    if (!isMask) return tl::unexpected(isMask.error());
    if (*isMask || isInFolder) return {};
  }
  return adoptFrom(from, readUnnamed(file, from.meaning.areProgramLabels), assembly);
}

Result<LabelReadResult> fromDicom(const PatientCase& patient, const fs::path& file, const StructureChoices& choices,
                                  const Progress& progress) {
  const auto segments = readDicomSegments(file, choices);
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

Result<void> addFile(const Sources& from, const fs::path& file, LabelAssembly& assembly) {
  if (isVolumeFile(file)) return addVolume(from, file, false, assembly);
  if (layoutOf(file) == DicomLayout::kNotDicom)
    return fail(file.string() +
                " contains no labels: it is neither a DICOM segmentation or RT Structure Set nor NRRD, NIfTI or "
                "MetaImage.");
  if (isStructureSet(file)) return addStructureSet(from.patient, file, assembly, from.progress);
  return adoptFrom(from, fromDicom(from.patient, file, from.meaning.choices, from.progress), assembly);
}

Result<void> addFolder(const Sources& from, const fs::path& folder, LabelAssembly& assembly) {
  const auto files = volumesIn(folder);
  if (!files) return tl::unexpected(files.error());
  for (std::size_t n = 0; n < files->size(); ++n) {
    const Progress share = [&from, n, count = files->size()](std::string_view, double fraction) {
      return report(from.progress, "Reading labels", (double(n) + fraction) / double(count));
    };
    if (!share({}, 0)) return fail(std::string(kCancelled));
    if (auto ok = addVolume({from.patient, from.meaning, share}, (*files)[n], true, assembly); !ok) return ok;
  }
  return {};
}

}  // namespace

Result<LabelReadResult> importLabelsTogether(const PatientCase& patient, std::span<const fs::path> sources,
                                             const NumberMeaning& meaning, const Progress& progress) {
  LabelAssembly assembly(patient, meaning.choices);
  const Sources from{patient, meaning, progress};
  for (const fs::path& source : sources) {
    std::error_code error;
    const bool isFolder = fs::is_directory(source, error);
    if (!isFolder && !fs::is_regular_file(source, error))
      return fail("There is no file " + source.string() +
                  " with labels. Name a DICOM segmentation or RT Structure Set, NRRD, NIfTI or MetaImage, or a folder "
                  "of masks.");
    if (auto ok = isFolder ? addFolder(from, source, assembly) : addFile(from, source, assembly); !ok)
      return tl::unexpected(ok.error());
  }
  auto result = assembly.finish();
  if (!result) return inFile(sources.front(), result.error());
  return result;
}

Result<LabelReadResult> importLabels(const PatientCase& patient, const fs::path& source, const NumberMeaning& meaning,
                                     const Progress& progress) {
  return importLabelsTogether(patient, std::span(&source, 1), meaning, progress);
}

}  // namespace insonate
