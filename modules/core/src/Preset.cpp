#include <insonate/core/Preset.h>
#include <insonate/core/Words.h>

#include <fstream>
#include <iterator>

namespace insonate {

std::vector<std::string> presetNames(const std::vector<Preset>& presets) {
  std::vector<std::string> names;
  for (const Preset& preset : presets) names.emplace_back(preset.name);
  return names;
}

Result<std::string> readTextFile(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) return fail(file.string() + " is a folder; a file is needed.");
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) return fail(file.string() + " cannot be read; check the path and the permissions.");
  return text;
}

Result<PresetText> presetOrFile(std::string_view what, std::string_view nameOrPath,
                                const std::vector<Preset>& presets) {
  std::vector<std::string_view> names;
  for (const Preset& preset : presets) {
    if (preset.name == nameOrPath) return PresetText{std::string(preset.text), ""};
    names.push_back(preset.name);
  }
  const std::filesystem::path path(nameOrPath);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    const std::string_view near = nearestWord(nameOrPath, names);
    return fail("'" + path.string() + "' is neither " + std::string(what) + " (" + joinedWords(names) + ") nor a file" +
                (near.empty() ? "." : "; did you mean '" + std::string(near) + "'?"));
  }
  return readTextFile(path).map([&](std::string text) { return PresetText{std::move(text), path.string() + ": "}; });
}

}  // namespace insonate
