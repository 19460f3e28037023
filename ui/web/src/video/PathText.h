#pragma once

#include <insonate/teaching/NeedlePath.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>

namespace insonate::web {

/// Writes a path as JSON, in steps of 0.01 mm.
nlohmann::json pathToJson(const NeedlePath& path);
/// Reads a path; empty if this is not a path that pathToJson() has written.
std::optional<NeedlePath> pathFromJson(const nlohmann::json& json);

}  // namespace insonate::web
