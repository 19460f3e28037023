#pragma once

#include <insonate/deformation/DeformationModel.h>

#include <QString>

namespace insonate::ui {

enum class AreaForm {
  Full,   ///< "85 mm² · 141 % of the area in the CT"
  Short,  ///< "85 mm² · 141 % of CT area"
  Share,  ///< "141 % of CT", for narrow places
};

/// Formats a vessel's present area in the image plane, in mm² and in % of its area in the CT; "n/a" if the area in the
/// CT is 0.
QString areaOf(const LumenArea& lumen, AreaForm form);

/// Returns a text for a screen reader: "85 square millimeters, 141 percent of the area in the CT".
QString spokenAreaOf(const LumenArea& lumen);

}  // namespace insonate::ui
