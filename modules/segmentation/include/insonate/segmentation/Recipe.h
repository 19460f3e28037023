#pragma once

#include <insonate/core/Preset.h>
#include <insonate/segmentation/LabelStep.h>
#include <insonate/tissue/OwnLabels.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// A sequence of labeling steps that can be repeated: the same CT, labels and recipe give the same voxels, on any
/// number of threads.
struct Recipe {
  std::string description;
  std::vector<LabelStep> steps;
  OwnLabels labels{};  ///< the author's own labels that steps refer to
};

/// Reads a JSON object with `steps` and optionally a `description` and the author's own `labels`. A step names its
/// `tool` and the tool's parameters. Missing parameters take their defaults; missing points are an error. Fails with
/// the step, the error in it, and the possible values.
Result<Recipe> readRecipe(std::string_view text);

/// Writes a recipe as text that readRecipe() reads.
std::string textOf(const Recipe& recipe);

/// Returns the recipes that are compiled in.
const std::vector<Preset>& recipePresets();

/// Loads a compiled-in recipe by name, else a file.
Result<Recipe> loadRecipe(std::string_view nameOrPath);

/// Performs all steps and returns the change made by each. If a step fails, the sentence contains its number and tool;
/// the steps before it are kept and can be undone one by one.
Result<std::vector<LabelChange>> perform(const Recipe& recipe, LabelEdit& edit, const Progress& progress = {});

}  // namespace insonate
