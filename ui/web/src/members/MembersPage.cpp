#include "members/MembersPage.h"

#include "classes/TaughtClass.h"
#include "people/Accounts.h"

#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PublishedCurricula.h>

#include <QString>
#include <algorithm>
#include <charconv>

namespace insonate::web {
namespace {

std::string classAddress(const TaughtClass& taught) {
  return "/classes/" + encoded(taught.cohort.id);
}

Markup memberTable(const Visit& visit, const TaughtClass& taught, const std::vector<Member>& members) {
  if (members.empty()) return paragraph("The class has no members yet.");
  std::vector<std::vector<Markup>> rows;
  for (const Member& one : members) {
    const bool isRemovable = isAdministrator(visit) || !one.teaches;
    // Instructors do not see the accounts of other instructors.
    const bool isSeen = isRemovable || one.person.id == visit.by->person().id;
    const std::string name = displayName(one.person);
    rows.push_back({isSeen ? link(accountAddress(one.person.id), name) : text(name), text(one.person.name),
                    text(one.teaches ? "instructor" : "trainee"), text(one.person.disabled ? "disabled" : "active"),
                    isRemovable ? postForm(visit, classAddress(taught) + "/members/remove",
                                           hiddenField("person", one.person.id), "Remove")
                                : Markup()});
  }
  return table("Members of the class", {"Name", "Sign-in name", "Role in the class", "Account", "Remove"}, rows);
}

Markup existingPersonForm(const Visit& visit, const TaughtClass& taught) {
  const Fields& form = visit.request.form;
  return section(
      "Add a person who has an account",
      note("The instructors of a class see all attempts of its trainees, including attempts that were made before a "
           "trainee joined the class. If you add a member again with another role, the role changes.") +
          postForm(visit, classAddress(taught) + "/members",
                   inputField("Sign-in name or e-mail address", "person", "text", "off", valueOf(form, "person")) +
                       choiceField("Role in the class", "as", {{"trainee", "trainee"}, {"instructor", "instructor"}},
                                   valueOf(form, "as")),
                   "Add to class"));
}

Markup newTraineeForm(const Visit& visit, const TaughtClass& taught) {
  const Fields& form = visit.request.form;
  return section("Add a new trainee",
                 note("This form creates an account. The trainee signs in with this password once, and then chooses "
                      "another password.") +
                     postForm(visit, classAddress(taught) + "/members/new",
                              inputField("Sign-in name (letters, digits and . _ - + @)", "name", "text", "off",
                                         valueOf(form, "name")) +
                                  inputField("Full name", "full-name", "text", "off", valueOf(form, "full-name")) +
                                  optionalField("E-mail address (optional)", "email", "email", valueOf(form, "email")) +
                                  newPasswordField(),
                              "Add trainee") +
                     element("p", {}, link(classAddress(taught) + "/import", "Import a list of trainees")));
}

Result<Markup> curriculumForm(const Visit& visit, const TaughtClass& taught) {
  const auto published = PublishedCurricula(*visit.by).list();
  if (!published) return tl::unexpected(published.error());
  Choices choices;
  if (taught.cohort.curriculum.empty()) choices.emplace_back("", "none yet");
  for (const CurriculumEntry& one : *published)
    choices.emplace_back(std::to_string(one.version) + " " + one.name,
                         one.name + ", version " + std::to_string(one.version));
  if (published->empty())
    return section("Curriculum", paragraph("No curriculum is published.") +
                                     element("p", {}, link("/curricula", "Publish a curriculum")));
  return section("Curriculum", note("The curriculum consists of the levels that the class learns. If you change the "
                                    "curriculum, the progress of each trainee is computed again from the new levels.") +
                                   postForm(visit, classAddress(taught) + "/curriculum",
                                            choiceField("Curriculum", "curriculum", choices,
                                                        std::to_string(taught.cohort.curriculumVersion) + " " +
                                                            taught.cohort.curriculum),
                                            "Set curriculum"));
}

Markup administrationSections(const Visit& visit, const TaughtClass& taught) {
  const bool archived = taught.cohort.archived;
  Markup content = section("Name", postForm(visit, classAddress(taught) + "/name",
                                            inputField("Name", "class-name", "text", "off",
                                                       typedOr(visit, "class-name", taught.cohort.name)),
                                            "Rename"));
  content += section(
      archived ? "Restore the class" : "Archive the class",
      note(archived
               ? "After you restore a class, you can add members and open tests again. Its closed tests stay closed."
               : "Archive a class that has ended. Members, attempts and results stay visible, but you can neither add "
                 "members nor open tests, and open tests are closed. You can restore an archived class.") +
          postForm(visit, classAddress(taught) + "/archive", hiddenField("state", archived ? "active" : "archived"),
                   archived ? "Restore" : "Archive"));
  content +=
      section("Delete the class",
              element("p", {}, link(classAddress(taught) + "/delete", "Show what a deletion removes and keeps")));
  return content;
}

Response membersPage(const Visit& visit, const TaughtClass& taught, const std::string& trouble) {
  const auto members = CohortStore(*visit.by).members(taught.cohort.id);
  if (!members) return refusal(visit, 403, members.error().message);
  Markup content = trouble.empty() ? Markup() : troubleLine(trouble);
  // At the top, where a browser shows the page after a change.
  if (taught.cohort.archived)
    content += paragraph("This class is archived: you can neither add members nor open tests.");
  content += memberTable(visit, taught, *members);
  if (!taught.cohort.archived) {
    if (isAdministrator(visit)) content += existingPersonForm(visit, taught);
    content += newTraineeForm(visit, taught);
    const auto curriculum = curriculumForm(visit, taught);
    if (!curriculum) return refusal(visit, 403, curriculum.error().message);
    content += *curriculum;
  }
  if (isAdministrator(visit)) content += administrationSections(visit, taught);
  content += element("p", {}, link(classAddress(taught), "Back to the class"));
  return page(visit, "Members and settings of " + taught.cohort.name, content, trouble.empty() ? 200 : 422);
}

/// Shows the members after a change, or why it was refused.
Response afterClassChange(const Visit& visit, const TaughtClass& taught, const Result<void>& changed) {
  return changed ? redirect(classAddress(taught) + "/members") : membersPage(visit, taught, changed.error().message);
}

QString comparable(const std::string& name) {
  return QString::fromStdString(name).normalized(QString::NormalizationForm_KC).trimmed().toCaseFolded();
}

/// Finds a person by sign-in name or e-mail address; only administrators see all people.
Result<Person> personBy(const Visit& visit, const std::string& nameOrEmail) {
  const auto people = PeopleStore(*visit.by).all();
  if (!people) return tl::unexpected(people.error());
  const QString wanted = comparable(nameOrEmail);
  for (const Person& one : *people)
    if (!wanted.isEmpty() && (comparable(one.name) == wanted || comparable(one.email) == wanted)) return one;
  return fail("No account has the sign-in name or e-mail address '" + nameOrEmail +
              "'. Search it on the page People, or add a new trainee.");
}

}  // namespace

Response showMembers(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) { return membersPage(visit, taught, {}); });
}

