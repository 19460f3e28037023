#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QMenu;
class QPushButton;
class QSlider;

namespace insonate::train {

class TrainSession;

/// Under the image: the last seconds of a frozen one, and what can be done with the image on display. Keeps its
/// size whatever it shows.
class CineBar : public QWidget {
  Q_OBJECT

 public:
  explicit CineBar(TrainSession& session, QWidget* parent = nullptr);

  /// Selects a caliper (views::CalliperKind), or none with -1.
  void setCalliper(int kind);
  void setCtBeside(bool shown);
  void setCtBesideOffered(bool offered);
  /// Takes as little width as it can.
  void setCompact(bool compact);
  /// Tells whether saved images include measurements.
  bool savesMeasurements() const;

 Q_SIGNALS:
  void calliperChosen(int kind);
  void clearCallipers();
  void ctBesideChosen(bool shown);
  void savePicture();
  void saveScreen();  ///< the image as it is seen, with what stands beside and over it
  void saveClip();

 private:
  QMenu* buildMeasures();
  QMenu* buildSaving();
  void refresh();
  void refreshTime();

  TrainSession& session_;
  QSlider* slider_;
  QLabel* time_;
  QAction* measures_[3];
  QAction* withMeasurements_ = nullptr;
  bool compact_ = false;
  QPushButton *measure_, *beside_, *save_;
};

}  // namespace insonate::train
