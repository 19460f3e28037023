#pragma once

#include <insonate/procedure/Procedure.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// Follows an attempt through its procedure: current step, findings (errors) and metrics so far, computed from the
/// samples and events of the attempt. The same sequence gives the same result, live and replayed.
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
    /// Name of the vessel whose puncture broke the rule; empty: no vessel, or one without a name.
    std::string vessel{};
  };

  /// `vessels`: AttemptHeader::vessels, the names of the case's vessels, the target first.
  ProcedureRun(Procedure procedure, const ImageField& picture, std::vector<std::string> vessels = {});

  void take(const AttemptSample& sample);
  void take(const AttemptEvent& event);

  const Procedure& procedure() const { return procedure_; }
  const std::vector<std::string>& vessels() const { return vessels_; }
  const AttemptMetrics& metrics() const { return metrics_; }
  const std::vector<Step>& steps() const { return steps_; }
  /// Returns the index of the step that the trainee has to do next; empty if all are done.
  std::optional<std::size_t> due() const;
  const std::vector<Finding>& findings() const { return findings_; }  ///< errors so far, sorted by time
  /// Returns the events that summarize the attempt, in the order of their times: counted punctures, contacts with bone,
  /// needle withdrawn or replaced, image frozen, table tilted. Repeated crossings of one wall by a trembling tip give
  /// one event.
  const std::vector<AttemptEvent>& milestones() const { return milestones_; }
  /// Returns the name of the vessel in which the needle's tip is, in the words of vesselName(); empty: no vessel, or
  /// unknown.
  std::string vesselIn() const;
  /// Tells whether the attempt meets the conditions of success (Procedure::success) so far.
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
  std::optional<AttemptEvent> vesselWall_;  ///< event by which the tip entered its present vessel
  /// for each rule, the metric's value at the rule's last finding; empty: no finding yet
  std::vector<std::optional<double>> told_;
  /// Times since which the probe has been on the skin, and the needle has aspirated blood in the vein; empty: not at
  /// present.
  std::optional<std::int64_t> probeOnSkin_us_, aspirating_us_;
};

}  // namespace insonate
