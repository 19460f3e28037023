#pragma once

#include <insonate/views/SceneView.h>

#include <QWidget>
#include <memory>

class QCheckBox;
class QComboBox;
class QSettings;

namespace insonate::ui {

class ValueSlider;

/// Controls of stereo and of the head-coupled view.
class EyeControls : public QWidget {
  Q_OBJECT

 public:
  explicit EyeControls(std::shared_ptr<views::SceneView> scene, QWidget* parent = nullptr);

  /// Updates the controls from the scene and from the stereo modes that the scene's window supports.
  void refresh();
  /// Saves the numbers, even while the head-coupled view is off. The stereo mode is not saved, since it depends on the
  /// glasses in use.
  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 Q_SIGNALS:
  void changed();  ///< emitted when the user changes a control

 private:
  void apply();

  std::shared_ptr<views::SceneView> scene_;
  QComboBox* stereo_;
  QCheckBox* coupled_;
  QWidget* numbers_;
  ValueSlider *right_, *up_, *distance_, *width_, *separation_;
  bool refreshing_ = false;
};

}  // namespace insonate::ui
