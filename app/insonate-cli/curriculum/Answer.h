#pragma once

#include "../Commands.h"
#include "StoreAccess.h"

#include <insonate/core/Result.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace insonate::cli {

using Json = nlohmann::json;

/// Output of a subcommand: `object` with --json, otherwise `text`.
struct Answer {
  Json object = Json::object();
  std::string text;
  /// Message about a fault that the command found in the checked data; printed after text or object, with exit
  /// status 1.
  std::string failure{};
  int status = 0;  ///< exit status if there is no failure: 0, or kDoneInPart
};

/// Exit status of a command that did a part of its work and left out the rest with reasons.
inline constexpr int kDoneInPart = 3;

/// Adds a subcommand that prints the result of `work`.
CLI::App* addAnsweringCommand(CLI::App& group, Outcome& outcome, const std::string& name, const std::string& about,
                              std::function<Result<Answer>()> work);

enum class SigningIn { No, Yes };

/// Adds a subcommand with the option --database and, if `signingIn` is Yes, the options for signing in; `work` receives
/// these options.
CLI::App* addStoreCommand(CLI::App& group, Outcome& outcome, const std::string& name, const std::string& about,
                          SigningIn signingIn, std::function<Result<Answer>(const StoreOptions&)> work);
/// Adds a subcommand that signs a user in and passes the session to `work`.
CLI::App* addSignedInCommand(CLI::App& group, Outcome& outcome, const std::string& name, const std::string& about,
                             std::function<Result<Answer>(const SignedIn&)> work);

struct Column {
  const char* key;
  const char* title;
};

/// Formats a JSON list of objects as a table with aligned columns. A missing value becomes n/a, control characters
/// become spaces.
std::string tableOf(const Json& rows, const std::vector<Column>& columns);

/// Formats microseconds since 1970 as ISO 8601 in UTC.
std::string timeText(std::int64_t time_us);

template <class T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace insonate::cli
