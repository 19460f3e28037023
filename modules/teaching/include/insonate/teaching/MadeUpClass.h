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

/// Plan of a class of invented people, for demonstrations and benchmarks.
struct MadeUpPlan {
  int trainees = 20;
  int attempts = 50;  ///< attempts of each trainee
  std::uint32_t seed = 1;
  /// Since 1970, UTC. Each trainee made the last attempt in the ten days before.
  std::int64_t until_us = 1'767'258'000'000'000;
};

/// Makes up a trainee's attempts, in order, without person and id. Each trainee has an initial skill, an attainable
/// skill and a learning rate. Each metric goes from the novice's to the expert's value (the procedure's norms if it has
/// some, else round numbers), with random scatter. After every five attempts the trainee takes up the first open level.
/// The same trainee and seed give the same attempts.
Result<std::vector<AttemptFacts>> madeUpAttempts(const Curriculum& curriculum, int trainee, const MadeUpPlan& plan);

inline constexpr const char *kMadeUpAdministrator = "made-up-administrator", *kMadeUpTeacher = "made-up-teacher",
                            *kMadeUpClass = "Made-up class", *kMadeUpHalf = "Made-up class, second half";

/// Fills an empty store: an administrator, an instructor, the published curriculum, a class of all trainees and a class
/// of the second half. All names begin with "made-up", and all accounts have this password. Fails if the store has
/// people, or if cancelled; entries made until then stay.
Result<void> makeUpClass(const CurriculumStore& store, const Curriculum& curriculum, const MadeUpPlan& plan,
                         const std::string& password, const Progress& progress = {});

/// Adds each recording as the newest attempt of a trainee of makeUpClass(), starting with the first trainee, at the
/// curriculum's first level: metrics and points are those of the recording. Fails if there are fewer trainees than
/// recordings, if a recording cannot be scored, or if its procedure is not the level's.
Result<void> addRecordedAttempts(const CurriculumStore& store, const Curriculum& curriculum,
                                 const std::vector<std::filesystem::path>& recordings, const std::string& password);

}  // namespace insonate
