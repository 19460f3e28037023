#pragma once

#include <insonate/procedure/AttemptEvent.h>

#include <string>

namespace insonate {

/// Returns a sentence about an event of the line (from Performed on, without ColorShown). `vessel`: vessel or tissue of
/// the event with its article, e.g. "the right internal jugular vein".
std::string lineSentence(const AttemptEvent& event, const std::string& vessel);

}  // namespace insonate
