#include "people/PersonErasure.h"

#include "people/Accounts.h"

#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PersonData.h>

namespace insonate::web {
namespace {

std::string countedNoun(std::int64_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

Markup itemsOf(const std::vector<std::string>& sentences) {
  Markup items;
  for (const std::string& one : sentences) items += element("li", {}, one);
  return element("ul", {}, items);
}

Markup deletedSection(const PersonExtent& extent) {
  return section(
      "What is deleted",
      itemsOf(
          {"Sign-in name, full name, e-mail address, password and sessions. The account stays disabled permanently.",
           countedNoun(extent.recordings, "recording") + " of attempts, with their videos.",
           countedNoun(extent.comments, "comment") + " on the attempts of this person, and the texts in " +
               countedNoun(extent.forms, "form") + " about this person.",
           "Names and reasons in the audit log. Workstations erase the person, with the recordings beside their "
           "databases, when they next exchange data."}));
}

constexpr const char* kAboutOthers =
    "Comments, forms and decisions of this person about other people, under the pseudonym, since they belong to the "
    "records of these people.";
constexpr const char* kOnWorkstations =
    "On workstations: the original recordings in the folder of recordings of Insonate, files that the person saved, "
    "and copies of the database beside it. Delete these files on the workstations.";

Markup keptSection(const PersonExtent& extent) {
  return section("What stays",
                 itemsOf({countedNoun(extent.attempts, "attempt") +
                              " with points and metrics, under a pseudonym, for the statistics of classes.",
                          "Answers in forms that are choices or numbers.", kAboutOthers, kOnWorkstations,
                          "Backups of the database that were made before the erasure. Delete these backups when their "
                          "storage period ends."}));
}

Response erasurePage(const Visit& visit, const Person& person, const std::string& trouble) {
  const auto extent = PersonData(*visit.by).previewErasure(person.id);
  if (!extent) return refusal(visit, 403, extent.error().message);
  const Markup back = element("p", {}, link(accountAddress(person.id), "Account of this person"));
  if (extent->isErased && trouble.empty())
    return page(visit, "Erasure", paragraph("This person was erased already.") + back);
  if (extent->isErased)
    return page(visit, "Erasure",
                troubleLine(trouble) +
                    paragraph("The person is erased. The server tries each minute to delete the files that remain. "
                              "Check the permissions of these files and of their folder.") +
                    back,
                422);
  return page(visit, "Erase " + displayName(person) + "?",
              (trouble.empty() ? Markup() : troubleLine(trouble)) + deletedSection(*extent) + keptSection(*extent) +
                  section("Erase", note("An erasure cannot be undone. The person may first download all data.") +
                                       postForm(visit, accountAddress(person.id) + "/erase",
                                                inputField("Sign-in name of the person", "name", "text", "off"),
                                                "Erase person")) +
                  back,
              trouble.empty() ? 200 : 422);
}

/// Calls work(Person) for an administrator, or returns a page that says why not.
template <class Work>
Response withPerson(const Visit& visit, const std::string& id, const Work& work) {
  if (!isAdministrator(visit)) return refusal(visit, 403, "Only administrators erase people.");
  const auto person = PeopleStore(*visit.by).person(id);
  return person ? work(*person) : refusal(visit, 404, person.error().message);
}

}  // namespace

Response showErasure(const Visit& visit, const Parts& parts) {
  return withPerson(visit, parts[0], [&](const Person& person) { return erasurePage(visit, person, {}); });
}

Response erasePerson(const Visit& visit, const Parts& parts) {
  return withPerson(visit, parts[0], [&](const Person& person) {
    if (valueOf(visit.request.form, "name") != person.name)
      return erasurePage(visit, person, "Nothing was erased. Type the sign-in name of this person: " + person.name);
    const auto erased = PersonData(*visit.by).erase(person.id);
    return erased ? redirect(accountAddress(person.id)) : erasurePage(visit, person, erased.error().message);
  });
}

}  // namespace insonate::web
