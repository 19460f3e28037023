#pragma once

#include "../feature/Feature.h"

namespace insonate::train {

class AttemptControl;
class AttemptPanel;

/// An attempt at a procedure: its control, the panel over the controls, the strip under the image and its keys.
class AttemptFeature final : public Feature {
  Q_OBJECT

 public:
  AttemptFeature(TrainModel& model, TrainLayout& layout);
  /// Waits until an attempt that is ending is written.
  ~AttemptFeature() override;

  AttemptControl& control() { return *control_; }
  AttemptPanel& panel() { return *panel_; }

  void act(const KeyRow& row, KeyPress press) override;
  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;
  QString endsWithTheCase() const override;
  bool holdsCase() const override;
  bool needsImages() const override;
  void stop() override;

 private:
  void showNeedle();

  AttemptControl* control_;
  AttemptPanel* panel_;
};

}  // namespace insonate::train
