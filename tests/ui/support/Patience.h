#pragma once

namespace insonate::test {

/// Time limit of a test's wait; under sanitizers everything takes several times as long.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int kPatience_ms = 300'000;
#else
inline constexpr int kPatience_ms = 60'000;
#endif

}  // namespace insonate::test
