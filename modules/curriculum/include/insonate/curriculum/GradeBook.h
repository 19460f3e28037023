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

/// Somebody without a line.
struct UngradedPerson {
  std::string fullName{};
  std::string why{};  ///< "no grade yet", "no e-mail address", "no name"
};

struct GradeBook {
  std::string csv{};
  std::vector<UngradedPerson> leftOut{};
};

/// For Moodle's import of grades: "Email address" or "ID number", then `item`, then its feedback where anyone has some.
/// Who has no grade is left out, with the feedback: Moodle would take an empty grade beside it for one and wipe theirs.
GradeBook gradeBook(const std::string& item, GradeKey key, std::span<const Grade> grades);

}  // namespace insonate
