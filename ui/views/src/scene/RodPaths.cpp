#include <insonate/views/RodPaths.h>

#include <algorithm>

namespace insonate::views {

std::vector<ScenePath> pathsOf(std::span<const FlexibleRod> rods) {
  constexpr double kLeast_mm = 0.5;
  std::vector<ScenePath> paths;
  for (const FlexibleRod& rod : rods)
    paths.push_back({rod.nodes_mm, rod.material == RodMaterial::SteelCoil ? theme::kWire : theme::kCatheter,
                     std::max(rod.radius_mm, kLeast_mm)});
  return paths;
}

}  // namespace insonate::views
