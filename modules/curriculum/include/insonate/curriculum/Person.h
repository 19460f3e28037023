#pragma once

#include <string>

namespace insonate {

enum class Role { Trainee, Instructor, Administrator };

/// A user with an account. An instructor sees the instructor's own cohorts only.
struct Person {
  std::string id{};        ///< UUID
  std::string name{};      ///< to sign in; unique, whatever its case
  std::string fullName{};  ///< as others see it
  std::string email{};     ///< may be empty
  Role role = Role::Trainee;
  bool disabled = false;  ///< cannot sign in; what they did stays

  bool operator==(const Person&) const = default;
};

/// People who are taught together, by one version of one curriculum.
struct Cohort {
  std::string id{};  ///< UUID
  std::string name{};
  std::string curriculum{};  ///< Curriculum::name; "": none yet
  int curriculumVersion = 0;

  bool operator==(const Cohort&) const = default;
};

}  // namespace insonate
