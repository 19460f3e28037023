#pragma once

#include "CasePlaces.h"
#include "LabelTerms.h"

#include <insonate/cases/CaseCheck.h>
#include <insonate/cases/CaseStatistics.h>
#include <insonate/cases/Difficulty.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/segmentation/LabelEdit.h>

#include <QObject>
#include <memory>
#include <vector>

namespace insonate::ui {
class TaskBar;
}

namespace insonate::prepare {

/// Results of measuring and checking a case.
struct CaseMeasures {
  CaseStatistics statistics;
  std::vector<Finding> findings;
  Result<DifficultyEstimate> difficulty;
};

/// Measures and checks a case as a long job of the window, while this is allowed. If another job replaces the
/// measurement, the measurement begins again after that job. If the user cancels the measurement, it begins again only
/// after start().
class CaseMeasuring : public QObject {
  Q_OBJECT

 public:
  enum class State { Idle, Waiting, Running, Done, Stopped };

  CaseMeasuring(ui::TaskBar& tasks, QObject* parent);
  ~CaseMeasuring() override;

  /// Sets the case and discards the former results; null: no case.
  void setCase(std::shared_ptr<const PatientCase> patient);
  /// Sets edited labels in place of the case's labels and measures them. The former results stay until the new results
  /// are ready.
  void setLabels(std::shared_ptr<const LabelMap> labels);
  /// Announces an edit of these labels. A running measurement ends and releases the label map, and no measurement
  /// begins before setLabels().
  void awaitLabels(const LabelSet& edited);
  /// Sets edited targets, landmarks and start poses, and the meanings of labels, and checks again.
  void setWords(const CasePlaces& places, const LabelTerms& terms);
  /// Allows or forbids the start of measurements; a running measurement continues.
  void setAllowed(bool allowed);
  /// Starts a measurement, even if the user has cancelled the last one.
  void start();

  State state() const { return state_; }
  /// The results; null until they are ready.
  const std::shared_ptr<const CaseMeasures>& measures() const { return measures_; }
  /// Tells whether the label has voxels according to the results; false until the results are ready.
  bool hasVoxels(std::uint8_t label) const { return measures_ && measures_->statistics.voxels[label] > 0; }
  /// Tells whether the label was edited since the results were measured.
  bool isOutdated(std::uint8_t label) const { return measures_ && edited_.test(label); }
  /// Sentence that says why there are no results.
  const QString& error() const { return error_; }

 Q_SIGNALS:
  void changed();

 private:
  void beginAgain();
  void tryToRun();
  void ended(int number, Result<std::shared_ptr<const CaseMeasures>> result);
  void enter(State state);

  ui::TaskBar& tasks_;
  std::shared_ptr<const PatientCase> patient_;
  std::shared_ptr<const LabelMap> labels_;  ///< labels to measure; null after awaitLabels() until setLabels()
  std::shared_ptr<const CaseManifest> manifest_;
  std::shared_ptr<const CaseMeasures> measures_;
  LabelSet edited_;  ///< labels that were edited since the results were measured
  QString error_;
  State state_ = State::Idle;
  bool allowed_ = false;
  int number_ = 0;  ///< number of the present job; results of earlier jobs are dropped
};

}  // namespace insonate::prepare
