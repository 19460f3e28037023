#include "store/Paging.h"
#include "store/Session.h"
#include "store/site/Site.h"

#include <insonate/curriculum/SiteUpload.h>

#include <algorithm>
#include <optional>
#include <set>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Core;
using store::Row;
using store::Transaction;
using store::Way;

/// From now on the server determines the people.
Result<void> joinServer(Core& here, const std::string& server) {
  return inTransaction(here, Way::Write, [&](Transaction& transaction) -> Result<void> {
    const auto site = transaction.row("SELECT server FROM site");
    if (!site || site->text(0) == server) return {};
    if (!site->text(0).empty())
      return fail(here.place() + " belongs to " + site->text(0) + ". A workstation can have only one server.");
    transaction.run("UPDATE site SET server = ?", server);
    // From now on, tests are opened on the server only.
    transaction.run("UPDATE openings SET closed_us = ?, closed_by = opened_by WHERE closed_us IS NULL", here.now_us());
    here.audit(transaction, "", "join server", "", server);
    return {};
  });
}

/// Sends people whom the server does not know yet.
Result<void> sendPeople(Core& here, store::Site& server, UploadReport& report) {
  const auto people = store::peopleOf(here);
  if (!people) return tl::unexpected(people.error());
  std::set<std::string> ids;
  for (const store::SentPerson& sent : *people) ids.insert(sent.person.id);
  const auto unknown = server.unknownPeople(ids);
  if (!unknown) return tl::unexpected(unknown.error());
  std::vector<store::SentPerson> sent;
  for (const store::SentPerson& person : *people)
    if (unknown->contains(person.person.id)) sent.push_back(person);
  constexpr std::size_t kAtOnce = 100;
  for (std::size_t i = 0; i < sent.size(); i += kAtOnce) {
    const auto begin = sent.begin() + static_cast<std::ptrdiff_t>(i);
    const auto end = sent.begin() + static_cast<std::ptrdiff_t>(std::min(sent.size(), i + kAtOnce));
    const auto troubles = server.addPeople({begin, end});
    if (!troubles) return tl::unexpected(troubles.error());
    report.errors.insert(report.errors.end(), troubles->begin(), troubles->end());
  }
  return {};
}

/// Receives the attempts at other workstations, part by part.
Result<void> receiveElsewhere(Core& here, store::Site& server, UploadReport& report, const Progress& progress) {
  auto known = store::digestsHere(here);
  if (!known) return tl::unexpected(known.error());
  std::string after;
  do {
    const auto part = server.attemptsElsewhere(*known, after);
    if (!part) return tl::unexpected(part.error());
    if (auto taken = store::takeElsewhere(here, part->attempts, report); !taken) return taken;
    // A server that names the same people again must not hold the workstation for ever.
    if (!part->last.empty() && part->last <= after)
      return fail(server.place() +
                  " sends the same attempts again. Install the same version of Insonate on both sides.");
    after = part->last;
    known->erase(known->begin(), known->upper_bound(after));
    if (!insonate::report(progress, "receiving", 0)) return fail(std::string(kCancelled));
  } while (!after.empty());
  return {};
}

/// Removes what the server has stored from the outbox.
Result<void> waitNoMore(Core& here, const std::vector<std::int64_t>& numbers) {
  return inTransaction(here, Way::Write, [&](Transaction& transaction) -> Result<void> {
    for (const std::int64_t number : numbers) transaction.run("DELETE FROM outbox WHERE number = ?", number);
    return {};
  });
}

/// Sends all waiting attempts and forms in batches.
Result<void> sendFacts(Core& here, store::Site& server, UploadReport& report, const Progress& progress) {
  std::int64_t after = 0, total = 0, sent = 0;
  for (;;) {
    const auto batch = store::readBatch(here, after);
    if (!batch) return tl::unexpected(batch.error());
    if (batch->items.empty()) return {};
    total = std::max(total, batch->waiting);
    if (!insonate::report(progress, "sending", static_cast<double>(sent) / static_cast<double>(total)))
      return fail(std::string(kCancelled));
    const auto taken = server.take(*batch);
    if (!taken) return tl::unexpected(taken.error());
    if (auto done = waitNoMore(here, taken->numbers); !done) return done;
    report.attempts += taken->attempts;
    report.forms += taken->forms;
    report.errors.insert(report.errors.end(), taken->troubles.begin(), taken->troubles.end());
    sent += static_cast<std::int64_t>(batch->items.size());
    after = batch->items.back().number;
  }
}

}  // namespace

