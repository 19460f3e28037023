#pragma once

#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptRecording.h>

#include <string>

namespace insonate {

/// AttemptFacts::handsHash: over all samples, then all events, in whole steps and bits as they are kept, without the
/// header and without where blocks begin. "": there is no event and nothing moved, which two attempts may have in
/// common. Fails where a block is damaged.
Result<std::string> handsHash(const AttemptRecording& recording);

}  // namespace insonate
