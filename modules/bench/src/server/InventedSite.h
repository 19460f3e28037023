#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/SignedIn.h>

#include <string>
#include <vector>

namespace insonate::bench {

inline constexpr const char* kMadeUpPassword = "made-up password";

struct MadeUpClass {
  std::string id{};
  std::string instructor{};  ///< sign-in name
  struct Trainee {
    std::string id{}, name{};
  };
  std::vector<Trainee> trainees{};
};

/// People, classes, workstations and earlier attempts of an invented site.
struct InventedSite {
  CurriculumStore store;
  SignedIn administrator;
  Curriculum curriculum;
  std::vector<MadeUpClass> classes;
  std::vector<std::string> tokens;  ///< tokens of "workstation 1" and the following ones
  int trainees = 0, attempts = 0;   ///< attempts: earlier attempts of all trainees together
};

/// Makes a site with trainees in classes of 25, and one workstation more than `workstations`, for trials. Fails if the
/// database has people, or if cancelled.
Result<InventedSite> makeSite(const CurriculumStore& store, int trainees, int workstations, const Progress& progress);

}  // namespace insonate::bench
