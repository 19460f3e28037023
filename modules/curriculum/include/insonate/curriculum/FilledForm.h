#pragma once

#include <cstdint>
#include <string>

namespace insonate {

/// A filled-in questionnaire, checklist or rating.
struct FilledForm {
  std::string id{};  ///< UUID; made when missing
  std::string form{};
  int formVersion = 0;
  std::string person{};   ///< the person whom the form is about
  std::string attempt{};  ///< the person's attempt that the form is about; "": no particular attempt
  std::string by{};       ///< Person::id of the author; set by the store
  std::int64_t filled_us = 0;
  std::string answers{};  ///< JSON object, at most 1 MB, stored byte for byte

  bool operator==(const FilledForm&) const = default;
};

/// A form with the data that the store adds to it.
struct KeptForm {
  FilledForm filled{};
  std::string rater{};  ///< full name of the author, or name if there is no full name
  /// True if the answers are another rater's and are withheld: the reader must first submit the same form.
  bool withheld = false;

  bool operator==(const KeptForm&) const = default;
};

}  // namespace insonate
