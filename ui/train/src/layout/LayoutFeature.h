#pragma once

#include "../feature/Feature.h"

class QAction;

namespace insonate::train {

/// The feature for the columns' widths and the layout for left-handed users.
class LayoutFeature final : public Feature {
  Q_OBJECT

 public:
  LayoutFeature(TrainModel& model, TrainLayout& layout);

  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;

 private:
  void setLeftHanded(bool isLeftHanded);

  bool isLeftHanded_ = false;
  QAction* leftHandedAction_ = nullptr;
};

}  // namespace insonate::train
