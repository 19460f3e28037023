#pragma once

#include "StepReader.h"

namespace insonate::segmentation {

/// Reads a step of a recipe from its JSON object; an error is left in `trouble`.
LabelStep readStep(const nlohmann::json& object, const std::string& where, std::string& trouble,
                   Points points = Points::kGiven);

/// Inverse of readStep().
nlohmann::json jsonOf(LabelStep step);

}  // namespace insonate::segmentation
