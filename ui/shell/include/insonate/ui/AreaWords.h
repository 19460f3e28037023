#pragma once

#include <insonate/deformation/DeformationModel.h>

#include <QString>

namespace insonate::ui {

enum class AreaForm {
  Full,   ///< "85 mm² · 141 % of the area in the CT"
  Short,  ///< "85 mm² · 141 % of CT"
  Share,  ///< "141 % of CT", where there is room for no more
};

/// Area of a vessel in the image's plane as it lies now, in mm², and in % of the area that the CT shows there. "n/a"
/// where the CT shows none.
QString areaOf(const LumenArea& lumen, AreaForm form);

/// Text for a screen reader: "85 square millimeters, 141 percent of the area in the CT".
QString spokenAreaOf(const LumenArea& lumen);

}  // namespace insonate::ui
