#include "NeedleOptions.h"

#include <cmath>
#include <string>

namespace insonate::cli {
namespace {

constexpr double kMaxTenting_mm = 30, kMaxTentingRadius_mm = 30;

Vec3 vectorOf(const std::vector<double>& values) {
  return {values[0], values[1], values[2]};
}

/// Toward the probe; where the needle points along the beam, toward the marker.
Vec3 usualBevel(Vec3 direction) {
  const Vec3 up{0, 0, -1};
  return norm(cross(direction, up)) > 0.01 ? up : Vec3{1, 0, 0};
}

}  // namespace

void NeedleOptions::addTo(CLI::App& command) {
  const auto vector = [&command](const char* name, std::vector<double>& value, const char* what) {
    return command.add_option(name, value, what)->delimiter(',')->expected(3)->type_name("X,Y,Z");
  };
  auto* tip = vector("--needle-tip", tip_mm,
                     "Position of the needle tip in the probe frame, in mm from the middle of the face: lateral "
                     "(positive to the right of the image), elevation (perpendicular to the image), depth. 0,0,20 is "
                     "in the middle of the image, 20 mm deep");
  vector("--needle-direction", direction,
         "Direction from hub to tip in the probe frame, as a vector of any length. 1,0,1 comes from the left at 45 "
         "degrees in-plane, 0,1,1 is out-of-plane; by default 1,0,1")
      ->needs(tip);
  vector("--needle-bevel", bevel, "Direction in which the opening of the bevel faces; by default toward the probe")
      ->needs(tip);
  command.add_option("--needle-diameter", diameter_mm, "Diameter of the needle, mm; 1.27 is 18 G")
      ->capture_default_str()
      ->needs(tip);
  command.add_option("--needle-length", length_mm, "Length from tip to hub, mm")->capture_default_str()->needs(tip);
  command
      .add_option("--tenting", tenting_mm,
                  "Distance by which the tip displaces tissue before it punctures the tissue, mm")
      ->needs(tip);
  command.add_option("--tenting-radius", tentingRadius_mm, "Radius of the tissue that moves with the tip, mm")
      ->capture_default_str()
      ->needs(tip);
}

Result<NeedlePlan> readNeedle(const NeedleOptions& options) {
  NeedlePlan plan;
  if (options.tip_mm.empty()) return plan;
  Needle needle;
  needle.tip_mm = vectorOf(options.tip_mm);
  const Vec3 direction = vectorOf(options.direction);
  if (!(norm(direction) > 0) || !isFinite(direction))
    return fail("--needle-direction is 0,0,0. Give three numbers that are not all 0, such as 1,0,1.");
  needle.direction = normalized(direction);
  needle.bevelNormal = options.bevel.empty() ? usualBevel(needle.direction) : vectorOf(options.bevel);
  needle.radius_mm = options.diameter_mm / 2, needle.length_mm = options.length_mm;
  if (auto ok = validate(needle); !ok) return tl::unexpected(ok.error());
  plan.needle = needle;
  if (!(options.tenting_mm >= 0 && options.tenting_mm <= kMaxTenting_mm)) return fail("--tenting must be 0 to 30 mm.");
  if (!(options.tentingRadius_mm >= 1 && options.tentingRadius_mm <= kMaxTentingRadius_mm))
    return fail("--tenting-radius must be 1 to 30 mm.");
  if (options.tenting_mm > 0)
    plan.tenting = Tenting{needle.tip_mm, needle.direction, options.tenting_mm, options.tentingRadius_mm};
  return plan;
}

Needle NeedlePlan::needleAt(const Transform& patientFromProbe) const {
  Needle moved = *needle;
  moved.tip_mm = patientFromProbe * needle->tip_mm;
  moved.direction = patientFromProbe.linear * needle->direction;
  moved.bevelNormal = patientFromProbe.linear * needle->bevelNormal;
  return moved;
}

const PlaneDisplacement& NeedlePlan::dented(const PlaneDisplacement& pressed, TentedTissue& tissue,
                                            const Transform& patientFromProbe) const {
  if (!tenting) return pressed;
  Tenting moved = *tenting;
  moved.tip_mm = patientFromProbe * tenting->tip_mm;
  moved.direction = patientFromProbe.linear * tenting->direction;
  return tissue.addTenting(pressed, patientFromProbe, moved);
}

}  // namespace insonate::cli
