#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/views/Theme.h>

#include <string>

namespace insonate::views {

/// A named point in patient space (LPS, mm): a landmark, a target or a start pose of the probe.
struct NamedPoint {
  Vec3 position_mm;
  std::string name;
  Color color = theme::kText;
};

}  // namespace insonate::views
