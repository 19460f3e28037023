#pragma once

#include "FovModel.h"
#include "Plate.h"

#include <vector>

namespace insonate::fit {

/// Models that some of the body's outline speaks for, many of them wrong. The same body gives the same guesses.
std::vector<FovModel> guessesFor(const Plate& plate);

}  // namespace insonate::fit
