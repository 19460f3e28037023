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

/// The planned outcome of one line of a class list.
struct ClassImportRow {
  enum class Step {
    Add,           ///< someone new, who joins the class
    Join,          ///< is here, and joins the class
    AlreadyThere,  ///< learns in the class
    Refuse,        ///< why() it stays out
  };
  int line = 0;
  NewPerson person{};
  Step step = Step::Refuse;
  std::string why{};  ///< of Refuse: a sentence that begins with the line
  std::string id{};   ///< Person::id of who is here
};

/// Imports a class list into a class: first a plan, then all lines or none. For the class's instructors and for
/// administrators; only administrators add people who already have an account. On a workstation that belongs to a
/// server, people are changed on the server.
class ClassImport {
 public:
  explicit ClassImport(SignedIn by) : by_(std::move(by)) {}

  /// Returns the planned rows in the order of lines. Changes nothing.
  Result<std::vector<ClassImportRow>> plan(const std::string& cohort, const ClassList& list) const;

  /// New passwords for all whom a plan adds, in its order.
  static std::vector<FirstPassword> passwordsFor(std::span<const ClassImportRow> plan);
  /// Adds and joins as planned, in one transaction. Fails, having changed nothing, where that is not possible any more,
  /// naming the line, and when cancelled. Takes 0.1 s for each new password.
  Result<void> apply(const std::string& cohort, std::span<const ClassImportRow> plan,
                     std::span<const FirstPassword> passwords, const Progress& progress = {}) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
