#pragma once

#include <insonate/procedure/Procedure.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// Tracks an attempt through the steps of its procedure: computes the present step, the findings (errors) and the
/// metrics from the samples and events of the attempt. The same sequence of samples and events gives the same result,
/// live and replayed.
class ProcedureRun {
 public:
  enum class StepState { Open, Done, Skipped };
  struct Step {
    StepState state = StepState::Open;
    std::int64_t time_us = 0;  ///< time at which the step was done or skipped
  };
  struct Finding {
    std::size_t rule = 0;  ///< index into Procedure::rules
    std::int64_t time_us = 0;
    double value = 0;  ///< value of the rule's metric at that time
    /// Name of the vessel whose puncture broke the rule; empty if there is no vessel or it has no name.
    std::string vessel{};
  };

  /// `vessels`: AttemptHeader::vessels, the names of the case's vessels, the target first.
  ProcedureRun(Procedure procedure, const ImageField& imageField, std::vector<std::string> vessels = {});

  /// Adds the next sample or event of the attempt, in the order of the recording.
  void add(const AttemptSample& sample);
  void add(const AttemptEvent& event);

  const Procedure& procedure() const { return procedure_; }
  const std::vector<std::string>& vessels() const { return vessels_; }
  /// Returns the metrics of the samples and events so far.
  const AttemptMetrics& metrics() const { return metrics_; }
  /// Returns the states of the steps, in the order of Procedure::steps.
  const std::vector<Step>& steps() const { return steps_; }
  /// Returns the index of the step that is to be done next; empty if all steps are done.
  std::optional<std::size_t> nextStep() const;
  const std::vector<Finding>& findings() const { return findings_; }  ///< errors so far, sorted by time
  /// Returns the events that summarize the attempt, in the order of their times: counted punctures, contacts with bone,
  /// needle withdrawn or replaced, image frozen, table tilted. Repeated crossings of one wall by a trembling tip are
  /// combined in one event.
  const std::vector<AttemptEvent>& milestones() const { return milestones_; }
  /// Returns the name of the vessel in which the needle's tip is, as vesselName() does; empty if the tip is in no
  /// vessel or the vessel is unknown.
  std::string vesselAtTip() const;
  /// Tells whether the attempt meets the conditions of success (Procedure::success) so far.
  bool succeeded() const;

 private:
  bool complete(std::int64_t time_us, const AttemptEvent* event);
  bool isTarget(const AttemptEvent& event) const { return vessels_.empty() || event.vessel == 1; }
  bool isMet(const StateCondition& condition, std::int64_t time_us) const;
  bool isMet(const EventCondition& condition, const AttemptEvent& event) const;
  void restartAt(std::size_t step);
  void goOnAfter(std::size_t step, std::int64_t time_us);
  void restartLine(const AttemptEvent& event);
  void followVessel(const AttemptEvent& event);
  void watchRules(std::int64_t time_us, const std::string& vessel);

  Procedure procedure_;
  std::vector<std::string> vessels_;
  AttemptMetrics metrics_;
  std::vector<Step> steps_;
  std::size_t due_ = 0;
  bool hasHarmed_ = false;  ///< this pass of the needle has punctured an artery, the lung or the airway
  bool isLine_;             ///< the procedure continues after the puncture
  std::vector<Finding> findings_;
  std::vector<AttemptEvent> milestones_;
  std::optional<AttemptEvent> vesselWall_;  ///< event by which the tip entered its present vessel
  /// for each rule, the value of the rule's metric when the rule last caused a finding; empty if there was no finding
  /// yet
  std::vector<std::optional<double>> told_;
  /// Time at which the present contact of the probe with the skin, or the present aspiration of blood in the vein,
  /// began; empty if there is none.
  std::optional<std::int64_t> probeOnSkin_us_, aspirating_us_;
};

}  // namespace insonate
