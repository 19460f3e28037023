#pragma once

#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/tissue/Labels.h>

#include <string>
#include <string_view>

namespace insonate {

/// Returns a symbol for a place of the needle, so that users who cannot distinguish colors can read it.
std::string_view needleSymbol(NeedlePlace place);
/// Describes a place of the needle: "in the vein". `vessel`: name of the vessel in which the tip is; empty if the tip
/// is in no vessel or the name is unknown.
std::string displayText(NeedlePlace place, const std::string& vessel = {});

/// Content of the syringe during aspiration.
enum class SyringeContent { Nothing, DarkBlood, BrightBlood, Air };
/// Returns the content that is aspirated with the needle's tip in this tissue or structure.
SyringeContent aspiratedContent(Label tissue);
/// Describes a syringe: "dark red blood, non-pulsatile".
std::string_view displayText(SyringeContent content, bool isAspirating);

}  // namespace insonate
