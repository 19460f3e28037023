#pragma once

#include "PatientBody.h"

#include <vector>

namespace insonate {

/// The body's cross-section at a level: its largest piece, so that arms beside the head do not count.
struct BodyLevel {
  double z_mm = 0;       ///< patient LPS
  double area_mm2 = 0;   ///< 0 where there is no body
  double middle_mm = 0;  ///< x of the patient's midline, the same at all levels
  double front_mm = 0;  ///< y of the front of the skin, 25 mm right of the patient's midline; large where there is none
};

/// Levels through the whole volume, feet to head, a few millimeters apart.
std::vector<BodyLevel> bodyLevels(const PatientBody& body, const VolumeGeometry& grid);

struct ChosenLevel {
  BodyLevel level;
  bool isNeck = false;
};

/// The neck, of the central 80 % of the levels: the hollow of the front between chest and chin, where a head and no
/// trunk is above it. Without such a hollow the level that is narrowest compared with the head above it, if it is also
/// much narrower than the shoulders below. Without a neck the middle level. The hollow comes first because with the
/// arms raised and the chin down the shoulders reach up to the jaw, whose level is the narrowest.
ChosenLevel neckOrMiddle(const std::vector<BodyLevel>& levels);

}  // namespace insonate
