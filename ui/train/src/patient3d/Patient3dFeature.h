#pragma once

#include "../feature/Feature.h"

namespace insonate::train {

class PatientViews;

/// The feature for the patient in 3D and as CT slices, in a column beside the image.
class Patient3dFeature final : public Feature {
  Q_OBJECT

 public:
  Patient3dFeature(TrainModel& model, TrainLayout& layout);

  PatientViews& patientViews() { return *patient_; }

  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;
  void setCompact(bool isCompact) override;

 private:
  void addCommands();
  void addWindows();
  void connectNeedle();

  PatientViews* patient_ = nullptr;
  bool touchesTray_ = false;  ///< true: the used needle touches the tray while the user holds it
};

}  // namespace insonate::train
