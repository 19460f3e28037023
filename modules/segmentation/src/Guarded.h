#pragma once

#include "Work.h"

#include <insonate/core/Result.h>

#include <exception>
#include <new>
#include <string>

namespace insonate::segmentation {

template <class T>
struct ResultOf {
  using type = Result<T>;
};
template <class T>
struct ResultOf<Result<T>> {
  using type = Result<T>;
};

/// Calls `work` and returns its result; converts cancellation, lack of memory and exceptions of libraries to errors.
template <class Function>
auto guarded(const Function& work) -> typename ResultOf<decltype(work())>::type {
  try {
    return work();
  } catch (const Cancelled&) {
    return fail(std::string(kCancelled));
  } catch (const std::bad_alloc&) {
    return fail("There is not enough memory for this region. Choose a smaller region or close other programs.");
  } catch (const std::exception& e) {
    return fail("This could not be computed: " + std::string(e.what()) + " Try a smaller region.");
  }
}

}  // namespace insonate::segmentation
