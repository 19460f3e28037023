#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the published curricula, and a form that publishes a file or a built-in curriculum. For instructors and
/// administrators.
Response showCurricula(const Visit& visit, const Parts& parts);
/// Publishes a curriculum if its levels name only cases, procedures and metrics that this server knows.
Response publishCurriculum(const Visit& visit, const Parts& parts);
/// Shows the levels of a published version; parts: name and version.
Response showCurriculum(const Visit& visit, const Parts& parts);
/// Sends a published version as a JSON file, from which the next version can be made.
Response downloadCurriculum(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
