#pragma once

#include <insonate/segmentation/Recipe.h>

#include <QObject>
#include <QString>
#include <deque>
#include <functional>
#include <vector>

class QUndoStack;

namespace insonate::prepare {

class LabelSession;

/// Performs labeling steps one after the other on a background thread, and inserts them between earlier steps. For
/// this, the steps after the insertion are first undone and then repeated with their own rules.
class StepReplay : public QObject {
 public:
  /// Called with true after success, and with false after a failure. After a failure the labels are as they were
  /// before.
  using Done = std::function<void(bool well)>;

  StepReplay(LabelSession& labels, QUndoStack& undo, QObject* parent) : QObject(parent), labels_(labels), undo_(undo) {}

  /// Replaces the recorded steps [first, end) by `steps`. Returns false, without a change, if those steps can no longer
  /// be undone.
  bool run(std::vector<LabelStep> steps, std::size_t first, std::size_t end, const QString& name, Done done);
  bool isRunning() const { return running_; }
  /// Discards the steps in progress, since another case is open.
  void forget() { ++number_, running_ = false; }

 private:
  bool undoTo(std::size_t count);
  bool wasRedone();
  void next();
  void fail();
  void restoreSoon();
  void restore();
  void end(bool well);

  LabelSession& labels_;
  QUndoStack& undo_;
  std::vector<LabelStep> before_;  ///< the recorded steps before run()
  std::deque<LabelStep> todo_;
  /// first_: index of the first replaced step; again_: number of steps at the end of todo_ that are repeated.
  std::size_t first_ = 0, again_ = 0;
  int here_ = 0;  ///< position in the undo stack
  QString name_;
  Done done_;
  bool running_ = false, restoring_ = false;
  int number_ = 0;
};

}  // namespace insonate::prepare
