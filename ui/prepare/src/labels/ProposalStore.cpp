#include "ProposalStore.h"

#include <mutex>
#include <utility>
#include <vector>

namespace insonate::prepare {

struct ProposalStore::Shelf {
  std::mutex mutex;
  std::vector<std::unique_ptr<Proposal>> free;
};

ProposalStore::ProposalStore() : shelf_(std::make_shared<Shelf>()) {}

std::shared_ptr<Proposal> ProposalStore::take() {
  std::unique_ptr<Proposal> one;
  {
    const std::lock_guard lock(shelf_->mutex);
    if (!shelf_->free.empty()) {
      one = std::move(shelf_->free.back());
      shelf_->free.pop_back();
    }
  }
  if (!one) one = std::make_unique<Proposal>();
  return {one.release(), [shelf = std::weak_ptr(shelf_)](Proposal* back) {
            std::unique_ptr<Proposal> held(back);
            const auto there = shelf.lock();
            if (!there) return;
            const std::lock_guard lock(there->mutex);
            there->free.push_back(std::move(held));
          }};
}

void ProposalStore::forget() {
  shelf_ = std::make_shared<Shelf>();
}

}  // namespace insonate::prepare
