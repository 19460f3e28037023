#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;

namespace insonate::ui {
class Commands;
}

namespace insonate::review {

class ReviewSession;

/// Controls for play and stop, speed, moments and time, with a description of probe and needle at the present time.
class Transport : public QWidget {
 public:
  /// `commands` holds the commands of the buttons, "review.replay.play" and others.
  Transport(ReviewSession& session, const ui::Commands& commands, QWidget* parent = nullptr);

 private:
  QPushButton* add(const char* object, const char* icon, const QString& name, const QString& tip);
  void showPlaying();
  void showTime();
  QString handsNow() const;

  ReviewSession& session_;
  QPushButton* play_;
  QComboBox* speed_;
  QLabel *time_, *place_, *hands_;
};

}  // namespace insonate::review
