#include "store/Paging.h"
#include "store/Session.h"
#include "store/site/Down.h"
#include "store/site/Up.h"

#include <insonate/curriculum/SiteUpload.h>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Core;
using store::Row;
using store::Transaction;
using store::Way;

Result<void> checkServer(Core& here, Core& server) {
  if (here.address().isServer)
    return fail(here.place() + " is a server. Name the file of a workstation, which is uploaded to a server.");
  if (here.place() == server.place())
    return fail(here.place() + " cannot be its own server; name the server's address.");
  const auto people = inTransaction(server, Way::Read, [](Transaction& transaction) -> Result<bool> {
    return transaction.row("SELECT id FROM people LIMIT 1").has_value();
  });
  if (!people) return tl::unexpected(people.error());
  if (!*people) return fail(server.place() + " has no people yet; open it and set up its administrator first.");
  return {};
}

/// From now on the server determines the people.
Result<void> joinServer(Core& here, const std::string& server) {
  return inTransaction(here, Way::Write, [&](Transaction& transaction) -> Result<void> {
    const auto site = transaction.row("SELECT server FROM site");
    if (!site || site->text(0) == server) return {};
    if (!site->text(0).empty())
      return fail(here.place() + " belongs to " + site->text(0) + ". A workstation can have only one server.");
    transaction.run("UPDATE site SET server = ?", server);
    here.audit(transaction, "", "join server", "", server);
    return {};
  });
}

}  // namespace

Result<UploadReport> SiteUpload::exchange(const Progress& progress) const {
  Core &here = *here_.core_, &server = *server_.core_;
  if (auto ok = checkServer(here, server); !ok) return tl::unexpected(ok.error());
  if (auto ok = joinServer(here, server.place()); !ok) return tl::unexpected(ok.error());
  UploadReport report;
  if (auto sent = sendPeople(here, server, report); !sent) return tl::unexpected(sent.error());
  if (auto sent = sendFacts(here, server, report, progress); !sent) return tl::unexpected(sent.error());
  if (auto fetched = fetchFromServer(here, server, report); !fetched) return tl::unexpected(fetched.error());
  return report;
}

Result<std::int64_t> SiteUpload::pending() const {
  return inTransaction(*here_.core_, Way::Read, [](Transaction& transaction) -> Result<std::int64_t> {
    return transaction.number("SELECT COUNT(*) FROM outbox");
  });
}

Result<std::vector<PendingUpload>> pendingUploads(const SignedIn& by, int count) {
  if (auto ok = store::checkPage(count); !ok) return tl::unexpected(ok.error());
  return by.session()->read(
      {.act = Act::SeeUploads}, [&](Transaction& transaction, const Actor&) -> Result<std::vector<PendingUpload>> {
        std::vector<PendingUpload> uploads;
        for (const Row& row :
             transaction.rows("SELECT number, kind, id, since_us FROM outbox ORDER BY number LIMIT ?", count))
          uploads.push_back({row.number(0), row.text(1), row.text(2), row.number(3)});
        return uploads;
      });
}

}  // namespace insonate
