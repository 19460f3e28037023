#include "people/PeoplePage.h"

#include "people/Accounts.h"

#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/PeopleStore.h>

#include <QString>
#include <QStringList>
#include <algorithm>
#include <set>

namespace insonate::web {
namespace {

constexpr std::size_t kMostPeopleShown = 200;

QString folded(const std::string& words) {
  return QString::fromStdString(words).normalized(QString::NormalizationForm_KC).toCaseFolded();
}

/// Tells whether each word occurs in the person's names or e-mail address.
bool hasWords(const Person& person, const QStringList& words) {
  const QString all = folded(person.name + '\n' + person.fullName + '\n' + person.email);
  return std::ranges::all_of(words, [&](const QString& word) { return all.contains(word); });
}

Result<std::vector<Person>> selectedPeople(const Visit& visit) {
  const Fields& query = visit.request.query;
  auto people = PeopleStore(*visit.by).all();
  if (!people) return people;
  const std::string& cohort = valueOf(query, "class");
  std::set<std::string> members;
  if (!cohort.empty()) {
    const auto found = CohortStore(*visit.by).members(cohort);
    if (!found) return tl::unexpected(found.error());
    for (const Member& one : *found) members.insert(one.person.id);
  }
  const QStringList words = folded(valueOf(query, "search")).split(QLatin1Char(' '), Qt::SkipEmptyParts);
  const auto role = roleNamed(valueOf(query, "role"));
  const std::string& state = valueOf(query, "state");
  std::erase_if(*people, [&](const Person& one) {
    return (role && one.role != *role) || (!cohort.empty() && !members.contains(one.id)) ||
           (state == "active" && one.disabled) || (state == "disabled" && !one.disabled) || !hasWords(one, words);
  });
  return people;
}

Choices withFirst(const std::string& first, Choices choices) {
  choices.insert(choices.begin(), {"", first});
  return choices;
}

Markup filterForm(const Visit& visit, const Choices& cohorts) {
  const Fields& query = visit.request.query;
  const Markup fields = optionalField("Search (name or e-mail)", "search", "search", valueOf(query, "search")) +
                        choiceField("Role", "role", withFirst("all", roleChoices()), valueOf(query, "role")) +
                        choiceField("Class", "class", withFirst("all", cohorts), valueOf(query, "class")) +
                        choiceField("State", "state", {{"", "all"}, {"active", "active"}, {"disabled", "disabled"}},
                                    valueOf(query, "state")) +
                        element("button", {{"type", "submit"}}, "Show");
  return element("form", {{"method", "get"}, {"action", "/people"}, {"class", "line"}}, fields);
}

Markup peopleTable(const std::vector<Person>& people) {
  if (people.empty()) return paragraph("No person matches the search.");
  std::vector<std::vector<Markup>> rows;
  for (const Person& one : people) {
    if (rows.size() == kMostPeopleShown) break;
    rows.push_back({link(accountAddress(one.id), displayName(one)), text(one.name), text(one.email),
                    text(roleWord(one.role)), text(one.disabled ? "disabled" : "active")});
  }
  Markup content = table("People, sorted by sign-in name", {"Name", "Sign-in name", "E-mail", "Role", "Account"}, rows);
  if (people.size() > rows.size())
    content += paragraph("The first " + std::to_string(rows.size()) + " of " + std::to_string(people.size()) +
                         " people are shown. Narrow the search to see the others.");
  return content;
}

Markup addForm(const Visit& visit, const Choices& cohorts, const std::string& trouble) {
  const auto typed = [&](std::string_view name) { return valueOf(visit.request.form, name); };
  const Markup fields =
      inputField("Sign-in name (letters, digits and . _ - + @)", "name", "text", "off", typed("name")) +
      inputField("Full name", "full-name", "text", "off", typed("full-name")) +
      optionalField("E-mail address (optional)", "email", "email", typed("email")) +
      choiceField("Role", "role", roleChoices(), typed("role")) +
      choiceField("Class", "class", withFirst("none", cohorts), typed("class")) + newPasswordField();
  return section("Add a person",
                 note("The person signs in with this password once, and then chooses another password.") +
                     (trouble.empty() ? Markup() : troubleLine(trouble)) + postForm(visit, "/people", fields, "Add"));
}

Response peoplePage(const Visit& visit, const std::string& trouble) {
  const auto people = selectedPeople(visit);
  if (!people) return refusal(visit, 403, people.error().message);
  const auto cohorts = CohortStore(*visit.by).cohorts();
  if (!cohorts) return refusal(visit, 403, cohorts.error().message);
  Choices choices;
  for (const Cohort& one : *cohorts) choices.emplace_back(one.id, one.name);
  return page(visit, "People",
              filterForm(visit, choices) + peopleTable(*people) + addForm(visit, choices, trouble) +
                  element("p", {}, link("/retention", "Retention of personal data")),
              trouble.empty() ? 200 : 422);
}

}  // namespace

Response showPeople(const Visit& visit, const Parts& /*parts*/) {
  return peoplePage(visit, {});
}

Response addPerson(const Visit& visit, const Parts& /*parts*/) {
  const Fields& form = visit.request.form;
  const auto role = roleNamed(valueOf(form, "role"));
  if (!role) return peoplePage(visit, "Choose a role.");
  const NewPassword password = newPassword(visit);
  const auto added = PeopleStore(*visit.by).add({.name = valueOf(form, "name"),
                                                 .fullName = valueOf(form, "full-name"),
                                                 .email = valueOf(form, "email"),
                                                 .role = *role},
                                                password.text, valueOf(form, "class"));
  if (!added) return peoplePage(visit, added.error().message);
  return password.isRandom ? showNewPassword(visit, *added, password.text) : redirect(accountAddress(added->id));
}

}  // namespace insonate::web
