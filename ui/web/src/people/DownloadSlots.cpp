#include "people/DownloadSlots.h"

#include <mutex>
#include <set>

namespace insonate::web {

struct DownloadSlots::Taken {
  std::mutex mutex{};
  std::set<std::string> people{};
};

DownloadSlots::DownloadSlots() : taken_(std::make_shared<Taken>()) {}

Result<std::shared_ptr<const void>> DownloadSlots::take(const std::string& person) {
  const std::lock_guard lock(taken_->mutex);
  if (taken_->people.contains(person))
    return fail("These data are being downloaded already. Wait until that download has ended, then try again.");
  if (taken_->people.size() >= kMost)
    return fail("The server is sending the data of other people. Try again in a few minutes.");
  taken_->people.insert(person);
  return std::shared_ptr<const void>(taken_.get(), [taken = taken_, person](const void*) {
    const std::lock_guard end(taken->mutex);
    taken->people.erase(person);
  });
}

}  // namespace insonate::web
