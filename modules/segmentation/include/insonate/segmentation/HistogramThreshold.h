#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace insonate {

/// Returns the threshold of a histogram by Otsu's method, which maximizes the variance between the two classes and
/// minimizes the variance within them. The result is the index of the bin whose lower edge is the threshold; no value
/// if fewer than two bins are filled. Takes microseconds.
std::optional<std::size_t> otsuBin(std::span<const std::uint64_t> counts);

}  // namespace insonate
