#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/ClassList.h>
#include <insonate/curriculum/FirstPassword.h>
#include <insonate/curriculum/SignedIn.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// Planned action for one line of a class list.
struct ClassImportRow {
  enum class Step {
    Add,           ///< the person gets an account and joins the class
    Join,          ///< the person has an account and joins the class
    AlreadyThere,  ///< the person is already a learner in the class
    Refuse,        ///< the line is not imported; ClassImportRow::why says why
  };
  int line = 0;
  NewPerson person{};
  Step step = Step::Refuse;
  std::string why{};  ///< reason for Step::Refuse: a sentence that begins with the line number
  std::string id{};   ///< Person::id, if the person has an account
};

/// Imports a class list into a class: plan() computes the action for each line, apply() imports all lines or none.
/// Allowed to the instructors of the class and to administrators; only administrators may add people who already have
/// an account. If the workstation belongs to a server, people can be changed on the server only.
class ClassImport {
 public:
  explicit ClassImport(SignedIn by) : by_(std::move(by)) {}

  /// Returns the planned action for each line of `list`, in the order of the lines. Changes nothing.
  Result<std::vector<ClassImportRow>> plan(const std::string& cohort, const ClassList& list) const;

  /// Makes random first passwords for all people that a plan adds, in the plan's order.
  static std::vector<FirstPassword> passwordsFor(std::span<const ClassImportRow> plan);
  /// Adds the people to the database and to the class as planned, in one transaction. Fails, with nothing changed, if
  /// the plan is no longer possible (the error names the line), or if cancelled. Takes 0.1 s for each new password.
  Result<void> apply(const std::string& cohort, std::span<const ClassImportRow> plan,
                     std::span<const FirstPassword> passwords, const Progress& progress = {}) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
