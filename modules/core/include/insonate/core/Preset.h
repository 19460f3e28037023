#pragma once

#include <insonate/core/Result.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace insonate {

/// A named text file that is compiled into the program.
struct Preset {
  std::string_view name, text;
};

/// Returns the presets for files that the CMake function insonate_embed() has compiled into the program.
template <class Files>
std::vector<Preset> embeddedPresets(const Files& files) {
  std::vector<Preset> presets;
  for (const auto& file : files) presets.push_back({file.name, file.text});
  return presets;
}

std::vector<std::string> presetNames(const std::vector<Preset>& presets);

/// Returns the whole text of a file; fails on a folder.
Result<std::string> readTextFile(const std::filesystem::path& file);

struct PresetText {
  std::string text;
  std::string where;  ///< prefix for an error sentence about the text: "" for a preset, "PATH: " for a file
};

/// Returns the text of the preset with this name, else of the file with this path. `what` names the expected kind of
/// file in the error sentence, e.g. "a procedure".
Result<PresetText> presetOrFile(std::string_view what, std::string_view nameOrPath, const std::vector<Preset>& presets);

/// Finds the preset with this name, else the file with this path, and parses its text with `parse`, a function that
/// takes a text and returns a Result. The sentence of an error in a file begins with the path of the file.
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
