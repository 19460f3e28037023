#pragma once

#include "record/Bytes.h"

#include <insonate/procedure/AttemptRecording.h>

#include <optional>

/// Encoding of a stretch (about a second of a recording) as bytes that zlib compresses well. Each channel is stored
/// separately, as its values, or as their first, second or higher differences if these are smaller. The lowest bytes of
/// all numbers of a channel come first, then the next bytes. Stretches are decoded independently.
namespace insonate::record {

/// Encodes a stretch of samples and events. Times of samples must not decrease, and must lie within an hour of each
/// other.
Bytes encoded(const RecordingSegment& segment);
/// Decodes a stretch of samples and events; empty if the bytes are invalid.
std::optional<RecordingSegment> decoded(std::span<const std::uint8_t> bytes);

}  // namespace insonate::record
