#include "store/Session.h"

#include <insonate/curriculum/StoreChanges.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace insonate {
namespace {

using store::Transaction;
using store::Way;

/// Larger changes, such as an import, count as changes of everything.
constexpr std::int64_t kMaxEntries = 1000;

/// Words at the beginning of acts that change nothing that is shown (Rule::words). What an upload brings and what a
/// rule of retention erases has entries of its own.
constexpr std::array<std::string_view, 7> kViews{"see ",   "read ",         "sign in",         "stay signed in",
                                                 "upload", "export person", "manage retention"};

bool isChange(std::string_view act) {
  return std::ranges::none_of(kViews, [&](std::string_view view) { return act.starts_with(view); });
}

}  // namespace

Result<std::set<std::string>> StoreChanges::readChanges() {
  const std::int64_t before = lastEntry_;
  std::int64_t last = before;
  const auto read = [&](Transaction& transaction) -> Result<std::set<std::string>> {
    last = transaction.number("SELECT number FROM audit_end");
    if (before < 0) return {};
    if (last - before > kMaxEntries) return std::set<std::string>{""};
    std::set<std::string> people;
    // Refused requests change nothing; the refusal of an attempt by the server itself, which has no actor, does.
    for (const store::Row& row :
         transaction.rows("SELECT act, person FROM audit WHERE number > ? AND (allowed = 1 OR actor = '')", before))
      if (isChange(row.text(0))) people.insert(row.text(1));
    return people;
  };
  auto changed = inTransaction(by_.session()->core(), Way::Read, read);
  if (changed) lastEntry_ = last;
  return changed;
}

}  // namespace insonate
