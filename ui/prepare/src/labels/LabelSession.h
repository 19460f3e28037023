#pragma once

#include "../structures/Structures.h"
#include "LabelPreview.h"
#include "LabelRules.h"
#include "LabelSnapshots.h"

#include <insonate/cases/PatientCase.h>
#include <insonate/segmentation/Recipe.h>

#include <QFuture>
#include <QFutureWatcher>
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace insonate::ui {
class TaskBar;
}

namespace insonate::prepare {

/// The labels of the open case while they are edited: tools, brush strokes, undo, what is recorded, what is not saved.
///
/// Three maps, and who may touch them. The case's own labels never change while they are shared. The working map is a
/// copy that is made when the first tool is taken up (getReady); brush strokes, undo and redo write it on the window's
/// thread. Everything on other threads (tools, previews, surfaces, the live image, the check, saving) reads a
/// snapshot (LabelSnapshots), which shares the CT of the case and takes as long as what has changed since the last one.
/// While a tool's result is being written, on another thread, the window reads the snapshot, too. So no map is read and
/// written at once. Memory beside the case: the working map, as a rule three snapshots, two proposals while a slider is
/// dragged, and LabelEdit's steps.
///
/// For the window's thread.
class LabelSession : public QObject {
  Q_OBJECT

 public:
  using Done = std::function<void(const Result<LabelChange>&)>;

  LabelSession(ui::TaskBar& tasks, QUndoStack& undo, QObject* parent);
  /// Sets the names of labels in sentences; the default are those of the label table.
  void setNames(std::function<QString(std::uint8_t)> names) { names_ = std::move(names); }
  ~LabelSession() override;

  /// Another case, null for none: edits are forgotten, a tool that runs is stopped.
  void setCase(std::shared_ptr<const PatientCase> patient);
  /// Replaces the case by its saved state with labels() of that time.
  void replaceCase(std::shared_ptr<const PatientCase> patient);

  /// The labels as displayed. A case is open.
  const LabelMap& labels() const { return *seen(); }
  /// The displayed labels, shared with views of this thread; seenChanged() announces another map.
  std::shared_ptr<const LabelMap> seen() const;
  /// labels() as they are now, for other threads.
  std::shared_ptr<const LabelMap> snapshot();
  /// They differ from the case's.
  bool isChanged() const { return state() != saved_; }

  const LabelRules& rules() const { return rules_; }
  void setRules(const LabelRules& rules);
  /// Tools leave a locked label as it is.
  void setLocked(std::uint8_t label, bool locked);

  /// Copies what the first edit needs on another thread, so that it does not wait for it.
  void getReady();

  /// A tool is at work: nothing else is edited.
  bool isBusy() const { return busy_; }
  /// Computes a step on another thread, as a long job of the window that can be cancelled, and writes the result as
  /// one undoable, recorded step; rules() are added to the step's own. Calls `done`, with kCancelled if it was
  /// cancelled; other failures also emit failed().
  void run(LabelStep step, const QString& name, Done done = {});
  /// Runs a step of a recipe(), with its own rules instead of rules(), so that it has the same result again.
  void runAgain(LabelStep step, const QString& name, Done done);
  /// Tells whether no work is running that a tool would end.
  bool isFree() const;
  /// Stops the tool that run() began; nothing is changed.
  void cancel() { settle(); }
  /// Computes in preview() the result that run() would have.
  void wantPreview(LabelStep step);
  LabelPreview& preview() { return preview_; }
  const LabelPreview& preview() const { return preview_; }

  /// A stroke of the brush, written at once: one step from its first to its last point. False, and failed(), where
  /// nothing may be painted.
  bool beginStroke(LabelStep step, const QString& name);
  void strokeTo(Vec3 patient_mm);
  void endStroke();

  /// All steps since the case was opened that are not undone.
  Recipe recipe() const;
  /// Memory that undo takes.
  std::size_t undoBytes() const { return edit_ ? edit_->bytes() : 0; }

 Q_SIGNALS:
  void caseSet();
  /// Voxels have changed: by a tool, a stroke, undo or redo.
  void changed(const insonate::LabelChange& change);
  void seenChanged();
  void busyChanged();
  void rulesChanged();
  void failed(const QString& sentence);

 private:
  struct Writing {
    LabelStep step;
    QString name;
    Done done;
  };

  /// Copies of the case's labels, for the working map and its snapshots.
  struct Copies {
    std::shared_ptr<LabelMap> working;
    LabelSnapshots::Copies snapshots;
  };

  /// False if the step was discarded.
  bool undo();
  void redo();
  /// Why a label may not be edited now; empty where it may.
  QString refusal(std::uint8_t label) const;
  void start(LabelStep step, const QString& name, Done done);
  void beginWork();
  void write(LabelStep step, QString name, std::shared_ptr<const Proposal> proposal, Done done);
  void finishWriting();
  void settle();
  void record(LabelStep step, const QString& name);
  void announce(const LabelChange& change);
  void endWriting();
  void setBusy(bool busy);
  int state() const { return steps_.empty() ? first_ : steps_.back().state; }

  struct Step {
    LabelStep step;
    int state;  ///< a number of the labels after it
  };

  ui::TaskBar& tasks_;
  std::function<QString(std::uint8_t)> names_ = structureName;
  QUndoStack& undo_;
  std::shared_ptr<const PatientCase> patient_;
  std::optional<QFuture<std::shared_ptr<Copies>>> ready_;
  std::shared_ptr<LabelMap> working_;  ///< null before the first edit
  std::unique_ptr<LabelEdit> edit_;
  std::unique_ptr<LabelSnapshots> snapshots_;
  std::shared_ptr<const LabelMap> before_;  ///< what is seen while a result is being written
  LabelRules rules_;
  LabelPreview preview_;
  std::vector<Step> steps_, undone_;
  int first_ = 0, saved_ = 0, states_ = 0;
  bool busy_ = false;
  std::optional<LabelStep> stroke_;
  bool strokeRecorded_ = false;
  QString strokeName_;
  std::optional<Writing> atWork_;  ///< what is being written
  QFutureWatcher<Result<LabelChange>> writing_;
};

}  // namespace insonate::prepare
