#pragma once

#include <string>

namespace insonate {

enum class Role { Trainee, Instructor, Administrator };

/// A user with an account. An instructor sees the instructor's own cohorts only.
struct Person {
  std::string id{};        ///< UUID
  std::string name{};      ///< name for signing in; unique, ignoring case
  std::string fullName{};  ///< name shown to others
  std::string email{};     ///< may be empty
  Role role = Role::Trainee;
  bool disabled = false;  ///< cannot sign in; the person's data is kept

  bool operator==(const Person&) const = default;
};

/// People who are taught together, by one version of one curriculum.
struct Cohort {
  std::string id{};  ///< UUID
  std::string name{};
  std::string curriculum{};  ///< Curriculum::name; "": no curriculum yet
  int curriculumVersion = 0;

  bool operator==(const Cohort&) const = default;
};

}  // namespace insonate
