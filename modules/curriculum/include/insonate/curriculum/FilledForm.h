#pragma once

#include <cstdint>
#include <string>

namespace insonate {

/// A questionnaire, checklist or rating as it was filled in.
struct FilledForm {
  std::string id{};  ///< UUID; made when missing
  std::string form{};
  int formVersion = 0;
  std::string person{};   ///< whom it is about
  std::string attempt{};  ///< which of theirs; "": none in particular
  std::string by{};       ///< Person::id of who filled it in; the store's doing
  std::int64_t filled_us = 0;
  std::string answers{};  ///< JSON object, at most 1 MB, kept byte for byte

  bool operator==(const FilledForm&) const = default;
};

/// A form with what the store adds to it.
struct KeptForm {
  FilledForm filled{};
  std::string rater{};  ///< who filled it in, by full name, or by name where there is none
  /// Another rater's form whose answers are withheld: raters submit the same form themselves first.
  bool withheld = false;

  bool operator==(const KeptForm&) const = default;
};

}  // namespace insonate
