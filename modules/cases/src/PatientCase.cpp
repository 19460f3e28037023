#include "files/CaseFiles.h"
#include "files/Hounsfield.h"
#include "files/ItkSnapLabels.h"
#include "files/LabelGrid.h"
#include "files/ManifestJson.h"
#include "files/NrrdWriter.h"
#include "files/SlicerSegmentation.h"

#include <insonate/cases/LabelFile.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/core/AtomicFile.h>
#include <insonate/tissue/Labels.h>

#include <array>
#include <fstream>
#include <iterator>

namespace insonate {
namespace fs = std::filesystem;
namespace {

std::string text(const std::array<int, 3>& size) {
  return std::to_string(size[0]) + "x" + std::to_string(size[1]) + "x" + std::to_string(size[2]);
}
std::string text(Vec3 v) {
  return "(" + exactDecimal(v.x) + ", " + exactDecimal(v.y) + ", " + exactDecimal(v.z) + ")";
}

std::string differenceOf(const VolumeGeometry& ct, const VolumeGeometry& labels) {
  if (ct.size != labels.size) return "the CT has " + text(ct.size) + " voxels, the label map " + text(labels.size);
  if (norm(ct.spacing_mm - labels.spacing_mm) > 1e-4)
    return "the CT has a spacing of " + text(ct.spacing_mm) + " mm, the label map " + text(labels.spacing_mm);
  for (int a = 0; a < 3; ++a)
    if (norm(ct.direction.column[a] - labels.direction.column[a]) > 1e-4)
      return "axis " + std::to_string(a + 1) + " of the CT points along " + text(ct.direction.column[a]) +
             ", that of the label map along " + text(labels.direction.column[a]);
  return "the CT starts at " + text(ct.origin_mm) + " mm, the label map at " + text(labels.origin_mm);
}

Result<CtVolume> readCt(const fs::path& file, std::vector<std::string>& notes) {
  const auto header = readVolumeHeader(file);
  if (!header) return tl::unexpected(header.error());
  const auto geometry = orthogonalGeometry(*header);
  if (!geometry) return fail(file.string() + ": " + geometry.error().message);
  if (!header->oriented)
    notes.push_back(std::string(kCtFile) +
                    " does not state its orientation; its axes are assumed to be left, posterior, superior.");
  auto read = readHounsfield(file, *header, *geometry, notes);
  if (!read) return tl::unexpected(read.error());
  return std::move(read->ct);
}

Result<LabelReadResult> readLabels(const fs::path& folder, std::vector<std::string>& notes) {
  std::error_code error;
  const bool segmentation = fs::exists(folder / kLabelFile, error), plain = fs::exists(folder / kPlainLabelFile, error);
  if (!segmentation && !plain)
    return fail("The case " + folder.string() + " has no labels: " + kLabelFile + " or " + kPlainLabelFile +
                " is missing. Label the CT, e.g. in 3D Slicer, or import it with --auto-label.");
  if (segmentation && plain)
    notes.push_back(std::string("There are two label maps; ") + kLabelFile + " is used, " + kPlainLabelFile +
                    " is ignored.");
  if (!segmentation) notes.push_back(std::string("There is no ") + kLabelFile + "; " + kPlainLabelFile + " is used.");
  auto read = readLabelMap(folder / (segmentation ? kLabelFile : kPlainLabelFile));
  if (!read) return tl::unexpected(read.error());
  notes.insert(notes.end(), read->notes.begin(), read->notes.end());
  return read;
}

}  // namespace

Result<void> writeCaseFiles(const PatientCase& patient, const CaseManifest& manifest, const fs::path& folder,
                            const fs::path& sameCt, const Progress& progress) {
  const auto& ct = patient.ct;
  const auto& labels = patient.labels;
  std::error_code error;
  if (!sameCt.empty()) fs::create_hard_link(sameCt, folder / kCtFile, error);
  if (sameCt.empty() || error)
    if (auto ok = writeNrrd(folder / kCtFile, ct.geometry, "short", std::as_bytes(std::span(ct.voxels)), {}, progress);
        !ok)
      return ok;
  if (auto ok = writeNrrd(folder / kLabelFile, labels.geometry, "unsigned char",
                          std::as_bytes(std::span(labels.voxels)), slicerFields(patient), progress);
      !ok)
    return ok;
  if (auto ok = writeAtomically(folder / kSnapFile, itkSnapLabelText(patient)); !ok) return ok;
  if (auto ok = writeAtomically(folder / kManifestFile, manifestToJson(manifest)); !ok) return ok;
  if (!report(progress, "Writing the case", 1)) return fail(std::string(kCancelled));
  return {};
}

std::string_view nameOf(LabelState state) {
  constexpr std::array<std::string_view, 4> kNames{"not started", "in progress", "completed", "flagged"};
  return kNames[static_cast<std::size_t>(state)];
}

LabelState stateOf(const LabelStates& states, std::uint8_t label, bool hasVoxels) {
  const auto found = states.find(label);
  return found != states.end() ? found->second : hasVoxels ? LabelState::InProgress : LabelState::NotStarted;
}

Result<CaseManifest> readManifest(const fs::path& file, std::vector<std::string>& notes) {
  std::error_code error;
  if (!fs::exists(file, error)) {
    notes.push_back(
        "There is no case.json: the case has no title, target or start pose; the pose \"auto\" is the "
        "front of the skin.");
    return CaseManifest{};
  }
  std::ifstream in(file, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(in), {}};
  if (!in && !in.eof()) return fail("Could not read " + file.string() + ".");
  auto manifest = manifestFromJson(content, notes);
  if (!manifest) return fail(file.parent_path().string() + ": " + manifest.error().message);
  return manifest;
}

LabelColor caseLabelColor(const LabelColors& colors, std::uint8_t label) {
  constexpr LabelColor kUnknown{128, 128, 128};
  const auto found = colors.find(label);
  if (found != colors.end()) return found->second;
  return label < kLabelCount ? labelTable()[label].color : kUnknown;
}

bool isUsualColor(std::uint8_t label, const LabelColor& color) {
  constexpr LabelColor kSlicerArtery{216, 101, 79}, kSlicerMuscle{192, 104, 88};
  const bool isMuscle = label == kMuscle || label == kSternocleidomastoid;
  return color == caseLabelColor({}, label) || (label == kArtery && color == kSlicerArtery) ||
         (isMuscle && color == kSlicerMuscle);
}

Result<CaseReadResult> readCase(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error))
    return fail(folder.string() +
                " is a file, but a case is a folder. Name the folder of a case, or make a case from a CT with import.");
  if (!fs::is_directory(folder, error))
    return fail("There is no case folder " + folder.string() + ". Make one with import or phantom.");
  if (!fs::exists(folder / kCtFile, error))
    return fail("The case " + folder.string() + " has no " + kCtFile +
                ". Check that this is the folder of a case. To make a case from a DICOM folder, use import.");
  CaseReadResult result;
  auto ct = readCt(folder / kCtFile, result.notes);
  if (!ct) return tl::unexpected(ct.error());
  auto labels = readLabels(folder, result.notes);
  if (!labels) return tl::unexpected(labels.error());
  LabelMap& map = labels->labels;
  // 3D Slicer may store only the box around the segments.
  if (!sameGrid(ct->geometry, map.geometry) && isPartOf(map.geometry, ct->geometry)) {
    auto placed = placeLabels(map, ct->geometry, result.notes);
    if (!placed) return fail("The labels of " + folder.string() + " do not fit: " + placed.error().message);
    map = std::move(*placed);
  }
  if (!sameGrid(ct->geometry, map.geometry))
    return fail("The CT and the labels of " + folder.string() + " are on different grids: " +
                differenceOf(ct->geometry, map.geometry) + ". Resample the label map to the CT.");
  map.geometry = ct->geometry;
  auto manifest = readManifest(folder / kManifestFile, result.notes);
  if (!manifest) return tl::unexpected(manifest.error());
  // If another program has edited the labels, its entries take precedence over case.json.
  for (auto& [label, own] : labels->own) manifest->ownLabels[label] = std::move(own);
  for (const auto& [label, state] : labels->states)
    if (state != stateOf(manifest->states, label, true)) manifest->states[label] = state;
  result.patient = {std::move(*manifest), std::move(*ct), std::move(map), std::move(labels->colors)};
  return result;
}

