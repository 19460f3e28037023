#include <insonate/cases/LabelFile.h>
#include <insonate/core/Fingerprint.h>
#include <insonate/preparation/StudyPreparation.h>
#include <insonate/segmentation/AutoLabel.h>
#include <insonate/simulator/ImportedLabels.h>
#include <insonate/simulator/TouchingPose.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace insonate {
namespace {

/// A neck from clavicle to jaw is about 100 mm long.
constexpr double kShort_mm = 60;
/// Folder for segmentations in the folder of a study, as on the help page Prepare.
constexpr const char* kLabelFolder = "labels";

double length_mm(const VolumeGeometry& g) {
  return g.size[2] * g.spacing_mm.z;
}

/// A series of slices from a scanner is rather a CT than a volume file, which may be a label map.
bool isBetter(const SeriesInfo& a, const SeriesInfo& b) {
  if (a.modality != b.modality) return a.modality == "CT";
  const bool aIsLong = length_mm(a.geometry) >= kShort_mm, bIsLong = length_mm(b.geometry) >= kShort_mm;
  if (aIsLong != bIsLong) return aIsLong;
  if (!aIsLong) return length_mm(a.geometry) > length_mm(b.geometry);
  if (a.geometry.spacing_mm.z != b.geometry.spacing_mm.z) return a.geometry.spacing_mm.z < b.geometry.spacing_mm.z;
  return length_mm(a.geometry) > length_mm(b.geometry);
}

/// A volume file is the CT only if it lies in the study's folder itself: the others are segmentations.
bool isUsable(const std::filesystem::path& folder, const SeriesInfo& series) {
  if (!series.refusal.empty()) return false;
  if (!series.modality.empty()) return series.modality == "CT";
  return !std::filesystem::is_directory(folder) || std::filesystem::exists(folder / series.uid);
}

std::string idOf(const std::filesystem::path& folder, const SeriesInfo& series) {
  Fingerprint id;
  id.add(series.uid);
  const bool isFile = series.modality.empty();
  if (isFile) id.add(std::filesystem::absolute(folder).lexically_normal().string());
  return id.text();
}

/// Segmentations of other programs for the study; empty if there are none.
std::filesystem::path labelsOf(const Study& study) {
  const std::filesystem::path labels = study.folder / kLabelFolder;
  return std::filesystem::is_directory(labels) ? labels : std::filesystem::path();
}

/// Structures whose side is doubtful are left out: nobody is there to be asked.
Result<LabelReadResult> readWithoutDoubts(const PatientCase& patient, const std::filesystem::path& labels,
                                          std::vector<std::string>& warnings, const Progress& progress) {
  auto read = importLabels(patient, labels, {}, progress);
  if (!read) return read;
  NumberMeaning meaning;
  for (const ReadStructure& structure : read->structures) {
    if (structure.state != StructureState::kDoubtful) continue;
    warnings.push_back(structure.doubt + " It was left out.");
    meaning.choices.taken[structure.key()] = false;
  }
  return meaning.choices.taken.empty() ? std::move(read) : importLabels(patient, labels, meaning, progress);
}

/// The study's own segmentations over the automatic labels.
Result<void> takeLabels(const std::filesystem::path& labels, PreparedStudy& prepared, const Progress& progress) {
  PatientCase& patient = prepared.patient;
  auto read = readWithoutDoubts(patient, labels, prepared.warnings, progress);
  if (!read) return tl::unexpected(read.error());
  for (std::string& missing : missingForLines(read->structures)) prepared.warnings.push_back(std::move(missing));
  if (auto ok = makeImportedVessels(*read, progress); !ok) return ok;
  if (auto ok = labelRest(patient.ct, *read, progress); !ok) return ok;
  std::ranges::move(read->notes, std::back_inserter(prepared.warnings));
  replaceLabels(std::move(*read), patient);
  return {};
}

Result<void> labelAutomatically(PatientCase& patient, const Progress& progress) {
  auto labels = autoLabel(patient.ct, progress);
  if (!labels) return tl::unexpected(labels.error());
  patient.labels = std::move(*labels);
  patient.manifest.source += " Labeled automatically from Hounsfield units.";
  return {};
}

/// Part of a longer piece of work.
Progress partOf(const Progress& progress, double from, double to) {
  if (!progress) return {};
  return
      [progress, from, to](std::string_view doing, double done) { return progress(doing, from + done * (to - from)); };
}

}  // namespace

Result<Study> findStudy(const std::filesystem::path& folder, const Progress& progress) {
  auto listing = listSeries(folder, progress);
  if (!listing) return tl::unexpected(listing.error());
  const SeriesInfo* best = nullptr;
  int usable = 0;
  std::string reason;
  for (const SeriesInfo& series : listing->series) {
    if (!isUsable(folder, series)) {
      reason = series.refusal.empty() ? "its modality is " + series.modality + ", not CT" : series.refusal;
      continue;
    }
    ++usable;
    if (!best || isBetter(series, *best)) best = &series;
  }
  if (!best)
    return fail("No CT series in " + folder.string() + " can be imported. " + std::to_string(listing->series.size()) +
                (listing->series.size() == 1 ? " series was found: " : " series were found; the last one: ") + reason);
  Study study{folder, *best, idOf(folder, *best), {}};
  if (usable > 1)
    study.choice = "The series with the thinnest slices was chosen from " + std::to_string(usable) + " series.";
  return study;
}

Result<PreparedStudy> prepareStudy(const Study& study, const Progress& progress) {
  auto imported = importSeries(study.folder, study.series.uid, partOf(progress, 0, 0.4));
  if (!imported) return tl::unexpected(imported.error());
  if (imported->saturatedVoxels > 0) return fail(saturationText(*imported) + " Import this study by itself.");
  PreparedStudy prepared;
  if (!study.choice.empty()) prepared.warnings.push_back(study.choice);
  if (imported->likelyShift_HU) {
    shiftValues(*imported, *imported->likelyShift_HU);
    prepared.warnings.push_back("The offset " + std::to_string(*imported->likelyShift_HU) +
                                " was added to all values, since air was not at -1000 HU. Check the CT values.");
  }
  PatientCase& patient = prepared.patient;
  patient.manifest.title = "Case " + study.id.substr(0, 6);
  patient.manifest.source = imported->source;
  patient.manifest.importNotes = imported->series.warnings;
  patient.ct = std::move(imported->ct);
  patient.labels = LabelMap(patient.ct.geometry);
  const Progress labeling = partOf(progress, 0.4, 0.8);
  const std::filesystem::path labels = labelsOf(study);
  if (auto ok = labels.empty() ? labelAutomatically(patient, labeling) : takeLabels(labels, prepared, labeling); !ok)
    return tl::unexpected(ok.error());
  auto places = proposeTouchingPlaces(patient, partOf(progress, 0.8, 0.85));
  if (!places) return tl::unexpected(places.error());
  std::ranges::move(places->notes, std::back_inserter(prepared.warnings));
  addPlaces(std::move(*places), patient.manifest);
  auto findings = checkCase(patient, partOf(progress, 0.85, 1));
  if (!findings) return tl::unexpected(findings.error());
  prepared.findings = std::move(*findings);
  return prepared;
}

}  // namespace insonate
