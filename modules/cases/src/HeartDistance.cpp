#include <insonate/cases/HeartDistance.h>
#include <insonate/cases/VesselName.h>

#include <optional>
#include <string_view>

namespace insonate {
namespace {

constexpr double kNeck_mm = 150, kArm_mm = 120, kGroin_mm = -350;

std::optional<double> knownSite_mm(std::string_view name) {
  const auto vessel = parsedVesselName(name).vessel;
  if (!vessel) return std::nullopt;
  switch (*vessel) {
    case KnownVessel::Iliac:
    case KnownVessel::Femoral:
    case KnownVessel::Saphenous:
      return kGroin_mm;
    case KnownVessel::Brachial:
    case KnownVessel::Basilic:
    case KnownVessel::Cephalic:
      return kArm_mm;
    default:
      return kNeck_mm;
  }
}

}  // namespace

double siteAboveHeart_mm(const CaseManifest& manifest) {
  for (const Target& target : manifest.targets)
    if (const auto site_mm = knownSite_mm(target.name)) return *site_mm;
  for (const NamedVessel& vessel : manifest.vessels)
    if (const auto site_mm = knownSite_mm(vessel.name)) return *site_mm;
  return kNeck_mm;
}

}  // namespace insonate
