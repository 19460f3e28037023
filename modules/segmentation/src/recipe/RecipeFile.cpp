#include "StepReader.h"
#include "StepWriter.h"

#include <insonate/core/Words.h>
#include <insonate/embedded/recipes.h>
#include <insonate/segmentation/Recipe.h>

namespace insonate {
namespace {

using nlohmann::json;
using segmentation::fields;
using segmentation::kToolNames;

/// What every step may have, beside its tool's fields.
template <class Io>
void commonFields(Io& io, LabelStep& s) {
  io("label", s.label);
  io("rest", s.rest);
  io("locked", s.locked);
  io("over", s.over);
  io("editable_HU", s.editable_HU);
  io("box_mm", s.box_mm);
}

/// The names of a step's fields.
struct FieldNames {
  std::vector<std::string_view> names{"tool", "comment"};
  template <class... Rest>
  void operator()(const char* key, Rest&&...) {
    names.emplace_back(key);
  }
};

template <std::size_t... N>
LabelTool toolOf(std::size_t index, std::index_sequence<N...>) {
  LabelTool tool;
  ((index == N ? void(tool.emplace<N>()) : void()), ...);
  return tool;
}

/// Tools that write several labels, or those that the CT gives, and need none.
bool needsLabel(const LabelTool& tool) {
  return !std::holds_alternative<step::Auto>(tool) && !std::holds_alternative<step::SmoothTogether>(tool) &&
         !std::holds_alternative<step::GrowSeeds>(tool) && !std::holds_alternative<step::Watershed>(tool);
}

LabelStep readStep(const json& object, const std::string& where, std::string& trouble) {
  LabelStep step;
  {
    // Which fields are known depends on the tool, which is asked for first.
    std::vector<std::string_view> any;
    if (object.is_object())
      for (const auto& [key, value] : object.items()) any.push_back(key);
    JsonEntry entry(object, where, any);
    step.tool = toolOf(entry.word("tool", {kToolNames.begin(), kToolNames.end()}),
                       std::make_index_sequence<std::variant_size_v<LabelTool>>());
    trouble = entry.trouble();
  }
  if (!trouble.empty()) return step;
  const std::string tool = where + " (" + std::string(nameOf(step.tool)) + ")";
  FieldNames known;
  commonFields(known, step);
  std::visit([&](auto& parameters) { fields(known, parameters); }, step.tool);
  segmentation::StepReader reader(object, tool, known.names);
  commonFields(reader, step);
  std::visit([&](auto& parameters) { fields(reader, parameters); }, step.tool);
  if (needsLabel(step.tool) && !object.contains("label")) reader.refuse("has no 'label': name the one it is for.");
  trouble = reader.trouble();
  return step;
}

}  // namespace

Result<Recipe> readRecipe(std::string_view text) {
  json file;
  try {
    file = json::parse(text);
  } catch (const json::exception& e) {
    return fail("The recipe is not JSON: " + jsonTrouble(e.what()));
  }
  JsonEntry entry(file, "The recipe", {"description", "steps"});
  Recipe recipe;
  recipe.description = entry.text("description", false);
  recipe.steps = entry.list("steps", "step", readStep);
  if (entry.trouble().empty() && recipe.steps.empty()) entry.refuse("has no steps in its list 'steps'.");
  if (!entry.trouble().empty()) return fail(entry.trouble());
  return recipe;
}

std::string textOf(const Recipe& recipe) {
  json steps = json::array();
  for (LabelStep step : recipe.steps) {
    json object{{"tool", nameOf(step.tool)}};
    segmentation::StepWriter writer(object);
    commonFields(writer, step);
    std::visit([&](auto& parameters) { fields(writer, parameters); }, step.tool);
    if (!needsLabel(step.tool)) object.erase("label");
    steps.push_back(std::move(object));
  }
  json file{{"steps", std::move(steps)}};
  if (!recipe.description.empty()) file["description"] = recipe.description;
  return file.dump(2, ' ', false, json::error_handler_t::replace) + '\n';
}

const std::vector<Preset>& recipePresets() {
  static const std::vector<Preset> kPresets = presetsOf(embedded::recipes::files());
  return kPresets;
}

Result<Recipe> loadRecipe(std::string_view nameOrPath) {
  const auto source = presetOrFile("a recipe", nameOrPath, recipePresets());
  if (!source) return tl::unexpected(source.error());
  auto recipe = readRecipe(source->text);
  if (!recipe) return fail(source->where + recipe.error().message);
  return recipe;
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
