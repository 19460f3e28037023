#include <insonate/core/Words.h>
#include <insonate/embedded/attempts.h>
#include <insonate/simulator/ScriptedSession.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace insonate {

std::vector<std::string> sessionScriptNames() {
  std::vector<std::string> names;
  for (const auto& file : embedded::attempts::files()) names.emplace_back(file.name);
  return names;
}

Result<SessionScript> loadSessionScript(std::string_view nameOrPath, const PatientCase& patient) {
  std::vector<std::string_view> names;
  for (const auto& file : embedded::attempts::files()) {
    if (file.name == nameOrPath) {
      auto script = readSessionScript(file.text, patient);
      if (!script)
        return fail("The script '" + std::string(nameOrPath) + "' does not fit this case: " + script.error().message);
      return script;
    }
    names.push_back(file.name);
  }
  const std::filesystem::path path(nameOrPath);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    const std::string_view near = nearestWord(nameOrPath, names);
    return fail("'" + path.string() + "' is neither a script (" + joinedWords(names) + ") nor a file" +
                (near.empty() ? "." : "; did you mean '" + std::string(near) + "'?"));
  }
  std::ifstream stream(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) return fail("The script " + path.string() + " cannot be read; check its permissions.");
  auto script = readSessionScript(text, patient);
  if (!script) return fail(path.string() + ": " + script.error().message);
  return script;
}

}  // namespace insonate
