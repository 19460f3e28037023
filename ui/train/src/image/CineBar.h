#pragma once

#include <QString>
#include <QWidget>
#include <array>

class QAction;
class QLabel;
class QMenu;
class QPushButton;
class QSlider;

namespace insonate::ui {
class Commands;
}

namespace insonate::train {

class CaseModel;
class LiveModel;

/// The bar under the image, with a constant size: the images of the last seconds before a freeze, and commands for the
/// image on display.
class CineBar : public QWidget {
  Q_OBJECT

 public:
  /// `commands`: commands for measuring, saving and the CT beside the image, which appear in menus and tooltips.
  CineBar(CaseModel& patientCase, LiveModel& live, ui::Commands& commands, QWidget* parent = nullptr);

  /// Selects a caliper (views::CaliperKind); -1: no caliper.
  void setCaliper(int kind);
  void setCtBeside(bool shown);
  void setCtBesideOffered(bool offered);
  /// Reduces the width to a minimum.
  void setCompact(bool compact);
  /// Tells whether saved images include measurements.
  bool savesMeasurements() const;

 Q_SIGNALS:
  void ctBesideChosen(bool shown);
  /// Emitted when the user wants to save the image as it is on the screen, with overlays and the CT beside it.
  void saveScreen();
  void saveClip();

 private:
  QMenu* buildMeasures(ui::Commands& commands);
  QMenu* buildSaving(ui::Commands& commands);
  void refresh();
  void refreshTime();

  CaseModel& patientCase_;
  LiveModel& live_;
  QSlider* slider_;
  QLabel* time_;
  std::array<QAction*, 3> measures_{};  ///< actions in the order of views::CaliperKind
  std::array<QString, 3> measureNames_;
  int caliper_ = -1;  ///< the selected caliper (views::CaliperKind); -1: none
  QAction* withMeasurements_ = nullptr;
  bool compact_ = false;
  QPushButton *measure_, *beside_, *save_;
};

}  // namespace insonate::train
