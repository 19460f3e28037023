#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace insonate::web {

/// Returns a text field of an object that another program sent; empty if the field is missing or is no text.
inline std::string jsonText(const nlohmann::json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace insonate::web
