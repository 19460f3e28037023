#pragma once

#include <insonate/curriculum/Person.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Grade of one person, for export to a learning management system.
struct Grade {
  Person person{};
  std::optional<double> percent{};  ///< grade, 0 to 100; empty: not graded yet
  std::string feedback{};
};

/// Property that identifies a person in a learning management system: the e-mail address or the name.
enum class GradeKey { Email, Name };

/// A person who is left out of exported grades.
struct UngradedPerson {
  std::string fullName{};
  std::string why{};  ///< reason: "no grade yet", "no e-mail address", "no name"
};

struct GradeBook {
  std::string csv{};
  std::vector<UngradedPerson> leftOut{};
};

/// Writes grades as CSV for Moodle's import: a column "Email address" or "ID number", a column with the title `item`,
/// and a column of feedback if any person has feedback. People without a grade are left out, even if they have
/// feedback, since Moodle would replace an existing grade by the empty one.
GradeBook gradeBook(const std::string& item, GradeKey key, std::span<const Grade> grades);

}  // namespace insonate
