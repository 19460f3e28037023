#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

enum class AttemptState {
  Open,       ///< begun, not ended: its workstation is still running it, or has crashed
  Completed,  ///< carried out to the end of its procedure
  Abandoned,  ///< ended early, by the trainee or by a crash
  Voided,     ///< excluded from the count by an instructor, with a reason; still stored
};

/// Evidence that an attempt was made as its facts say.
enum class AttemptProof {
  Unproven,       ///< no evidence: the recording was made for another store or by an earlier program, or its origin is
                  ///< unknown
  Proven,         ///< proved by its recording, which is complete and keyed as the store required when the attempt began
  Accepted,       ///< accepted without evidence by an instructor or administrator, whose name is stored
  Earlier,        ///< stored before proofs existed, so that none was required
  Demonstration,  ///< made up, and marked as such (`curriculum demo`)
};

/// A metric's measured value; a missing value stays missing.
struct MetricFact {
  std::string id{};  ///< as in procedure/AttemptMetrics.h: "vein_punctures"
  int version = 0;   ///< version of the metric's definition
  std::optional<double> value{};

  bool operator==(const MetricFact&) const = default;
};

/// Facts about one attempt; its samples are in its recording. After its end an attempt does not change, except that it
/// can be voided.
struct AttemptFacts {
  std::string id{};          ///< UUID, made by the workstation at which the attempt was begun
  std::string person{};      ///< Person::id
  std::string curriculum{};  ///< Curriculum::name; "": free practice
  int curriculumVersion = 0;
  std::string level{};  ///< Level::name; "": free practice
  std::string procedure{};
  int procedureVersion = 0;
  std::string caseName{}, caseHash{};
  std::string workstation{};   ///< workstation at which the attempt was made
  std::int64_t begun_us = 0;   ///< since 1970, UTC, by the workstation's clock, which may be wrong
  std::int64_t length_us = 0;  ///< measured by a clock that does not jump
  AttemptState state = AttemptState::Open;
  bool succeeded = false;
  int criticalErrors = 0;
  std::optional<double> points{};     ///< 0..100
  std::vector<MetricFact> metrics{};  ///< the metrics that existed when the attempt was made
  std::string recording{};            ///< file name within the workstation's recordings; "": no recording
  std::string recordingHash{};        ///< SHA-256 of the file, hexadecimal
  /// BLAKE2b (256 bits, hexadecimal) of the hands' motion, independent of the recording's header. Empty if the hands
  /// did nothing, if there is no recording, or if an earlier program stored the attempt.
  std::string handsHash{};
  AttemptProof proof = AttemptProof::Unproven;

  bool operator==(const AttemptFacts&) const = default;
};

}  // namespace insonate
