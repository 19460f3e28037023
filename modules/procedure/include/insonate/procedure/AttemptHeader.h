#pragma once

#include <insonate/procedure/PictureField.h>

#include <cstdint>
#include <string>
#include <vector>

namespace insonate {

/// The attempt of a store to which a recording belongs; all empty if the recording belongs to no store. The store
/// issues the nonce when the attempt begins, for this person, level and id (curriculum/AttemptSeal.h).
struct RecordedFor {
  std::string attempt{}, person{};  ///< AttemptFacts::id, Person::id
  std::string curriculum{};         ///< "": free practice
  int curriculumVersion = 0;
  std::string level{};
  std::string nonce{};

  bool operator==(const RecordedFor&) const = default;
};

/// Case, devices and settings of an attempt. They allow a replay under the same conditions, or tell that it is not
/// possible.
struct AttemptHeader {
  std::string software{};   ///< "insonate 0.1.0"
  std::string begun{};      ///< ISO 8601, UTC
  std::string procedure{};  ///< id of the procedure
  int procedureVersion = 0;
  std::string caseName{}, caseHash{};
  std::string settingsHash{};  ///< hash of `settings`; the recorder fills it in
  std::string engine{};        ///< engine that made the images
  PictureField picture{};
  /// Names of the case's vessels, the target of this attempt first. Empty: the case has no target in a vein, and each
  /// vein counts as the target.
  std::vector<std::string> vessels{};
  /// Settings of probe, image, tissue and blood at the beginning of the attempt, JSON (simulator/AttemptSettings.h);
  /// empty: unknown.
  std::string settings{};
  bool isScripted = false;  ///< a script moved the hands: the recording is a demonstration, not a person's attempt
  RecordedFor recordedFor{};

  bool operator==(const AttemptHeader&) const = default;
};

/// Settings that replace the settings of the header, or of the previous change.
struct SettingsChange {
  std::int64_t time_us = 0;  ///< since the recording began
  std::string settings;      ///< all settings, as in AttemptHeader

  bool operator==(const SettingsChange&) const = default;
};

enum class AttemptStatus : std::uint8_t {
  Completed = 0,
  Abandoned = 1,
  CutShort = 2,  ///< the program or the disk ended the recording; never written
};

}  // namespace insonate
