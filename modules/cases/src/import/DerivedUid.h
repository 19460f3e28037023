#pragma once

#include <string>
#include <string_view>

namespace insonate {

/// A valid DICOM UID (2.25.*, from a name-based UUID, RFC 4122 version 3) that depends on `text` alone and does not
/// show it.
std::string derivedUid(std::string_view text);

}  // namespace insonate
