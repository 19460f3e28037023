#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/Person.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// One person on a class list.
struct ClassListEntry {
  int line = 0;
  /// Trainee on this line. The sign-in name is taken from the column of user names, else from the column of ID numbers,
  /// else from the column of e-mail addresses.
  NewPerson person{};
};

struct ClassListError {
  int line = 0;
  std::string sentence{};  ///< explains the error and what to do
  NewPerson person{};      ///< data of the person that could be read from the line in spite of the error
};

struct ClassList {
  std::vector<ClassListEntry> entries{};  ///< people on the lines without errors
  std::vector<ClassListError> errors{};
};

/// Parses a class list: CSV with a header line, as Moodle and other systems export participants. Columns: "First name"
/// and "Last name" (or "Surname"), or "Full name"; "Email address"; "Username"; "ID number"; or the German, French or
/// Spanish titles of these. Case and other columns are ignored. Text that is not UTF-8 is read as Windows-1252, which
/// includes Latin-1. Fails if the text is not a class list; an invalid line becomes an entry in ClassList::errors.
Result<ClassList> parseClassList(std::string_view csv);

/// A class list compared with the people who already have accounts.
struct ClassListMatch {
  struct Known {
    ClassListEntry entry{};
    Person person{};
  };
  std::vector<ClassListEntry> added{};  ///< entries for people who have no account yet
  std::vector<Known> known{};
  std::vector<ClassListError> errors{};  ///< lines with errors, and lines that match two people
};

/// Compares a class list with existing people. An entry and a person match if their e-mail addresses or, failing that,
/// their sign-in names are equal; case is ignored.
ClassListMatch matchClassList(const ClassList& list, std::span<const Person> people);

}  // namespace insonate
