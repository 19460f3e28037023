#include "store/AttemptRows.h"
#include "store/Session.h"
#include "store/StoredRecordings.h"

#include <insonate/curriculum/VideoQueue.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Core;
using store::Transaction;
using store::Way;

/// A server reports each few seconds; one that does not has ended.
constexpr std::int64_t kMaxOfPerson = 5;
constexpr std::int64_t kLongestSilence_us = std::int64_t{2} * 60 * 1'000'000;
/// A server that ends while it makes a video may have failed for another reason, but not this often.
constexpr std::int64_t kMaxTries = 3;
constexpr const char* kGivenUp =
    "The video cannot be made: the server stopped three times while it made this video, and does not try again by "
    "itself. The attempt and its results are kept. Tell the administrator of the server.";

VideoState videoStateOf(Transaction& transaction, const std::string& attempt, std::int64_t now_us) {
  VideoState state{.length_us =
                       transaction.number("SELECT COALESCE(length_us, 0) FROM attempts WHERE id = ?", attempt)};
  const auto row = transaction.row(
      "SELECT asked_us, begun_us, permille, ended_us, why, taken_us FROM videos WHERE attempt = ?", attempt);
  if (!row) return state;
  state.fraction = double(row->number(2)) / 1000, state.why = row->text(4);
  state.stage = !row->isNull(3)   ? VideoState::Stage::Ended
                : !row->isNull(5) ? VideoState::Stage::Making
                                  : VideoState::Stage::Waiting;
  if (!row->isNull(1)) state.taken_us = std::max<std::int64_t>(0, now_us - row->number(1));
  if (state.stage == VideoState::Stage::Waiting)
    state.before = transaction.number(
        "SELECT COUNT(*) FROM videos WHERE ended_us IS NULL AND attempt <> ? AND (taken_us IS NOT NULL OR asked_us <= "
        "?)",
        attempt, row->number(0));
  return state;
}

}  // namespace

Result<void> AttemptVideos::request(const std::string& attempt) const {
  const std::int64_t now_us = by_.session()->core().now_us();
  return by_.session()->write(
      {.act = Act::SeeAttempts, .attempt = attempt, .detail = "video"},
      [&](Transaction& transaction, const Actor&) -> Result<void> {
        const std::int64_t waiting = transaction.number(
            "SELECT COUNT(*) FROM videos JOIN attempts ON attempts.id = attempt WHERE ended_us IS NULL AND attempt <> "
            "? "
            "AND person = (SELECT person FROM attempts WHERE id = ?)",
            attempt, attempt);
        if (waiting >= kMaxOfPerson)
          return fail(
              "Five videos of this person are being made or wait. Request this video when one of them is ready.");
        transaction.run("DELETE FROM videos WHERE attempt = ? AND ended_us IS NOT NULL", attempt);
        if (transaction.number("SELECT COUNT(*) FROM videos WHERE attempt = ?", attempt) == 0)
          transaction.run("INSERT INTO videos VALUES (?, ?, NULL, NULL, '', 0, NULL, '', 0)", attempt, now_us);
        return {};
      });
}

Result<VideoState> AttemptVideos::state(const std::string& attempt) const {
  const std::int64_t now_us = by_.session()->core().now_us();
  return by_.session()->read({.act = Act::SeeAttempts, .attempt = attempt, .detail = "video", .isLoggedHourly = true},
                             [&](Transaction& transaction, const Actor&) -> Result<VideoState> {
                               return videoStateOf(transaction, attempt, now_us);
                             });
}

Result<std::optional<WaitingVideo>> VideoQueue::takeNext() const {
  using Outcome = Result<std::optional<WaitingVideo>>;
  Core& core = *store_.core_;
  const std::int64_t now_us = core.now_us();
  const auto next = [&](Transaction& transaction) {
    return transaction.row(
        "SELECT attempt, tries FROM videos WHERE ended_us IS NULL AND (taken_us IS NULL OR taken_us < ? OR taken_us > "
        "?) "
        "ORDER BY asked_us LIMIT 1",
        now_us - kLongestSilence_us, now_us + kLongestSilence_us);
  };
  // Most of the time nothing waits, and a transaction for writing would hold up others.
  const auto waits = inTransaction(
      core, Way::Read, [&](Transaction& transaction) -> Result<bool> { return next(transaction).has_value(); });
  if (!waits) return tl::unexpected(waits.error());
  if (!*waits) return std::nullopt;
  return inTransaction(core, Way::Write, [&](Transaction& transaction) -> Outcome {
    auto row = next(transaction);
    for (; row && row->number(1) >= kMaxTries; row = next(transaction))
      transaction.run("UPDATE videos SET ended_us = ?, why = ? WHERE attempt = ?", now_us, kGivenUp, row->text(0));
    if (!row) return std::nullopt;
    transaction.run(
        "UPDATE videos SET begun_us = ?, taken_us = ?, taken_by = ?, permille = 0, tries = tries + 1 WHERE attempt = ?",
        now_us, now_us, server_, row->text(0));
    return WaitingVideo{row->text(0), store::storedRecording(core.recordings(), row->text(0))};
  });
}

Result<bool> VideoQueue::reportProgress(const std::string& attempt, double fraction) const {
  Core& core = *store_.core_;
  return inTransaction(core, Way::Write, [&](Transaction& transaction) -> Result<bool> {
    return transaction.run(
               "UPDATE videos SET taken_us = ?, permille = ? WHERE attempt = ? AND taken_by = ? AND ended_us IS NULL",
               core.now_us(), std::int64_t{std::llround(std::clamp(fraction, 0.0, 1.0) * 1000)}, attempt, server_) > 0;
  });
}

Result<void> VideoQueue::storeResult(const std::string& attempt, const std::string& why) const {
  Core& core = *store_.core_;
  return inTransaction(core, Way::Write, [&](Transaction& transaction) -> Result<void> {
    transaction.run("UPDATE videos SET ended_us = ?, why = ? WHERE attempt = ? AND taken_by = ? AND ended_us IS NULL",
                    core.now_us(), why, attempt, server_);
    return {};
  });
}

Result<void> VideoQueue::release(const std::string& attempt) const {
  return inTransaction(*store_.core_, Way::Write, [&](Transaction& transaction) -> Result<void> {
    transaction.run(
        "UPDATE videos SET begun_us = NULL, taken_us = NULL, taken_by = '', tries = tries - 1 WHERE attempt = ? AND "
        "taken_by = ? AND ended_us IS NULL",
        attempt, server_);
    return {};
  });
}

Result<std::int64_t> VideoQueue::waiting() const {
  return inTransaction(*store_.core_, Way::Read, [](Transaction& transaction) -> Result<std::int64_t> {
    return transaction.number("SELECT COUNT(*) FROM videos WHERE ended_us IS NULL");
  });
}

}  // namespace insonate
