#include "live/LiveUpdates.h"

#include "monitoring/FailureLog.h"

#include <insonate/curriculum/StoreChanges.h>

#include <algorithm>
#include <utility>

namespace insonate::web {
namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;

/// Streams take connections, of which the server has a limited number (HttpLimits).
constexpr std::size_t kMostPages = 500, kMostPagesOfUser = 60;
constexpr auto kPause = 2s, kPauseAfterFailure = 30s;
/// Shorter than the time after which common proxies close a silent connection.
constexpr auto kLongestSilence = 20s;
constexpr auto kLongestStream = 5min;

constexpr const char* kChanged = "changed";

bool concerns(const std::set<std::string>& changed, const std::set<std::string>& people) {
  return changed.contains("") ||
         std::ranges::any_of(changed, [&](const std::string& person) { return people.contains(person); });
}

}  // namespace

LiveUpdates::LiveUpdates(const CurriculumStore& store, Log log)
    : store_(store), log_(std::move(log)), thread_([this] { run(); }) {}

LiveUpdates::~LiveUpdates() {
  end();
  thread_.join();
}

std::int64_t LiveUpdates::numberOfLastChange() const {
  StoreChanges changes(store_.guest());
  return changes.readChanges() ? changes.number() : -1;
}

std::shared_ptr<EventStream> LiveUpdates::open(const std::string& user, std::set<std::string> people,
                                               std::int64_t since) {
  StoreChanges missed(store_.guest(), since);
  const auto changed = missed.readChanges();
  const std::lock_guard lock(mutex_);
  std::erase_if(pages_, [](const Page& page) { return page.stream->isOver(); });
  if (isEnding_ || pages_.size() >= kMostPages) return nullptr;
  if (std::ranges::count(pages_, user, &Page::user) >= std::ptrdiff_t{kMostPagesOfUser}) return nullptr;
  const auto now = steady_clock::now();
  auto stream = std::make_shared<EventStream>();
  // A change of which the others were told since then may concern this page, too.
  if (!changed || concerns(*changed, people) || told_ > missed.number())
    stream->push(kChanged, std::max(told_, missed.number()));
  if (pages_.empty()) begin_ = missed.number();
  pages_.push_back({stream, user, std::move(people), now, now});
  wake_.notify_all();
  return stream;
}

void LiveUpdates::end() {
  const std::lock_guard lock(mutex_);
  isEnding_ = true;
  for (const Page& page : pages_) page.stream->end();
  pages_.clear();
  wake_.notify_all();
}

void LiveUpdates::tell(const std::set<std::string>& changed, std::int64_t number) {
  const std::lock_guard lock(mutex_);
  const auto now = steady_clock::now();
  told_ = std::max(told_, number);
  for (Page& page : pages_) {
    if (now - page.opened > kLongestStream) {
      page.stream->end();
    } else if (concerns(changed, page.people)) {
      page.stream->push(kChanged, number);
      page.sent = now;
    } else if (now - page.sent > kLongestSilence) {
      page.stream->keepAlive();
      page.sent = now;
    }
  }
  std::erase_if(pages_, [](const Page& page) { return page.stream->isOver(); });
}

void LiveUpdates::run() {
  StoreChanges changes(store_.guest());
  for (;;) {
    const auto changed = changes.readChanges();
    if (!changed) logFailure(log_, "live updates failed", changed.error().message);
    tell(changed ? *changed : std::set<std::string>{}, changes.number());
    std::unique_lock lock(mutex_);
    if (wake_.wait_for(lock, changed ? kPause : kPauseAfterFailure, [this] { return isEnding_; })) return;
    // Without pages there is nothing to look for; the first page that is opened then knows what happened before.
    wake_.wait(lock, [this] { return isEnding_ || !pages_.empty(); });
    if (isEnding_) return;
    if (const auto begin = std::exchange(begin_, std::nullopt)) changes = StoreChanges(store_.guest(), *begin);
  }
}

}  // namespace insonate::web
