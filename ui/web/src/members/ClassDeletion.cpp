#include "members/ClassDeletion.h"

#include "classes/TaughtClass.h"
#include "people/Accounts.h"

#include <insonate/curriculum/OpeningStore.h>

#include <algorithm>

namespace insonate::web {
namespace {

std::string countedWord(std::ptrdiff_t count, const std::string& word) {
  return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

Markup listOf(const std::vector<std::string>& sentences) {
  Markup items;
  for (const std::string& one : sentences) items += element("li", {}, one);
  return element("ul", {}, items);
}

Response deletionPage(const Visit& visit, const TaughtClass& taught, const std::string& trouble) {
  if (!isAdministrator(visit)) return refusal(visit, 403, "Only administrators delete classes.");
  const auto members = CohortStore(*visit.by).members(taught.cohort.id);
  if (!members) return refusal(visit, 403, members.error().message);
  const auto openings = OpeningStore(*visit.by).listByCohort(taught.cohort.id);
  if (!openings) return refusal(visit, 403, openings.error().message);
  const auto instructors = std::ranges::count(*members, true, &Member::teaches);
  const auto trainees = std::ssize(*members) - instructors;
  const Markup lost = listOf({"The class and its list of " + countedWord(trainees, "trainee") + " and " +
                                  countedWord(instructors, "instructor") +
                                  ". These instructors no longer see the attempts of these trainees.",
                              "The list of " + countedWord(std::ssize(*openings), "opening") +
                                  " of its tests. Tests that are open are closed. If a workstation has not sent an "
                                  "attempt at a test yet, the attempt becomes practice.",
                              "The assignment of a curriculum to the class. The curriculum itself stays."});
  const Markup stays =
      listOf({"Accounts: all members can still sign in. A trainee who is in no other class takes tests without an "
              "instructor; attempts at these tests are shown as self-administered.",
              "Attempts with their results, recordings, comments and forms.", "The audit log."});
  return page(visit, "Delete the class " + taught.cohort.name + "?",
              (trouble.empty() ? Markup() : troubleLine(trouble)) + section("What is deleted", lost) +
                  section("What stays", stays) +
                  section("Delete",
                          note("A deleted class cannot be restored. To keep a class that has ended, archive it "
                               "on the page of its members and settings.") +
                              postForm(visit, "/classes/" + encoded(taught.cohort.id) + "/delete",
                                       inputField("Name of the class", "class-name", "text", "off"), "Delete class")) +
                  element("p", {}, link("/classes/" + encoded(taught.cohort.id) + "/members", "Keep the class")),
              trouble.empty() ? 200 : 422);
}

}  // namespace

Response showClassDeletion(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) { return deletionPage(visit, taught, {}); });
}

Response deleteClass(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    const auto done = CohortStore(*visit.by).remove(taught.cohort.id, valueOf(visit.request.form, "class-name"));
    return done ? redirect("/classes?deleted=1") : deletionPage(visit, taught, done.error().message);
  });
}

}  // namespace insonate::web
