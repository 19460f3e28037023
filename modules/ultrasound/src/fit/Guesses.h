#pragma once

#include "FovModel.h"
#include "Plate.h"

#include <vector>

namespace insonate::fit {

/// Returns models that agree with a part of the body's outline; many of them are wrong. The same body gives the same
/// guesses.
std::vector<FovModel> guessesFor(const Plate& plate);

}  // namespace insonate::fit
