#pragma once

#include <insonate/procedure/PictureField.h>

#include <cstdint>
#include <string>
#include <vector>

namespace insonate {

/// Which attempt of a store a recording is of; all empty where it belongs to none. The store gives the nonce as the
/// attempt begins, to this person, level and id (curriculum/AttemptSeal.h).
struct RecordedFor {
  std::string attempt{}, person{};  ///< AttemptFacts::id, Person::id
  std::string curriculum{};         ///< "": free practice
  int curriculumVersion = 0;
  std::string level{};
  std::string nonce{};

  bool operator==(const RecordedFor&) const = default;
};

/// What an attempt was made on and with, so that it can be replayed on the same or be told that it cannot.
struct AttemptHeader {
  std::string software{};   ///< "insonate 0.1.0"
  std::string begun{};      ///< ISO 8601, UTC
  std::string procedure{};  ///< its id
  int procedureVersion = 0;
  std::string caseName{}, caseHash{};
  std::string settingsHash{};  ///< of `settings`; the recorder fills it in
  std::string engine{};        ///< that made the pictures
  PictureField picture{};
  /// Names of the vessels that the case names, the target of this attempt first; empty: the case has no target in a
  /// vein, and each vein counts as the target.
  std::vector<std::string> vessels{};
  /// Of probe, picture, tissue and blood as the attempt began, JSON (simulator/AttemptSettings.h); "": not known.
  std::string settings{};
  bool isScripted = false;  ///< a script moved the hands: the recording is a demonstration and nobody's attempt
  RecordedFor recordedFor{};

  bool operator==(const AttemptHeader&) const = default;
};

/// What replaced the settings of the header, or of the change before.
struct SettingsChange {
  std::int64_t time_us = 0;  ///< since the recording began
  std::string settings;      ///< all of them anew, as in AttemptHeader

  bool operator==(const SettingsChange&) const = default;
};

enum class AttemptStatus : std::uint8_t {
  Completed = 0,
  Abandoned = 1,
  CutShort = 2,  ///< the program or the disk ended it; never written
};

}  // namespace insonate
