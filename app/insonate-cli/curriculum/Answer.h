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

/// Output of a command: for programs, and for people.
struct Answer {
  Json object = Json::object();
  std::string text;
  /// A fault that the command looked for and found; the sentence is printed after text and object, with exit status 1.
  std::string failure{};
};

/// A command that prints what `work` answers.
CLI::App* addAnsweringCommand(CLI::App& group, Outcome& outcome, const std::string& name, const std::string& about,
                              std::function<Result<Answer>()> work);

enum class SigningIn { No, Yes };

/// A command whose `work` gets --database, and what is needed to sign in.
CLI::App* addStoreCommand(CLI::App& group, Outcome& outcome, const std::string& name, const std::string& about,
                          SigningIn signingIn, std::function<Result<Answer>(const StoreOptions&)> work);
/// A command of who is signed in.
CLI::App* addSignedInCommand(CLI::App& group, Outcome& outcome, const std::string& name, const std::string& about,
                             std::function<Result<Answer>(const SignedIn&)> work);

struct Column {
  const char* key;
  const char* title;
};

/// Rows of a JSON list, aligned for reading: a missing value is n/a, control characters become spaces.
std::string tableOf(const Json& rows, const std::vector<Column>& columns);

/// ISO 8601, UTC, of microseconds since 1970.
std::string timeText(std::int64_t time_us);

template <class T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace insonate::cli
