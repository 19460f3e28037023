#pragma once

#include "page/Page.h"

#include <insonate/teaching/NeedlePath.h>

#include <string>

namespace insonate::web {

/// Returns the section of an attempt's page with the path of the needle in the image plane. Empty until the server has
/// made the video of the attempt, and the path with it. `attempt`: AttemptFacts::id.
Markup pathSection(const Visit& visit, const std::string& attempt);

/// Draws a path (SVG), with its numbers in a table below the drawing.
Markup drawPath(const NeedlePath& path);

}  // namespace insonate::web
