#pragma once

#include <insonate/curriculum/Person.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate {

struct Grade {
  Person person{};
  std::optional<double> percent{};  ///< none: not graded yet
  std::string feedback{};
};

enum class GradeKey { Email, Name };  ///< how a learning management system knows people

/// A person who is left out.
struct UngradedPerson {
  std::string fullName{};
  std::string why{};  ///< "no grade yet", "no e-mail address", "no name"
};

struct GradeBook {
  std::string csv{};
  std::vector<UngradedPerson> leftOut{};
};

/// Grades for Moodle's import: "Email address" or "ID number", then `item`, then its feedback if anyone has some.
/// People without a grade are left out, with their feedback: Moodle would take an empty grade beside it for a grade
/// and overwrite theirs.
GradeBook gradeBook(const std::string& item, GradeKey key, std::span<const Grade> grades);

}  // namespace insonate
