#pragma once

#include "../model/Structures.h"
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

/// Edits the labels of the open case: tools, brush strokes, undo, recorded steps and unsaved changes.
///
/// There are three kinds of label maps. The case's own labels never change while they are shared. The working map is a
/// copy, made when the first tool is selected (getReady); brush strokes, undo and redo write to the working map on the
/// window's thread. Code on other threads (tools, previews, surfaces, the live image, the check, saving) reads a
/// snapshot (LabelSnapshots). Taking a snapshot takes time in proportion to the changes since the last snapshot. The
/// snapshot shares the CT of the case. While a background thread writes a tool's result, the window reads the snapshot,
/// too. Therefore no map is read and written at the same time. Memory besides the case: the working map, normally three
/// snapshots, two proposals while a slider is dragged, and LabelEdit's steps.
///
/// May be used only on the window's thread.
class LabelSession : public QObject {
  Q_OBJECT

 public:
  using Done = std::function<void(const Result<LabelChange>&)>;

  LabelSession(ui::TaskBar& tasks, QUndoStack& undo, QObject* parent);
  /// Sets the function that names labels in sentences; by default, the names of the label table are used.
  void setNames(std::function<QString(std::uint8_t)> names) { names_ = std::move(names); }
  ~LabelSession() override;

  /// Sets the case; null: no case. Edits are discarded, and a running tool is stopped.
  void setCase(std::shared_ptr<const PatientCase> patient);
  /// Replaces the case by its saved state, whose labels are labels() at the time of saving.
  void replaceCase(std::shared_ptr<const PatientCase> patient);

  /// The labels as displayed. Call it only while a case is open.
  const LabelMap& labels() const { return *seen(); }
  /// The displayed labels, shared with views of this thread. When another map is displayed, seenChanged() is emitted.
  std::shared_ptr<const LabelMap> seen() const;
  /// Returns the present labels, for use on other threads.
  std::shared_ptr<const LabelMap> snapshot();
  /// Returns the present labels if this takes only a few milliseconds; else null.
  std::shared_ptr<const LabelMap> snapshotIfCheap();
  /// Tells whether the labels differ from the case's.
  bool isChanged() const { return state() != saved_; }

  const LabelRules& rules() const { return rules_; }
  void setRules(const LabelRules& rules);
  /// Locks a label, so that tools do not change the label, or unlocks it.
  void setLocked(std::uint8_t label, bool locked);

  /// Copies the labels for the first edit on a background thread, so that the edit need not wait.
  void getReady();

  /// Tells whether a tool is running. No other edit is possible while a tool is running.
  bool isBusy() const { return busy_; }
  /// Computes a step on a background thread, as a long job of the window that can be cancelled, and writes the result
  /// as one undoable, recorded step. rules() apply in addition to the step's own rules. Calls `done`, with kCancelled
  /// if the step was cancelled; other failures also emit failed().
  void run(LabelStep step, const QString& name, Done done = {});
  /// Runs a step of a recipe() again. The step's own rules apply instead of rules(), so that the result is the same.
  void runAgain(LabelStep step, const QString& name, Done done);
  /// Tells whether no job is running that a tool would end.
  bool isFree() const;
  /// Stops the tool that run() started, without a change of the labels.
  void cancel() { settle(); }
  /// Computes the result that run() would have, and shows this result in preview().
  void wantPreview(LabelStep step);
  LabelPreview& preview() { return preview_; }
  const LabelPreview& preview() const { return preview_; }

  /// Begins a brush stroke. Points of the stroke are written at once; the whole stroke is one step. Returns false and
  /// emits failed() if painting is not possible.
  bool beginStroke(LabelStep step, const QString& name);
  void strokeTo(Vec3 patient_mm);
  void endStroke();

  /// Returns all steps that were made since the case was opened and were not undone.
  Recipe recipe() const;
  /// Returns those steps of recipe() that were made after the labels were last saved.
  Recipe unsavedRecipe() const;
  /// Sets labels and steps that were made before the program ended. They count as unsaved and cannot be undone.
  /// Discards edits made since the case was opened.
  void restore(std::shared_ptr<const LabelMap> labels, std::vector<LabelStep> steps, const LabelChange& change);
  /// Bytes of memory that undo uses.
  std::size_t undoBytes() const { return edit_ ? edit_->bytes() : 0; }

 Q_SIGNALS:
  void caseSet();
  void restored();  ///< emitted after restore(), before changed()
  /// Emitted when a tool, a stroke, undo or redo has changed voxels.
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

  /// Undoes the last step; returns false if that step was discarded.
  bool undo();
  void redo();
  /// Returns a sentence that says why a step may not be performed now; empty if the step may be performed.
  QString refusal(const LabelStep& step) const;
  void start(LabelStep step, const QString& name, Done done);
  void discardEdits();
  /// Begins to copy the labels on a background thread.
  void copy(std::shared_ptr<const LabelMap> labels);
  void beginWork();
  void write(LabelStep step, QString name, std::shared_ptr<const Proposal> proposal, Done done);
  void finishWriting();
  void settle();
  void record(LabelStep step, const QString& name);
  void announce(const LabelChange& change);
  void endWriting();
  void setBusy(bool busy);
  /// Returns the steps after those that led to the labels with this number.
  Recipe recipeAfter(int state) const;
  int state() const { return steps_.empty() ? first_ : steps_.back().state; }

  struct Step {
    LabelStep step;
    int state;  ///< number that identifies the labels after the step
  };

  ui::TaskBar& tasks_;
  std::function<QString(std::uint8_t)> names_ = structureName;
  QUndoStack& undo_;
  std::shared_ptr<const PatientCase> patient_;
  std::optional<QFuture<std::shared_ptr<Copies>>> ready_;
  std::shared_ptr<LabelMap> working_;  ///< the working map; null before the first edit
  std::unique_ptr<LabelEdit> edit_;
  std::unique_ptr<LabelSnapshots> snapshots_;
  std::shared_ptr<const LabelMap> before_;  ///< map that is displayed while a result is being written
  LabelRules rules_;
  LabelPreview preview_;
  std::vector<LabelStep> restored_;  ///< steps that restore() has set, before steps_
  std::vector<Step> steps_, undone_;
  int first_ = 0, saved_ = 0, states_ = 0;
  bool busy_ = false;
  std::optional<LabelStep> stroke_;
  bool strokeRecorded_ = false;
  QString strokeName_;
  std::optional<Writing> atWork_;  ///< the step that is being written
  QFutureWatcher<Result<LabelChange>> writing_;
};

}  // namespace insonate::prepare
