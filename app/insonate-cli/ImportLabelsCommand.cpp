#include "Commands.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/LabelFile.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/simulator/ImportedLabels.h>
#include <insonate/tissue/Labels.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

using nlohmann::json;

struct ImportLabelsArguments {
  std::string caseFolder, names;
  std::vector<std::string> sources, sides, taken, leftOut, only;
  bool ours = false, replace = false, json = false, list = false, autoLabel = false, onlyImported = false;
};

json structuresOf(const LabelMap& labels, bool print) {
  std::array<std::size_t, 256> voxels{};
  for (const std::uint8_t label : labels.voxels) ++voxels[label];
  json rows = json::array();
  for (int label = 1; label < 256; ++label) {
    if (voxels[label] == 0) continue;
    const std::string name = labelName(static_cast<std::uint8_t>(label));
    if (print) std::printf("%10zu voxels  %s\n", voxels[label], name.c_str());
    rows.push_back({{"label", label}, {"name", name}, {"voxels", voxels[label]}});
  }
  return rows;
}

std::string wordOf(StructureState state) {
  switch (state) {
    case StructureState::kTaken:
      return "read";
    case StructureState::kLeftOut:
      return "left out";
    case StructureState::kEmpty:
      return "empty";
    case StructureState::kDoubtful:
      return "doubtful side";
  }
  return {};
}

/// Name in the file, its meaning here, and what becomes of it.
json mappingOf(const std::vector<ReadStructure>& structures, bool print) {
  json rows = json::array();
  for (const ReadStructure& one : structures) {
    const std::string label = one.label == 0 ? "-" : labelName(one.label), state = wordOf(one.state);
    if (print)
      std::printf("%-36s %-20s %-32s %10zu voxels  %s%s\n", one.key().c_str(), label.c_str(), one.vessel.c_str(),
                  one.voxels, state.c_str(), one.details.empty() ? "" : ("; " + one.details).c_str());
    rows.push_back({{"number", one.number},
                    {"name_in_file", one.name},
                    {"label", label},
                    {"vessel", one.vessel},
                    {"voxels", one.voxels},
                    {"details", one.details},
                    {"state", state}});
  }
  return rows;
}

/// "NAME=left"
Result<void> addSide(const std::string& text, StructureChoices& choices) {
  const std::size_t at = text.rfind('=');
  const std::string side = at == std::string::npos ? "" : text.substr(at + 1);
  if (side != "left" && side != "right" && side != "both")
    return fail("--side " + text + " states no side. Write --side NAME=left, right or both.");
  choices.sides[text.substr(0, at)] = side == "left"    ? SideAnswer::Left
                                      : side == "right" ? SideAnswer::Right
                                                        : SideAnswer::Both;
  return {};
}

Result<StructureChoices> choicesOf(const ImportLabelsArguments& a) {
  StructureChoices choices;
  for (const std::string& side : a.sides)
    if (auto ok = addSide(side, choices); !ok) return tl::unexpected(ok.error());
  for (const std::string& name : a.taken) choices.taken[name] = true;
  for (const std::string& name : a.leftOut) choices.taken[name] = false;
  choices.only.insert(a.only.begin(), a.only.end());
  return choices;
}

/// A name that no structure has is a slip of the pen.
Result<void> checkChoices(const StructureChoices& choices, const std::vector<ReadStructure>& structures) {
  const auto isThere = [&structures](const std::string& key) {
    return std::ranges::find(structures, key, &ReadStructure::key) != structures.end();
  };
  const auto isNumber = [&structures](const std::string& key) {
    return std::ranges::any_of(structures, [&](const auto& one) { return std::to_string(one.number) == key; });
  };
  for (const std::string& key : choices.only)
    if (!isThere(key) && !isNumber(key))
      return fail("There is no structure \"" + key + "\". List the structures with --list.");
  for (const auto& [key, taken] : choices.taken)
    if (!isThere(key)) return fail("There is no structure \"" + key + "\". List the structures with --list.");
  for (const auto& [key, side] : choices.sides)
    if (!isThere(key)) return fail("There is no structure \"" + key + "\". List the structures with --list.");
  return {};
}

Result<void> checkDoubts(const std::vector<ReadStructure>& structures) {
  if (std::ranges::all_of(structures, [](const auto& one) { return one.state == StructureState::kLeftOut; }))
    return fail("No structure is read. List the structures with --list, and name those to read with --take NAME.");
  std::string doubts;
  for (const ReadStructure& one : structures)
    if (one.state == StructureState::kDoubtful) doubts += one.doubt + " ";
  if (doubts.empty()) return {};
  return fail(doubts + "State the side with --side NAME=left, right or both.");
}

