#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/MetricMeaning.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Amount of help that a level gives during an attempt.
enum class Assistance {
  Guided,  ///< each step of the procedure is announced; hints and CT are shown
  Hints,   ///< hints are shown only if something goes wrong
  Test,    ///< neither hints nor CT are shown
};
/// Returns the name of an assistance in files: "guided", "hints", "test".
std::string_view nameOf(Assistance assistance);

/// Limit that the value of a metric has to meet in one attempt. A missing value, or a value measured by another version
/// of the metric's definition, does not meet the limit.
struct MetricStandard {
  std::string metric{};  ///< id of the metric: MetricFact::id
  int version = 1;
  std::optional<double> minimum{}, maximum{};  ///< limit of the value; exactly one of the two is set
  std::string otherwise{};  ///< text shown to the trainee if the limit is not met, e.g. "the artery was punctured"
  std::string source{};     ///< justification of the limit, e.g. a publication
  bool critical = false;    ///< true: an attempt that misses this standard fails, even if it meets enough others

  bool operator==(const MetricStandard&) const = default;
};

/// Conditions for passing one attempt at a level. The attempt must also be completed and successful, without a critical
/// error.
struct PassRule {
  std::optional<double> minPoints{};  ///< minimum score (AttemptFacts::points); empty: none
  std::vector<MetricStandard> standards{};
  double mastery_percent = 100;  ///< minimum share of `standards` that are met; critical standards must all be met

  bool operator==(const PassRule&) const = default;
};

/// Parameters of the learning curve test LC-CUSUM (LcCusum.h); a level with this rule is mastered only after the test
/// has signaled.
struct CusumRule {
  double acceptable = 0.1, unacceptable = 0.25;  ///< failure rates of a trainee who is able, and of one who is not
  /// Threshold h of the score at which the test signals that the trainee is able. With the default of 3.1, the test
  /// wrongly signals for 8.9 % of trainees who are not able within 50 attempts.
  double limit = 3.1;

  bool operator==(const CusumRule&) const = default;
};

/// Rule by which mastery of a level lapses: at least `failures` of the last `within` attempts have failed.
struct FailureRule {
  int failures = 2, within = 3;

  bool operator==(const FailureRule&) const = default;
};

struct MasteryRule {
  int consecutivePasses = 1;
  std::optional<CusumRule> cusum{};
  /// mastery lapses after this number of days without an attempt at this level or at a level of which this level is a
  /// prerequisite; empty: never
  std::optional<int> lapsesAfter_days{};
  std::optional<FailureRule> lapsesAfter{};
  std::string source{};

  bool operator==(const MasteryRule&) const = default;
};

struct Level {
  std::string name{}, title{};
  std::string about{};     ///< description of the level, one or two sentences
  std::string caseName{};  ///< name of a case in the case library, or of a variant of the built-in neck
  std::string procedure{};
  std::string position{};  ///< name of a patient position of the procedure; "": the trainee chooses
  Assistance assistance = Assistance::Guided;
  std::vector<std::string> prerequisites{};  ///< names of levels that must be mastered first
  PassRule pass{};
  MasteryRule mastery{};

  bool operator==(const Level&) const = default;
};

/// A curriculum as data: levels with their prerequisites and passing standards. `levels` is in an order in which they
/// can be learned: the prerequisites of a level precede it.
struct Curriculum {
  std::string name{}, title{}, about{};
  int version = 1;
  std::vector<Level> levels{};

  const Level* level(std::string_view levelName) const;
  bool operator==(const Curriculum&) const = default;
};

/// Returns the names of the built-in curricula, which are in resources/curricula.
std::vector<std::string> curriculumPresetNames();
/// Loads a built-in curriculum by name, or a JSON file of the same format. Fails with a sentence that names the place,
/// the error and the possible values.
Result<Curriculum> loadCurriculum(std::string_view nameOrPath);
/// Reads a curriculum from JSON. Levels may be written in any order; they are returned in an order in which they can be
/// learned. Fails on circular prerequisites and on more than 200 levels.
Result<Curriculum> parseCurriculum(std::string_view json);
/// Writes a curriculum as JSON; inverse of parseCurriculum().
std::string curriculumText(const Curriculum& curriculum);

/// Names of cases, procedures and metrics that a curriculum may refer to in this installation.
struct TeachingNames {
  struct Procedure {
    std::string name{};
    std::vector<std::string> positions{};
  };
  std::vector<std::string> cases{};
  std::vector<Procedure> procedures{};
  std::vector<MetricMeaning> metrics{};
};

/// Checks that every case, procedure and metric that a curriculum names exists, and that a standard sets a minimum only
/// if higher values of its metric are better, a maximum only if lower values are. Fails with the first violation.
Result<void> checkNames(const Curriculum& curriculum, const TeachingNames& known);

}  // namespace insonate
