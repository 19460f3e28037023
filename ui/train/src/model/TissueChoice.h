#pragma once

#include <insonate/deformation/Physiology.h>

#include <string>

class QSettings;

namespace insonate::train {

/// The patient's mechanical model and blood pressure, as chosen in the panel.
struct TissueChoice {
  std::string model = "elastic";  ///< name of the mechanical model: TissueMechanics::model
  Physiology body;                ///< physiology; includes heartbeat and breathing even if they are switched off
  bool pulse = true, breathing = true;

  bool operator==(const TissueChoice&) const = default;
};

/// Returns the physiology of a choice, without heartbeat or breathing if they are switched off.
Physiology physiologyOf(const TissueChoice& choice);

void saveTissue(const TissueChoice& choice, QSettings& settings);
/// Restores a choice from settings; missing or invalid values get their defaults.
TissueChoice restoredTissue(QSettings& settings);

}  // namespace insonate::train
