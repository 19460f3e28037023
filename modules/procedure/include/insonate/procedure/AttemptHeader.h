#pragma once

#include <insonate/procedure/TipInView.h>

#include <cstdint>
#include <string>
#include <vector>

namespace insonate {

/// Identifies the recorded attempt in a curriculum store (database of people and attempts). All members are empty if
/// the recording belongs to no store. When the attempt begins, the store issues the nonce for this person, level and
/// attempt id (curriculum/AttemptSeal.h).
struct RecordedFor {
  std::string attempt{}, person{};  ///< ids of attempt and person: AttemptFacts::id, Person::id
  std::string curriculum{};         ///< name of the curriculum; "": free practice
  int curriculumVersion = 0;
  std::string level{};
  std::string nonce{};

  bool operator==(const RecordedFor&) const = default;
};

/// Kinds of the hands that moved the tools when the attempt began: "mouse" (mouse and keys), "simulated", or a name of
/// DeviceKind ("force", "motion", "camera", "tracker", "controller"). Empty: unknown, in recordings before December
/// 2026.
struct HandKinds {
  std::string probe{}, needle{};

  bool operator==(const HandKinds&) const = default;
};

/// Header of a recording: procedure, case and settings of the attempt. A replay uses the same procedure, case and
/// settings, and fails if they are not available.
struct AttemptHeader {
  std::string software{};   ///< name and version of the program that made the recording: "insonate 0.1.0"
  std::string begun{};      ///< time at which the attempt began: ISO 8601, UTC
  std::string procedure{};  ///< id of the procedure
  int procedureVersion = 0;
  std::string caseName{}, caseHash{};
  std::string settingsHash{};  ///< hash of `settings`; the recorder computes the hash
  std::string engine{};        ///< name of the ultrasound engine that made the images
  ImageField picture{};
  /// Names of the case's vessels; the first one is the target vein of this attempt. Empty: the case has no target in a
  /// vein, and every vein counts as the target.
  std::vector<std::string> vessels{};
  /// Settings of probe, image, tissue and blood at the beginning of the attempt, JSON (simulator/AttemptSettings.h);
  /// empty: unknown.
  std::string settings{};
  /// true: a script moved probe and needle; the recording is a demonstration, not a person's attempt
  bool isScripted = false;
  RecordedFor recordedFor{};
  HandKinds hands{};

  bool operator==(const AttemptHeader&) const = default;
};

/// Change of settings during an attempt. The new settings replace the settings of the header or of the previous change.
struct SettingsChange {
  std::int64_t time_us = 0;  ///< time of the change since the recording began
  std::string settings;      ///< all settings, in the form of AttemptHeader::settings

  bool operator==(const SettingsChange&) const = default;
};

enum class AttemptStatus : std::uint8_t {
  Completed = 0,
  Abandoned = 1,
  CutShort = 2,  ///< the recording has no end, because the program or the disk failed; this value is never stored
};

}  // namespace insonate
