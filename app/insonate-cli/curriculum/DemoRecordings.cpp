#include "DemoRecordings.h"

#include <insonate/cases/Phantom.h>
#include <insonate/simulator/ScriptedSession.h>

#include <array>
#include <system_error>

namespace insonate::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kSeed = 1;  // the neck that the window shows
constexpr std::array<const char*, kDemonstrations> kScripts{"clean-success", "two-passes", "carotid-puncture"};

}  // namespace

Result<std::vector<fs::path>> recordDemonstrations(const Level& level, const fs::path& folder, const std::string& name,
                                                   int most, const Progress& progress) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return fail(folder.string() + " cannot be made: " + error.message() + ". Name a database elsewhere.");
  const auto patient = makePhantom(level.caseName, kSeed, progress);
  if (!patient) return tl::unexpected(patient.error());
  std::vector<fs::path> recordings;
  for (const char* script : kScripts) {
    if (static_cast<int>(recordings.size()) == most) break;
    const auto acts = loadSessionScript(script, *patient);
    if (!acts) return tl::unexpected(acts.error());
    recordings.push_back(folder / (name + ' ' + script + ".attempt"));
    const auto recorded = runSession(*acts, *patient, "insonate " INSONATE_VERSION, recordings.back(), progress);
    if (!recorded) return tl::unexpected(recorded.error());
  }
  return recordings;
}

}  // namespace insonate::cli
