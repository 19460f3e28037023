#pragma once

#include <insonate/core/Preset.h>
#include <insonate/segmentation/LabelStep.h>
#include <insonate/tissue/OwnLabels.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// A repeatable sequence of labeling steps. The same CT, labels and recipe give the same result on any number of
/// threads.
struct Recipe {
  std::string description;
  std::vector<LabelStep> steps;
  OwnLabels labels{};  ///< labels that the author has defined and that the steps use
};

/// Reads a recipe from a JSON object with `steps` and optionally a `description` and the `labels` that the author has
/// defined. A step contains its `tool` and the parameters of the tool. A missing parameter has its default; missing
/// points are an error. Fails with a sentence that states the step, the error and the possible values.
Result<Recipe> readRecipe(std::string_view text);

/// Writes a recipe as text that readRecipe() reads.
std::string textOf(const Recipe& recipe);

/// Returns the recipes that are compiled into the program.
const std::vector<Preset>& recipePresets();

/// Loads a recipe: one that is compiled into the program, by name, or a file, by path.
Result<Recipe> loadRecipe(std::string_view nameOrPath);

/// Performs all steps and returns the change by each step. If a step fails, the sentence states its number and tool;
/// the changes of the steps before it remain and can be undone one by one.
Result<std::vector<LabelChange>> perform(const Recipe& recipe, LabelEdit& edit, const Progress& progress = {});

}  // namespace insonate
