#include "Commands.h"

#include <insonate/cases/CaseFromLabels.h>
#include <insonate/cases/DicomWriter.h>
#include <insonate/cases/Phantom.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

namespace fs = std::filesystem;

struct PhantomArguments {
  std::string folder, dicomFolder, labelFile, mapFile;
  std::string variant{phantomVariants().front().name};
  std::uint32_t seed = 1;
  bool contrast = false, list = false, replace = false, json = false;
};

void listVariants(bool json) {
  nlohmann::json rows = nlohmann::json::array();
  for (const PhantomVariant& v : phantomVariants()) {
    rows.push_back(
        {{"name", v.name}, {"title", v.title}, {"difficulty", v.difficulty}, {"description", v.description}});
    if (!json)
      std::printf("%-20s %-9s %s\n", std::string(v.name).c_str(), std::string(v.difficulty).c_str(),
                  std::string(v.description).c_str());
  }
  if (json) printJson({{"variants", rows}});
}

Result<PatientCase> makePatient(const PhantomArguments& a, std::vector<std::string>& notes) {
  const CtContrast contrast = a.contrast ? CtContrast::kArterial : CtContrast::kNative;
  if (a.labelFile.empty()) return makePhantom(a.variant, a.seed, terminalProgress(), contrast);
  auto made = caseFromLabels(a.labelFile, a.mapFile, {.seed = a.seed, .contrast = contrast}, terminalProgress());
  if (!made) return tl::unexpected(made.error());
  notes = std::move(made->notes);
  return std::move(made->patient);
}

Result<void> checkTargets(const PhantomArguments& a) {
  if (auto ok = checkCaseTarget(a.folder, a.replace); !ok || a.dicomFolder.empty()) return ok;
  if (fs::weakly_canonical(a.folder) == fs::weakly_canonical(a.dicomFolder))
    return fail("CASE and --dicom name the same folder. Name two different folders.");
  return checkDicomTarget(a.dicomFolder);
}

/// The series and the case, or neither.
Result<void> write(const PatientCase& patient, const PhantomArguments& a) {
  if (a.dicomFolder.empty()) return writeOrReplace(patient, a.folder);
  const bool wasThere = fs::exists(a.dicomFolder);
  const DicomSeriesIdentity identity{.seed = patient.manifest.source, .description = "Synthetic neck CT"};
  if (auto ok = writeDicomSeries(patient.ct, a.dicomFolder, identity, terminalProgress()); !ok) return ok;
  auto written = writeOrReplace(patient, a.folder);
  if (written) return written;
  std::error_code error;
  if (!wasThere) {
    fs::remove_all(a.dicomFolder, error);
  } else {
    for (const auto& slice : fs::directory_iterator(a.dicomFolder, error)) fs::remove(slice, error);
  }
  return written;
}

Result<void> makeCase(const PhantomArguments& a) {
  if (auto ok = checkTargets(a); !ok) return ok;
  std::vector<std::string> notes;
  const auto patient = makePatient(a, notes);
  if (!patient) return tl::unexpected(patient.error());
  for (const std::string& note : notes) std::cerr << "insonate-cli: " << note << '\n';
  if (auto written = write(*patient, a); !written) return written;
  printNextSteps(a.folder);
  if (!a.json) return {};
  nlohmann::json object{
      {"case", a.folder}, {"title", patient->manifest.title}, {"source", patient->manifest.source}, {"notes", notes}};
  if (!a.dicomFolder.empty()) object["dicom"] = a.dicomFolder;
  printJson(object);
  return {};
}

}  // namespace

void addPhantomCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand("phantom", "Write a built-in case: neck, axillary vessels, arm or groin");
  auto a = std::make_shared<PhantomArguments>();
  auto* folder = command->add_option("CASE", a->folder, "Folder to write the case to")->check(notEmpty());
  command->add_option("--variant", a->variant, "Name of the built-in case (see --list)")->capture_default_str();
  command
      ->add_option("--seed", a->seed,
                   "Seed of the random numbers: another seed makes another person of the same variant")
      ->capture_default_str();
  command->add_flag("--contrast", a->contrast, "Simulate contrast agent in the vessels of the CT");
  command->add_option("--dicom", a->dicomFolder, "Also write the CT as a DICOM series, into a new or empty folder")
      ->check(notEmpty());
  command->add_flag("--replace", a->replace, "Replace the case in CASE, which is kept as an earlier version");
  auto* labels =
      command->add_option("--from-labels", a->labelFile, "Make the case from this label map instead of a built-in case")
          ->check(notEmpty());
  auto* map =
      command
          ->add_option("--map", a->mapFile,
                       "JSON file with the name of each number in the label map, and with the parts to complete")
          ->check(notEmpty());
  labels->needs(map);
  map->needs(labels);
  labels->excludes("--variant");
  auto* list = command->add_flag("--list", a->list, "List the variants and stop");
  folder->excludes(list);
  command->add_flag("--json", a->json, "Print one JSON object");
  command->callback([a, folder, list, &outcome] {
    outcome.json = a->json;
    if (*list) return listVariants(a->json);
    if (!*folder) throw CLI::RequiredError("CASE");
    if (auto made = makeCase(*a); !made) refuse(outcome, made.error());
  });
}

}  // namespace insonate::cli
