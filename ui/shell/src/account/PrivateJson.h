#pragma once

#include <insonate/core/Result.h>

#include <QJsonObject>
#include <filesystem>

namespace insonate::ui {

/// Reads a file of writePrivateJson(); empty if there is none or it cannot be read.
QJsonObject readPrivateJson(const std::filesystem::path& file);
/// Writes a file that only its owner can read. On failure the former file is unchanged.
Result<void> writePrivateJson(const std::filesystem::path& file, const QJsonObject& json);

}  // namespace insonate::ui
