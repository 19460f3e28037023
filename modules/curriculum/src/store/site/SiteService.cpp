#include "store/Proofs.h"
#include "store/StoredRecordings.h"
#include "store/Texts.h"
#include "store/site/Site.h"
#include "store/site/WireJson.h"

#include <insonate/curriculum/SiteService.h>

#include <charconv>
#include <cstdio>

namespace insonate {
namespace {

using nlohmann::json;
using store::Core;
using store::Row;
using store::StoreSite;
using store::Transaction;
using store::Way;

constexpr std::int64_t kMinute_us = std::int64_t{60} * 1'000'000, kDay_us = 24 * 60 * kMinute_us;
constexpr std::size_t kMostPeople = 10'000, kMostItems = 500;

/// One request, with everything that answers it.
struct Call {
  Core& core;
  StoreSite& site;
  const std::string& workstation;
  const json& content;
};

template <class T, class Write>
Result<json> written(const Result<T>& result, const Write& write) {
  return result ? Result<json>(write(*result)) : tl::unexpected(result.error());
}

/// The first contact tells the secret by which the workstation's recordings are checked. Another secret would let other
/// recordings pass, so that it needs a new token.
Result<json> hello(const Call& call) {
  const std::string name = call.content.at("workstation"), secret = call.content.at("secret");
  if (name != call.workstation)
    return fail("The name of this computer is '" + name.substr(0, 64) + "', but its token belongs to '" +
                call.workstation + "'. Ask an administrator for a token under this computer's name.");
  if (secret.size() != 64 || secret.find_first_not_of("0123456789abcdef") != std::string::npos)
    return fail(
        "The workstation did not send the secret of its store. Install the same version of Insonate on workstation and "
        "server.");
  const auto known = inTransaction(call.core, Way::Read, [&](Transaction& transaction) -> Result<std::string> {
    const auto row = transaction.row("SELECT store_secret FROM workstations WHERE name = ?", call.workstation);
    return row ? row->text(0) : std::string();
  });
  if (!known) return tl::unexpected(known.error());
  if (*known == secret) return json::object();
  if (!known->empty())
    return fail("The store of '" + call.workstation +
                "' is not the one that connected first with this token. Ask an administrator to revoke the token and "
                "to add the workstation again.");
  const auto kept = inTransaction(call.core, Way::Write, [&](Transaction& transaction) -> Result<void> {
    transaction.run("UPDATE workstations SET store_secret = ? WHERE name = ? AND store_secret = ''", secret,
                    call.workstation);
    call.core.audit(transaction, "", "connect workstation", "", call.workstation);
    return {};
  });
  return kept ? Result<json>(json::object()) : tl::unexpected(kept.error());
}

Result<json> signIn(const Call& call) {
  return written(call.site.signIn(call.content.at("name"), call.content.at("password")), [](const auto& known) {
    std::vector<store::SentPerson> people;
    if (known) people.push_back(*known);
    return json{{"people", store::jsonOf(people)}};
  });
}

Result<json> changePassword(const Call& call) {
  const auto person =
      call.site.changePassword(call.content.at("name"), call.content.at("password"), call.content.at("newPassword"));
  return written(person, [](const store::SentPerson& changed) {
    return json{{"people", store::jsonOf(std::vector<store::SentPerson>{changed})}};
  });
}

Result<json> unknownPeople(const Call& call) {
  const auto ids = call.content.at("ids").get<std::set<std::string>>();
  if (ids.size() > kMostPeople) return fail("The workstation has more than 10 000 people.");
  return written(call.site.unknownPeople(ids), [](const auto& unknown) { return json{{"ids", unknown}}; });
}

Result<json> addPeople(const Call& call) {
  return written(call.site.addPeople(store::peopleFrom(call.content.at("people"))), [](const auto& troubles) {
    return json{{"troubles", troubles}};
  });
}

Result<json> takeFacts(const Call& call) {
  const store::SentBatch batch = store::batchFrom(call.content);
  if (batch.items.size() > kMostItems)
    return fail(
        "The message has more than 500 entries. Install the same version of Insonate on workstation and server.");
  return written(call.site.take(batch), [](const store::Taken& taken) { return store::jsonOf(taken); });
}

Result<json> directory(const Call& call) {
  return written(call.site.teach(), [](const store::Taught& taught) { return store::jsonOf(taught); });
}

Result<json> attemptsElsewhere(const Call& call) {
  return written(
      call.site.attemptsElsewhere(call.content.at("digests").get<store::Digests>(), call.content.at("after")),
      [](const store::AttemptsElsewhere& part) { return store::jsonOf(part); });
}

Result<json> wantedRecordings(const Call& call) {
  const auto wanted =
      inTransaction(call.core, Way::Read, [&](Transaction& transaction) -> Result<std::vector<std::string>> {
        std::vector<std::string> ids;
        for (const Row& row : transaction.rows(
                 "SELECT attempt FROM verifications JOIN attempts ON attempts.id = attempt WHERE ended_us IS NULL AND "
                 "received_us IS NULL AND workstation = ? ORDER BY since_us",
                 call.workstation))
          ids.push_back(row.text(0));
        return ids;
      });
  return written(wanted, [](const auto& ids) { return json{{"attempts", ids}}; });
}

/// Attempts whose recordings the workstation still does not have after a day cannot be verified. Before, the recording
/// may be on its way into the workstation's folder, or the folder may not be connected.
Result<json> unavailable(const Call& call) {
  const auto ids = call.content.at("attempts").get<std::vector<std::string>>();
  if (ids.size() > kMostPeople)
    return fail(
        "The message has more than 10 000 attempts. Install the same version of Insonate on workstation and server.");
  const auto done = inTransaction(call.core, Way::Write, [&](Transaction& transaction) -> Result<void> {
    for (const std::string& id : ids) {
      const auto changed = transaction.run(
          "UPDATE verifications SET ended_us = ?, why = ? WHERE attempt = ? AND ended_us IS NULL AND received_us IS "
          "NULL AND since_us < ? AND attempt IN (SELECT id FROM attempts WHERE workstation = ?)",
          call.core.now_us(), "The workstation does not have the recording.", id, call.core.now_us() - kDay_us,
          call.workstation);
      if (changed == 0) continue;
      store::concludeProof(transaction, id, AttemptProof::Unproven);
      call.core.audit(transaction, "", "refuse attempt", "", id + ": its workstation does not have the recording",
                      false);
    }
    return {};
  });
  return done ? Result<json>(json::object()) : tl::unexpected(done.error());
}

struct Command {
  std::string_view path;
  Result<json> (*answer)(const Call&);
};
constexpr Command kCommands[]{
    {"hello", &hello},
    {"sign-in", &signIn},
    {"unknown-people", &unknownPeople},
    {"people", &addPeople},
    {"facts", &takeFacts},
    {"directory", &directory},
    {"attempts-elsewhere", &attemptsElsewhere},
    {"wanted", &wantedRecordings},
    {"unavailable", &unavailable},
    {"password", &changePassword},
};

Result<std::string> answerMessage(Core& core, StoreSite& site, const std::string& workstation, const std::string& path,
                                  const std::string& body) {
  const auto message = store::readMessage(body);
  if (!message) return tl::unexpected(message.error());
  for (const Command& command : kCommands) {
    if (command.path != path) continue;
    try {
      const auto answered = command.answer({core, site, workstation, *message});
      return answered ? Result<std::string>(store::messageOf(*answered)) : tl::unexpected(answered.error());
    } catch (const json::exception&) {
      return fail(
          "The message of the workstation cannot be read. Install the same version of Insonate on workstation and "
          "server.");
    }
  }
  return fail("The server does not know this request. Install the same version of Insonate on workstation and server.");
}

/// Reads "5/70" as numbers; -1 for anything else.
std::pair<std::int64_t, std::int64_t> numbersOf(std::string_view text) {
  std::int64_t first = -1, second = -1;
  const char* const end = text.data() + text.size();
  const auto [after, error] = std::from_chars(text.data(), end, first);
  if (error == std::errc() && after != end && *after == '/') std::from_chars(after + 1, end, second);
  return {first, second};
}

/// Fails with a sentence for the workstation if it has sent too much. A workstation that keeps the rules has days to
/// send the rest: its recordings stay there until the server has them.
Result<void> checkRoom(Core& core, const std::string& workstation, std::int64_t more_bytes, std::int64_t max_bytes) {
  const auto recent = inTransaction(core, Way::Read, [&](Transaction& transaction) -> Result<std::vector<std::string>> {
    std::vector<std::string> ids;
    for (const Row& row : transaction.rows(
             "SELECT attempt FROM verifications JOIN attempts ON attempts.id = attempt WHERE workstation = ? AND "
             "(received_us > ? OR (received_us IS NULL AND ended_us IS NULL))",
             workstation, core.now_us() - kDay_us))
      ids.push_back(row.text(0));
    return ids;
  });
  if (!recent) return tl::unexpected(recent.error());
  if (store::sizeOfRecordings(core.recordings(), *recent) + more_bytes <= max_bytes) return {};
  char limit[32];
  std::snprintf(limit, sizeof limit, "%.3g GB", static_cast<double>(max_bytes) * 1e-9);
  return fail(
      "The server takes recordings of up to " + std::string(limit) +
      " from this computer in 24 hours, and has received them. Further recordings stay on this computer and are "
      "sent later. If this is too little, ask the server's administrator to increase recordings-per-day.");
}

/// `path`: ID/OFFSET/SIZE
Result<std::string> answerRecording(Core& core, const std::string& workstation, const std::string& path,
                                    const std::string& bytes, std::int64_t mostPerDay_bytes) {
  const std::size_t slash = path.find('/');
  const std::string attempt = path.substr(0, slash);
  const auto [offset_bytes, total_bytes] =
      numbersOf(slash == std::string::npos ? std::string_view() : std::string_view(path).substr(slash + 1));
  if (!store::isUuid(attempt) || offset_bytes < 0 || total_bytes <= 0)
    return fail("The address of the recording is not ID/OFFSET/SIZE.");
  const auto hash = inTransaction(core, Way::Read, [&](Transaction& transaction) -> Result<std::string> {
    const auto row = transaction.row(
        "SELECT recording_hash FROM attempts JOIN verifications ON attempt = id WHERE id = ? AND workstation = ? AND "
        "ended_us IS NULL AND received_us IS NULL",
        attempt, workstation);
    return row ? row->text(0) : std::string();
  });
  if (!hash) return tl::unexpected(hash.error());
  if (hash->empty()) return fail("The server does not need this recording.");
  if (!bytes.empty())
    if (auto ok = checkRoom(core, workstation, static_cast<std::int64_t>(bytes.size()), mostPerDay_bytes); !ok)
      return tl::unexpected(ok.error());
  const auto received = store::receiveRecording(core.recordings(), attempt, *hash, offset_bytes, total_bytes, bytes);
  if (!received) return tl::unexpected(received.error());
  if (received->isComplete) {
    const auto noted = inTransaction(core, Way::Write, [&](Transaction& transaction) -> Result<void> {
      transaction.run("UPDATE verifications SET received_us = ? WHERE attempt = ? AND received_us IS NULL",
                      core.now_us(), attempt);
      return {};
    });
    if (!noted) return tl::unexpected(noted.error());
  }
  return store::messageOf({{"received", received->size_bytes}});
}

}  // namespace

Result<std::optional<std::string>> SiteService::workstationOf(const std::string& token) const {
  Core& core = *server_.core_;
  bool isOutdated = false;
  auto found = inTransaction(core, Way::Read, [&](Transaction& transaction) -> Result<std::optional<std::string>> {
    const auto row = transaction.row(
        "SELECT name, seen_us FROM workstations WHERE token_hash = ? AND revoked_us IS NULL", store::sha256(token));
    if (!row) return std::nullopt;
    isOutdated = row->isNull(1) || core.now_us() - row->number(1) > kMinute_us;
    return row->text(0);
  });
  if (!found || !*found || !isOutdated) return found;
  const auto noted = inTransaction(core, Way::Write, [&](Transaction& transaction) -> Result<void> {
    transaction.run("UPDATE workstations SET seen_us = ? WHERE name = ?", core.now_us(), **found);
    return {};
  });
  if (!noted) return tl::unexpected(noted.error());
  return found;
}

Result<std::string> SiteService::answer(const std::string& workstation, const std::string& path,
                                        const std::string& body) const {
  constexpr std::string_view kRecordings = "recordings/";
  if (path.starts_with(kRecordings))
    return answerRecording(*server_.core_, workstation, path.substr(kRecordings.size()), body, recordingsPerDay_bytes_);
  StoreSite site(server_.core_, {.workstation = workstation, .isTrusted = false});
  return answerMessage(*server_.core_, site, workstation, path, body);
}

}  // namespace insonate
