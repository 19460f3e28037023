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

/// A CSV with a head line as Moodle and others export participants: "First name" and "Last name" (or "Surname"), or
/// "Full name"; "Email address"; "Username", "ID number"; others are passed over. Whatever the case. Fails where
/// nothing of it is a class list; a line that is wrong is a trouble and costs itself alone.
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

/// By e-mail address, else by name, whatever the case.
ClassListMatch matchClassList(const ClassList& list, std::span<const Person> people);

}  // namespace insonate
