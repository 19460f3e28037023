#pragma once

#include "GuideReplay.h"

#include <insonate/segmentation/Guide.h>

#include <QObject>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <vector>

namespace insonate::prepare {

struct PrepareModel;

/// The guide of an author: its steps, the state of each, and the clicks for it. Runs tools through the labels'
/// session, so that everything is recorded and can be undone. Knows no widget.
class GuideSession : public QObject {
  Q_OBJECT

 public:
  enum class State { ToDo, Working, Done, Doubtful, Skipped };

  GuideSession(PrepareModel& shared, QObject* parent);

  const std::vector<GuideStep>& steps() const { return guide_.steps; }
  int current() const { return current_; }
  const GuideStep& step() const { return guide_.steps[std::size_t(current_)]; }
  void go(int index);
  /// Moves to the first step that makes a label; false if none does.
  bool goToStepFor(std::uint8_t label);
  State state(int index) const;
  /// Its author was led by it when the case was saved, and what training needs is not all there.
  bool goesOn() const;
  /// Why a step is doubtful, or what else is to be said of its state.
  QStringList remarks(int index) const;

  /// Sets whether the page is shown: then clicks in slices belong to the current step.
  void setShown(bool shown);
  bool isShown() const { return shown_; }
  bool takesClicks() const { return shown_ && !correcting_ && step().clicks > 0 && !isBusy(); }
  const std::vector<Vec3>& clicks_mm() const { return progress_[std::size_t(current_)].clicks_mm; }
  /// Its clicks while they can be seen.
  std::vector<Vec3> shownClicks_mm() const;
  void addClick(Vec3 patient_mm);
  void moveClick(std::size_t index, Vec3 patient_mm);
  void removeClick(std::size_t index);

  bool isBusy() const;
  /// There are clicks enough, and nothing is at work.
  bool canRun() const;
  /// Runs the current step; its former result is undone first, and later steps are repeated.
  void run();
  /// Stops it; the labels are as they were before.
  void cancel();
  /// The result is right: on to the next step that is to do.
  void accept();
  /// Continues without the current step.
  void skip();
  /// Action of the Enter key: run, then accept.
  void proceed();

  /// The current step's label is painted and erased in the slices; other structures are spared.
  bool isCorrecting() const { return shown_ && correcting_; }
  void setCorrecting(bool on);
  double brush_mm() const { return brush_mm_; }
  void setBrush(double radius_mm) { brush_mm_ = radius_mm; }

  /// Beside a case that was saved: everything that made its labels since the CT was imported, to be replayed.
  Result<void> saveRecipe(const std::filesystem::path& folder) const;

 Q_SIGNALS:
  void changed();
  void clicksChanged();
  /// A sentence for the author.
  void told(const QString& sentence);

 private:
  /// Recorded steps that belong to one step of the guide.
  struct Span {
    std::size_t first = 0, count = 0;
  };
  struct StepProgress {
    std::vector<Vec3> clicks_mm{};
    std::size_t made = 0;   ///< recorded steps that it came to
    bool restored = false;  ///< made before the case was opened
    bool accepted = false, skipped = false;
    QStringList doubts{};
    QString caution{};  ///< of the way in which it was made
    int look = 0;       ///< for doubts: of several, the last counts
  };

  void beginCase();
  void takeUpRecipe();
  void beginAtFirstToDo();
  Span spanOf(int index) const;
  bool isMade(int index) const;
  bool isThere(int index) const;
  void finished(int index, bool well);
  void goToNext();
  void findWarnings(int index);

  PrepareModel& shared_;
  Guide guide_;
  GuideReplay& replay_;
  std::vector<StepProgress> progress_;
  Recipe before_;  ///< saved with the case when it was opened
  Recipe recipe_;  ///< since then
  int current_ = 0, working_ = -1;
  int looks_ = 0;
  bool shown_ = false, correcting_ = false;
  bool begun_ = false;  ///< it is known what the case has, and the first step to do is shown
  double brush_mm_ = 2;
};

}  // namespace insonate::prepare
