#pragma once

#include <insonate/views/SceneView.h>

#include <QWidget>
#include <memory>

class QCheckBox;
class QComboBox;
class QToolButton;

namespace insonate::ui {

class ValueSlider;

/// Controls of a scene's clipping plane.
class ClippingControls : public QWidget {
  Q_OBJECT

 public:
  explicit ClippingControls(std::shared_ptr<views::SceneView> scene, QWidget* parent = nullptr);

  /// Updates the controls from the scene.
  void refresh();

 Q_SIGNALS:
  void changed();  ///< emitted when the user changes a control

 private:
  void apply();
  void takeView();

  std::shared_ptr<views::SceneView> scene_;
  QComboBox* kind_;
  ValueSlider *offset_, *turn_, *tilt_;
  QCheckBox* flipped_;
  QToolButton* asSeen_;
  bool refreshing_ = false;
};

}  // namespace insonate::ui
