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

/// Patient position that a procedure permits: a tilt of the table. Other positions, such as a turned head, would move
/// muscles and vessels and therefore need another case.
struct PatientPosition {
  std::string name;
  double tilt_deg = 0;  ///< tilt of the table; positive: head down; -45 to 45
};

/// Event that completes a step of a procedure.
struct EventCondition {
  AttemptEventKind kind = AttemptEventKind::Entered;
  std::optional<Label> wall;               ///< structure whose wall the event must concern; empty: any structure
  std::optional<LineAct> act{};            ///< act of a Performed event; empty: any act
  std::optional<Instrument> instrument{};  ///< instrument of an event of the line; empty: any instrument
};
/// State that completes a step of a procedure once the state has lasted for `for_s`.
struct StateCondition {
  enum class What {
    ProbeOnSkin,
    AspiratingInVein,
    Performed,            ///< `act` has been performed
    SyringeOff,           ///< the needle is in the body, and its syringe is off
    WireSeenInShortAxis,  ///< the live image has shown the wire in the target vein, in short axis
    WireSeenInLongAxis,
    LumensFlushed,   ///< all lumens of the catheter are flushed
    NeedleOffWire,   ///< the wire is in the body, and the needle is not
    SkinNicked,      ///< the skin is nicked for the wire that is in the body
    DilatorRemoved,  ///< a vessel was dilated over this wire, and the dilator is out again
    VeinsSurveyed,   ///< the probe has compressed at least `veins` different veins of the case
    /// the wire is in the target vein, without a kink, by `wire_mm` or until it has irritated the heart; like the
    /// states below, it implies the steps before it
    WireInTarget,
    VesselDilated,        ///< the dilator has entered a vessel over this wire
    CatheterInTarget,     ///< the catheter is in the target vein
    CatheterWithoutWire,  ///< the catheter is in a vessel, and the wire is out
  };
  What what = What::ProbeOnSkin;
  double for_s = 0;
  LineAct act = LineAct::CheckConsent;  ///< act of Performed
  int veins = 1;                        ///< number of veins of VeinsSurveyed, 1 to 20
  double wire_mm = 0;                   ///< length of wire in the body of WireInTarget, 0 to 700
};

struct ProcedureStep {
  std::string name, title;
  std::string instruction;  ///< instruction for the trainee
  bool optional = false;    ///< true: later steps can be completed without this step
  std::variant<EventCondition, StateCondition> until;
};

/// Limit of a metric. A missing value is never beyond the limit.
struct MetricLimit {
  Metric metric = Metric::VeinPunctures;
  std::optional<double> over, under;  ///< maximum (`over`) or minimum (`under`); exactly one is set

  bool isBeyond(std::optional<double> value) const {
    return value && ((over && *value > *over) || (under && *value < *under));
  }
};

enum class Severity { Minor, Major, Critical };

/// Definition of an error: a metric beyond a limit, with its severity and texts.
struct ProcedureRule {
  std::string name;
  /// limit whose violation is the error; if the metric is a count, each further increase is another error; other
  /// metrics cause at most one error
  MetricLimit limit;
  Severity severity = Severity::Minor;
  std::string text;    ///< text for the trainee: the error, and what to do
  std::string advice;  ///< advice for the next attempt, one sentence, or empty
};

/// Published values of a metric for novices and experts.
struct MetricNorm {
  Metric metric = Metric::VeinPunctures;
  /// Published values in the metric's unit. They differ; the expert's value is the better one.
  double novice = 0, expert = 0;
  std::string source;  ///< study in which the values were measured
  std::string advice;  ///< advice on how to come closer to the expert's value, one sentence
};

/// A structure that must be labeled in a case, so that the procedure can be done on it.
struct NeededStructure {
  Label label = kVein;
  std::string why;  ///< consequence of a missing structure; worded as the end of a sentence
};

/// A clinical procedure as data: steps, errors, published norms and target.
struct Procedure {
  std::string name, title;
  int version = 1;
  std::vector<NeededStructure> needs;
  /// text that the name of a case's target must contain, or a name of the same vessel in another language
  /// (namesVessel()); empty: any target
  std::string target;
  std::vector<PatientPosition> positions;
  std::vector<ProcedureStep> steps;  ///< steps in their order, at least one
  /// index of the step to which the attempt returns if the needle leaves the body before all steps that need the needle
  /// are done
  std::size_t passBegins = 0;
  std::vector<ProcedureRule> rules;
  /// conditions of success: at the end of the attempt, the value of each of these metrics must be beyond its limit
  std::vector<MetricLimit> success;
  std::vector<MetricNorm> norms;  ///< published values, at most one for each metric; metrics without an entry have none
};

/// Tells whether a procedure continues after the puncture, with wire, dilator and catheter.
bool hasLine(const Procedure& procedure);

/// Returns the names of the built-in procedures, which are in resources/procedures.
std::vector<std::string> procedurePresetNames();
/// Returns the built-in procedure with this name. Reads no file, so that the name may come from another computer, as in
/// a recording or a curriculum. Fails with a sentence that names the built-in procedures.
Result<Procedure> builtInProcedure(std::string_view name);
/// Loads a built-in procedure by name, or a JSON file of the same format. The name must come from the user of this
/// program. Fails with a sentence that names the place, the error and the possible values.
Result<Procedure> loadProcedure(std::string_view nameOrPath);
Result<Procedure> parseProcedure(std::string_view json);

}  // namespace insonate
