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

/// People who do not exist, for demonstrations and benchmarks.
struct MadeUpPlan {
  int trainees = 20;
  int attempts = 50;  ///< of each
  std::uint32_t seed = 1;
  /// Since 1970, UTC; each made their last in the ten days before.
  std::int64_t until_us = 1'767'258'000'000'000;
};

/// A made-up trainee's attempts, in the order in which they were made up, without person and id. Who they are decides
/// how good they begin, how good they can become and how fast; each metric goes from what novices reach to what experts
/// reach (the procedure's norms where there are some, else round numbers), and scatters. After each five attempts they
/// take up the first level that is open to them. The same trainee and seed give the same attempts.
Result<std::vector<AttemptFacts>> madeUpAttempts(const Curriculum& curriculum, int trainee, const MadeUpPlan& plan);

inline constexpr const char *kMadeUpAdministrator = "made-up-administrator", *kMadeUpTeacher = "made-up-teacher",
                            *kMadeUpClass = "Made-up class", *kMadeUpHalf = "Made-up class, second half";

/// Fills an empty store: an administrator, a teacher, the published curriculum, a class of all trainees and one of the
/// second half. All names begin with made-up, and all have this password. Fails if there are people, or when
/// cancelled; entries made until then stay.
Result<void> makeUpClass(const CurriculumStore& store, const Curriculum& curriculum, const MadeUpPlan& plan,
                         const std::string& password, const Progress& progress = {});

/// Adds each recording as the newest attempt of a trainee of makeUpClass(), starting with the first trainee, at the
/// curriculum's first level: metrics and points are those of the recording. Fails if there are fewer trainees than
/// recordings, if a recording cannot be scored, or if its procedure is not the level's.
Result<void> addRecordedAttempts(const CurriculumStore& store, const Curriculum& curriculum,
                                 const std::vector<std::filesystem::path>& recordings, const std::string& password);

}  // namespace insonate
