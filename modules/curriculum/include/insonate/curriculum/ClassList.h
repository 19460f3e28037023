#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/Person.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Someone on a class list.
struct ClassListEntry {
  int line = 0;
  NewPerson person{};  ///< a trainee; `name` from the column of user names, else ID numbers, else e-mail addresses
};

struct ClassListTrouble {
  int line = 0;
  std::string sentence{};  ///< what is wrong and what to do
  NewPerson person{};      ///< as far as the line could be read
};

struct ClassList {
  std::vector<ClassListEntry> entries{};  ///< whose lines are fine
  std::vector<ClassListTrouble> troubles{};
};

/// Parses a CSV with a header line as Moodle and others export participants: "First name" and "Last name" (or
/// "Surname"), or "Full name"; "Email address"; "Username", "ID number", in any case; other columns are ignored. Fails
/// if nothing of it is a class list; a wrong line becomes an error of that line alone.
Result<ClassList> parseClassList(std::string_view csv);

/// A class list beside the people who are there already.
struct ClassListMatch {
  struct Known {
    ClassListEntry entry{};
    Person person{};
  };
  std::vector<ClassListEntry> added{};  ///< who are not there yet
  std::vector<Known> known{};
  std::vector<ClassListTrouble> troubles{};  ///< those of the list, and who is two people here
};

/// Matches by e-mail address, else by name, ignoring case.
ClassListMatch matchClassList(const ClassList& list, std::span<const Person> people);

}  // namespace insonate
