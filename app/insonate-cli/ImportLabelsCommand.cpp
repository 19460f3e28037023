#include "Commands.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/LabelFile.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/cases/StructureSet.h>
#include <insonate/tissue/Labels.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

using nlohmann::json;

struct ImportLabelsArguments {
  std::string caseFolder, file, names;
  std::vector<std::string> only;
  bool ours = false, replace = false, list = false, json = false;
};

Result<std::vector<ListedStructure>> structuresIn(const std::string& file) {
  if (!isStructureSet(file))
    return fail(file + " is not a complete RT Structure Set. Only its structures can be listed and chosen.");
  return listStructures(file);
}

Result<void> listStructuresOf(const ImportLabelsArguments& a) {
  const auto structures = structuresIn(a.file);
  if (!structures) return tl::unexpected(structures.error());
  json rows = json::array();
  for (const ListedStructure& s : *structures) {
    if (!a.json)
      std::printf("%6d  %6zu contours  %-14s  %-10s  %s\n", s.number, s.contours, s.algorithm.c_str(), s.type.c_str(),
                  s.name.c_str());
    rows.push_back({{"number", s.number},
                    {"name", s.name},
                    {"contours", s.contours},
                    {"other_contours", s.otherContours},
                    {"algorithm", s.algorithm},
                    {"type", s.type}});
  }
  if (a.json) printJson({{"structures", rows}});
  return {};
}

/// Numbers of the structures that were chosen by name or number. Several structures may have the same name.
Result<std::vector<std::int32_t>> chosenNumbers(const ImportLabelsArguments& a) {
  const auto structures = structuresIn(a.file);
  if (!structures) return tl::unexpected(structures.error());
  std::vector<std::int32_t> numbers;
  for (const std::string& name : a.only) {
    const std::size_t before = numbers.size();
    for (const ListedStructure& s : *structures)
      if (s.name == name || std::to_string(s.number) == name) numbers.push_back(s.number);
    if (numbers.size() == before)
      return fail(a.file + " contains no structure \"" + name + "\". --list prints the names of its structures.");
  }
  return numbers;
}

Result<LabelReadResult> readLabels(const ImportLabelsArguments& a, const PatientCase& patient) {
  if (a.only.empty()) return importLabels(patient, a.file, {a.names, a.ours}, terminalProgress());
  const auto numbers = chosenNumbers(a);
  if (!numbers) return tl::unexpected(numbers.error());
  return readStructureSet(patient, a.file, *numbers, terminalProgress());
}

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

Result<void> importLabelsInto(const ImportLabelsArguments& a) {
  auto read = readCase(a.caseFolder);
  if (!read) return tl::unexpected(read.error());
  PatientCase& patient = read->patient;
  const bool labeled = std::ranges::any_of(patient.labels.voxels, [](std::uint8_t label) { return label != 0; });
  if (labeled && !a.replace)
    return fail("The case " + a.caseFolder + " already has labels. Add --replace to replace them.");
  auto imported = readLabels(a, patient);
  if (!imported) return tl::unexpected(imported.error());
  for (const std::string& note : imported->notes) std::cerr << "note: " << note << '\n';
  replaceLabels(std::move(*imported), patient);
  if (auto version = saveCaseVersion(patient, a.caseFolder, today(), {}, terminalProgress()); !version)
    return tl::unexpected(version.error());
  const json rows = structuresOf(patient.labels, !a.json);
  printNextSteps(a.caseFolder);
  if (a.json) printJson({{"case", a.caseFolder}, {"structures", rows}, {"notes", imported->notes}});
  return {};
}

}  // namespace

void addImportLabelsCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand("import-labels", "Replace a case's labels by those of another program");
  auto a = std::make_shared<ImportLabelsArguments>();
  command->add_option("CASE", a->caseFolder, "Folder of the case")->required()->check(notEmpty());
  command
      ->add_option("FILE", a->file,
                   "DICOM segmentation or RT Structure Set, .seg.nrrd, or a label map (NRRD, NIfTI, MetaImage)")
      ->required()
      ->check(notEmpty());
  auto* names = command->add_option("--names", a->names,
                                    "Names of the label map's numbers: label description of ITK-SNAP, color table of "
                                    "3D Slicer (.ctbl), or JSON of dcmqi or nnU-Net");
  names->check(notEmpty());
  auto* ours = command->add_flag("--ours", a->ours, "The numbers of the label map are Insonate's label numbers");
  ours->excludes(names);
  command
      ->add_option("--only", a->only,
                   "Names or numbers of the structures of an RT Structure Set to read, with commas between")
      ->delimiter(',')
      ->check(notEmpty())
      ->excludes(names)
      ->excludes(ours);
  command->add_flag("--list", a->list, "List the structures of an RT Structure Set and stop");
  command->add_flag("--replace", a->replace, "Replace the labels of the case");
  command->add_flag("--json", a->json, "Print one JSON object");
  command->callback([a, &outcome] {
    outcome.json = a->json;
    if (auto done = a->list ? listStructuresOf(*a) : importLabelsInto(*a); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
