#pragma once

#include "record/Bytes.h"

#include <insonate/procedure/AttemptRecording.h>

#include <optional>

/// Encodes a stretch as bytes that zlib packs well. Each channel is stored separately, as differences of the order that
/// gives the smallest numbers, lowest bytes first. Decoding needs no other stretch.
namespace insonate::record {

/// Encodes a stretch. Times of samples must not decrease, and must lie within an hour of each other.
Bytes encoded(const Stretch& stretch);
/// Decodes a stretch; empty if the bytes are not a stretch.
std::optional<Stretch> decoded(std::span<const std::uint8_t> bytes);

}  // namespace insonate::record
