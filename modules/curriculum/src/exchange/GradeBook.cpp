#include <insonate/curriculum/Csv.h>
#include <insonate/curriculum/GradeBook.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

std::string keyOf(const Person& person, GradeKey key) {
  return key == GradeKey::Email ? person.email : person.name;
}

/// Reason why there is no grade to write; empty if there is one.
std::string whyLeftOut(const Grade& grade, GradeKey key) {
  if (!grade.percent || !std::isfinite(*grade.percent)) return "no grade yet";
  if (!keyOf(grade.person, key).empty()) return {};
  return key == GradeKey::Email ? "no e-mail address" : "no name";
}

}  // namespace

GradeBook gradeBook(const std::string& item, GradeKey key, std::span<const Grade> grades) {
  const bool withFeedback = std::ranges::any_of(
      grades, [&](const Grade& grade) { return whyLeftOut(grade, key).empty() && !grade.feedback.empty(); });
  std::vector<std::vector<std::string>> rows{{key == GradeKey::Email ? "Email address" : "ID number", item}};
  if (withFeedback) rows.front().push_back(item + " (feedback)");
  GradeBook book;
  for (const Grade& grade : grades) {
    if (const std::string why = whyLeftOut(grade, key); !why.empty()) {
      book.leftOut.push_back({grade.person.fullName, why});
      continue;
    }
    rows.push_back({keyOf(grade.person, key), csvNumber(std::round(*grade.percent * 100) / 100)});
    if (withFeedback) rows.back().push_back(grade.feedback);
  }
  book.csv = csvText(rows);
  return book;
}

}  // namespace insonate
