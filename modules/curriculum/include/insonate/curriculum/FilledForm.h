#pragma once

#include <cstdint>
#include <string>

namespace insonate {

/// A filled-in questionnaire, checklist or rating.
struct FilledForm {
  std::string id{};  ///< UUID of the filled form; made by the database if empty
  std::string form{};
  int formVersion = 0;
  std::string person{};   ///< person whom the form is about (Person::id)
  std::string attempt{};  ///< attempt of that person that the form is about; "": no particular attempt
  std::string by{};       ///< author of the answers (Person::id); set by the database
  std::int64_t filled_us = 0;
  std::string answers{};  ///< answers as a JSON object of at most 1 MB, stored byte for byte

  bool operator==(const FilledForm&) const = default;
};

/// A filled form as read from the database, with the data that the database adds.
struct StoredForm {
  FilledForm filled{};
  std::string rater{};  ///< full name of the author, or sign-in name if there is no full name
  /// true: `answers` is empty, since the form is another rater's and the user has not yet submitted the same form.
  bool withheld = false;

  bool operator==(const StoredForm&) const = default;
};

}  // namespace insonate
