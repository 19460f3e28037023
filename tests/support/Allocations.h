#pragma once

namespace insonate::test {

/// How often this program has asked for memory with new, so far and in all threads.
long allocations();

}  // namespace insonate::test
