#pragma once

#include <insonate/core/Preset.h>
#include <insonate/segmentation/LabelStep.h>
#include <insonate/tissue/OwnLabels.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Steps of labelling, to be replayed: the same CT, labels and recipe give the same voxels, on any number of threads.
struct Recipe {
  std::string description;
  std::vector<LabelStep> steps;
  OwnLabels labels{};  ///< what numbers mean that steps name and the label table does not know
};

/// Reads a JSON object with `steps` and optionally a `description` and the author's own `labels`. A step names its
/// `tool` and that tool's parameters; missing ones take their defaults, missing points are none. Fails with the step,
/// the error in it, and the possible values.
Result<Recipe> readRecipe(std::string_view text);

/// Inverse of readRecipe().
std::string textOf(const Recipe& recipe);

/// Recipes that are compiled in.
const std::vector<Preset>& recipePresets();

/// One of these by name, else a file.
Result<Recipe> loadRecipe(std::string_view nameOrPath);

/// Performs all steps and returns what each has changed. Where one fails, its number and tool are in the sentence;
/// those before it stay, each to be undone.
Result<std::vector<LabelChange>> perform(const Recipe& recipe, LabelEdit& edit, const Progress& progress = {});

}  // namespace insonate
