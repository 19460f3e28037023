#pragma once

#include "page/Page.h"

#include <insonate/curriculum/Person.h>

#include <optional>
#include <string>
#include <string_view>

namespace insonate::web {

std::string roleWord(Role role);
/// Returns the role of a word of roleWord(); empty: there is none.
std::optional<Role> roleNamed(std::string_view word);
Choices roleChoices();

bool isAdministrator(const Visit& visit);
std::string accountAddress(const std::string& person);

/// Returns what the form of this request has in a field, or `stored` if the form has no such field.
std::string typedOr(const Visit& visit, std::string_view name, const std::string& stored);

/// A password that a form sets for another person.
struct NewPassword {
  std::string text{};
  bool isRandom = false;  ///< the form had none: the page must show it
};
/// Returns the optional field "password" of such a form.
Markup newPasswordField();
/// Returns the password in the field of the request's form, or a random one if the field is empty.
NewPassword newPassword(const Visit& visit);
/// Shows a random password, this once.
Response showNewPassword(const Visit& visit, const Person& person, const std::string& password);

}  // namespace insonate::web