/// Labels of the CT beside the imported structures, if they are asked for or if there would be no skin.
Result<void> addRest(const ImportLabelsArguments& a, const PatientCase& patient, bool isLabeled,
                     LabelReadResult& imported) {
  const bool byItself = !isLabeled && !a.onlyImported && needsRest(imported);
  if (!a.autoLabel && !byItself) return {};
  auto done = labelRest(patient.ct, imported, terminalProgress());
  if (done || a.autoLabel || done.error().message == kCancelled) return done;
  imported.notes.push_back("The rest of the CT was not labeled: " + done.error().message);
  return {};
}

/// Returns the labels of the sources; no doubts are left.
Result<LabelReadResult> readSources(const ImportLabelsArguments& a, const PatientCase& patient) {
  auto choices = choicesOf(a);
  if (!choices) return tl::unexpected(choices.error());
  const std::vector<std::filesystem::path> sources(a.sources.begin(), a.sources.end());
  const NumberMeaning meaning{a.names, a.ours, *choices};
  auto imported = importLabelsTogether(patient, sources, meaning, terminalProgress());
  if (!imported) return imported;
  if (auto ok = checkChoices(*choices, imported->structures); !ok) return tl::unexpected(ok.error());
  return imported;
}

Result<void> importLabelsInto(const ImportLabelsArguments& a) {
  auto read = readCase(a.caseFolder);
  if (!read) return tl::unexpected(read.error());
  PatientCase& patient = read->patient;
  const bool isLabeled = std::ranges::any_of(patient.labels.voxels, [](std::uint8_t label) { return label != 0; });
  if (isLabeled && !a.replace && !a.list)
    return fail("The case " + a.caseFolder + " already has labels. Add --replace to replace them.");
  auto imported = readSources(a, patient);
  if (!imported) return tl::unexpected(imported.error());
  const json mapping = mappingOf(imported->structures, !a.json);
  const std::vector<std::string> missing = missingForLines(imported->structures);
  json object{{"case", a.caseFolder}, {"mapping", mapping}, {"missing", missing}};
  if (!a.list) {
    if (auto ok = checkDoubts(imported->structures); !ok) return ok;
    if (auto ok = makeImportedVessels(*imported, terminalProgress()); !ok) return ok;
    if (auto ok = addRest(a, patient, isLabeled, *imported); !ok) return ok;
  }
  for (const std::string& note : imported->notes) std::cerr << "note: " << note << '\n';
  for (const std::string& sentence : missing) std::cerr << "note: " << sentence << '\n';
  object["notes"] = imported->notes;
  if (!a.list) {
    replaceLabels(std::move(*imported), patient);
    if (auto version = saveCaseVersion(patient, a.caseFolder, today(), {}, terminalProgress()); !version)
      return tl::unexpected(version.error());
    object["structures"] = structuresOf(patient.labels, !a.json);
    json vessels = json::array();
    for (const NamedVessel& vessel : patient.manifest.vessels) vessels.push_back(vessel.name);
    object["vessels"] = vessels;
    printNextSteps(a.caseFolder);
  }
  if (a.json) printJson(std::move(object));
  return {};
}

}  // namespace

void addImportLabelsCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand("import-labels", "Replace a case's labels by those of another program");
  auto a = std::make_shared<ImportLabelsArguments>();
  command->add_option("CASE", a->caseFolder, "Folder of the case")->required()->check(notEmpty());
  command
      ->add_option("FILE", a->sources,
                   "DICOM segmentation, RT Structure Set, .seg.nrrd, label map or mask (NRRD, NIfTI, MetaImage), or a "
                   "folder of masks; "
                   "several files and folders of one patient are combined")
      ->required()
      ->check(notEmpty());
  auto* names = command->add_option("--names", a->names,
                                    "Names of the label map's numbers: label description of ITK-SNAP, color table of "
                                    "3D Slicer (.ctbl), or JSON of dcmqi, nnU-Net or MONAI");
  names->check(notEmpty());
  command->add_flag("--ours", a->ours, "The numbers of the label map are Insonate's label numbers")->excludes(names);
  command->add_flag("--list", a->list, "Print how each structure would be read, and change nothing");
  command->add_option("--side", a->sides, "Side of a vessel whose side is doubtful: NAME=left, right or both")
      ->allow_extra_args(false);
  command->add_option("--take", a->taken, "Read a structure that would be left out, as a label of its own")
      ->allow_extra_args(false);
  command->add_option("--leave-out", a->leftOut, "Do not read the structure with this name")->allow_extra_args(false);
  command->add_option("--only", a->only, "Names or numbers of the structures to read, with commas between")
      ->delimiter(',')
      ->check(notEmpty());
  auto* automatic =
      command->add_flag("--auto-label", a->autoLabel,
                        "Label skin, air, bone, fat and muscle from the CT; this is the default for a case without "
                        "labels if the files contain no skin");
  command->add_flag("--only-imported", a->onlyImported, "Label nothing but the imported structures")
      ->excludes(automatic);
  command->add_flag("--replace", a->replace, "Replace the labels of the case");
  command->add_flag("--json", a->json, "Print one JSON object");
  command->callback([a, &outcome] {
    outcome.json = a->json;
    if (auto done = importLabelsInto(*a); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
