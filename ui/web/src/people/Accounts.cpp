#include "people/Accounts.h"

#include <insonate/curriculum/FirstPassword.h>

namespace insonate::web {

std::string roleWord(Role role) {
  switch (role) {
    case Role::Instructor:
      return "instructor";
    case Role::Administrator:
      return "administrator";
    case Role::Trainee:
      break;
  }
  return "trainee";
}

std::optional<Role> roleNamed(std::string_view word) {
  for (const Role role : {Role::Trainee, Role::Instructor, Role::Administrator})
    if (roleWord(role) == word) return role;
  return std::nullopt;
}

Choices roleChoices() {
  Choices choices;
  for (const Role role : {Role::Trainee, Role::Instructor, Role::Administrator})
    choices.emplace_back(roleWord(role), roleWord(role));
  return choices;
}

bool isAdministrator(const Visit& visit) {
  return visit.by->person().role == Role::Administrator;
}

std::string accountAddress(const std::string& person) {
  return "/people/" + encoded(person);
}

std::string typedOr(const Visit& visit, std::string_view name, const std::string& stored) {
  const auto typed = visit.request.form.find(name);
  return typed == visit.request.form.end() ? stored : typed->second;
}

Markup newPasswordField() {
  return optionalField("Password (8 to 200 characters; empty: a random one)", "password", "text");
}

NewPassword newPassword(const Visit& visit) {
  const std::string& typed = valueOf(visit.request.form, "password");
  return typed.empty() ? NewPassword{.text = generateFirstPassword(), .isRandom = true} : NewPassword{.text = typed};
}

Response showNewPassword(const Visit& visit, const Person& person, const std::string& password) {
  const auto row = [](std::string_view term, const Markup& value) {
    return element("dt", {}, term) + element("dd", {}, value);
  };
  return page(
      visit, "Password of " + displayName(person),
      paragraph("Give this password to the person. It cannot be shown again. The person chooses another password "
                "at the next sign-in.") +
          element("dl", {},
                  row("Sign-in name", text(person.name)) +
                      row("Password", element("code", {{"class", "token"}}, password))) +
          element("p", {}, link(accountAddress(person.id), "Account of this person")));
}

}  // namespace insonate::web
