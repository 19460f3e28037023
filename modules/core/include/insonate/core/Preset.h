#pragma once

#include <insonate/core/Result.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// A text that is compiled in.
struct Preset {
  std::string_view name, text;
};

/// Finds a preset among the files that insonate_embed() compiled in.
template <class Files>
std::vector<Preset> presetsOf(const Files& files) {
  std::vector<Preset> presets;
  for (const auto& file : files) presets.push_back({file.name, file.text});
  return presets;
}

std::vector<std::string> namesOf(const std::vector<Preset>& presets);

struct PresetText {
  std::string text;
  std::string where;  ///< opens a sentence on what is wrong in it: "" for a preset, "PATH: " for a file
};

/// Returns a preset's text, else that of the file with this path. `what` names the expected kind: "a procedure".
Result<PresetText> presetOrFile(std::string_view what, std::string_view nameOrPath, const std::vector<Preset>& presets);

}  // namespace insonate
