#pragma once

#include "record/Bytes.h"

#include <insonate/procedure/AttemptRecording.h>

#include <optional>

/// A stretch as bytes that a general packer makes small: each channel by itself, as differences of the order that
/// leaves the smallest numbers, lowest bytes first. Needs nothing of other stretches.
namespace insonate::record {

/// Times of samples do not fall, and lie within an hour of each other.
Bytes encoded(const Stretch& stretch);
/// Decodes a stretch; empty if the bytes are not one.
std::optional<Stretch> decoded(std::span<const std::uint8_t> bytes);

}  // namespace insonate::record
