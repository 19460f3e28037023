#pragma once

#include "../places/CasePlaces.h"
#include "../structures/LabelTerms.h"

#include <insonate/cases/CaseCheck.h>
#include <insonate/cases/CaseStatistics.h>
#include <insonate/cases/Difficulty.h>
#include <insonate/cases/PatientCase.h>

#include <QObject>
#include <memory>
#include <vector>

namespace insonate::ui {
class TaskBar;
}

namespace insonate::prepare {

/// Measures of a case.
struct CaseMeasures {
  CaseStatistics statistics;
  std::vector<Finding> findings;
  Result<DifficultyEstimate> difficulty;
};

/// Measures and checks a case as a long job of the window, while it is allowed to. Another job of the window takes its
/// turn, and this one begins again after it; the user's Cancel ends it until start().
class CaseMeasuring : public QObject {
  Q_OBJECT

 public:
  enum class State { Idle, Waiting, Running, Done, Stopped };

  CaseMeasuring(ui::TaskBar& tasks, QObject* parent);
  ~CaseMeasuring() override;

  /// Sets the case and discards former measures; null for no case.
  void setCase(std::shared_ptr<const PatientCase> patient);
  /// Sets edited labels in place of the case's; former measures stay until the new ones are ready.
  void setLabels(std::shared_ptr<const LabelMap> labels);
  /// Announces edits of the labels: the running measurement ends and releases them, and none begins before
  /// setLabels().
  void awaitLabels();
  /// Edited targets, landmarks and start poses, and what labels mean, likewise.
  void setWords(const CasePlaces& places, const LabelTerms& terms);
  /// While not allowed, no measurement begins; a running one continues.
  void setAllowed(bool allowed);
  /// Begins, or begins again after a cancel.
  void start();

  State state() const { return state_; }
  /// The measures; null before they are ready.
  const std::shared_ptr<const CaseMeasures>& measures() const { return measures_; }
  /// Tells whether the measures have voxels of a label; false before they are ready.
  bool hasVoxels(std::uint8_t label) const { return measures_ && measures_->statistics.voxels[label] > 0; }
  /// Why there is nothing, a sentence.
  const QString& trouble() const { return trouble_; }

 Q_SIGNALS:
  void changed();

 private:
  void beginAgain();
  void tryToRun();
  void ended(int number, Result<std::shared_ptr<const CaseMeasures>> result);
  void enter(State state);

  ui::TaskBar& tasks_;
  std::shared_ptr<const PatientCase> patient_;
  std::shared_ptr<const LabelMap> labels_;  ///< null while they are awaited
  std::shared_ptr<const CaseManifest> manifest_;
  std::shared_ptr<const CaseMeasures> measures_;
  QString trouble_;
  State state_ = State::Idle;
  bool allowed_ = false;
  int number_ = 0;  ///< of the job whose end counts
};

}  // namespace insonate::prepare
