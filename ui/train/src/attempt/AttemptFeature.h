#pragma once

#include "../feature/Feature.h"

namespace insonate::train {

class AttemptControl;
class AttemptPanel;
class AimOverlay;

/// The feature for attempts at procedures: AttemptControl, the panel above the controls, the strip under the image, and
/// the keys.
class AttemptFeature final : public Feature {
  Q_OBJECT

 public:
  AttemptFeature(TrainModel& model, TrainLayout& layout);
  /// Waits until the recording of an ending attempt is written.
  ~AttemptFeature() override;

  AttemptControl& control() { return *control_; }
  AttemptPanel& panel() { return *panel_; }

  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;
  QString interruptionWarning() const override;
  bool holdsCase() const override;
  bool needsImages() const override;
  void stop() override;

 private:
  void addCommands();
  void buildAim();
  void startOrFinish();
  void showNeedle();

  AttemptControl* control_;
  AttemptPanel* panel_ = nullptr;
  AimOverlay* aim_ = nullptr;
};

}  // namespace insonate::train
