#include "people/AccountPage.h"

#include "people/Accounts.h"
#include "people/PersonDownload.h"

#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/PeopleStore.h>

#include <algorithm>

namespace insonate::web {
namespace {

struct AccountFacts {
  Person person{};
  std::vector<Membership> memberships{};
};

bool isOneself(const Visit& visit, const AccountFacts& facts) {
  return facts.person.id == visit.by->person().id;
}

Markup detailsForm(const Visit& visit, const AccountFacts& facts) {
  const Person& person = facts.person;
  const Markup fields =
      inputField("Sign-in name (letters, digits and . _ - + @)", "name", "text", "off",
                 typedOr(visit, "name", person.name)) +
      inputField("Full name", "full-name", "text", "off", typedOr(visit, "full-name", person.fullName)) +
      optionalField("E-mail address (optional)", "email", "email", typedOr(visit, "email", person.email)) +
      choiceField("Role", "role", roleChoices(), typedOr(visit, "role", roleWord(person.role)));
  return section("Details", note("Instructors see the people of the classes that they teach; administrators see "
                                 "everyone. An instructor who becomes a trainee no longer teaches.") +
                                postForm(visit, accountAddress(person.id), fields, "Save"));
}

Markup detailsList(const AccountFacts& facts) {
  const auto row = [](std::string_view term, const std::string& value) {
    return element("dt", {}, term) + element("dd", {}, value.empty() ? "none" : value);
  };
  const Person& person = facts.person;
  return element("dl", {},
                 row("Sign-in name", person.name) + row("E-mail", person.email) + row("Role", roleWord(person.role)) +
                     row("Account", person.disabled ? "disabled: the person cannot sign in" : "active"));
}

Markup passwordSection(const Visit& visit, const AccountFacts& facts) {
  if (isOneself(visit, facts)) return section("Password", element("p", {}, link("/password", "Change your password")));
  if (!isAdministrator(visit) && facts.person.role != Role::Trainee) return {};
  return section(
      "Password",
      note("Set a new password if the person forgot the password, or is locked out after wrong passwords. The person "
           "is then signed out everywhere, and chooses another password at the next sign-in.") +
          postForm(visit, accountAddress(facts.person.id) + "/password", newPasswordField(), "Set password"));
}

Markup stateSection(const Visit& visit, const AccountFacts& facts) {
  const bool disabled = facts.person.disabled;
  return section("Account",
                 note(disabled ? "The account is disabled: the person cannot sign in. All data are kept."
                               : "If you disable the account, the person is signed out and cannot sign in. Classes, "
                                 "attempts and results stay, and you can enable the account again.") +
                     postForm(visit, accountAddress(facts.person.id) + "/state",
                              hiddenField("state", disabled ? "active" : "disabled"),
                              disabled ? "Enable account" : "Disable account"));
}

Markup membershipTable(const Visit& visit, const AccountFacts& facts) {
  if (facts.memberships.empty()) return paragraph("The person is not in any class.");
  std::vector<std::string> titles{"Class", "Role in the class", "Progress"};
  if (isAdministrator(visit)) titles.emplace_back("Remove");
  std::vector<std::vector<Markup>> rows;
  for (const auto& [cohort, teaches] : facts.memberships) {
    const std::string address = "/classes/" + encoded(cohort.id);
    const bool isSeen = visit.by->person().role != Role::Trainee;
    rows.push_back({isSeen ? link(address, cohort.name) : text(cohort.name), text(teaches ? "instructor" : "trainee"),
                    teaches ? Markup() : link(address + "/people/" + encoded(facts.person.id), "Levels and attempts")});
    if (isAdministrator(visit))
      rows.back().push_back(postForm(visit, accountAddress(facts.person.id) + "/classes/leave",
                                     hiddenField("class", cohort.id), "Remove"));
  }
  return table("Classes of this person", titles, rows);
}

Result<Markup> classesSection(const Visit& visit, const AccountFacts& facts) {
  Markup content = membershipTable(visit, facts);
  if (!isAdministrator(visit)) return section("Classes", content);
  const auto cohorts = CohortStore(*visit.by).cohorts();
  if (!cohorts) return tl::unexpected(cohorts.error());
  Choices choices;
  for (const Cohort& one : *cohorts) choices.emplace_back(one.id, one.name);
  if (choices.empty()) return section("Classes", content);
  content += note(
      "The instructors of a class see all attempts of its trainees. If you add a member again with another role, the "
      "role changes.");
  content += postForm(visit, accountAddress(facts.person.id) + "/classes",
                      choiceField("Class", "class", choices, valueOf(visit.request.form, "class")) +
                          choiceField("Role in the class", "as", {{"trainee", "trainee"}, {"instructor", "instructor"}},
                                      valueOf(visit.request.form, "as")),
                      "Add to class");
  return section("Classes", content);
}

Response accountPage(const Visit& visit, const AccountFacts& facts, const std::string& trouble) {
  const bool isAdmin = isAdministrator(visit);
  const auto classes = classesSection(visit, facts);
  if (!classes) return refusal(visit, 403, classes.error().message);
  Markup content = trouble.empty() ? Markup() : troubleLine(trouble);
  content += detailsList(facts);
  if (isAdmin) content += detailsForm(visit, facts);
  content += passwordSection(visit, facts);
  if (isAdmin) content += stateSection(visit, facts);
  if (isAdmin || isOneself(visit, facts)) content += downloadSection(visit, facts.person.id);
  if (isAdmin && !isOneself(visit, facts))
    content +=
        section("Erasure", element("p", {}, link(accountAddress(facts.person.id) + "/erase", "Erase this person")));
  content += *classes;
  if (isAdmin) content += element("p", {}, link("/people", "All people"));
  return page(visit, "Account of " + displayName(facts.person), content, trouble.empty() ? 200 : 422);
}

/// Calls work(AccountFacts) for the person of this id, or returns a page that says why not.
template <class Work>
Response withAccount(const Visit& visit, const std::string& id, const Work& work) {
  auto person = PeopleStore(*visit.by).person(id);
  if (!person) return refusal(visit, isAdministrator(visit) ? 404 : 403, person.error().message);
  auto memberships = CohortStore(*visit.by).listByPerson(id);
  if (!memberships) return refusal(visit, 403, memberships.error().message);
  return work(AccountFacts{std::move(*person), std::move(*memberships)});
}

/// Shows the account after a change, or why it was refused.
Response afterChange(const Visit& visit, const AccountFacts& facts, const Result<void>& changed) {
  return changed ? redirect(accountAddress(facts.person.id)) : accountPage(visit, facts, changed.error().message);
}

}  // namespace

Response showAccount(const Visit& visit, const Parts& parts) {
  return withAccount(visit, parts[0], [&](const AccountFacts& facts) { return accountPage(visit, facts, {}); });
}

Response changeAccount(const Visit& visit, const Parts& parts) {
  return withAccount(visit, parts[0], [&](const AccountFacts& facts) {
    const Fields& form = visit.request.form;
    const auto role = roleNamed(valueOf(form, "role"));
    if (!role) return accountPage(visit, facts, "Choose a role.");
    Person changed = facts.person;
    changed.name = valueOf(form, "name"), changed.fullName = valueOf(form, "full-name");
    changed.email = valueOf(form, "email"), changed.role = *role;
    return afterChange(visit, facts, PeopleStore(*visit.by).change(changed));
  });
}

Response setAccountPassword(const Visit& visit, const Parts& parts) {
  return withAccount(visit, parts[0], [&](const AccountFacts& facts) {
    const NewPassword password = newPassword(visit);
    const auto done = PeopleStore(*visit.by).resetPassword(facts.person.id, password.text);
    return done && password.isRandom ? showNewPassword(visit, facts.person, password.text)
                                     : afterChange(visit, facts, done);
  });
}

Response setAccountState(const Visit& visit, const Parts& parts) {
  return withAccount(visit, parts[0], [&](const AccountFacts& facts) {
    const std::string& state = valueOf(visit.request.form, "state");
    if (state != "active" && state != "disabled") return accountPage(visit, facts, "Choose a state of the account.");
    Person changed = facts.person;
    changed.disabled = state == "disabled";
    return afterChange(visit, facts, PeopleStore(*visit.by).change(changed));
  });
}

Response joinClass(const Visit& visit, const Parts& parts) {
  return withAccount(visit, parts[0], [&](const AccountFacts& facts) {
    const Fields& form = visit.request.form;
    return afterChange(
        visit, facts,
        CohortStore(*visit.by).join(valueOf(form, "class"), facts.person.id, valueOf(form, "as") == "instructor"));
  });
}

Response leaveClass(const Visit& visit, const Parts& parts) {
  return withAccount(visit, parts[0], [&](const AccountFacts& facts) {
    return afterChange(visit, facts,
                       CohortStore(*visit.by).leave(valueOf(visit.request.form, "class"), facts.person.id));
  });
}

}  // namespace insonate::web
