#include "StepFile.h"

#include <insonate/embedded/recipes.h>
#include <insonate/segmentation/Recipe.h>

#include <utility>

namespace insonate {

using nlohmann::json;

namespace {

std::pair<std::uint8_t, OwnLabel> readOwnLabel(const json& object, const std::string& where, std::string& error) {
  JsonEntry entry(object, where, {"label", "name", "tissue"}, error);
  const auto label = static_cast<std::uint8_t>(entry.integer("label", kLabelCount, kLastOwnLabel));
  const std::string name = tidyLabelName(entry.text("name", false)), tissue = entry.text("tissue", false);
  const auto made = tissue.empty() ? kSoftTissue : labelFromName(tissue);
  if (!made || *made == kBackground)
    entry.setError("needs a structure of the label table as 'tissue', not '" + tissue + "'.");
  return {label, {name, made.value_or(kSoftTissue)}};
}

json jsonOf(const OwnLabels& labels) {
  json list = json::array();
  for (const auto& [label, own] : labels) {
    list.push_back({{"label", label}, {"tissue", labelTable()[own.tissue].name}});
    if (!own.name.empty()) list.back()["name"] = own.name;
  }
  return list;
}

}  // namespace

Result<Recipe> readRecipe(std::string_view text) {
  const auto file = parsedJson(text, "The recipe");
  if (!file) return tl::unexpected(file.error());
  JsonEntry entry(*file, "The recipe", {"description", "labels", "steps"});
  Recipe recipe;
  recipe.description = entry.text("description", false);
  for (auto& [label, own] : entry.list("labels", "label", readOwnLabel)) recipe.labels[label] = std::move(own);
  recipe.steps = entry.list("steps", "step", [](const json& object, const std::string& where, std::string& error) {
    return segmentation::readStep(object, where, error);
  });
  if (entry.error().empty() && recipe.steps.empty()) entry.setError("has no steps in its list 'steps'.");
  if (!entry.error().empty()) return fail(entry.error());
  return recipe;
}

std::string textOf(const Recipe& recipe) {
  json steps = json::array();
  for (const LabelStep& step : recipe.steps) steps.push_back(segmentation::jsonOf(step));
  json file{{"steps", std::move(steps)}};
  if (!recipe.labels.empty()) file["labels"] = jsonOf(recipe.labels);
  if (!recipe.description.empty()) file["description"] = recipe.description;
  return file.dump(2, ' ', false, json::error_handler_t::replace) + '\n';
}

const std::vector<Preset>& recipePresets() {
  static const std::vector<Preset> kPresets = embeddedPresets(embedded::recipes::files());
  return kPresets;
}

Result<Recipe> loadRecipe(std::string_view nameOrPath) {
  return presetOrFile("a recipe", nameOrPath, recipePresets(), readRecipe);
}

Result<std::vector<LabelChange>> perform(const Recipe& recipe, LabelEdit& edit, const Progress& progress) {
  std::vector<LabelChange> changes;
  const auto count = double(recipe.steps.size());
  for (const LabelStep& step : recipe.steps) {
    const auto done = double(changes.size());
    const auto change = perform(step, edit, [&](std::string_view doing, double fraction) {
      return report(progress, doing, (done + fraction) / count);
    });
    if (change) {
      changes.push_back(*change);
      continue;
    }
    if (change.error().message == kCancelled) return tl::unexpected(change.error());
    return fail("Step " + std::to_string(changes.size() + 1) + " (" + std::string(nameOf(step.tool)) +
                ") of the recipe could not be done: " + change.error().message);
  }
  return changes;
}

}  // namespace insonate
