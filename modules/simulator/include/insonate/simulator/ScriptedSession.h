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

/// One action of the hands. Lengths in patient space, mm; hands that move do so at `speed_mmps`.
struct SessionAct {
  struct PutProbe {
    Transform patientFromProbe;
  };
  struct LiftProbe {};
  struct MoveProbe {  ///< straight, with constant angles
    Vec3 to_mm;       ///< position of the middle of the face
    double speed_mmps = 10;
  };
  struct PutNeedle {  ///< puts the needle outside the body: tip at `from_mm`, pointing to `to_mm`
    Vec3 from_mm, to_mm;
  };
  struct MoveNeedle {  ///< moves the needle along its direction; backward if negative
    double by_mm = 0, speed_mmps = 10;
  };
  struct Wait {
    double seconds = 0;
  };
  struct Aspirate {
    bool on = false;
  };
  struct Tell {  ///< reports an event: needle replaced, image frozen or released, patient positioned
    AttemptEventKind kind = AttemptEventKind::NeedleReplaced;
    double tilt_deg = 0;
  };
  std::variant<PutProbe, LiftProbe, MoveProbe, PutNeedle, MoveNeedle, Wait, Aspirate, Tell> what;
};

struct SessionScript {
  std::string procedure = "internal_jugular", probe = "linear";
  bool abandoned = false;  ///< true: the attempt ends as abandoned
  std::vector<SessionAct> acts;
};

/// Reads a script; modules/simulator/README.md describes the form. Fails with a sentence that names the act, counted
/// from 1.
Result<SessionScript> readSessionScript(std::string_view json, const PatientCase& patient);

/// Names of the built-in scripts in resources/procedures/attempts.
std::vector<std::string> sessionScriptNames();

/// Loads a built-in script by name, or a script from a file. Fails as readSessionScript() does, and if neither exists.
Result<SessionScript> loadSessionScript(std::string_view nameOrPath, const PatientCase& patient);

struct SessionOutcome {
  AttemptStatus status = AttemptStatus::Completed;
  MetricValues metrics;
  std::vector<AttemptEvent> events;
  ProcedureRun run;
};

/// Images made during the session, as AttemptPictures would make them from the recording.
struct SessionPictures {
  /// Interval in script time, a multiple of 1000; the first image is at the first multiple.
  std::int64_t every_us = 1'000'000;
  /// Receives each image while a probe is held; a frozen image only once. A failure ends the session. Empty: no images
  /// are made.
  std::function<Result<void>(const LiveFrame&)> take;
};

/// Runs a whole attempt without a window, device or clock: the hands take the poses of the script, pass through the
/// servo at 1 kHz, and are recorded. If the script puts the probe's face below the undeformed skin, the face compresses
/// the tissue. The tissue is then solved from rest 30 times per second of script time; the solution gives the probe's
/// force and the displaced tissue that the needle meets. Runs faster than real time, unless images are made or the
/// probe moves through tissue. The same script, case and program give the same attempt. `software` is name and version,
/// for the header, which also says that a script moved the hands. If cancelled, no file is left.
Result<SessionOutcome> runSession(const SessionScript& script, const PatientCase& patient, std::string_view software,
                                  const std::filesystem::path& recording, const Progress& progress = {},
                                  const SessionPictures& pictures = {});

}  // namespace insonate
