#pragma once

namespace insonate::test {

/// Number of allocations with new by all threads of this program so far.
long allocations();

}  // namespace insonate::test
