#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/procedure/ProcedureRun.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/ultrasound/Probe.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>
#include <variant>
#include <vector>

namespace insonate {

/// One action of a scripted attempt on probe or needle. Positions are in patient space, mm; motions have the speed
/// `speed_mmps`.
struct ScriptAction {
  struct PlaceProbe {
    Transform patientFromProbe;
  };
  struct LiftProbe {};
  struct MoveProbe {  ///< moves the probe along a straight line, with constant angles
    Vec3 to_mm;       ///< final position of the middle of the probe's face
    double speed_mmps = 10;
  };
  struct PlaceNeedle {  ///< puts the needle outside the body: tip at `from_mm`, pointing to `to_mm`
    Vec3 from_mm, to_mm;
  };
  struct MoveNeedle {  ///< moves the needle along its direction by `by_mm`; negative: withdraws it
    double by_mm = 0, speed_mmps = 10;
  };
  struct Wait {
    double seconds = 0;
  };
  struct Aspirate {
    bool on = false;
  };
  struct ReportEvent {  ///< reports an event: needle replaced, image frozen or released, or patient positioned
    AttemptEventKind kind = AttemptEventKind::NeedleReplaced;
    double tilt_deg = 0;
  };
  struct PerformAct {  ///< performs an act of the line; the session fails if the act is not possible
    LineAct act = LineAct::CheckConsent;
    int lumen = 1;
  };
  /// Moves wire, dilator or catheter into the body, or out of it if `by_mm` is negative. An instrument that is held
  /// back stops; the script continues.
  struct MoveInstrument {
    Instrument instrument = Instrument::Wire;
    double by_mm = 0, speed_mmps = 20;
  };
  std::variant<PlaceProbe, LiftProbe, MoveProbe, PlaceNeedle, MoveNeedle, Wait, Aspirate, ReportEvent, PerformAct,
               MoveInstrument>
      what;
};

/// A scripted attempt: procedure, probe and the actions in their order.
struct SessionScript {
  std::string procedure = "internal_jugular", probe = "linear";
  bool abandoned = false;  ///< true: the attempt ends as abandoned, else as completed
  std::vector<ScriptAction> actions;
};

/// Reads a session script from JSON; modules/simulator/README.md describes the format. Fails with a sentence that names
/// the action, counted from 1.
Result<SessionScript> readSessionScript(std::string_view json, const PatientCase& patient);

/// Returns the names of the built-in session scripts, which are in resources/procedures/attempts.
std::vector<std::string> sessionScriptNames();

/// Loads a session script: a built-in script by name, or a file. Fails if neither exists, or as readSessionScript()
/// does.
Result<SessionScript> loadSessionScript(std::string_view nameOrPath, const PatientCase& patient);

/// Results of a scripted attempt.
struct SessionOutcome {
  AttemptStatus status = AttemptStatus::Completed;
  MetricValues metrics;
  std::vector<AttemptEvent> events;
  ProcedureRun run;
};

/// Request for ultrasound images during a scripted attempt. The images equal those that AttemptImages makes from the
/// recording.
struct SessionImages {
  /// Interval between images in script time, a multiple of 1000. The first image is made at the end of the first
  /// interval.
  std::int64_t every_us = 1'000'000;
  /// Function that receives each image while the probe is on the patient; a frozen image only once. If the function
  /// returns an error, the session fails with this error. Empty: no images are made.
  std::function<Result<void>(const LiveFrame&)> take;
};

/// Runs a whole attempt by a script, without window, device or clock. Probe and needle take the poses of the script;
/// the force loop computes each tick of 1 ms, and the ticks are recorded. If the probe's face is below the undeformed
/// skin, the compression of the tissue is computed 30 times per second of script time, each time from the undeformed
/// state. The compression determines the force on the probe and the displacement of the tissue around the needle. The
/// session runs faster than real time, unless images are made or the probe moves while it compresses tissue. The same
/// script, case and program give the same attempt. `software`: name and version of the program for the recording's
/// header, which also says that the attempt was scripted. If cancelled, no file is left.
Result<SessionOutcome> runSession(const SessionScript& script, const PatientCase& patient, std::string_view software,
                                  const std::filesystem::path& recording, const Progress& progress = {},
                                  const SessionImages& pictures = {});

}  // namespace insonate
