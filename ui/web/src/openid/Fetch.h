#pragma once

#include <insonate/core/Result.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>

namespace insonate::web {

/// Limits by which a server protects itself against a slow or faulty provider.
struct FetchLimits {
  std::chrono::milliseconds connection{5'000};  ///< time for connecting
  std::chrono::milliseconds total{10'000};      ///< time for the whole request
  std::size_t answer_bytes = 256 << 10;         ///< size of an answer
};

/// A request to the provider. The request is sent by GET if `form` is empty, else by POST.
struct FetchRequest {
  std::string url{};
  std::string form{};                 ///< content type application/x-www-form-urlencoded
  std::string user{}, password{};     ///< HTTP Basic authentication; empty: none
  std::filesystem::path authority{};  ///< certificate that must have signed the provider's; empty: those of the system
};

struct Fetched {
  long status = 0;
  std::string body{};
};

/// Sends a request and waits for the answer; follows no redirect. Fails with a sentence if the address is not protected
/// (isProtected()), if the provider cannot be reached or its certificate is not valid, or beyond the limits. An answer
/// with another status than 200 is no failure. May be called on any thread.
Result<Fetched> fetch(const FetchRequest& request, const FetchLimits& limits);

}  // namespace insonate::web
