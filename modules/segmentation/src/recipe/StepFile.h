#pragma once

#include "StepReader.h"

namespace insonate::segmentation {

/// Reads a step of a recipe from its JSON object; stores the first error in `error`.
LabelStep readStep(const nlohmann::json& object, const std::string& where, std::string& error,
                   Points points = Points::kGiven);

/// Writes a step as a JSON object that readStep() reads.
nlohmann::json jsonOf(LabelStep step);

}  // namespace insonate::segmentation
