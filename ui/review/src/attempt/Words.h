#pragma once

#include <insonate/procedure/AttemptHeader.h>

#include <QString>
#include <cstdint>

namespace insonate::review {

/// "0:07.25"; minutes, seconds and hundredths.
QString clockOf(std::int64_t time_us);

/// "completed", "abandoned", "abandoned: its recording broke off".
QString wordsOf(AttemptStatus status);
/// "20 Nov 2026, 14:05" in the user's time zone, of ISO 8601; as it is where it is none.
QString dateOf(const std::string& begun);
/// The procedure's title, or its id where it is not known.
QString titleOf(const AttemptHeader& header);

}  // namespace insonate::review
