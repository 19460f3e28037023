#include <insonate/ultrasound/Needle.h>

#include <string>

namespace insonate {
namespace {

std::string number(double value) {
  std::string text = std::to_string(value);
  return text.substr(0, text.find('.') + 4);
}

Result<void> checkRange(const char* what, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return fail(std::string("The needle's ") + what + " is " + number(value) + " mm; allowed is " + number(low) + " to " +
              number(high) + " mm.");
}

}  // namespace

Result<void> validate(const Needle& needle) {
  constexpr double kUnit = 1e-3;
  if (!isFinite(needle.tip_mm) || !isFinite(needle.direction) || !isFinite(needle.bevelNormal))
    return fail("The tip, direction and bevel of the needle must be finite numbers; one of them is not finite.");
  if (std::abs(norm(needle.direction) - 1) > kUnit)
    return fail("The needle's direction is " + number(norm(needle.direction)) + " long; give a vector of length 1.");
  if (norm(cross(needle.bevelNormal, needle.direction)) < kUnit)
    return fail("The bevel of the needle faces along its shaft; give a direction that is not along the shaft.");
  if (auto ok = checkRange("radius", needle.radius_mm, 0.1, 2); !ok) return ok;
  return checkRange("length", needle.length_mm, 1, 300);
}

}  // namespace insonate
