#pragma once

#include "../feature/Feature.h"

class QToolButton;

namespace insonate::ui {
class ViewWidget;
}

namespace insonate::review {

class AttemptPage;
class ReplayScene;

/// The patient in 3D beside the replay, with the settings of the 3D view below.
class SceneFeature final : public Feature {
  Q_OBJECT

 public:
  SceneFeature(const ReviewModel& model, AttemptPage& page);

  ui::ViewWidget& widget();
  /// Tells whether the settings are shown.
  bool showsSettings() const;

  bool isReady() const override;
  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;

 Q_SIGNALS:
  void settingsShown(bool shown);

 private:
  ReplayScene* scene_;
  QToolButton* tab_ = nullptr;
};

}  // namespace insonate::review
