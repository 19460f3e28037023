#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;

namespace insonate::review {

class ReviewSession;

/// Play and stop, speed, moments, the time, and what the hands do just then.
class Transport : public QWidget {
 public:
  explicit Transport(ReviewSession& session, QWidget* parent = nullptr);

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
