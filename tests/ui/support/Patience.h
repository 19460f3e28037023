#pragma once

namespace insonate::test {

/// How long a test waits for what must come; under sanitizers all takes several times as long.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int kPatience_ms = 300'000;
#else
inline constexpr int kPatience_ms = 60'000;
#endif

}  // namespace insonate::test
