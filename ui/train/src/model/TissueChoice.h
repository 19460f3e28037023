#pragma once

#include <insonate/deformation/Physiology.h>

#include <string>

class QSettings;

namespace insonate::train {

/// Mechanical model and blood pressure of the patient, as chosen in the panel.
struct TissueChoice {
  std::string model = "elastic";  ///< see TissueMechanics::model
  Physiology body;                ///< with a heart and a breath, whether or not they are on
  bool pulse = true, breathing = true;
};
bool operator==(const TissueChoice& a, const TissueChoice& b);

/// Physiology of the choice, without heart or breath if those are off.
Physiology physiologyOf(const TissueChoice& choice);

void saveTissue(const TissueChoice& choice, QSettings& settings);
/// Restores the choice; missing or invalid values take their defaults.
TissueChoice restoredTissue(QSettings& settings);

}  // namespace insonate::train
