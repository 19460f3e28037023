#pragma once

#include "store/site/Wire.h"

#include <insonate/core/Result.h>

#include <nlohmann/json.hpp>

#include <string>

namespace insonate::store {

/// Version of the messages between workstation and server; a server refuses messages of another version.
inline constexpr int kWireVersion = 3;

nlohmann::json jsonOf(const std::vector<SentPerson>& people);
nlohmann::json jsonOf(const SentBatch& batch);
nlohmann::json jsonOf(const Taken& taken);
nlohmann::json jsonOf(const Taught& taught);
nlohmann::json jsonOf(const AttemptsElsewhere& part);

// The following functions read the JSON that jsonOf() writes. They throw nlohmann::json::exception for any other JSON.
std::vector<SentPerson> peopleFrom(const nlohmann::json& json);
SentBatch batchFrom(const nlohmann::json& json);
Taken takenFrom(const nlohmann::json& json);
Taught taughtFrom(const nlohmann::json& json);
AttemptsElsewhere elsewhereFrom(const nlohmann::json& json);

/// Adds the version, and writes the message. Text that is no valid UTF-8 is replaced.
std::string messageOf(nlohmann::json content);
/// Reads a message; fails with a sentence if it is no JSON object of kWireVersion.
Result<nlohmann::json> readMessage(const std::string& text);

}  // namespace insonate::store
