#pragma once

#include <insonate/deformation/Physiology.h>

#include <string>

class QSettings;

namespace insonate::train {

/// How the tissue under the probe gives way, and what the patient's blood is under, as chosen in the panel.
struct TissueChoice {
  std::string model = "elastic";  ///< see TissueMechanics::model
  Physiology body;                ///< with a heart and a breath, whether or not they are on
  bool pulse = true, breathing = true;
};
bool operator==(const TissueChoice& a, const TissueChoice& b);

/// Without heart or breath where those are off.
Physiology physiologyOf(const TissueChoice& choice);

void saveTissue(const TissueChoice& choice, QSettings& settings);
/// What is missing or cannot be is as usual.
TissueChoice restoredTissue(QSettings& settings);

}  // namespace insonate::train
