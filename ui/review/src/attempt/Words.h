#pragma once

#include <insonate/procedure/AttemptHeader.h>

#include <QString>
#include <cstdint>

namespace insonate::review {

/// Formats a time as minutes, seconds and hundredths: "0:07.25".
QString clockOf(std::int64_t time_us);

/// Returns "completed", "abandoned" or "abandoned: the recording stopped early".
QString displayText(AttemptStatus status);
/// Names the hands that moved probe and needle, e.g. "probe: camera, needle: mouse and keys"; empty if they are
/// unknown.
QString displayText(const HandKinds& hands);
/// Formats ISO 8601 as "20 Nov 2026, 14:05" in the user's time zone; other text is returned unchanged.
QString dateOf(const std::string& begun);
/// Returns the procedure's title, or its id if the procedure is unknown.
QString titleOf(const AttemptHeader& header);

}  // namespace insonate::review
