#pragma once

#include <string>
#include <string_view>

namespace insonate {

/// Returns a valid DICOM UID (2.25.*, from a name-based UUID, RFC 4122 version 3) that depends only on `text` and does
/// not reveal it.
std::string derivedUid(std::string_view text);

}  // namespace insonate
