#pragma once

#include "PatientBody.h"

#include <vector>

namespace insonate {

/// The body's cross-section at a level: its largest connected part, so that arms beside the head do not count.
struct BodyLevel {
  double z_mm = 0;       ///< level, patient LPS
  double area_mm2 = 0;   ///< 0 if there is no body at this level
  double middle_mm = 0;  ///< x of the patient's midline, the same at all levels
  double front_mm = 0;   ///< y of the skin's front, 25 mm to the right of the patient's midline; 1e6 if there is none
};

/// Returns the levels through the whole volume, from feet to head, 3 mm apart.
std::vector<BodyLevel> bodyLevels(const PatientBody& body, const VolumeGeometry& grid);

struct ChosenLevel {
  BodyLevel level;
  bool isNeck = false;
};

/// Chooses the neck's level among the central 80 % of the levels. First choice is the hollow of the front between chest
/// and chin, if a head and no trunk lies above it. Second choice is the narrowest level compared with the head above
/// it, if it is also much narrower than the shoulders below. If neither exists, the middle level is chosen. The hollow
/// comes first because, with raised arms and lowered chin, the shoulders reach up to the jaw, and the jaw's level would
/// be the narrowest.
ChosenLevel neckOrMiddle(const std::vector<BodyLevel>& levels);

}  // namespace insonate
