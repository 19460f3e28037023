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
  Guided,  ///< each step is said, hints and CT are shown
  Hints,   ///< hints only when something goes wrong
  Test,    ///< neither
};
/// Name in files: "guided", "hints", "test".
std::string_view nameOf(Assistance assistance);

/// The value that a metric has to reach in one attempt. A missing value, or one measured by another version of the
/// metric's definition, does not reach it.
struct MetricStandard {
  std::string metric{};  ///< MetricFact::id
  int version = 1;
  std::optional<double> least{}, most{};  ///< one of the two
  std::string otherwise{};                ///< what is said where it is not met: "the artery was punctured"
  std::string source{};                   ///< why this limit
  bool critical = false;                  ///< an attempt that does not meet it fails, whatever the share

  bool operator==(const MetricStandard&) const = default;
};

/// Conditions for passing one attempt: completed, succeeded, without a critical error, and:
struct PassRule {
  std::optional<double> leastPoints{};  ///< of AttemptFacts::points
  std::vector<MetricStandard> standards{};
  double mastery_percent = 100;  ///< minimum share of the standards that are met, and all critical ones

  bool operator==(const PassRule&) const = default;
};

/// The learning curve test LC-CUSUM (LcCusum.h): mastery waits for its signal.
struct CusumRule {
  double acceptable = 0.1, unacceptable = 0.25;  ///< rates of failure
  double limit = 3.1;  ///< h: what the score has to reach; 8.9 % do within 50 attempts falsely

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
  std::optional<int> lapsesAfter_days{};  ///< without an attempt here or in a level that builds on this one
  std::optional<FailureRule> lapsesAfter{};
  std::string source{};

  bool operator==(const MasteryRule&) const = default;
};

struct Level {
  std::string name{}, title{};
  std::string about{};     ///< what is learnt, one or two sentences
  std::string caseName{};  ///< of the case library, or a variant of the built-in neck
  std::string procedure{};
  std::string position{};  ///< of the procedure's positions; "": the trainee's choice
  Assistance assistance = Assistance::Guided;
  std::vector<std::string> prerequisites{};  ///< levels to be mastered before
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

/// The presets of resources/curricula.
std::vector<std::string> curriculumPresetNames();
/// Loads a preset by name, or a JSON file of the same form. Fails with a sentence that names the place, the error and
/// the possible values.
Result<Curriculum> loadCurriculum(std::string_view nameOrPath);
/// Levels may be written in any order; they come back in one in which they can be learnt. Refuses circles and
/// more than 200 levels.
Result<Curriculum> parseCurriculum(std::string_view json);
/// Inverse of parseCurriculum().
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

/// Checks that every name in the curriculum exists and that its standards ask for more of what is better. Fails with
/// the first violation.
Result<void> checkNames(const Curriculum& curriculum, const TeachingNames& known);

}  // namespace insonate
