#include "Region.h"

namespace insonate::phantom {

std::vector<Landmark> punctureSites(const std::vector<StartPose>& poses) {
  std::vector<Landmark> sites;
  for (const StartPose& pose : poses)
    if (const auto comma = pose.name.rfind(", transverse"); comma != std::string::npos)
      sites.push_back({"puncture_site", "puncture site, " + pose.name.substr(0, comma), pose.position_mm});
  return sites;
}

}  // namespace insonate::phantom
