#pragma once

#include "page/Page.h"

#include <insonate/curriculum/AttemptStore.h>

namespace insonate::web {

/// Content-Security-Policy of pages with a video: their script and their video come from this server.
extern const std::pair<std::string, std::string> kVideoPolicy;

/// Returns the section of an attempt's page with its video: the video with its events on a timeline and in a list, or
/// the way to it. Empty if the attempt has no recording here. `query`: that of the attempt's page ("" or "?class=5").
Result<Markup> videoSection(const Visit& visit, const StoredAttempt& attempt, const std::string& query);

/// Requests the video of the attempt whose id is the only part.
Response requestVideo(const Visit& visit, const Parts& parts);
/// Shows how far the video of the attempt is, until it leads to the attempt's page.
Response showVideoProgress(const Visit& visit, const Parts& parts);
/// Sends the video of the attempt, or a part of it.
Response sendVideo(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