Result<void> checkCaseTarget(const fs::path& folder, bool replace) {
  if (auto ok = checkFolderTarget(folder); !ok) return ok;
  std::error_code error;
  const fs::path parent = (folder.has_filename() ? folder : folder.parent_path()).parent_path();
  if (!parent.empty() && fs::exists(parent / kCtFile, error) && fs::exists(parent / kManifestFile, error))
    return fail(folder.string() + " lies in the folder of another case, " + parent.string() +
                ". Choose a folder outside of it.");
  for (const char* name : {kCtFile, kLabelFile, kManifestFile}) {
    if (!fs::exists(folder / name, error)) continue;
    if (!replace)
      return fail(folder.string() + " already holds a case. Name another folder, or add --replace to overwrite it.");
    if (fs::equivalent(folder, ".", error))
      return fail(
          folder.string() +
          " is the current folder, which cannot be replaced. Change to its parent folder and run the command again.");
  }
  return {};
}

bool isCaseFile(const fs::path& folder, const fs::path& file) {
  for (const char* name : {kCtFile, kLabelFile, kPlainLabelFile, kManifestFile, kSnapFile}) {
    std::error_code error;
    if (fs::equivalent(folder / name, file, error)) return true;
    if (file.filename() == name && fs::equivalent(folder, file.has_parent_path() ? file.parent_path() : ".", error))
      return true;
  }
  return false;
}

Result<void> checkVolumes(const PatientCase& patient) {
  for (const VolumeGeometry& g : {patient.ct.geometry, patient.labels.geometry})
    if (auto ok = validate(g); !ok) return ok;
  if (!sameGrid(patient.ct.geometry, patient.labels.geometry))
    return fail("The CT and the labels are on different grids: " +
                differenceOf(patient.ct.geometry, patient.labels.geometry) + ". Nothing was written.");
  return {};
}

Result<void> writeCase(const PatientCase& patient, const fs::path& folder, const Progress& progress) {
  if (auto ok = checkVolumes(patient); !ok) return ok;
  return writeFolderAtomically(
      folder, [&](const fs::path& beside) { return writeCaseFiles(patient, patient.manifest, beside, {}, progress); },
      {kPlainLabelFile});
}

}  // namespace insonate
