#pragma once

#include <insonate/curriculum/Person.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate {

struct Grade {
  Person person{};
  std::optional<double> percent{};  ///< empty: not graded yet
  std::string feedback{};
};

enum class GradeKey { Email, Name };  ///< key by which a learning management system identifies people

/// A person who is left out of the grades.
struct UngradedPerson {
  std::string fullName{};
  std::string why{};  ///< "no grade yet", "no e-mail address", "no name"
};

struct GradeBook {
  std::string csv{};
  std::vector<UngradedPerson> leftOut{};
};

/// Grades for Moodle's import: a column "Email address" or "ID number", a column `item`, and a column of feedback if
/// anyone has feedback. People without a grade are left out, with their feedback: Moodle would import the empty grade
/// next to the feedback and overwrite an existing grade.
GradeBook gradeBook(const std::string& item, GradeKey key, std::span<const Grade> grades);

}  // namespace insonate
