#pragma once

#include <insonate/core/Result.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
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

/// Returns a file's whole text; refuses a folder.
Result<std::string> textOfFile(const std::filesystem::path& file);

struct PresetText {
  std::string text;
  std::string where;  ///< opens a sentence on what is wrong in it: "" for a preset, "PATH: " for a file
};

/// Returns a preset's text, else that of the file with this path. `what` names the expected kind: "a procedure".
Result<PresetText> presetOrFile(std::string_view what, std::string_view nameOrPath, const std::vector<Preset>& presets);

/// Parses that text by `parse`, a function of a text that returns a Result; an error in a file begins with its path.
template <class Parse>
auto presetOrFile(std::string_view what, std::string_view nameOrPath, const std::vector<Preset>& presets,
                  const Parse& parse) -> std::invoke_result_t<Parse, std::string_view> {
  const auto file = presetOrFile(what, nameOrPath, presets);
  if (!file) return tl::unexpected(file.error());
  auto parsed = parse(std::string_view(file->text));
  if (!parsed) return fail(file->where + parsed.error().message);
  return parsed;
}

}  // namespace insonate
