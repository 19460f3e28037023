#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QMenu;
class QPushButton;
class QSlider;

namespace insonate::train {

class CaseModel;
class LiveModel;

/// The bar under the image, of constant size: the last seconds before a freeze, and commands for the image on display.
class CineBar : public QWidget {
  Q_OBJECT

 public:
  CineBar(CaseModel& patientCase, LiveModel& live, QWidget* parent = nullptr);

  /// Selects a caliper (views::CalliperKind); -1: no caliper.
  void setCalliper(int kind);
  void setCtBeside(bool shown);
  void setCtBesideOffered(bool offered);
  /// Reduces the width to a minimum.
  void setCompact(bool compact);
  /// Tells whether saved images include measurements.
  bool savesMeasurements() const;

 Q_SIGNALS:
  void calliperChosen(int kind);
  void clearCallipers();
  void ctBesideChosen(bool shown);
  void savePicture();
  /// Emitted when the user wants to save the image as on the screen, with overlays and the CT beside it.
  void saveScreen();
  void saveClip();

 private:
  QMenu* buildMeasures();
  QMenu* buildSaving();
  void refresh();
  void refreshTime();

  CaseModel& patientCase_;
  LiveModel& live_;
  QSlider* slider_;
  QLabel* time_;
  QAction* measures_[3];
  QAction* withMeasurements_ = nullptr;
  bool compact_ = false;
  QPushButton *measure_, *beside_, *save_;
};

}  // namespace insonate::train
