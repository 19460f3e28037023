#pragma once

#include <insonate/segmentation/Region.h>

#include <memory>

namespace insonate::prepare {

/// Keeps the buffers of unused proposals for reuse: a proposal for a whole CT takes tens of megabytes, and allocating
/// them takes longer than a threshold takes to fill them.
class ProposalStore {
 public:
  ProposalStore();

  /// Returns a proposal to fill, with its former contents; it returns here from whichever thread releases it last.
  std::shared_ptr<Proposal> take();
  /// Frees all memory; that of a displayed proposal once it is released.
  void forget();

 private:
  struct Shelf;
  std::shared_ptr<Shelf> shelf_;
};

}  // namespace insonate::prepare
