#pragma once

#include <tl/expected.hpp>

#include <string>
#include <utility>

namespace insonate {

/// Reason why a function failed: a sentence that says what is wrong, where, and what to do.
struct Error {
  std::string message;
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(std::string message) {
  return tl::unexpected(Error{std::move(message)});
}

}  // namespace insonate
