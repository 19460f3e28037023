#include "Commands.h"

#include <insonate/cases/DicomSegmentation.h>
#include <insonate/cases/DicomWriter.h>
#include <insonate/cases/LabelFile.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

using nlohmann::json;

struct ExportArguments {
  std::string caseFolder, dicomFolder, segmentation, labels;
  bool json = false;
};

/// Everything that could be refused later is asked for before anything is written.
Result<void> checkTargets(const ExportArguments& a) {
  if (!a.dicomFolder.empty())
    if (auto ok = checkDicomTarget(a.dicomFolder); !ok) return ok;
  if (!a.labels.empty())
    if (auto ok = checkLabelTarget(a.labels); !ok) return ok;
  for (const std::string& file : {a.segmentation, a.labels})
    if (!file.empty() && isCaseFile(a.caseFolder, file))
      return fail(file + " is a file of the case itself. Name another file.");
  return {};
}

Result<void> exportCase(const ExportArguments& a) {
  if (auto ok = checkTargets(a); !ok) return ok;
  const auto read = readCase(a.caseFolder);
  if (!read) return tl::unexpected(read.error());
  for (const std::string& note : read->notes) std::cerr << "note: " << note << '\n';
  const PatientCase& patient = read->patient;
  json written = json::object();
  if (!a.dicomFolder.empty()) {
    if (auto ok = writeDicomSeries(patient.ct, a.dicomFolder, dicomIdentityOf(patient), terminalProgress()); !ok)
      return ok;
    written["dicom"] = a.dicomFolder;
  }
  if (!a.segmentation.empty()) {
    if (auto ok = writeDicomSegmentation(patient, a.segmentation, terminalProgress()); !ok) return ok;
    written["seg"] = a.segmentation;
  }
  if (!a.labels.empty()) {
    if (auto ok = writeLabelFile(patient, a.labels, terminalProgress()); !ok) return ok;
    written["labels"] = a.labels;
  }
  for (const auto& [kind, place] : written.items())
    if (!a.json) std::printf("Wrote %s\n", place.get<std::string>().c_str());
  if (a.json) printJson({{"case", a.caseFolder}, {"written", written}});
  return {};
}

}  // namespace

void addExportCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand(
      "export", "Write CT and labels of a case for other programs (for meshes, see the command surfaces)");
  auto a = std::make_shared<ExportArguments>();
  command->add_option("CASE", a->caseFolder, "Folder of the case")->required()->check(notEmpty());
  auto* dicom = command->add_option("--dicom", a->dicomFolder, "New or empty folder for the CT as a DICOM series");
  auto* seg = command->add_option("--seg", a->segmentation,
                                  "File for the labels, as a DICOM segmentation (.dcm) of that series");
  auto* labels = command->add_option(
      "--labels", a->labels,
      "File for the labels for 3D Slicer (.seg.nrrd); ITK-SNAP's label description (.label.txt) is written beside it");
  for (auto* option : {dicom, seg, labels}) option->check(notEmpty());
  command->add_flag("--json", a->json, "Print one JSON object");
  command->callback([a, dicom, seg, labels, &outcome] {
    outcome.json = a->json;
    if (!*dicom && !*seg && !*labels) throw CLI::RequiredError("--dicom, --seg or --labels");
    if (auto done = exportCase(*a); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
