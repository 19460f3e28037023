#pragma once

#include <insonate/segmentation/Region.h>

#include <memory>

namespace insonate::prepare {

/// Keeps the buffers of unused proposals for reuse: a proposal for a whole CT takes tens of megabytes, and allocating
/// this memory takes longer than filling it by a threshold.
class ProposalStore {
 public:
  ProposalStore();

  /// Returns a proposal to be filled; it still has former contents. The thread that releases it last returns it to this
  /// store.
  std::shared_ptr<Proposal> take();
  /// Frees all memory; the memory of a proposal in use is freed when it is released.
  void forget();

 private:
  struct Shelf;
  std::shared_ptr<Shelf> shelf_;
};

}  // namespace insonate::prepare
