#include <insonate/procedure/AttemptEvent.h>
#include <insonate/simulator/TargetVein.h>

#include <algorithm>
#include <iterator>
#include <tuple>

namespace insonate {
namespace {

/// Index of the line that passes nearest; the number of lines where there is none.
std::size_t nearestLine(std::span<const CentreLine> lines, Vec3 point_mm) noexcept {
  std::size_t nearest = lines.size();
  std::optional<double> least_mm;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto distance_mm = insonate::distanceToCentre_mm(lines.subspan(i, 1), point_mm);
    if (distance_mm && (!least_mm || *distance_mm < *least_mm)) least_mm = distance_mm, nearest = i;
  }
  return nearest;
}

}  // namespace

TargetVein::TargetVein(const CaseManifest& manifest, const Procedure& procedure, Vec3 near_mm) {
  std::ranges::copy_if(manifest.targets, std::back_inserter(named_),
                       [](const Target& target) { return target.label == kVein; });
  if (named_.size() > kUnnamedVessel - 1U) named_.resize(kUnnamedVessel - 1U);
  const auto rank = [&](const Target& target) {
    const bool fits = !procedure.target.empty() && target.name.find(procedure.target) != std::string::npos;
    return std::tuple(!fits, norm(target.position_mm - near_mm));
  };
  std::ranges::stable_sort(named_, {}, rank);
}

std::vector<std::string> TargetVein::names() const {
  std::vector<std::string> names;
  for (const Target& target : named_) names.push_back(target.name.empty() ? "target vein" : target.name);
  return names;
}

std::uint8_t TargetVein::vesselAt(Vec3 rest_mm, std::span<const CentreLine> veins) const noexcept {
  if (named_.empty()) return 0;
  const std::size_t line = nearestLine(veins, rest_mm);
  if (line < veins.size())
    for (std::size_t i = 0; i < named_.size(); ++i)
      if (nearestLine(veins, named_[i].position_mm) == line) return static_cast<std::uint8_t>(i + 1);
  return kUnnamedVessel;
}

std::optional<double> TargetVein::distanceToCentre_mm(Vec3 rest_mm, std::span<const CentreLine> veins) const noexcept {
  if (named_.empty()) return insonate::distanceToCentre_mm(veins, rest_mm);
  const std::size_t line = nearestLine(veins, named_.front().position_mm);
  if (line == veins.size()) return std::nullopt;
  return insonate::distanceToCentre_mm(veins.subspan(line, 1), rest_mm);
}

}  // namespace insonate
