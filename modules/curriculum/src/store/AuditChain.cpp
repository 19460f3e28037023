#include "store/AuditChain.h"

#include "store/Texts.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace insonate::store {
namespace {

/// SHA-256 over another hash and all fields, each preceded by its length, so that no two entries have the same input.
std::string hashOf(const AuditEntry& entry, const std::string& before) {
  std::string bytes;
  for (const std::string& field :
       {before, std::to_string(entry.number), std::to_string(entry.time_us), entry.actor, entry.workstation, entry.act,
        entry.person, entry.detail, std::string(entry.allowed ? "1" : "0")})
    bytes += std::to_string(field.size()) + ":" + field;
  return sha256(bytes);
}

tl::unexpected<Error> broken(std::int64_t number, const std::string& what) {
  return fail("The audit log is inconsistent at entry " + std::to_string(number) + ": " + what +
              ". Another program has written to the database. Compare it with a backup.");
}

/// Anchors that entries have not been compared with, in the order of their numbers.
class OpenAnchors {
 public:
  explicit OpenAnchors(std::vector<AuditAnchor> anchors) : anchors_(std::move(anchors)) {
    std::ranges::sort(anchors_, {}, &AuditAnchor::number);
  }
  Result<void> compare(const AuditEntry& entry) {
    for (; next_ < anchors_.size() && anchors_[next_].number <= entry.number; ++next_)
      if (anchors_[next_].number == entry.number && anchors_[next_].hash != entry.hash)
        return broken(entry.number, "it differs from the noted anchor");
    return {};
  }
  bool isEmpty() const { return next_ == anchors_.size(); }

 private:
  std::vector<AuditAnchor> anchors_;
  std::size_t next_ = 0;
};

}  // namespace

std::string forLog(const std::string& text) {
  constexpr int kMost = 300;
  return bound(text).toString().left(kMost).toStdString();
}

AuditEntry auditEntryOf(const Row& row) {
  return {.number = row.number(0),
          .time_us = row.number(1),
          .actor = row.text(2),
          .workstation = row.text(3),
          .act = row.text(4),
          .person = row.text(5),
          .detail = row.text(6),
          .allowed = row.truth(7),
          .hash = row.text(8)};
}

AuditAnchor auditEnd(Transaction& transaction) {
  const auto row = transaction.row("SELECT number, hash FROM audit_end");
  return row ? AuditAnchor{row->number(0), row->text(1)} : AuditAnchor{};
}

void appendAudit(Transaction& transaction, AuditEntry entry) {
  const AuditAnchor end = auditEnd(transaction);
  entry.number = end.number + 1;
  entry.hash = hashOf(entry, end.hash);
  transaction.run("INSERT INTO audit VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)", entry.number, entry.time_us, entry.actor,
                  entry.workstation, entry.act, entry.person, entry.detail, entry.allowed, entry.hash);
  transaction.run("UPDATE audit_end SET number = ?, hash = ?", entry.number, entry.hash);
}

bool isAsWritten(const AuditEntry& entry, const std::string& hashBefore) {
  return entry.hash == hashOf(entry, hashBefore);
}

std::string voucherFor(const AuditEntry& entry) {
  return std::to_string(entry.number) + " " + hashOf(entry, entry.hash);
}

namespace {

/// Tells whether an erasure of a person changes an entry. Details of other entries hold no names, and must not be
/// hidden.
bool isOfErasure(Transaction& transaction, const AuditEntry& entry, const std::string& person) {
  const bool isAdding = entry.act == "add person" || entry.act == "add trainee";
  const bool hasText = entry.act == "change person" || entry.act == "add person of workstation" ||
                       entry.act == "void attempt" || entry.act == "accept attempt";
  return (isAdding || (hasText && entry.person == person)) &&
         transaction.number("SELECT COUNT(*) FROM erasures WHERE person = ?", person) > 0;
}

}  // namespace

Result<void> verifyAudit(Transaction& transaction, const std::vector<AuditAnchor>& anchors) {
  constexpr std::int64_t kAtOnce = 10000;
  std::map<std::string, AuditEntry> unvouched;  // entries with erased details, by their vouchers
  AuditAnchor last;
  OpenAnchors open(anchors);
  for (;;) {
    const auto rows =
        transaction.rows("SELECT * FROM audit WHERE number > ? ORDER BY number LIMIT ?", last.number, kAtOnce);
    for (const Row& row : rows) {
      const AuditEntry entry = auditEntryOf(row);
      if (entry.number != last.number + 1) return broken(last.number + 1, "it is missing");
      if (!isAsWritten(entry, last.hash)) {
        if (!entry.detail.starts_with(kErased)) return broken(entry.number, "it was changed");
        unvouched.emplace(voucherFor(entry), entry);
      }
      if (const auto found = unvouched.find(entry.detail); entry.act == kEraseDetail && found != unvouched.end())
        if (isOfErasure(transaction, found->second, entry.person)) unvouched.erase(found);
      if (auto ok = open.compare(entry); !ok) return ok;
      last = {entry.number, entry.hash};
    }
    if (rows.empty()) break;
  }
  if (transaction.error()) return tl::unexpected(*transaction.error());
  if (!unvouched.empty()) return broken(unvouched.begin()->second.number, "it was changed");
  if (last != auditEnd(transaction) || !open.isEmpty()) return broken(last.number + 1, "the end is missing");
  return {};
}

}  // namespace insonate::store
