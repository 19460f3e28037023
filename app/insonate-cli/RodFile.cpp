#include "RodFile.h"

#include "Commands.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/core/JsonEntry.h>
#include <insonate/core/Preset.h>

#include <nlohmann/json.hpp>

namespace insonate::cli {

Result<void> writeRod(const Wire& wire, std::span<const Vec3> nodes_mm, const std::string& file) {
  nlohmann::json nodes = nlohmann::json::array();
  for (const Vec3& node : nodes_mm) nodes.push_back(jsonArray(node));
  const nlohmann::json json{{"name", wire.name},
                            {"kind", nameOf(wire.kind)},
                            {"diameter_mm", wire.diameter_mm},
                            {"innerDiameter_mm", wire.innerDiameter_mm},
                            {"nodes_mm", nodes}};
  return writeAtomically(file, json.dump(1) + "\n");
}

Result<FlexibleRod> readRod(const std::string& file) {
  const auto text = readTextFile(file);
  if (!text) return tl::unexpected(text.error());
  const std::string where = "The wire in '" + file + "'";
  const auto json = parsedJson(*text, where);
  if (!json) return tl::unexpected(json.error());
  JsonEntry entry(*json, where, {"name", "kind", "diameter_mm", "innerDiameter_mm", "nodes_mm"});
  FlexibleRod rod;
  const bool isCoil = entry.word("kind", {"guidewire", "dilator", "catheter"}) == std::size_t(WireKind::Guidewire);
  rod.material = isCoil ? RodMaterial::SteelCoil : RodMaterial::Polymer;
  rod.radius_mm = entry.number("diameter_mm", 0.2, 6) / 2;
  rod.innerRadius_mm = entry.optionalNumber("innerDiameter_mm", 0, 5.7).value_or(0) / 2;
  for (const nlohmann::json& node : entry.value("nodes_mm")) {
    const bool isPoint =
        node.is_array() && node.size() == 3 && node[0].is_number() && node[1].is_number() && node[2].is_number();
    if (!isPoint) return fail(where + " has a node that is not a list of three numbers.");
    rod.nodes_mm.push_back({node[0].get<double>(), node[1].get<double>(), node[2].get<double>()});
  }
  if (!entry.error().empty()) return fail(entry.error());
  if (auto ok = validate(rod); !ok) return fail(where + ": " + ok.error().message);
  return rod;
}

}  // namespace insonate::cli
