#pragma once

#include <insonate/procedure/AttemptHeader.h>

#include <QString>
#include <cstdint>

namespace insonate::review {

/// "0:07.25"; minutes, seconds and hundredths.
QString clockOf(std::int64_t time_us);

/// "completed", "abandoned", "abandoned: its recording broke off".
QString wordsOf(AttemptStatus status);
/// Formats ISO 8601 as "20 Nov 2026, 14:05" in the user's time zone; other text is returned unchanged.
QString dateOf(const std::string& begun);
/// The procedure's title, or its id if it is unknown.
QString titleOf(const AttemptHeader& header);

}  // namespace insonate::review
