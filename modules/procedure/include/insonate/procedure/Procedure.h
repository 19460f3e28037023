#pragma once

#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptEvent.h>
#include <insonate/procedure/AttemptMetrics.h>

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace insonate {

/// Permitted tilt of the table. Turning the head moves muscle and vessels and needs another case.
struct PatientPosition {
  std::string name;
  double tilt_deg = 0;  ///< head down is positive; -45 to 45
};

/// An event that ends a step.
struct Happening {
  AttemptEventKind kind = AttemptEventKind::Entered;
  std::optional<Label> wall;  ///< none: any
};
/// A state that ends a step once it has lasted.
struct Holding {
  enum class What { ProbeOnSkin, AspiratingInVein };
  What what = What::ProbeOnSkin;
  double for_s = 0;
};

struct ProcedureStep {
  std::string name, title;
  std::string say;        ///< what to do, for the trainee
  bool optional = false;  ///< what comes after may be done without
  std::variant<Happening, Holding> until;
};

/// Tells whether a metric's value exceeds a limit. A missing value exceeds none.
struct MetricLimit {
  Metric metric = Metric::VeinPunctures;
  std::optional<double> over, under;  ///< one of the two

  bool isBeyond(std::optional<double> value) const {
    return value && ((over && *value > *over) || (under && *value < *under));
  }
};

enum class Severity { Minor, Major, Critical };

/// An error that an attempt must not contain.
struct ProcedureRule {
  std::string name;
  MetricLimit limit;  ///< of a count, each one more counts anew; of other metrics, once
  Severity severity = Severity::Minor;
  std::string say;     ///< what went wrong, and what to do
  std::string advice;  ///< for the next time, one sentence; may be empty
};

/// Published values of a metric: the range between novice and expert is what can be learnt.
struct MetricNorm {
  Metric metric = Metric::VeinPunctures;
  double novice = 0, expert = 0;  ///< in the metric's unit; they differ, and the expert's is the better one
  std::string source;             ///< who measured it, on what
  std::string advice;             ///< how to come nearer to the expert, one sentence
};

/// A structure that a case must have labeled.
struct NeededStructure {
  Label label = kVein;
  std::string why;  ///< what would be lost without it, the end of a sentence
};

/// Steps, rules, norms and target of a procedure, as data.
struct Procedure {
  std::string name, title;
  int version = 1;
  std::vector<NeededStructure> needs;
  std::string target;  ///< what a case calls the vein, a part of its target's name; empty: any
  std::vector<PatientPosition> positions;
  std::vector<ProcedureStep> steps;  ///< at least one; in order
  std::size_t passBegins = 0;        ///< the step to which a needle that is pulled out too early goes back
  std::vector<ProcedureRule> rules;
  std::vector<MetricLimit> success;  ///< all of them beyond at the end
  std::vector<MetricNorm> norms;     ///< one a metric at most; of the others none is known
};

/// The presets of resources/procedures.
std::vector<std::string> procedurePresetNames();
/// Loads a preset by name, or a JSON file of the same form. Fails with a sentence that names the place, the error and
/// the possible values.
Result<Procedure> loadProcedure(std::string_view nameOrPath);
Result<Procedure> parseProcedure(std::string_view json);

}  // namespace insonate
