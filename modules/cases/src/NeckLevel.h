#pragma once

#include "PatientBody.h"

#include <vector>

namespace insonate {

/// The body's cross-section at a level: its largest piece, so that arms beside the head do not count.
struct BodyLevel {
  double z_mm = 0;       ///< patient LPS
  double area_mm2 = 0;   ///< 0 where there is no body
  double middle_mm = 0;  ///< x of the piece's centroid
};

/// Levels through the whole volume, feet to head, a few millimetres apart.
std::vector<BodyLevel> bodyLevels(const PatientBody& body, const VolumeGeometry& grid);

struct ChosenLevel {
  BodyLevel level;
  bool isNeck = false;
};

/// Of the central 80 % of the levels the one that is narrowest between wider ones, which is the neck between head and
/// shoulders, if it is narrower than both by a quarter; else the middle level.
ChosenLevel neckOrMiddle(const std::vector<BodyLevel>& levels);

}  // namespace insonate
