#include "AttemptImageFiles.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/core/Fingerprint.h>
#include <insonate/simulator/ImageFiles.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>

namespace insonate::cli {
namespace fs = std::filesystem;
namespace {

std::string nameOf(const LiveFrame& frame) {
  char name[32];
  std::snprintf(name, sizeof name, "%07lld_ms.png", std::llround(frame.time_s * 1000));
  return name;
}

std::string fingerprintOf(const EnvelopeFrame& envelope) {
  Fingerprint fingerprint;
  for (const float amplitude : envelope.amplitude)
    fingerprint.add(std::uint64_t{std::bit_cast<std::uint32_t>(amplitude)});
  return fingerprint.text();
}

nlohmann::json entryOf(const LiveFrame& frame) {
  const double indent_mm = frame.press.indentation_mm;
  return {{"t_s", frame.time_s},
          {"file", nameOf(frame)},
          {"force_N", frame.press.force_N},
          {"indent_mm", std::isfinite(indent_mm) ? nlohmann::json(indent_mm) : nlohmann::json(nullptr)},
          {"envelope", fingerprintOf(frame.envelope)}};
}

Result<void> checkFolder(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error) && !fs::is_empty(folder, error))
    return fail(folder.string() + " already contains files. Name a new or empty folder for the images.");
  return checkFolderTarget(folder);
}

}  // namespace

void AttemptImageOptions::addTo(CLI::App& command) {
  auto* pictures = command.add_option("--images,--pictures", folder, "New folder for the ultrasound images (PNG)");
  command.add_option("--every", every_s, "Interval between two images, in seconds of the attempt")
      ->check(CLI::Range(0.001, 3600.0))
      ->capture_default_str()
      ->needs(pictures);
}

std::int64_t AttemptImageOptions::every_us() const {
  return std::max<std::int64_t>(1000, 1000 * std::llround(every_s * 1000));
}

Result<nlohmann::json> writeAttemptPictures(const AttemptImageOptions& options,
                                            const std::function<Result<void>(const TakeFrame&)>& make) {
  if (auto ok = checkFolder(options.folder); !ok) return tl::unexpected(ok.error());
  nlohmann::json list = nlohmann::json::array();
  const auto fill = [&](const fs::path& beside) -> Result<void> {
    const TakeFrame take = [&](const LiveFrame& frame) {
      list.push_back(entryOf(frame));
      return writePng(frame.image, beside / nameOf(frame));
    };
    if (auto ok = make(take); !ok) return ok;
    return writeAtomically(beside / "pictures.json", list.dump(1) + "\n");
  };
  if (auto ok = writeFolderAtomically(options.folder, fill); !ok) return tl::unexpected(ok.error());
  return list;
}

}  // namespace insonate::cli
