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
  if (!std::ranges::all_of(rod.nodes_mm, isFinite))
    return fail("The nodes of a wire or catheter must be finite numbers; one of them is not finite.");
  return {};
}

}  // namespace insonate
