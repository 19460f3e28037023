#pragma once

#include "PlanePlot.h"

#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace insonate::review {

class JudgeDesk;
class MetricTableView;
class ReviewSession;

/// Result of an attempt: points, for a test whether it was open, advice, critical errors, and every metric beside
/// published values.
class ResultPage : public QWidget {
 public:
  ResultPage(ReviewSession& session, const JudgeDesk& judging, QWidget* parent = nullptr);

 private:
  void show();
  void showSitting();

  ReviewSession& session_;
  const JudgeDesk& judging_;
  QLabel *points_, *success_, *sitting_, *advice_, *errors_;
  MetricTableView* metrics_;
};

/// Widget with the tip's path in the image plane.
class PathPane : public QWidget {
 public:
  explicit PathPane(ReviewSession& session, QWidget* parent = nullptr);
  const PlaneSection& section() const { return section_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  ReviewSession& session_;
  PlaneSection section_;
};

/// Return the points, "74" or "–", and a sentence about them.
QString pointsOf(const AttemptDigest& attempt);
QString pointsNoteOf(const AttemptDigest& attempt);

}  // namespace insonate::review
