#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/GradeBook.h>
#include <insonate/curriculum/SignedIn.h>
#include <insonate/curriculum/XapiStatements.h>

#include <string>

/// Data of the trainees of a class for other programs, read with the permissions of a signed-in user. `curriculum` is
/// the curriculum of the class.
namespace insonate {

/// A table as CSV, and the number of its rows without the titles.
struct AttemptsExport {
  std::string csv{};
  std::size_t attempts = 0;
};
/// Writes all attempts, one in each row, with the columns of attemptColumns(), the person's names and one column for
/// each metric. If `curriculum` is null, the column "passed" is empty.
Result<AttemptsExport> exportAttempts(const SignedIn& by, const Cohort& cohort, const Curriculum* curriculum);

/// A grade book, and the number of its grades.
struct GradesExport {
  GradeBook book{};
  std::size_t grades = 0;
};
/// Grades each trainee by the share of levels that are mastered; `item` names the graded activity.
Result<GradesExport> exportGrades(const SignedIn& by, const Cohort& cohort, const Curriculum& curriculum,
                                  const std::string& item, GradeKey key);

/// Makes xAPI statements about all attempts.
Result<XapiExport> exportStatements(const SignedIn& by, const Cohort& cohort, const Curriculum& curriculum,
                                    const XapiSite& site);

}  // namespace insonate
