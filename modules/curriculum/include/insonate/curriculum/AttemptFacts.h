#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

enum class AttemptState {
  Open,       ///< begun, not ended: its workstation is at it, or has died
  Completed,  ///< to the end of its procedure
  Abandoned,  ///< ended early, by the trainee or by a crash
  Voided,     ///< taken out of the count by an instructor, with a reason; kept
};

/// Evidence that an attempt was made as its facts say.
enum class AttemptProof {
  Unproven,       ///< nothing: its recording was made for another store, by an earlier program or by nobody known
  Proven,         ///< its recording: whole, and keyed as the store asked when the attempt began
  Accepted,       ///< an instructor or administrator, by name, although nothing proves it
  Earlier,        ///< nothing was asked: it was kept before there were proofs
  Demonstration,  ///< it is made up, and says so (`curriculum demo`)
};

/// A metric's value as it was measured; a missing one stays missing.
struct MetricFact {
  std::string id{};  ///< as in procedure/AttemptMetrics.h: "vein_punctures"
  int version = 0;   ///< of its definition
  std::optional<double> value{};

  bool operator==(const MetricFact&) const = default;
};

/// Facts about one attempt; its samples are in its recording. After its end an attempt does not change; it can only be
/// voided.
struct AttemptFacts {
  std::string id{};          ///< UUID, made where the attempt was begun
  std::string person{};      ///< Person::id
  std::string curriculum{};  ///< Curriculum::name; "": free practice
  int curriculumVersion = 0;
  std::string level{};  ///< Level::name; "": free practice
  std::string procedure{};
  int procedureVersion = 0;
  std::string caseName{}, caseHash{};
  std::string workstation{};   ///< where it was made
  std::int64_t begun_us = 0;   ///< since 1970, UTC, by the workstation's clock, which may have been wrong
  std::int64_t length_us = 0;  ///< by a clock that does not jump
  AttemptState state = AttemptState::Open;
  bool succeeded = false;
  int criticalErrors = 0;
  std::optional<double> points{};     ///< 0..100
  std::vector<MetricFact> metrics{};  ///< those that were defined then
  std::string recording{};            ///< file name within the workstation's recordings; "": there is none
  std::string recordingHash{};        ///< SHA-256 of the file, hexadecimal
  /// BLAKE2b (256 bits, hexadecimal) of the hands' motion, independent of the recording's header. Empty if the hands
  /// did nothing, if there is no recording, or if an earlier program stored the attempt.
  std::string handsHash{};
  AttemptProof proof = AttemptProof::Unproven;

  bool operator==(const AttemptFacts&) const = default;
};

}  // namespace insonate
