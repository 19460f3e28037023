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
  Guided,  ///< each step is announced; hints and CT are shown
  Hints,   ///< hints are shown only if something goes wrong
  Test,    ///< neither hints nor CT are shown
};
/// Name in files: "guided", "hints", "test".
std::string_view nameOf(Assistance assistance);

/// The limit that a metric has to meet in one attempt. A missing value, or a value measured by another version of the
/// metric's definition, does not meet it.
struct MetricStandard {
  std::string metric{};  ///< MetricFact::id
  int version = 1;
  std::optional<double> least{}, most{};  ///< minimum or maximum; exactly one is set
  std::string otherwise{};                ///< text shown if the standard is not met: "the artery was punctured"
  std::string source{};                   ///< justification of the limit
  bool critical = false;  ///< an attempt that misses this standard fails, whatever share of standards it meets

  bool operator==(const MetricStandard&) const = default;
};

/// Conditions for passing one attempt. The attempt must be completed and successful, without a critical error, and meet
/// these:
struct PassRule {
  std::optional<double> leastPoints{};  ///< minimum of AttemptFacts::points
  std::vector<MetricStandard> standards{};
  double mastery_percent = 100;  ///< minimum share of standards met; critical standards must all be met

  bool operator==(const PassRule&) const = default;
};

/// Rule for the learning curve test LC-CUSUM (LcCusum.h): a level is mastered only after the test has signaled.
struct CusumRule {
  double acceptable = 0.1, unacceptable = 0.25;  ///< rates of failure
  /// Threshold h: score that signals; 8.9 % of trainees who are not able reach it falsely within 50 attempts.
  double limit = 3.1;

  bool operator==(const CusumRule&) const = default;
};

/// Rule by which a mastered level lapses: this many failures within the last attempts.
struct FailureRule {
  int failures = 2, within = 3;

  bool operator==(const FailureRule&) const = default;
};

struct MasteryRule {
  int passesInARow = 1;
  std::optional<CusumRule> cusum{};
  std::optional<int> lapsesAfter_days{};  ///< days without an attempt at this level or at one that builds on it
  std::optional<FailureRule> lapsesAfter{};
  std::string source{};

  bool operator==(const MasteryRule&) const = default;
};

struct Level {
  std::string name{}, title{};
  std::string about{};     ///< subject of the level, one or two sentences
  std::string caseName{};  ///< name in the case library, or a variant of the built-in neck
  std::string procedure{};
  std::string position{};  ///< a position of the procedure; "": the trainee chooses
  Assistance assistance = Assistance::Guided;
  std::vector<std::string> prerequisites{};  ///< levels that must be mastered first
  PassRule pass{};
  MasteryRule mastery{};

  bool operator==(const Level&) const = default;
};

/// Levels, their order and their passing standards, as data. A level depends on earlier levels only: `levels` is a
/// valid learning order.
struct Curriculum {
  std::string name{}, title{}, about{};
  int version = 1;
  std::vector<Level> levels{};

  const Level* level(std::string_view levelName) const;
  bool operator==(const Curriculum&) const = default;
};

/// Names of the presets of resources/curricula.
std::vector<std::string> curriculumPresetNames();
/// Loads a preset by name, or a JSON file of the same form. Fails with a sentence that names the place, the error and
/// the possible values.
Result<Curriculum> loadCurriculum(std::string_view nameOrPath);
/// Reads a curriculum. Levels may be written in any order; they are returned in an order in which they can be learned.
/// Fails on circular prerequisites and on more than 200 levels.
Result<Curriculum> parseCurriculum(std::string_view json);
/// Writes a curriculum; inverse of parseCurriculum().
std::string curriculumText(const Curriculum& curriculum);

/// Names that a curriculum may refer to in this installation.
struct TeachingNames {
  struct Procedure {
    std::string name{};
    std::vector<std::string> positions{};
  };
  std::vector<std::string> cases{};
  std::vector<Procedure> procedures{};
  std::vector<MetricMeaning> metrics{};
};

/// Checks that every name in the curriculum exists. Also checks that a standard sets a minimum only if higher values of
/// its metric are better, and a maximum only if lower values are better. Fails with the first violation.
Result<void> checkNames(const Curriculum& curriculum, const TeachingNames& known);

}  // namespace insonate
