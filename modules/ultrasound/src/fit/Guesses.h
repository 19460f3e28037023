#pragma once

#include "FovModel.h"
#include "Plate.h"

#include <vector>

namespace insonate::fit {

/// Returns models of the field of view that agree with a part of the body's outline; many of them are wrong. The same
/// body gives the same models.
std::vector<FovModel> guessesFor(const Plate& plate);

}  // namespace insonate::fit
