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

/// Performs steps of labeling one after the other, each off the window's thread, and inserts them between earlier
/// steps: the later ones are undone first and repeated, with the rules that they had.
class GuideReplay : public QObject {
 public:
  /// Called with true on success; otherwise the labels are as they were before.
  using Done = std::function<void(bool well)>;

  GuideReplay(LabelSession& labels, QUndoStack& undo, QObject* parent)
      : QObject(parent), labels_(labels), undo_(undo) {}

  /// Replaces the recorded steps [first, end). False if they can no longer be undone; then nothing has changed.
  bool run(std::vector<LabelStep> steps, std::size_t first, std::size_t end, const QString& name, Done done);
  bool isRunning() const { return running_; }
  /// Discards the steps of another case.
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
  std::vector<LabelStep> before_;  ///< what was there
  std::deque<LabelStep> todo_;
  std::size_t first_ = 0, again_ = 0;  ///< of todo_, those at its end that are made again
  int here_ = 0;                       ///< in the undo stack
  QString name_;
  Done done_;
  bool running_ = false, restoring_ = false;
  int number_ = 0;
};

}  // namespace insonate::prepare
