#pragma once

#include "PatientBody.h"

#include <vector>

namespace insonate {

/// The body's axial cross-section at one level: only its largest connected part, so that arms beside the head do not
/// count.
struct BodyLevel {
  double z_mm = 0;       ///< position of the level, patient LPS
  double area_mm2 = 0;   ///< area of the cross-section; 0 if there is no body at this level
  double middle_mm = 0;  ///< x of the patient's midline, the same at all levels
  /// Position y of the front of the body, 25 mm to the right of the patient's midline; 1e6 if there is no body at that
  /// place.
  double front_mm = 0;
};

/// Returns the levels through the whole volume, from feet to head, 3 mm apart.
std::vector<BodyLevel> bodyLevels(const PatientBody& body, const VolumeGeometry& grid);

struct ChosenLevel {
  BodyLevel level;
  bool isNeck = false;
};

/// Chooses the neck's level among the central 80 % of the levels. First choice is the level at which the front of the
/// body lies farthest behind chest and chin, if a head and no trunk lies above this level. Second choice is the level
/// that is narrowest compared with the head above, if it is also much narrower than the shoulders below. If neither
/// exists, the middle level is chosen. The front decides first because, with raised arms and lowered chin, the
/// shoulders reach up to the jaw, and the jaw's level would be the narrowest.
ChosenLevel neckOrMiddle(const std::vector<BodyLevel>& levels);

}  // namespace insonate
