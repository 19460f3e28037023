#pragma once

#include <string>

namespace insonate {

/// A password to hand over, by chance: 12 of 31 letters and digits that are not taken for one another, 59 bits, in
/// groups of four.
std::string firstPassword();

}  // namespace insonate
