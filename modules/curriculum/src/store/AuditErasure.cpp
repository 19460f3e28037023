#include "store/AuditErasure.h"

#include "store/AuditChain.h"
#include "store/Texts.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <vector>

namespace insonate::store {
namespace {

constexpr std::string_view kOfWorkstation = " of ", kAttempt = ", attempt ", kBetween = ", ";

/// Entries about the person, and entries of earlier programs about new people, which have names only.
std::vector<AuditEntry> entriesWithTexts(Transaction& transaction, const std::string& person) {
  std::vector<AuditEntry> entries;
  for (const Row& row :
       transaction.rows("SELECT * FROM audit WHERE (person = ? AND act IN ('change person', 'add person of "
                        "workstation', 'void attempt', 'accept attempt')) OR act IN ('add person', 'add trainee') "
                        "ORDER BY number",
                        person))
    entries.push_back(auditEntryOf(row));
  return entries;
}

/// The name in "anna, trainee, disabled", as earlier programs wrote it; empty in "trainee, disabled".
std::string nameBeforeRole(std::string_view detail) {
  constexpr std::array<std::string_view, 3> kRoleWords{"trainee", "instructor", "administrator"};
  const std::size_t end = detail.find(kBetween);
  if (end == std::string_view::npos) return {};
  std::string_view rest = detail.substr(end + kBetween.size());
  rest = rest.substr(0, rest.find(kBetween));
  return std::ranges::find(kRoleWords, rest) == kRoleWords.end() ? std::string() : std::string(detail.substr(0, end));
}

/// The name in an entry about a person; empty if there is none.
std::string nameIn(const AuditEntry& entry) {
  if (entry.act != "add person of workstation") return nameBeforeRole(entry.detail);
  const std::size_t end = entry.detail.find(kOfWorkstation);
  return end == std::string::npos ? std::string() : entry.detail.substr(0, end);
}

bool hasReason(const AuditEntry& entry) {
  return entry.act == "void attempt" || entry.act == "accept attempt";
}

/// The detail without its text; empty if there is nothing to erase. `names`: keys of the names that the person has had.
std::string withoutText(const AuditEntry& entry, const std::set<std::string>& names) {
  const std::string& detail = entry.detail;
  if (detail.starts_with(kErased)) return {};
  if (hasReason(entry)) {
    const std::size_t end = detail.rfind(kAttempt);
    return std::string(kErased) + (end == std::string::npos ? "" : detail.substr(end));
  }
  const std::string name = nameIn(entry);
  return !name.empty() && names.contains(nameKey(name)) ? std::string(kErased) + detail.substr(name.size()) : "";
}

Result<void> eraseDetail(Transaction& transaction, const Core& core, AuditEntry entry, const std::string& detail,
                         const std::string& person, const std::string& by) {
  const auto before = transaction.row("SELECT hash FROM audit WHERE number = ?", entry.number - 1);
  if (!isAsWritten(entry, before ? before->text(0) : ""))
    return fail("Entry " + std::to_string(entry.number) +
                " of the audit log was changed by another program, so that nothing was erased. Run 'curriculum verify' "
                "and compare the database with a backup.");
  entry.detail = detail;
  transaction.run("UPDATE audit SET detail = ? WHERE number = ?", detail, entry.number);
  core.audit(transaction, by, kEraseDetail, person, voucherFor(entry));
  return {};
}

}  // namespace

Result<void> eraseFromLog(Transaction& transaction, const Core& core, const Person& person, const std::string& by) {
  const std::vector<AuditEntry> entries = entriesWithTexts(transaction, person.id);
  std::set<std::string> names{nameKey(person.name)};
  for (const AuditEntry& entry : entries)
    if (entry.person == person.id && !hasReason(entry)) names.insert(nameKey(nameIn(entry)));
  for (const AuditEntry& entry : entries)
    if (const std::string detail = withoutText(entry, names); !detail.empty())
      if (auto done = eraseDetail(transaction, core, entry, detail, person.id, by); !done) return done;
  return {};
}

}  // namespace insonate::store
