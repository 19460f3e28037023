#include "audit/AuditPage.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/PeopleStore.h>

#include <algorithm>
#include <charconv>
#include <map>

namespace insonate::web {
namespace {

constexpr int kEntries = 100;

}  // namespace

Response showAudit(const Visit& visit, const Parts& /*parts*/) {
  const std::string& asked = valueOf(visit.request.query, "before");
  std::int64_t before = 0;
  std::from_chars(asked.data(), asked.data() + asked.size(), before);
  const auto entries = AuditLog(*visit.by).page(kEntries, std::max<std::int64_t>(before, 0));
  if (!entries) return refusal(visit, 403, entries.error().message);
  const auto people = PeopleStore(*visit.by).all();
  if (!people) return refusal(visit, 403, people.error().message);
  std::map<std::string, std::string> names;
  for (const Person& one : *people) names[one.id] = displayName(one);
  const auto nameOf = [&](const std::string& id) {
    const auto found = names.find(id);
    return text(found == names.end() ? id : found->second);
  };
  std::vector<std::vector<Markup>> rows;
  for (const AuditEntry& one : *entries)
    rows.push_back({text(std::to_string(one.number)), timeOf(one.time_us), nameOf(one.actor), text(one.act),
                    nameOf(one.person), text(one.allowed ? "allowed" : "refused"), text(one.detail),
                    text(one.workstation)});
  if (rows.empty())
    return page(visit, "Audit log",
                paragraph(before > 0 ? "There are no entries before number " + std::to_string(before) + "."
                                     : "There are no entries yet.") +
                    (before > 0 ? element("p", {}, link("/audit", "Newest entries")) : Markup()));
  Markup content =
      note(
          "The log lists each access to the data of other people, each change, and each action that the server "
          "refused. User: the person who acted. Action: what the user did or tried to do. Concerns: the person whose "
          "data the action concerns. Computer: the workstation or server on which the user acted.") +
      table("Entries, newest first", {"Number", "Time", "User", "Action", "Concerns", "Outcome", "Details", "Computer"},
            rows);
  if (static_cast<int>(entries->size()) == kEntries)
    content += element("p", {}, link("/audit?before=" + std::to_string(entries->back().number), "Earlier entries"));
  return page(visit, "Audit log", content);
}

}  // namespace insonate::web
