#pragma once

#include <insonate/core/Result.h>

#include <string>

namespace insonate {

/// Refuses NaN and values outside low to high with the error "`what` is 41; allowed is -40 to 40."
Result<void> checkRange(double value, double low, double high, const std::string& what);

}  // namespace insonate
