#pragma once

#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptRecording.h>

#include <string>

namespace insonate {

/// Computes AttemptFacts::handsHash: hash over all samples, then all events, in their stored quantized form,
/// independent of the header and of the division into blocks. Returns "" if nothing moved and no event occurred, since
/// two such attempts may be equal by chance. Fails if a block is damaged.
Result<std::string> handsHash(const AttemptRecording& recording);

}  // namespace insonate
