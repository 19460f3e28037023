#include "Commands.h"

#include <insonate/cases/CaseTitle.h>
#include <insonate/cases/Import.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/cases/StartPose.h>
#include <insonate/segmentation/AutoLabel.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

namespace insonate::cli {
namespace {

using nlohmann::json;

struct ImportArguments {
  std::string input, folder, series;
  std::optional<int> shift_HU;
  bool list = false, autoLabel = false, replace = false, saturate = false, asJson = false;
};

json textOrNull(const std::string& text) {
  return text.empty() ? json(nullptr) : json(text);
}

/// `direction` lists the patient directions of i, j and k.
json jsonOf(const SeriesInfo& s) {
  const VolumeGeometry& g = s.geometry;
  json directions = s.geometryKnown ? json::array() : json(nullptr);
  if (s.geometryKnown)
    for (Vec3 axis : g.direction.column) directions.push_back(jsonArray(axis));
  return {{"uid", s.uid},
          {"modality", textOrNull(s.modality)},
          {"kernel", textOrNull(s.kernel)},
          {"description", textOrNull(s.description)},
          {"date", textOrNull(s.date)},
          {"body_part", textOrNull(s.bodyPart)},
          {"size", g.size},
          {"spacing_mm", s.geometryKnown ? jsonArray(g.spacing_mm) : json(nullptr)},
          {"origin_mm", s.geometryKnown ? jsonArray(g.origin_mm) : json(nullptr)},
          {"direction", directions},
          {"warnings", s.warnings},
          {"refusal", textOrNull(s.refusal)}};
}

json jsonOf(const SeriesListing& listing) {
  json series = json::array(), aside = json::array();
  for (const SeriesInfo& s : listing.series) series.push_back(jsonOf(s));
  for (const SkippedFile& s : listing.skippedFiles) aside.push_back({{"file", s.file.string()}, {"reason", s.reason}});
  return {{"series", series}, {"set_aside", aside}, {"case", nullptr}};
}

Result<void> list(const ImportArguments& a) {
  const auto listing = listSeries(a.input, terminalProgress());
  if (!listing) return tl::unexpected(listing.error());
  if (a.asJson)
    printJson(jsonOf(*listing));
  else
    std::printf("%s\n", seriesListText(*listing).c_str());
  return {};
}

/// Scripts get the list also where an import is refused for being ambiguous; empty when there is none.
json fieldsOfRefusal(const ImportArguments& a, const Error& error) {
  if (a.list || !a.asJson || error.message == kCancelled) return json::object();
  const auto listing = listSeries(a.input);
  return listing ? jsonOf(*listing) : json::object();
}

/// The pose is not stored: what an author puts into case.json is better, and until then `auto` finds the same one.
void tellPose(const PatientCase& patient) {
  if (const auto pose = proposeStartPose(patient))
    std::cerr << "note: The pose \"auto\" is the " << pose->name
              << ", which was found automatically. Add other start poses in case.json.\n";
}

Result<void> importCase(const ImportArguments& a) {
  if (auto ok = checkCaseTarget(a.folder, a.replace); !ok) return ok;
  auto imported = importSeries(a.input, a.series, terminalProgress());
  if (!imported) return tl::unexpected(imported.error());
  if (imported->saturatedVoxels > 0 && !a.saturate)
    return fail(saturationText(*imported) +
                " Nothing was imported. Export the series again, or add --saturate to import it as it is.");
  if (a.shift_HU) shiftValues(*imported, *a.shift_HU);
  for (const std::string& warning : imported->series.warnings) std::cerr << "note: " << warning << '\n';
  const std::string advice =
      imported->likelyShift_HU ? " --shift " + std::to_string(*imported->likelyShift_HU) + " corrects this." : "";
  if (!advice.empty()) std::cerr << "note: The values were not changed;" << advice << '\n';

  PatientCase patient;
  patient.manifest.title = kImportedTitle;
  setTitleFromFolder(patient.manifest, a.folder);
  patient.manifest.source = imported->source;
  patient.manifest.importNotes = imported->series.warnings;
  patient.ct = std::move(imported->ct);
  if (a.autoLabel) {
    auto labels = autoLabel(patient.ct, terminalProgress());
    if (!labels && labels.error().message == kCancelled) return tl::unexpected(labels.error());
    if (!labels)
      return fail(labels.error().message + (advice.empty() ? " It can be imported without --auto-label." : advice));
    patient.labels = std::move(*labels);
    patient.manifest.source += " Labeled automatically from Hounsfield units.";
  } else {
    patient.labels = LabelMap(patient.ct.geometry);
    std::cerr << "note: The case has no labels yet. --auto-label labels tissues by their Hounsfield units.\n";
  }
  if (auto written = writeOrReplace(patient, a.folder); !written) return written;
  tellPose(patient);
  printNextSteps(a.folder);
  if (a.asJson) printJson({{"series", json::array({jsonOf(imported->series)})}, {"case", a.folder}});
  return {};
}

}  // namespace

void addImportCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand("import", "Make a case from a CT: DICOM, NRRD, NIfTI or MetaImage");
  auto a = std::make_shared<ImportArguments>();
  command->add_option("INPUT", a->input, "A folder (subfolders are included), a file, or the DICOMDIR of a folder")
      ->required()
      ->check(notEmpty());
  auto* folder = command->add_option("CASE", a->folder, "Folder to write the case to")->check(notEmpty());
  auto* listOnly = command->add_flag("--list", a->list, "List the series in INPUT and stop");
  folder->excludes(listOnly);
  command->add_option("--series", a->series, "UID of the series to import, as listed")->excludes(listOnly);
  command
      ->add_option(
          "--shift", a->shift_HU,
          "Number to add to every value, e.g. -1024 if air is at 0 instead of -1024 HU; by default nothing is added")
      ->check(CLI::Range(-4096, 4096))
      ->excludes(listOnly);
  command
      ->add_flag("--saturate", a->saturate,
                 "Import even if values exceed the range of a case; such values are limited to 32767 HU")
      ->excludes(listOnly);
  command->add_flag("--auto-label", a->autoLabel, "Label air, fat, muscle, bone and skin from Hounsfield units")
      ->excludes(listOnly);
  command->add_flag("--replace", a->replace, "Replace the case in CASE, which is kept as an earlier version")
      ->excludes(listOnly);
  command->add_flag("--json", a->asJson, "Print one JSON object");
  command->callback([a, folder, &outcome] {
    outcome.json = a->asJson;
    if (!a->list && !*folder) throw CLI::RequiredError("CASE (or --list)");
    if (auto done = a->list ? list(*a) : importCase(*a); !done)
      refuse(outcome, done.error(), fieldsOfRefusal(*a, done.error()));
  });
}

}  // namespace insonate::cli
