#pragma once

#include <insonate/procedure/Procedure.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// State of an attempt within its procedure: the current step and the findings so far. Processes samples and events
/// like AttemptMetrics, which it contains; the same stream gives the same result, live and replayed.
class ProcedureRun {
 public:
  enum class StepState { Open, Done, Skipped };
  struct Step {
    StepState state = StepState::Open;
    std::int64_t time_us = 0;  ///< when it was done or passed over
  };
  struct Finding {
    std::size_t rule = 0;  ///< of Procedure::rules
    std::int64_t time_us = 0;
    double value = 0;      ///< of the metric
    std::string vessel{};  ///< name of the vessel that was punctured as the rule was broken; empty: none, or not named
  };

  /// `vessels` as in AttemptHeader.
  ProcedureRun(Procedure procedure, const PictureField& picture, std::vector<std::string> vessels = {});

  void take(const AttemptSample& sample);
  void take(const AttemptEvent& event);

  const Procedure& procedure() const { return procedure_; }
  const std::vector<std::string>& vessels() const { return vessels_; }
  const AttemptMetrics& metrics() const { return metrics_; }
  const std::vector<Step>& steps() const { return steps_; }
  /// The first step that is due; none when all are done.
  std::optional<std::size_t> due() const;
  const std::vector<Finding>& findings() const { return findings_; }  ///< in the order of their times
  /// The events by which an attempt is described, in order of time: counted punctures, bone, needle out of the skin or
  /// replaced, pedal held, patient's position. A tip that trembles in a hole adds none.
  const std::vector<AttemptEvent>& milestones() const { return milestones_; }
  /// Name of the vessel that the tip is in, as vesselName(); empty: it is in none, or in one that is not known.
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
  std::optional<AttemptEvent> vesselWall_;                      ///< by which the tip came into the vessel that it is in
  std::vector<std::optional<double>> told_;                     ///< by rule: the value that was told last
  std::optional<std::int64_t> probeOnSkin_us_, aspirating_us_;  ///< since when they hold
};

}  // namespace insonate
