#include <insonate/cases/Landmarks.h>

#include <algorithm>

namespace insonate {

std::span<const LandmarkKind> landmarkKinds() {
  static constexpr LandmarkKind kKinds[] = {{"puncture_site", "puncture site", true},
                                            {"cricoid", "cricoid cartilage", false},
                                            {"sternal_notch", "sternal notch", false},
                                            {"clavicle_right", "right clavicle, inner end", false},
                                            {"clavicle_left", "left clavicle, inner end", false},
                                            {"mastoid_right", "right mastoid process", false},
                                            {"mastoid_left", "left mastoid process", false},
                                            {"pubic_tubercle_right", "right pubic tubercle", false},
                                            {"pubic_tubercle_left", "left pubic tubercle", false},
                                            {"inguinal_ligament_right", "right inguinal ligament, middle", false},
                                            {"inguinal_ligament_left", "left inguinal ligament, middle", false}};
  return kKinds;
}

const LandmarkKind* landmarkKind(std::string_view code) {
  const auto kinds = landmarkKinds();
  const auto found = std::ranges::find(kinds, code, &LandmarkKind::code);
  return found == kinds.end() ? nullptr : &*found;
}

}  // namespace insonate
