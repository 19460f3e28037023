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

/// One thing that hands do. Lengths in patient space, mm; hands move at `speed_mmps` where they move.
struct SessionAct {
  struct PutProbe {
    Transform patientFromProbe;
  };
  struct LiftProbe {};
  struct MoveProbe {  ///< straight, as it looks
    Vec3 to_mm;       ///< the middle of its face
    double speed_mmps = 10;
  };
  struct PutNeedle {  ///< outside, its tip at `from_mm`, pointing to `to_mm`
    Vec3 from_mm, to_mm;
  };
  struct MoveNeedle {  ///< along its direction, back when negative
    double by_mm = 0, speed_mmps = 10;
  };
  struct Wait {
    double seconds = 0;
  };
  struct Aspirate {
    bool on = false;
  };
  struct Tell {  ///< replaced, frozen, released, positioned
    AttemptEventKind kind = AttemptEventKind::NeedleReplaced;
    double tilt_deg = 0;
  };
  std::variant<PutProbe, LiftProbe, MoveProbe, PutNeedle, MoveNeedle, Wait, Aspirate, Tell> what;
};

struct SessionScript {
  std::string procedure = "internal_jugular", probe = "linear";
  bool abandoned = false;  ///< how it ends
  std::vector<SessionAct> acts;
};

/// Reads a script; modules/simulator/README.md describes the form. Fails with a sentence that names the act, counted
/// from 1.
Result<SessionScript> readSessionScript(std::string_view json, const PatientCase& patient);

/// The scripts that come along: resources/procedures/attempts.
std::vector<std::string> sessionScriptNames();

/// A script that comes along, by name, or a file. Fails as readSessionScript() does, and where there is neither.
Result<SessionScript> loadSessionScript(std::string_view nameOrPath, const PatientCase& patient);

struct SessionOutcome {
  AttemptStatus status = AttemptStatus::Completed;
  MetricValues metrics;
  std::vector<AttemptEvent> events;
  ProcedureRun run;
};

/// Images on the way, as AttemptPictures makes them of the recording.
struct SessionPictures {
  std::int64_t every_us = 1'000'000;  ///< of the script's time, a multiple of 1000; the first at the first multiple
  /// Called while a probe is held, once for a frozen image; a failure ends the session. Empty: no images are made.
  std::function<Result<void>(const LiveFrame&)> take;
};

/// Runs a whole attempt without a window, device or clock: hands at the script's poses pass through the servo at 1 kHz
/// into a recording. Where the script puts the probe's face below the undeformed skin, it compresses: 30 times per
/// second of the script's time the tissue is solved, from rest, for the probe's force and the place of the tissue that
/// the needle meets. Faster than real time, unless images are made or the probe moves through tissue. The same script,
/// case and program give the same attempt. `software` is name and version, for the header, which says that a script
/// moved the hands. Cancelled, it leaves no file.
Result<SessionOutcome> runSession(const SessionScript& script, const PatientCase& patient, std::string_view software,
                                  const std::filesystem::path& recording, const Progress& progress = {},
                                  const SessionPictures& pictures = {});

}  // namespace insonate
