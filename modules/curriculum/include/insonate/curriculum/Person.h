#pragma once

#include <string>

namespace insonate {

enum class Role { Trainee, Instructor, Administrator };

/// A user with an account.
struct Person {
  std::string id{};        ///< UUID of the person
  std::string name{};      ///< name for signing in; unique, ignoring case
  std::string fullName{};  ///< name shown to others
  std::string email{};     ///< e-mail address, or empty
  Role role = Role::Trainee;
  bool disabled = false;  ///< true: the person cannot sign in; all data is kept

  bool operator==(const Person&) const = default;
};

/// A class: people who are taught together, with one version of one curriculum.
struct Cohort {
  std::string id{};  ///< UUID of the cohort
  std::string name{};
  std::string curriculum{};  ///< name of the curriculum (Curriculum::name); "": none yet
  int curriculumVersion = 0;
  bool archived = false;  ///< true: the class has ended; it takes neither new members nor openings of tests

  bool operator==(const Cohort&) const = default;
};

/// Returns the name of a class as lists show it: "Spring" or "Spring (archived)".
inline std::string listedName(const Cohort& cohort) {
  return cohort.archived ? cohort.name + " (archived)" : cohort.name;
}

}  // namespace insonate
