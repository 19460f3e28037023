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
  double tilt_deg = 0;  ///< positive: head down; -45 to 45
};

/// An event that ends a step.
struct Happening {
  AttemptEventKind kind = AttemptEventKind::Entered;
  std::optional<Label> wall;  ///< empty: any wall
};
/// A state that ends a step once it has lasted for a time.
struct Holding {
  enum class What { ProbeOnSkin, AspiratingInVein };
  What what = What::ProbeOnSkin;
  double for_s = 0;
};

struct ProcedureStep {
  std::string name, title;
  std::string say;        ///< instruction for the trainee
  bool optional = false;  ///< later steps do not require this step
  std::variant<Happening, Holding> until;
};

/// A limit of a metric. A missing value never exceeds it.
struct MetricLimit {
  Metric metric = Metric::VeinPunctures;
  std::optional<double> over, under;  ///< maximum or minimum; exactly one is set

  bool isBeyond(std::optional<double> value) const {
    return value && ((over && *value > *over) || (under && *value < *under));
  }
};

enum class Severity { Minor, Major, Critical };

/// An error that an attempt must not contain.
struct ProcedureRule {
  std::string name;
  MetricLimit limit;  ///< for a count, each further increase is a new finding; for other metrics there is one finding
  Severity severity = Severity::Minor;
  std::string say;     ///< describes the error and what to do
  std::string advice;  ///< advice for the next attempt, one sentence; may be empty
};

/// Published values of a metric. The range between novice and expert is the part that can be learned.
struct MetricNorm {
  Metric metric = Metric::VeinPunctures;
  /// Values in the metric's unit; they differ, and the expert's value is the better one.
  double novice = 0, expert = 0;
  std::string source;  ///< study in which the values were measured
  std::string advice;  ///< advice for coming closer to the expert's value, one sentence
};

/// A structure that a case must have labeled.
struct NeededStructure {
  Label label = kVein;
  std::string why;  ///< consequence of a missing structure; the end of a sentence
};

/// Steps, rules, norms and target of a procedure, as data.
struct Procedure {
  std::string name, title;
  int version = 1;
  std::vector<NeededStructure> needs;
  std::string target;  ///< part of the name that a case's target must contain; empty: any target
  std::vector<PatientPosition> positions;
  std::vector<ProcedureStep> steps;  ///< at least one; in order
  std::size_t passBegins = 0;        ///< the step to which the attempt returns if the needle is pulled out too early
  std::vector<ProcedureRule> rules;
  std::vector<MetricLimit> success;  ///< limits that must all be exceeded at the end
  std::vector<MetricNorm> norms;     ///< at most one for each metric; other metrics have no known norm
};

/// Names of the presets of resources/procedures.
std::vector<std::string> procedurePresetNames();
/// Loads a preset by name, or a JSON file of the same form. Fails with a sentence that names the place, the error and
/// the possible values.
Result<Procedure> loadProcedure(std::string_view nameOrPath);
Result<Procedure> parseProcedure(std::string_view json);

}  // namespace insonate
