#pragma once

#include "page/Page.h"
#include "person/PersonReading.h"

namespace insonate::web {

/// Returns the section with a person's attempts, newest first, 100 on a page, with links to earlier ones. "attempts" in
/// the query: the level (Level::name) whose attempts are listed, "" for free practice, "*" or missing for all;
/// "before": the number (StoredAttempt::arrival) that precedes the page.
Result<Markup> attemptSection(const Visit& visit, const PersonFacts& facts);

/// Returns hidden fields with the parts of the query that choose the listed attempts, for other forms of the page.
Markup attemptFields(const Visit& visit);

}  // namespace insonate::web
