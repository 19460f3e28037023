#include "server/VideoCost.h"

#include <insonate/cases/Phantom.h>
#include <insonate/simulator/ScriptedSession.h>
#include <insonate/video/AttemptVideo.h>

#include <ctime>
#include <memory>
#include <utility>

namespace insonate::bench {

Result<VideoCost> measureVideoCost(const std::filesystem::path& folder, const Progress& progress) {
  constexpr std::uint32_t kSeed = 1;
  auto neck = makePhantom("textbook", kSeed, progress);
  if (!neck) return tl::unexpected(neck.error());
  const auto patient = std::make_shared<const PatientCase>(std::move(*neck));
  const auto script = loadSessionScript("clean-success", *patient);
  if (!script) return tl::unexpected(script.error());
  const auto file = folder / "video.attempt", target = folder / "video.webm";
  if (const auto recorded = runSession(*script, *patient, "insonate bench", file, progress); !recorded)
    return tl::unexpected(recorded.error());
  auto opened = AttemptRecording::open(file);
  if (!opened) return tl::unexpected(opened.error());
  const auto recording = std::make_shared<const AttemptRecording>(std::move(*opened));
  const std::clock_t before = std::clock();
  if (auto made = writeAttemptVideo(recording, patient, target, {}, progress); !made)
    return tl::unexpected(made.error());
  VideoCost cost;
  cost.processor_s = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  cost.attempt_s = 1e-6 * static_cast<double>(recording->end_us());
  std::error_code failed;
  cost.size_MB = static_cast<double>(std::filesystem::file_size(target, failed)) / 1e6;
  if (failed) return fail(target.string() + ": " + failed.message() + ".");
  return cost;
}

}  // namespace insonate::bench
