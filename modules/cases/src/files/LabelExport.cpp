#include "ItkSnapLabels.h"
#include "NrrdWriter.h"
#include "SlicerSegmentation.h"

#include <insonate/cases/LabelFile.h>
#include <insonate/core/AtomicFile.h>

#include <algorithm>

namespace insonate {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kEnding = ".seg.nrrd";

}  // namespace

Result<void> checkLabelTarget(const fs::path& file) {
  const std::string name = file.filename().string();
  if (name.size() <= kEnding.size() || !name.ends_with(kEnding))
    return fail(file.string() + " should be named .seg.nrrd, by which 3D Slicer knows a segmentation.");
  return {};
}

Result<void> writeLabelFile(const PatientCase& patient, const fs::path& file, const Progress& progress) {
  if (auto ok = checkLabelTarget(file); !ok) return ok;
  const LabelMap& labels = patient.labels;
  if (std::ranges::none_of(labels.voxels, [](std::uint8_t label) { return label != 0; }))
    return fail("Nothing is labeled, so there are no labels to write to " + file.string() + ".");
  const auto write = [&](const fs::path& beside) {
    return writeNrrd(beside, labels.geometry, "unsigned char", std::as_bytes(std::span(labels.voxels)),
                     slicerFields(patient), progress);
  };
  if (auto ok = writeAtomically(file, write); !ok) return ok;
  std::string names = file.string();
  names.resize(names.size() - kEnding.size());
  return writeAtomically(names + ".label.txt", itkSnapLabelText(patient));
}

void replaceLabels(LabelReadResult&& imported, PatientCase& patient) {
  patient.labels = std::move(imported.labels);
  patient.colors = std::move(imported.colors);
  patient.manifest.ownLabels = std::move(imported.own);
  patient.manifest.states = std::move(imported.states);
  std::vector<NamedVessel>& vessels = patient.manifest.vessels;
  for (NamedVessel& vessel : imported.vessels) {
    std::erase_if(vessels, [&](const NamedVessel& former) { return former.name == vessel.name; });
    vessels.push_back(std::move(vessel));
  }
  patient.manifest.importNotes.push_back("The labels were imported from a file of another program.");
}

}  // namespace insonate
