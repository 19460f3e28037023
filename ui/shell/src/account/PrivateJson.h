#pragma once

#include <insonate/core/Result.h>

#include <QJsonObject>
#include <filesystem>

namespace insonate::ui {

/// Reads a file that writePrivateJson() wrote; empty if the file is missing or cannot be read.
QJsonObject readPrivateJson(const std::filesystem::path& file);
/// Writes a file that only its owner can read. On failure the former file is unchanged.
Result<void> writePrivateJson(const std::filesystem::path& file, const QJsonObject& json);

}  // namespace insonate::ui
