#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace insonate {

/// The bin at whose lower edge a histogram parts best in two, by Otsu's method: so that the classes differ most from
/// each other and least within themselves. None where fewer than two bins are filled. Takes microseconds.
std::optional<std::size_t> otsuBin(std::span<const std::uint64_t> counts);

}  // namespace insonate
