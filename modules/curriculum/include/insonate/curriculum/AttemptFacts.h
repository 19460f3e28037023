#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

enum class AttemptState {
  Open,       ///< begun but not ended: the attempt is in progress at its workstation, or the workstation has crashed
  Completed,  ///< carried out to the end of the procedure
  Abandoned,  ///< ended early, by the trainee or by a crash
  Voided,     ///< excluded from all counts by an instructor, with a reason; still stored
};

/// Evidence that an attempt was really made and that its stored facts are true.
enum class AttemptProof {
  /// No evidence: the recording was made for another database or by an earlier version of the program, or its origin is
  /// unknown.
  Unproven,
  /// the server has received the attempt from a workstation, but has not verified it yet; counts like Unproven
  Verifying,
  /// Proven by the recording, which is complete and authenticated with the key that the database issued for the
  /// attempt.
  Proven,
  Accepted,       ///< accepted without evidence by an instructor or administrator, whose name is stored
  Earlier,        ///< the attempt was stored by an earlier version of the program, which did not require evidence
  Demonstration,  ///< generated demonstration data (`insonate-cli curriculum demo`)
};

/// Circumstances in which a test was taken (AttemptFacts::testConditions).
enum class TestConditions {
  None,  ///< the level was no test, or there was no level
  /// the attempt was stored by an earlier version of the program, in which tests were not opened by instructors
  Earlier,
  Opened,            ///< an instructor had opened the test (OpeningStore.h) when the attempt began
  SelfAdministered,  ///< the person had no class with another member, so that no instructor could open the test
  Practice,          ///< no test was open for the person: the attempt does not count
  /// not decided yet, since the beginning of the attempt was reported late. The database replaces this value when the
  /// attempt ends; until then the attempt does not count.
  Undecided,
};

/// Measured value of one metric of an attempt; empty if the attempt does not determine it.
struct MetricFact {
  std::string id{};  ///< id of the metric (procedure/AttemptMetrics.h): "vein_punctures"
  int version = 0;   ///< version of the metric's definition
  std::optional<double> value{};

  bool operator==(const MetricFact&) const = default;
};

/// Stored facts about one attempt; the motion of probe and needle is in its recording. The facts do not change after
/// the end of the attempt, except that the attempt can be voided.
struct AttemptFacts {
  std::string id{};          ///< UUID of the attempt, made by the workstation at which the attempt was begun
  std::string person{};      ///< id of the trainee: Person::id
  std::string curriculum{};  ///< name of the curriculum (Curriculum::name); "": free practice
  int curriculumVersion = 0;
  std::string level{};  ///< name of the level (Level::name); "": free practice
  std::string procedure{};
  int procedureVersion = 0;
  std::string caseName{}, caseHash{};
  std::string workstation{};  ///< workstation at which the attempt was made
  /// time at which the attempt began, since 1970, UTC, according to the clock of the workstation, which may be wrong
  std::int64_t begun_us = 0;
  std::int64_t length_us = 0;  ///< duration, measured by a monotonic clock
  AttemptState state = AttemptState::Open;
  bool succeeded = false;
  int criticalErrors = 0;
  std::optional<double> points{};     ///< score of the attempt, 0 to 100
  std::vector<MetricFact> metrics{};  ///< values of the metrics that existed when the attempt was made
  std::string recording{};            ///< file name within the workstation's recordings; "": no recording
  std::string recordingHash{};        ///< SHA-256 of the recording's file, hexadecimal
  /// BLAKE2b hash (256 bits, hexadecimal) of the recorded motion of probe and needle, without the header of the
  /// recording. Equal hashes reveal copied recordings. Empty if neither probe nor needle was moved, if there is no
  /// recording, or if an earlier version of the program stored the attempt.
  std::string handsHash{};
  AttemptProof proof = AttemptProof::Unproven;
  TestConditions testConditions = TestConditions::None;  ///< circumstances of a test; only the database decides them

  bool operator==(const AttemptFacts&) const = default;
};

}  // namespace insonate
