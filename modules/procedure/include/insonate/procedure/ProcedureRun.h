#pragma once

#include <insonate/procedure/Procedure.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// State of an attempt within its procedure: the current step and the findings so far. Receives samples and events like
/// AttemptMetrics, of which it contains one. The same sequence gives the same result, live and replayed.
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
    double value = 0;  ///< value of the metric
    /// Name of the vessel that was punctured when the rule was broken; empty: no vessel, or unnamed.
    std::string vessel{};
  };

  /// `vessels` as in AttemptHeader.
  ProcedureRun(Procedure procedure, const PictureField& picture, std::vector<std::string> vessels = {});

  void take(const AttemptSample& sample);
  void take(const AttemptEvent& event);

  const Procedure& procedure() const { return procedure_; }
  const std::vector<std::string>& vessels() const { return vessels_; }
  const AttemptMetrics& metrics() const { return metrics_; }
  const std::vector<Step>& steps() const { return steps_; }
  /// Index of the first step that is due; empty if all steps are done.
  std::optional<std::size_t> due() const;
  const std::vector<Finding>& findings() const { return findings_; }  ///< sorted by time
  /// Events that describe the attempt, in the order of their times: counted punctures, contact with bone, needle
  /// withdrawn or replaced, needle held by the pedal, change of position. A tip that trembles in a hole adds no event.
  const std::vector<AttemptEvent>& milestones() const { return milestones_; }
  /// Name of the vessel in which the tip is, as vesselName() gives it; empty: no vessel, or unknown.
  std::string vesselIn() const;
  /// Tells whether the procedure has succeeded so far.
  bool succeeded() const;

 private:
  bool complete(std::int64_t time_us, const AttemptEvent* event);
  bool isTarget(const AttemptEvent& event) const { return vessels_.empty() || event.vessel == 1; }
  void followVessel(const AttemptEvent& event);
  void watchRules(std::int64_t time_us, const std::string& vessel);

  Procedure procedure_;
  std::vector<std::string> vessels_;
  AttemptMetrics metrics_;
  std::vector<Step> steps_;
  std::size_t due_ = 0;
  std::vector<Finding> findings_;
  std::vector<AttemptEvent> milestones_;
  std::optional<AttemptEvent> vesselWall_;   ///< event by which the tip entered its present vessel
  std::vector<std::optional<double>> told_;  ///< for each rule, the value at the last finding
  /// Time since which the state has lasted; empty: the state does not hold.
  std::optional<std::int64_t> probeOnSkin_us_, aspirating_us_;
};

}  // namespace insonate