SiteUpload::SiteUpload(CurriculumStore here, const CurriculumStore& server)
    : here_(std::move(here)),
      server_(std::make_shared<store::StoreSite>(
          server.core_, store::Sender{.workstation = here_.workstation(), .isTrusted = true})) {}

SiteUpload::SiteUpload(CurriculumStore here, SiteLink server)
    : here_(std::move(here)), server_(std::make_shared<store::RemoteSite>(std::move(server))) {}

Result<UploadReport> SiteUpload::exchange(const Progress& progress) const {
  Core& here = *here_.core_;
  if (here.address().isServer)
    return fail(here.place() + " is a server. Name the file of a workstation, which is uploaded to a server.");
  if (auto ok = server_->greet(here); !ok) return tl::unexpected(ok.error());
  if (auto ok = joinServer(here, server_->place()); !ok) return tl::unexpected(ok.error());
  UploadReport report;
  if (auto sent = sendPeople(here, *server_, report); !sent) return tl::unexpected(sent.error());
  if (auto sent = sendFacts(here, *server_, report, progress); !sent) return tl::unexpected(sent.error());
  auto taught = server_->teach();
  if (!taught) return tl::unexpected(taught.error());
  if (auto ok = store::takeTaught(here, std::move(*taught), report); !ok) return tl::unexpected(ok.error());
  if (auto ok = receiveElsewhere(here, *server_, report, progress); !ok) return tl::unexpected(ok.error());
  if (auto sent = server_->takeRecordings(here, report, progress); !sent) return tl::unexpected(sent.error());
  return report;
}

Result<SiteUpload::Reached> SiteUpload::signIn(const std::string& name, const std::string& password) const {
  if (!server_->answers()) return Reached::No;
  if (auto ok = server_->greet(*here_.core_); !ok) return tl::unexpected(ok.error());
  const auto known = server_->signIn(name, password);
  if (!known) return tl::unexpected(known.error());
  if (!*known) return Reached::Yes;
  if (auto kept = keep(**known); !kept) return tl::unexpected(kept.error());
  return Reached::Yes;
}

Result<void> SiteUpload::changePassword(const std::string& name, const std::string& old,
                                        const std::string& password) const {
  const auto changed = server_->changePassword(name, old, password);
  if (!changed) return tl::unexpected(changed.error());
  return keep(*changed);
}

/// Stores what the server gives now, with the password of this person.
Result<void> SiteUpload::keep(const store::SentPerson& person) const {
  if (auto ok = joinServer(*here_.core_, server_->place()); !ok) return ok;
  auto taught = server_->teach();
  if (!taught) return tl::unexpected(taught.error());
  const auto row = taught->people.find(person.person.id);
  // If the password was changed just now, the person signs in once more.
  if (row != taught->people.end() && row->second[store::kVersionColumn] == std::to_string(person.version))
    row->second[store::kPasswordColumn] = person.password;
  taught->refused.clear();  // told once, by the next exchange
  UploadReport report;
  if (auto ok = store::takeTaught(*here_.core_, std::move(*taught), report); !ok) return ok;
  // The person is signed in, or the password is changed, even if attempts are missing; the next exchange receives them.
  static_cast<void>(receiveElsewhere(*here_.core_, *server_, report, {}));
  return {};
}

const std::string& SiteUpload::place() const {
  return server_->place();
}

Result<std::int64_t> SiteUpload::pending() const {
  return inTransaction(*here_.core_, Way::Read, [](Transaction& transaction) -> Result<std::int64_t> {
    return transaction.number("SELECT COUNT(*) FROM outbox");
  });
}

Result<std::vector<std::string>> SiteUpload::caseNames() const {
  return inTransaction(*here_.core_, Way::Read, [](Transaction& transaction) -> Result<std::vector<std::string>> {
    std::set<std::string> names;
    for (const Row& row :
         transaction.rows("SELECT DISTINCT curriculum, curriculum_version FROM cohorts WHERE archived = "
                          "0 AND curriculum <> ''")) {
      const auto curriculum = store::publishedCurriculum(transaction, row.text(0), static_cast<int>(row.number(1)));
      // A curriculum of a later version of the program must not hold up the cases of the others.
      if (!curriculum) continue;
      for (const Level& level : curriculum->levels) names.insert(level.caseName);
    }
    return std::vector<std::string>(names.begin(), names.end());
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
