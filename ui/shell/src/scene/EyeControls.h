#pragma once

#include <insonate/views/SceneView.h>

#include <QWidget>
#include <memory>

class QCheckBox;
class QComboBox;
class QSettings;

namespace insonate::ui {

class ValueSlider;

/// Stereo, and the view that goes with the viewer's head.
class EyeControls : public QWidget {
  Q_OBJECT

 public:
  explicit EyeControls(std::shared_ptr<views::SceneView> scene, QWidget* parent = nullptr);

  /// Shows the scene's present state, and the abilities of its window.
  void refresh();
  /// The numbers, which stay when the view is off; not the stereo mode, which belongs to a pair of glasses at hand.
  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 Q_SIGNALS:
  void changed();  ///< by the user

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