Response addMember(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    const Fields& form = visit.request.form;
    const auto person = personBy(visit, valueOf(form, "person"));
    if (!person) return membersPage(visit, taught, person.error().message);
    return afterClassChange(
        visit, taught, CohortStore(*visit.by).join(taught.cohort.id, person->id, valueOf(form, "as") == "instructor"));
  });
}

Response addTrainee(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    const Fields& form = visit.request.form;
    const NewPassword password = newPassword(visit);
    const auto added = PeopleStore(*visit.by).add(
        {.name = valueOf(form, "name"), .fullName = valueOf(form, "full-name"), .email = valueOf(form, "email")},
        password.text, taught.cohort.id);
    if (!added) return membersPage(visit, taught, added.error().message);
    return password.isRandom ? showNewPassword(visit, *added, password.text)
                             : redirect(classAddress(taught) + "/members");
  });
}

Response removeMember(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    return afterClassChange(visit, taught,
                            CohortStore(*visit.by).leave(taught.cohort.id, valueOf(visit.request.form, "person")));
  });
}

Response setClassCurriculum(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    const std::string& chosen = valueOf(visit.request.form, "curriculum");
    int version = 0;
    const auto [end, error] = std::from_chars(chosen.data(), chosen.data() + chosen.size(), version);
    const std::size_t at = static_cast<std::size_t>(end - chosen.data());
    if (error != std::errc() || at + 1 >= chosen.size() || chosen[at] != ' ')
      return membersPage(visit, taught, "Choose a curriculum.");
    return afterClassChange(visit, taught,
                            CohortStore(*visit.by).setCurriculum(taught.cohort.id, chosen.substr(at + 1), version));
  });
}

Response renameClass(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    return afterClassChange(visit, taught,
                            CohortStore(*visit.by).rename(taught.cohort.id, valueOf(visit.request.form, "class-name")));
  });
}

Response archiveClass(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    const std::string& state = valueOf(visit.request.form, "state");
    if (state != "active" && state != "archived") return membersPage(visit, taught, "Choose a state of the class.");
    return afterClassChange(visit, taught, CohortStore(*visit.by).archive(taught.cohort.id, state == "archived"));
  });
}

}  // namespace insonate::web
