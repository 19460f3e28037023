#include "NumberFields.h"
#include "TableFile.h"

#include <insonate/embedded/needles.h>
#include <insonate/tissue/NeedleTable.h>

namespace insonate {
namespace {

using tissuefile::Field;
using Tissue = NeedleTissue;

constexpr std::array kNumbers{
    Field<Tissue>{"stiffness_Npmm", &Tissue::stiffness_Npmm, 0, 50},
    Field<Tissue>{"stiffening_Npmm2", &Tissue::stiffening_Npmm2, 0, 10},
    Field<Tissue>{"puncture_N", &Tissue::puncture_N, 0, 20},
    Field<Tissue>{"cutting_N", &Tissue::cutting_N, 0, 10},
    Field<Tissue>{"cuttingStiffness_Npmm", &Tissue::cuttingStiffness_Npmm, 0, 10},
    Field<Tissue>{"friction_Npmm", &Tissue::friction_Npmm, 0, 1},
    Field<Tissue>{"stiction_Npmm", &Tissue::stiction_Npmm, 0, 1},
    Field<Tissue>{"viscosity_Nspmm2", &Tissue::viscosity_Nspmm2, 0, 0.01},
    Field<Tissue>{"lateral_Npmm2", &Tissue::lateral_Npmm2, 0, 1},
};

/// In the order of NeedleWall.
constexpr std::array<std::string_view, 3> kWalls{"none", "membrane", "hard"};
/// Words of the field "probe", the behavior of the transducer at this structure; the second one is true.
constexpr std::array<std::string_view, 2> kProbe{"passes", "touches"};

/// Contradictory values would make the servo return more energy than it received.
void checkTogether(JsonEntry& entry, const Tissue& t) {
  if (t.stiction_Npmm < t.friction_Npmm)
    entry.setError("has 'stiction_Npmm' below 'friction_Npmm'; static friction cannot be lower than sliding friction.");
  if (t.wall == NeedleWall::None) return;
  if (t.stiffness_Npmm <= 0 && t.stiffening_Npmm2 <= 0)
    entry.setError("has a wall, which needs 'stiffness_Npmm' or 'stiffening_Npmm2' above 0.");
  if (t.wall == NeedleWall::Membrane && t.puncture_N <= 0)
    entry.setError("has a membrane, which needs 'puncture_N' above 0.");
}

void readNeedle(const nlohmann::json& object, bool complete, const std::string& where, std::string& error,
                Tissue& tissue) {
  JsonEntry entry(object, where, tissuefile::presetNames(kNumbers, {"label", "wall", "probe"}), error);
  if (complete || entry.has("wall"))
    tissue.wall = static_cast<NeedleWall>(entry.word("wall", {kWalls.begin(), kWalls.end()}));
  if (complete || entry.has("probe")) tissue.probeTouches = entry.word("probe", {kProbe.begin(), kProbe.end()}) == 1;
  tissuefile::readNumbers(entry, kNumbers, complete, tissue);
  checkTogether(entry, tissue);
}

const tissuefile::TableForm<NeedleTable>& needleForm() {
  static const tissuefile::TableForm<NeedleTable> all{"needle", embeddedPresets(embedded::needles::files()),
                                                      readNeedle};
  return all;
}

}  // namespace

std::vector<std::string> needlePresetNames() {
  return presetNames(needleForm().presets);
}

Result<NeedleTable> parseNeedleTable(std::string_view text) {
  return tissuefile::parseTable(text, needleForm());
}

Result<NeedleTable> loadNeedleTable(std::string_view nameOrPath) {
  return tissuefile::loadTable(nameOrPath, needleForm());
}

}  // namespace insonate
