#pragma once

#include "../labels/StepReplay.h"

#include <insonate/cases/PatientCase.h>
#include <insonate/segmentation/Guide.h>
#include <insonate/ui/StateColors.h>

#include <QObject>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

namespace insonate::prepare {

struct PrepareModel;

/// The guide for an author, from labels to places: its steps, the state of each, and the points clicked for each. Runs
/// tools through LabelSession, so that every step is recorded and can be undone. Uses no widgets.
class GuideSession : public QObject {
  Q_OBJECT

 public:
  using State = ui::StepState;

  GuideSession(PrepareModel& shared, QObject* parent);

  const std::vector<GuideStep>& steps() const { return guide_.steps; }
  int current() const { return current_; }
  const GuideStep& step() const { return guide_.steps[std::size_t(current_)]; }
  void go(int index);
  /// Selects the first step that makes a label; returns false if there is none.
  bool goToStepFor(std::uint8_t label);
  State state(int index) const;
  /// Returns the state in the list of structures of the labels that a finished step makes, the least complete one; no
  /// value while the step is not done, and for a step that makes no labels.
  std::optional<LabelState> labelState(int index) const;
  /// Tells whether a step makes no labels, but proposes a target and start poses.
  bool proposesPlaces(int index) const;
  /// Tells whether the author had used the guide when the case was saved and required steps are still to do.
  bool continues() const;
  /// Returns sentences about a step's state, for example why the step's result may be wrong.
  QStringList remarks(int index) const;

  /// Sets whether the guide's page is shown: clicks in slices then belong to the current step.
  void setShown(bool shown);
  bool isShown() const { return shown_; }
  bool takesClicks() const { return shown_ && !correcting_ && step().clicks > 0 && !isBusy(); }
  const std::vector<Vec3>& clicks_mm() const { return progress_[std::size_t(current_)].clicks_mm; }
  /// The current step's points; empty while the slices do not show them.
  std::vector<Vec3> shownClicks_mm() const;
  void addClick(Vec3 patient_mm);
  void moveClick(std::size_t index, Vec3 patient_mm);
  void removeClick(std::size_t index);

  bool isBusy() const;
  /// Minimum number of clicks for the current step, as far as the clicks show the tissue.
  int clicksNeeded() const;
  /// Tells whether enough points were clicked and no step is running.
  bool canRun() const;
  /// Runs the current step. Its former result is undone first, and later steps are repeated.
  void run();
  /// Stops the running step; the labels are as they were before.
  void cancel();
  /// Tells whether the current step has a result that does not contradict the clicks.
  bool canAccept() const;
  /// Accepts the result of the current step, if it can be accepted: its labels count as completed. Selects the next
  /// step that is still to do; reports a message if no required step is left.
  void accept();
  /// Skips the current step and selects the next.
  void skip();
  /// Performs the action of the Enter key: runs the current step or, if it was run, accepts its result.
  void proceed();

  /// Tells whether the user corrects the current step's label by painting and erasing in the slices; other structures
  /// are protected.
  bool isCorrecting() const { return shown_ && correcting_; }
  void setCorrecting(bool on);
  double brush_mm() const { return brush_mm_; }
  void setBrush(double radius_mm) { brush_mm_ = radius_mm; }

 Q_SIGNALS:
  void changed();
  void clicksChanged();
  /// Emitted with a sentence about the last event for the author.
  void messageReported(const QString& sentence);

 private:
  /// Range of recorded steps that belong to one step of the guide.
  struct Span {
    std::size_t first = 0, count = 0;
  };
  struct StepProgress {
    std::vector<Vec3> clicks_mm{};
    std::size_t made = 0;   ///< number of recorded steps of this guide step
    bool restored = false;  ///< true: the step was done before the case was opened
    bool accepted = false, skipped = false;
    bool isWrong() const;  ///< tells whether the step has a finding with which the author cannot accept the result
    std::vector<GuideFinding> findings{};
    QString caution{};  ///< warning about the method by which the step was made
    int look = 0;       ///< number of the last search for findings; earlier results are dropped
  };

  void beginCase();
  void takeUpRecipe();
  /// Takes progress and clicks from steps that were made before the case was opened.
  void takeUp(const Recipe& recipe);
  void beginAtFirstToDo();
  Span spanOf(int index) const;
  bool isMade(int index) const;
  bool isThere(int index) const;
  void finished(int index, bool well);
  void completeLabels();
  void tellWhatIsLeft();
  void goToNext();
  void findWarnings(int index);
  /// Searches again for findings of each step whose result cannot be accepted, since an edit of the labels may have
  /// corrected the result.
  void findWarningsAgain();
  /// Writes a recipe beside the saved case. The recipe contains all steps that made the case's labels since the CT was
  /// imported, for replay.
  void saveRecipe();

  PrepareModel& shared_;
  Guide guide_;
  StepReplay& replay_;
  std::vector<StepProgress> progress_;
  Recipe before_;  ///< recipe that was saved with the case before it was opened
  Recipe recipe_;  ///< recipe of the steps since the case was opened
  int current_ = 0, working_ = -1;
  int looks_ = 0;
  bool shown_ = false, correcting_ = false;
  bool begun_ = false;  ///< true: the case's structures are known, and the first step that is to do was selected
  double brush_mm_ = 2;
};

}  // namespace insonate::prepare
