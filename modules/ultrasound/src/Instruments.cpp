#include <insonate/core/Range.h>
#include <insonate/ultrasound/Instruments.h>

#include <algorithm>
#include <string>

namespace insonate {

Result<void> validate(const FlexibleRod& rod) {
  if (auto ok = checkRange(rod.radius_mm, 0.1, 3, "The radius of the wire or catheter, in mm,"); !ok) return ok;
  if (auto ok =
          checkRange(rod.innerRadius_mm, 0, 0.95 * rod.radius_mm, "The inner radius of the wire or catheter, in mm,");
      !ok)
    return ok;
  if (rod.nodes_mm.size() < 2 || rod.nodes_mm.size() > 4000)
    return fail("A wire or catheter needs 2 to 4000 nodes, not " + std::to_string(rod.nodes_mm.size()) + ".");
  constexpr double kFarthest_mm = 1e4, kLongest_mm = 200;
  const auto isInReach = [](Vec3 node_mm) { return isFinite(node_mm) && norm(node_mm) <= kFarthest_mm; };
  if (!std::ranges::all_of(rod.nodes_mm, isInReach))
    return fail("The nodes of a wire or catheter must lie within 10 m of the origin, in mm; one of them does not.");
  for (std::size_t i = 1; i < rod.nodes_mm.size(); ++i)
    if (norm(rod.nodes_mm[i] - rod.nodes_mm[i - 1]) > kLongest_mm)
      return fail("Neighboring nodes of a wire or catheter must be at most 200 mm apart; nodes " + std::to_string(i) +
                  " and " + std::to_string(i + 1) + " are farther apart.");
  return {};
}

}  // namespace insonate
