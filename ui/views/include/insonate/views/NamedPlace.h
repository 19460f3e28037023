#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/views/Theme.h>

#include <string>

namespace insonate::views {

/// A place of the patient that has a name, LPS mm: a landmark, a target, where a probe begins.
struct NamedPlace {
  Vec3 position_mm;
  std::string name;
  Colour colour = theme::kText;
};

}  // namespace insonate::views
