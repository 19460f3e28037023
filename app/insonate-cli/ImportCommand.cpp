#include "Commands.h"

#include <insonate/cases/Import.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/cases/StartPose.h>
#include <insonate/segmentation/AutoLabel.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

using nlohmann::json;

struct ImportArguments {
  std::string input, folder, series;
  bool list = false, autoLabel = false, asJson = false;
};

json toJson(Vec3 v) {
  return {v.x, v.y, v.z};
}

/// `direction` lists the patient directions of i, j and k.
json toJson(const SeriesInfo& s) {
  const VolumeGeometry& g = s.geometry;
  json directions = json::array();
  for (Vec3 axis : g.direction.column) directions.push_back(toJson(axis));
  return {{"uid", s.uid},
          {"modality", s.modality.empty() ? json(nullptr) : json(s.modality)},
          {"size", g.size},
          {"spacing_mm", toJson(g.spacing_mm)},
          {"origin_mm", toJson(g.origin_mm)},
          {"direction", directions},
          {"warnings", s.warnings},
          {"refusal", s.refusal.empty() ? json(nullptr) : json(s.refusal)}};
}

json toJson(const SeriesListing& listing) {
  json series = json::array(), aside = json::array();
  for (const SeriesInfo& s : listing.series) series.push_back(toJson(s));
  for (const SetAside& s : listing.setAside) aside.push_back({{"file", s.file.string()}, {"reason", s.reason}});
  return {{"series", series}, {"set_aside", aside}, {"case", nullptr}};
}

Result<void> list(const ImportArguments& a) {
  const auto listing = listSeries(a.input, terminalProgress());
  if (!listing) return tl::unexpected(listing.error());
  if (a.asJson)
    printJson(toJson(*listing));
  else
    std::printf("%s\n", describe(*listing).c_str());
  return {};
}

/// Scripts get the list as JSON also where an import is refused for being ambiguous.
Result<ImportedCt> importOrList(const ImportArguments& a) {
  auto imported = importSeries(a.input, a.series, terminalProgress());
  if (!imported && a.asJson && imported.error().message != kCancelled)
    if (const auto listing = listSeries(a.input)) printJson(toJson(*listing));
  return imported;
}

Result<void> importCase(const ImportArguments& a) {
  auto imported = importOrList(a);
  if (!imported) return tl::unexpected(imported.error());
  for (const std::string& warning : imported->series.warnings) std::cerr << "note: " << warning << '\n';

  PatientCase patient;
  patient.manifest.title = "Imported CT";
  patient.manifest.source = imported->source;
  patient.ct = std::move(imported->ct);
  if (a.autoLabel) {
    auto labels = autoLabel(patient.ct, terminalProgress());
    if (!labels) return tl::unexpected(labels.error());
    patient.labels = std::move(*labels);
    patient.manifest.source += " Labelled automatically from Hounsfield units.";
    if (auto pose = proposeStartPose(patient)) patient.manifest.startPoses.push_back(*pose);
  } else {
    patient.labels = LabelMap(patient.ct.geometry);
    std::cerr << "note: Nothing is labelled yet; --auto-label would label what Hounsfield units tell.\n";
  }
  if (auto written = writeCase(patient, a.folder); !written) return written;
  if (a.asJson) printJson({{"series", json::array({toJson(imported->series)})}, {"case", a.folder}});
  return {};
}

}  // namespace

void addImportCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand("import", "Make a case from a CT: DICOM, NRRD, NIfTI or MetaImage");
  auto a = std::make_shared<ImportArguments>();
  command->add_option("INPUT", a->input, "A folder, searched with its subfolders, or a file")->required();
  auto* folder = command->add_option("CASE", a->folder, "Folder to write the case to");
  auto* listOnly = command->add_flag("--list", a->list, "List the series in INPUT and stop");
  command->add_option("--series", a->series, "UID of the series to import, as listed")->excludes(listOnly);
  command->add_flag("--auto-label", a->autoLabel, "Label air, fat, muscle, bone and skin from Hounsfield units")
      ->excludes(listOnly);
  command->add_flag("--json", a->asJson, "Print one JSON object");
  command->callback([a, folder, &outcome] {
    if (!a->list && !*folder) throw CLI::RequiredError("CASE (or --list)");
    if (auto done = a->list ? list(*a) : importCase(*a); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
