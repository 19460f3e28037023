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
  /// Trainee on this line; the sign-in name is from the column of user names, else of ID numbers, else of e-mail
  /// addresses.
  NewPerson person{};
};

struct ClassListTrouble {
  int line = 0;
  std::string sentence{};  ///< explains the error and what to do
  NewPerson person{};      ///< data of the person that could be read from the line in spite of the error
};

struct ClassList {
  std::vector<ClassListEntry> entries{};  ///< people on the lines without errors
  std::vector<ClassListTrouble> troubles{};
};

/// Parses a class list: CSV with a header line, as Moodle and other systems export participants, with the columns
/// "First name" and "Last name" (or "Surname"), or "Full name"; "Email address"; "Username", "ID number"; or their
/// German, French or Spanish titles. Case and other columns are ignored. Text that is not UTF-8 is read as
/// Windows-1252, which contains Latin-1. Fails if the text is no class list at all; an invalid line becomes an entry in
/// ClassList::troubles.
Result<ClassList> parseClassList(std::string_view csv);

/// A class list compared with the people who already have accounts.
struct ClassListMatch {
  struct Known {
    ClassListEntry entry{};
    Person person{};
  };
  std::vector<ClassListEntry> added{};  ///< people who have no account yet
  std::vector<Known> known{};
  std::vector<ClassListTrouble> troubles{};  ///< lines with errors, and lines that match two people
};

/// Compares a class list with existing people: they match by e-mail address, else by name, ignoring case.
ClassListMatch matchClassList(const ClassList& list, std::span<const Person> people);

}  // namespace insonate
