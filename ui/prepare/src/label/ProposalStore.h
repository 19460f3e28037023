#pragma once

#include <insonate/segmentation/Region.h>

#include <memory>

namespace insonate::prepare {

/// Memory of proposals that nobody looks at any more, used again: those of a whole CT are tens of megabytes, which the
/// system takes longer to give than a threshold to fill.
class ProposalStore {
 public:
  ProposalStore();

  /// Returns a proposal to fill, with its former contents; it returns here from whichever thread releases it last.
  std::shared_ptr<Proposal> take();
  /// Gives all memory back; what is looked at still, once it is let go.
  void forget();

 private:
  struct Shelf;
  std::shared_ptr<Shelf> shelf_;
};

}  // namespace insonate::prepare
