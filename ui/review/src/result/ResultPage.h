#pragma once

#include "PlanePlot.h"

#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace insonate::review {

class JudgingController;
class MetricTableView;
class ReviewSession;

/// Result of an attempt: points, advice, critical errors, and every metric beside published values; for a test, also
/// whether the test was open.
class ResultPage : public QWidget {
 public:
  ResultPage(ReviewSession& session, const JudgingController& judging, QWidget* parent = nullptr);

 private:
  void show();
  void showSitting();

  ReviewSession& session_;
  const JudgingController& judging_;
  QLabel *points_, *success_, *sitting_, *flags_, *advice_, *errors_;
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

/// pointsOf() returns the points, "74" or "–"; pointsNoteOf() returns a sentence about the points.
QString pointsOf(const AttemptDigest& attempt);
QString pointsNoteOf(const AttemptDigest& attempt);

}  // namespace insonate::review
