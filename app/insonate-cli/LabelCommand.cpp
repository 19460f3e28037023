#include "Commands.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/LabelFile.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/segmentation/Guide.h>
#include <insonate/segmentation/Recipe.h>
#include <insonate/segmentation/Score.h>
#include <insonate/simulator/VesselNaming.h>
#include <insonate/tissue/Labels.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct LabelArguments {
  std::string folder, recipe, outFolder, truth;
  bool list = false, asJson = false;
};

void listRecipes(bool asJson) {
  json rows = json::array();
  for (const Preset& preset : recipePresets()) {
    const auto recipe = loadRecipe(preset.name);
    const std::string description = recipe ? recipe->description : "";
    rows.push_back({{"name", preset.name}, {"description", description}});
    if (!asJson) std::printf("%-16s %s\n", std::string(preset.name).c_str(), description.c_str());
  }
  if (asJson) printJson({{"recipes", rows}});
}

json toJson(const Recipe& recipe, const std::vector<LabelChange>& changes) {
  json steps = json::array();
  for (std::size_t n = 0; n < changes.size(); ++n)
    steps.push_back({{"tool", nameOf(recipe.steps[n].tool)}, {"voxels", changes[n].voxels}});
  return steps;
}

/// A case's labels or a label map by itself.
Result<LabelMap> readTruth(const fs::path& path) {
  if (fs::is_directory(path)) {
    auto patient = readCase(path);
    if (!patient) return tl::unexpected(patient.error());
    return std::move(patient->patient.labels);
  }
  auto labels = readLabelMap(path);
  if (!labels) return tl::unexpected(labels.error());
  return std::move(labels->labels);
}

Result<json> score(const LabelMap& found, const LabelArguments& a) {
  const auto truth = readTruth(a.truth);
  if (!truth) return tl::unexpected(truth.error());
  const auto scores = scoreLabels(found, *truth, {}, terminalProgress());
  if (!scores) return tl::unexpected(scores.error());
  json rows = json::array();
  if (!a.asJson) std::printf("%-20s %7s %16s %16s\n", "label", "dice", "mean surface mm", "95 % surface mm");
  for (const LabelScore& s : *scores) {
    rows.push_back({{"label", labelName(s.label)},
                    {"voxels", s.voxels},
                    {"true_voxels", s.trueVoxels},
                    {"dice", s.dice},
                    {"mean_surface_mm", s.meanSurface_mm ? json(*s.meanSurface_mm) : json(nullptr)},
                    {"p95_surface_mm", s.p95Surface_mm ? json(*s.p95Surface_mm) : json(nullptr)}});
    if (a.asJson) continue;
    std::printf("%-20s %7.3f", labelName(s.label).c_str(), s.dice);
    if (s.meanSurface_mm) std::printf(" %16.2f %16.2f", *s.meanSurface_mm, *s.p95Surface_mm);
    std::printf("\n");
  }
  return rows;
}

/// The guide's steps say which vessels they label.
Result<void> nameVessels(const Recipe& recipe, PatientCase& patient) {
  for (const Preset& preset : guidePresets()) {
    const auto guide = readGuide(preset.text);
    if (!guide) return tl::unexpected(guide.error());
    auto vessels = vesselsFromGuide(*guide, recipe, patient.labels, patient.manifest.ownLabels, terminalProgress());
    if (!vessels) return tl::unexpected(vessels.error());
    for (NamedVessel& vessel : *vessels) addOrReplaceVessel(std::move(vessel), patient.manifest.vessels);
  }
  return {};
}

Result<void> label(const LabelArguments& a) {
  const std::string target = a.outFolder.empty() ? a.folder : a.outFolder;
  if (!a.recipe.empty())
    if (auto ok = checkCaseTarget(target, a.outFolder.empty()); !ok) return ok;
  auto read = readCase(a.folder);
  if (!read) return tl::unexpected(read.error());
  for (const std::string& note : read->notes) std::cerr << "note: " << note << '\n';
  PatientCase& patient = read->patient;
  json object{{"case", target}};
  if (!a.recipe.empty()) {
    const auto recipe = loadRecipe(a.recipe);
    if (!recipe) return tl::unexpected(recipe.error());
    LabelEdit edit(patient.ct, patient.labels);
    const auto changes = perform(*recipe, edit, terminalProgress());
    if (!changes) return tl::unexpected(changes.error());
    // The case's name of a label takes precedence over the recipe's.
    patient.manifest.ownLabels.insert(recipe->labels.begin(), recipe->labels.end());
    object["steps"] = toJson(*recipe, *changes);
    if (auto named = nameVessels(*recipe, patient); !named) return named;
  }
  if (!a.truth.empty()) {
    auto rows = score(patient.labels, a);
    if (!rows) return tl::unexpected(rows.error());
    object["scores"] = std::move(*rows);
  }
  if (!a.recipe.empty()) {
    const auto version = saveCaseVersion(patient, target, today(), {}, terminalProgress());
    if (!version) return tl::unexpected(version.error());
    object["case_version"] = version->number;
    printNextSteps(target);
  }
  if (a.asJson) printJson(std::move(object));
  return {};
}

}  // namespace

void addLabelCommand(CLI::App& app, Outcome& outcome) {
  auto* command =
      app.add_subcommand("label", "Label a case by a recipe of steps, or compare its labels with reference labels");
  auto a = std::make_shared<LabelArguments>();
  auto* folder = command->add_option("CASE", a->folder, "Folder of the case")->check(notEmpty());
  auto* recipe =
      command->add_option("RECIPE", a->recipe, "Name of a recipe (see --list), or a JSON file")->check(notEmpty());
  command->add_option("--out", a->outFolder, "Write the labeled case here and leave CASE unchanged")
      ->check(notEmpty())
      ->needs(recipe);
  auto* truth = command->add_option("--score", a->truth, "Reference to compare the labels with: a case or a label map")
                    ->check(notEmpty());
  auto* list = command->add_flag("--list", a->list, "List the recipes and stop");
  folder->excludes(list);
  command->add_flag("--json", a->asJson, "Print one JSON object");
  command->callback([a, folder, recipe, truth, list, &outcome] {
    outcome.json = a->asJson;
    if (*list) return listRecipes(a->asJson);
    if (!*folder) throw CLI::RequiredError("CASE");
    if (!*recipe && !*truth) throw CLI::RequiredError("RECIPE (or --score)");
    if (auto done = label(*a); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
