#ifdef __SANITIZE_THREAD__
#include <tbb/global_control.h>

namespace {
/// The library is not built with ThreadSanitizer, which therefore takes what one of its workers hands to another for a
/// race, everywhere. Without workers each thread of ours does its work alone, and what they hand to each other is seen.
const tbb::global_control kNoWorkers(tbb::global_control::max_allowed_parallelism, 1);
}  // namespace
#endif
