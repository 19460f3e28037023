#pragma once

#include "Work.h"

#include <insonate/core/Result.h>

#include <new>
#include <string>

namespace insonate::segmentation {

/// The result of `work`, a function that may be cancelled or run out of memory.
template <class Function>
auto guarded(const Function& work) -> Result<decltype(work())> {
  try {
    return work();
  } catch (const Cancelled&) {
    return fail(std::string(kCancelled));
  } catch (const std::bad_alloc&) {
    return fail("There is not enough memory for this region. Choose a smaller one or close other programs.");
  }
}

}  // namespace insonate::segmentation
