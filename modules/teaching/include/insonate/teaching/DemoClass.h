#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Size and random seed of a demonstration class: invented people and attempts, for demonstrations and benchmarks.
struct DemoClassPlan {
  int trainees = 20;
  int attempts = 50;  ///< number of attempts of each trainee
  std::uint32_t seed = 1;
  /// Time (since 1970, UTC) before which all attempts take place; the last attempt of each trainee is in the ten days
  /// before it.
  std::int64_t until_us = 1'767'258'000'000'000;
};

/// Generates the attempts of an invented trainee, in their order, without person and id. Each trainee has an initial
/// skill, an attainable skill and a learning rate. As the skill increases, each metric changes from the value of
/// novices to that of experts (the norms of the procedure, else round numbers), with random variation. After every five
/// attempts the trainee proceeds to the first open level. The same number of the trainee and the same seed give the
/// same attempts.
Result<std::vector<AttemptFacts>> demoAttempts(const Curriculum& curriculum, int trainee, const DemoClassPlan& plan);

inline constexpr const char *kDemoAdministrator = "made-up-administrator", *kDemoInstructor = "made-up-teacher",
                            *kDemoClass = "Made-up class", *kDemoHalfClass = "Made-up class, second half";

/// Fills an empty database with a demonstration class: an administrator, an instructor, the published curriculum, a
/// class of all trainees, and a class of the second half of the trainees. All names begin with "made-up", and all
/// accounts have the given password. Fails if the database has people, or if cancelled; data that was added until then
/// stays.
Result<void> makeDemoClass(const CurriculumStore& store, const Curriculum& curriculum, const DemoClassPlan& plan,
                           const std::string& password, const Progress& progress = {});

/// Adds recordings to a class that makeDemoClass() has made: the n-th recording becomes the newest attempt of the n-th
/// trainee, at the first level of the curriculum, with the metrics and points of the recording. Fails if there are
/// fewer trainees than recordings, if a recording cannot be scored, or if its procedure is not the level's.
Result<void> addRecordedAttempts(const CurriculumStore& store, const Curriculum& curriculum,
                                 const std::vector<std::filesystem::path>& recordings, const std::string& password);

}  // namespace insonate
