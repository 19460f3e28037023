#pragma once

#include <insonate/procedure/AttemptHeader.h>
#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/views/Theme.h>

#include <QString>
#include <cstdint>
#include <optional>

namespace insonate::review {

/// "0:07.25"; minutes, seconds and hundredths.
QString clockOf(std::int64_t time_us);

/// Where the needle is, and the thesis's colour of it.
QString wordsOf(NeedlePlace place);
views::Colour colourOf(NeedlePlace place);

/// Of what went wrong; quiet where nothing did.
views::Colour colourOf(const std::optional<Severity>& severity);
QString wordsOf(Severity severity);

QString wordsOf(AttemptStatus status);
/// "20 Nov 2026, 14:05" in the user's time zone, of ISO 8601; as it is where it is none.
QString dateOf(const std::string& begun);
/// The procedure's title, or its id where it is not known.
QString titleOf(const AttemptHeader& header);

}  // namespace insonate::review
