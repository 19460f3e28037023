#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/tissue/Labels.h>

namespace insonate {

/// Agitated saline that was flushed through the needle or a catheter. Time and place determine its bubbles.
struct SalineFlush {
  double time_s = 0;   ///< time of the flush since the recording began
  Label wall = kVein;  ///< vessel in which the tip was: kVein or kArtery
  Vec3 from_mm{};      ///< tip of the instrument, undeformed tissue, patient space

  bool operator==(const SalineFlush&) const = default;
};

}  // namespace insonate
