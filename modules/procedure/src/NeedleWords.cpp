#include <insonate/procedure/NeedleWords.h>

namespace insonate {

std::string_view needleSymbol(NeedlePlace place) {
  switch (place) {
    case NeedlePlace::Clean:
      return "\u25cb";
    case NeedlePlace::UnderSkin:
      return "\u25d0";
    case NeedlePlace::Vein:
      return "\u25cf";
    case NeedlePlace::WrongPlace:
      return "\u25b2";
    case NeedlePlace::Used:
      break;
  }
  return "\u25a0";
}

std::string displayText(NeedlePlace place, const std::string& vessel) {
  switch (place) {
    case NeedlePlace::Clean:
      return "needle is new";
    case NeedlePlace::UnderSkin:
      return "needle is inserted";
    case NeedlePlace::Vein:
      return "in the " + (vessel.empty() ? "vein" : vessel);
    case NeedlePlace::WrongPlace:
      return vessel.empty() ? "wrong place" : "wrong place: " + vessel;
    case NeedlePlace::Used:
      break;
  }
  return "needle is already used";
}

SyringeContent aspiratedContent(Label tissue) {
  switch (tissue) {
    case kVein:
      return SyringeContent::DarkBlood;
    case kArtery:
      return SyringeContent::BrightBlood;
    case kAirway:
      return SyringeContent::Air;
    default:
      return SyringeContent::Nothing;
  }
}

std::string_view displayText(SyringeContent content, bool isAspirating) {
  switch (content) {
    case SyringeContent::DarkBlood:
      return "dark red blood, non-pulsatile";
    case SyringeContent::BrightBlood:
      return "bright red blood, pulsatile";
    case SyringeContent::Air:
      return "air";
    case SyringeContent::Nothing:
      break;
  }
  return isAspirating ? "aspirating, still empty" : "empty";
}

}  // namespace insonate
