#include <insonate/core/Preset.h>
#include <insonate/embedded/attempts.h>
#include <insonate/simulator/ScriptedSession.h>

namespace insonate {

std::vector<std::string> sessionScriptNames() {
  return presetNames(embeddedPresets(embedded::attempts::files()));
}

Result<SessionScript> loadSessionScript(std::string_view nameOrPath, const PatientCase& patient) {
  const auto file = presetOrFile("a script", nameOrPath, embeddedPresets(embedded::attempts::files()));
  if (!file) return tl::unexpected(file.error());
  auto script = readSessionScript(file->text, patient);
  if (script) return script;
  const std::string where = "The script '" + std::string(nameOrPath) + "' does not fit this case: ";
  return fail((file->where.empty() ? where : file->where) + script.error().message);
}

}  // namespace insonate
