#pragma once

#include <insonate/core/Result.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Reading JSON objects with a fixed set of fields. `where` opens each sentence: "probe 'linear'", "settings".
namespace insonate::fields {

Result<nlohmann::json> parseFile(const std::filesystem::path& file);
Result<nlohmann::json> parseText(std::string_view text, const std::string& where);

/// Refuses anything but an object and keys that are not known, with the nearest known one.
Result<void> checkKeys(const nlohmann::json& object, const std::vector<std::string_view>& known,
                       const std::string& where);
Result<double> readNumber(const nlohmann::json& value, std::string_view name, const std::string& where);
/// Whole numbers only; 3.0 counts as 3.
Result<int> readInteger(const nlohmann::json& value, std::string_view name, const std::string& where);
Result<bool> readSwitch(const nlohmann::json& value, std::string_view name, const std::string& where);
/// The position of a word in `choices`.
Result<int> readChoice(const nlohmann::json& value, const std::vector<std::string_view>& choices, std::string_view name,
                       const std::string& where);

/// Refuses NaN and values outside low..high.
Result<void> checkRange(double value, double low, double high, std::string_view name, const std::string& where);

}  // namespace insonate::fields
